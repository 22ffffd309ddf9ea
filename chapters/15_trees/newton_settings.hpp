/// \file newton_settings.hpp
/// What Newton's method on C asks for, and the small things that its two parts share.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"

#include <span>

namespace rigid {

struct NewtonSettings {
    int most = 32;  ///< iterations a sub-step, for errors
    /// the same by sweeps, and until contacts and limits that push give way to joints
    int most_swept = 8;
    int most_follow = 20;  ///< and for the arcs; each halves what is left
    /// they end when no joint is off by more than this [ℓ]
    Real tolerance = 1e-9;
    Real beta = 0.2;       ///< part of an overlap that a sub-step takes back
    Real slop = 5e-3;      ///< s, an overlap of up to this much is left alone [ℓ]
    int sweeps = 10;       ///< of solvers that sweep, in an iteration
    int push_sweeps = 10;  ///< the same where overlaps are to come out
};

inline void require_valid(const NewtonSettings& settings)
{
    if (settings.most < 0 || settings.most_swept < 0 || settings.sweeps < 0 ||
        settings.push_sweeps < 0)
        throw std::invalid_argument(
            "Newton's method has " +
            std::to_string(std::min(settings.most, settings.most_swept)) +
            " iterations of " +
            std::to_string(std::min(settings.sweeps, settings.push_sweeps)) +
            " sweeps; both must be zero or positive");
    if (settings.most_follow < 0)
        throw std::invalid_argument("Newton's method follows arcs in " +
                                    std::to_string(settings.most_follow) +
                                    " iterations; it must be zero or positive");
    if (!(settings.tolerance >= 0) || !(settings.slop >= 0) ||
        !(settings.beta >= 0 && settings.beta <= 1))
        throw std::invalid_argument(
            "Newton's method has the tolerance " + shortest(settings.tolerance) +
            ", the slop " + shortest(settings.slop) + " and beta " +
            shortest(settings.beta) +
            "; they must be zero or positive, and beta at most 1");
}

/// What of a problem has its positions corrected.
enum class Corrected : unsigned char {
    errors,  ///< of joints and of contacts, by sweeps: with the J of the step
    arcs_and_errors,  ///< and what the step bends away: its joints are met, not swept
    overlaps,         ///< what lies too deep, once; no joint is closed
    joints,           ///< errors of joints, with limits that are near held
};

/// A solver whose problems, islands or all rows as one, can have their errors corrected each by itself.
///
/// - for_each_problem() calls visit(rows, bodies, apart, what) for each of them: apart.solve_apart() solves other biases on
///   these rows alone, apart.factor_again() takes their J from now.rows.
/// - bounce_late(), after the positions: what bounces at the end of a sub-step. It changes u and λ, and no x.
template <class Solver>
concept SolvesProblems = requires(Solver it, Bodies<3>& bodies, StepData<3>& now)
{
    it.for_each_problem(
        now, [](std::span<const int>, std::span<const int>, auto&, Corrected) {});
    it.bounce_late(bodies, now);
};

inline bool is_of_joint(const StepData<3>& now, int row)
{
    return now.sources[static_cast<std::size_t>(row)].of == Source::Of::joint;
}

/// Whether C is in radians: its row moves no centroid.
inline bool is_angle(const Constraint<3>& c)
{
    return c.Jb.head<2>().isZero(0) && (c.a == world || c.Ja.head<2>().isZero(0));
}

/// Of an overlap of two bodies, what is left alone [m].
/// \param most   where no body asks for less
/// \param slops  of each body; empty = none asks
inline Real least_slop(Real most, const Constraint<3>& c,
                       const std::vector<Real>& slops)
{
    for (const Index k : {c.a, c.b})
        if (k != world && k < static_cast<Index>(slops.size()))
            most = std::min(most, slops[static_cast<std::size_t>(k)]);
    return most;
}

/// Whether v moves one of these bodies much farther than what is to be corrected, and by more than a twentieth of ℓ.
inline bool goes_far(const VecX& v, std::span<const int> members, Real length,
                     Real h, Real wanted)
{
    Real farthest = 0;
    for (const int k : members)
        farthest = std::max(farthest, h * v.segment<2>(3 * k).norm());
    return !(farthest <= std::max(8 * wanted, length / 20));
}

/// What could move before and cannot now has no pseudo-velocity.
inline void stop_beside(std::span<const int> rows, const std::vector<Row<3>>& all,
                        const Bodies<3>& bodies, VecX& v)
{
    for (const int i : rows)
        for (const Index k : {all[static_cast<std::size_t>(i)].a,
                              all[static_cast<std::size_t>(i)].b})
            if (k != world && !bodies.can_move(k)) v.segment<3>(3 * k).setZero();
}

/// x ← x + h v, of some bodies.
inline void move_by(const VecX& v, Real h, Bodies<3>& bodies,
                    std::span<const int> members)
{
    for (const int k : members) bodies.integrate(k, v.segment<3>(3 * k), h);
}

/// Where some bodies were.
struct PlacesBefore {
    VecX x;

    void keep(const Bodies<3>& bodies, std::span<const int> members)
    {
        x.resize(bodies.x.size());
        for (const int k : members) x.segment<3>(3 * k) = bodies.position(k);
    }
    void put_back(Bodies<3>& bodies, std::span<const int> members) const
    {
        for (const int k : members) bodies.position(k) = x.segment<3>(3 * k);
    }
};

}  // namespace rigid
