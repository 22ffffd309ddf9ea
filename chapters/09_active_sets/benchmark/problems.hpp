/// \file problems.hpp
/// Scenes to measure exact solvers by: columns, pyramids and chains of any size, as rows and velocities.
///
///     rows (J, b, bounds), u*   →   A = J M⁻¹ Jᵀ,  q = J u* + b
///
/// They differ in what makes a problem hard: how much of A is zero, how far the masses are apart, whether
/// A is singular (a box that stands on more contacts than it needs), how many rows lie between bounds.
/// All are made from their arguments alone; what is random has a seed.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/05_lemke/families.hpp"
#include "chapters/05_lemke/stewart_trinkle.hpp"

#include <array>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

/// Rows and the velocities before the impulses: all that an MLCP is assembled from.
template <int Dof>
struct RowProblem {
    std::vector<Row<Dof>> rows;
    VecX u_star;  ///< [m/s, rad/s]

    Mlcp mlcp() const { return assemble(rows, u_star); }
};

/// How the bodies move before the impulses.
struct Motion {
    /// downward speed of all: what gravity gives in one step [m/s]
    Real fall = 9.81 / 60;
    Real jostle = 0;  ///< size of the random speeds on top of it [m/s, rad/s]
    std::uint64_t seed = 1;
};

inline constexpr Motion at_rest{}, nudged{9.81 / 60, 0.1, 1},
    in_impact{9.81 / 60, 1, 1};

/// Square boxes with a side of 1 m that stand on each other, and which box stands on which.
struct BoxPile {
    struct Stands {
        Index below = world, above = 0;
    };
    std::vector<Vec2> centre;  ///< [m]; the ground is y = 0
    std::vector<Real> mass;    ///< [kg]
    std::vector<Stands> stands;

    Index add(const Vec2& place, Real kilograms)
    {
        centre.push_back(place);
        mass.push_back(kilograms);
        return static_cast<Index>(mass.size()) - 1;
    }
};

struct ColumnShape {
    Real top_mass = 1;       ///< of the topmost box [kg]
    bool alternate = false;  ///< every second one below it has that mass too
    /// Each is moved by up to a twentieth from the axis, and at rest the column stands.
    bool upright = false;
};

/// Boxes of 1 kg one on the other, each moved sideways by up to a tenth of its side against the one below, unless
/// `upright`: a high column strays from the upright so far that it topples: parts of it open.
inline BoxPile box_column(Index boxes, const ColumnShape& shape = {})
{
    Random random(1);
    const auto [top_mass, alternate, upright] = shape;
    BoxPile pile;
    Real x = 0;
    for (Index k = 0; k < boxes; ++k) {
        x = upright ? random.uniform(-0.05, 0.05) : x + random.uniform(-0.1, 0.1);
        const Index below_top = boxes - 1 - k;
        const bool heavy = below_top == 0 || (alternate && below_top % 2 == 0);
        pile.add({x, static_cast<Real>(k) + 0.5}, heavy ? top_mass : 1);
        pile.stands.push_back({k - 1, k});
    }
    return pile;
}

/// L boxes on the ground, 1.1 m apart, L - 1 on the gaps between them, and so on: 2 L² rows, and without
/// friction only the L (L + 1)/2 boxes' upward speeds and spins answer to them: from L = 2 on A is singular.
inline BoxPile box_pyramid(Index levels)
{
    BoxPile pile;
    Index level_start = 0;
    for (Index level = 0; level < levels; ++level) {
        const Index count = levels - level;
        for (Index k = 0; k < count; ++k) {
            const Real left = -static_cast<Real>(count - 1) / 2;
            const Index box = pile.add({1.1 * (left + static_cast<Real>(k)),
                                        static_cast<Real>(level) + 0.5},
                                       1);
            if (level == 0) pile.stands.push_back({world, box});
            else
                for (const Index side : {0, 1})
                    pile.stands.push_back(
                        {level_start - count - 1 + k + side, box});
        }
        level_start += count;
    }
    return pile;
}

/// The two ends of the line on which a pair touches [m].
inline std::array<Vec2, 2> ends_of_contact(const BoxPile& pile,
                                           const BoxPile::Stands& pair)
{
    const Vec2 upper = pile.centre[static_cast<std::size_t>(pair.above)];
    const Vec2 lower = pair.below == world
                           ? upper
                           : pile.centre[static_cast<std::size_t>(pair.below)];
    return {Vec2(std::max(lower.x(), upper.x()) - 0.5, upper.y() - 0.5),
            Vec2(std::min(lower.x(), upper.x()) + 0.5, upper.y() - 0.5)};
}

/// The row of one direction at one point p of a contact, with the lever arms of p on both boxes.
inline Row<3> pile_row(const BoxPile& pile, const VecX& inverse_mass,
                       const BoxPile::Stands& pair, const Vec2& direction,
                       const Vec2& p)
{
    const auto centre = [&](Index k) {
        return pile.centre[static_cast<std::size_t>(k)];
    };
    const Vec2 arm =
        pair.below == world ? Vec2(0, 0) : Vec2(p - centre(pair.below));
    return contact_row(pair.below, pair.above, direction, arm,
                       p - centre(pair.above), inverse_mass);
}

/// The rows of a pile: two points for each pair that touches, a normal row for each; with `friction`, the
/// coefficient μ > 0, a tangential row behind each normal one. Its bounds are ±μ times what the point would
/// carry if each box handed half of what is above it to each of its two points: a box of friction, fixed
/// beforehand.
inline RowProblem<3> pile_problem(const BoxPile& pile, const Motion& motion,
                                  Real friction = 0)
{
    if (pile.mass.empty())
        throw std::invalid_argument("the pile has 0 boxes; it needs at least 1");
    const auto count = static_cast<Index>(pile.mass.size());
    const auto at = [](const auto& list, Index k) {
        return list[static_cast<std::size_t>(k)];
    };
    VecX inverse_mass(3 * count);
    RowProblem<3> problem;
    problem.u_star.resize(3 * count);
    Random random(motion.seed);
    // mass that the next box down has to carry: only meant for columns
    Real above = 0;
    for (Index k = 0; k < count; ++k) {
        const Real mass = at(pile.mass, k);
        above += mass;
        // a square about its centre
        inverse_mass.segment<3>(3 * k) << 1 / mass, 1 / mass, 6 / mass;
        for (Index d = 0; d < 3; ++d)
            problem.u_star[3 * k + d] = motion.jostle * random.uniform(-1, 1);
        problem.u_star[3 * k + 1] -= motion.fall;
    }
    for (const BoxPile::Stands& pair : pile.stands) {
        for (const Vec2& p : ends_of_contact(pile, pair)) {
            problem.rows.push_back(pile_row(pile, inverse_mass, pair, {0, 1}, p));
            if (!(friction > 0)) continue;
            Row<3> row = pile_row(pile, inverse_mass, pair, {1, 0}, p);
            row.hi = friction * above * motion.fall / 2;
            row.lo = -row.hi;
            problem.rows.push_back(row);
        }
        above -= at(pile.mass, pair.above);
    }
    return problem;
}

/// A chain of K discs of 1 kg on K - 1 links that lies on hilly ground, jostled: one bilateral row for each
/// link and one contact with the slope below for each disc, n = 2K - 1 rows for 2K velocities. Near half of
/// the contacts open.
inline RowProblem<2> chain_on_hills(Index discs, const Motion& motion = in_impact)
{
    if (discs < 2)
        throw std::invalid_argument("the chain has " + std::to_string(discs) +
                                    " discs; it needs 2");
    constexpr Real length = 0.1;
    Random random(motion.seed);
    VecX x(2 * discs), slope(discs);
    Vec2 place(0, 0);
    for (Index k = 0; k < discs; ++k) {
        // The height is 0.2 sin 3s: the next disc stands one link further along the ground.
        slope[k] = 0.6 * std::cos(3 * place.x());
        x.segment<2>(2 * k) = place;
        place += length * Vec2(1, slope[k]).normalized();
    }
    const VecX inverse_mass = VecX::Ones(2 * discs);
    RowProblem<2> problem;
    problem.u_star.resize(2 * discs);
    for (Real& speed : problem.u_star)
        speed = motion.jostle * random.uniform(-1, 1);
    for (Index k = 0; k < discs; ++k) problem.u_star[2 * k + 1] -= motion.fall;
    for (Index k = 0; k + 1 < discs; ++k)
        problem.rows.push_back(
            bilateral(distance_constraint(x, {k, k + 1, length}), inverse_mass));
    for (Index k = 0; k < discs; ++k) {
        const Vec2 normal = Vec2(-slope[k], 1).normalized();
        problem.rows.push_back(
            unilateral(alignment_constraint<2>(x, world, k, normal,
                                               normal.dot(x.segment<2>(2 * k))),
                       inverse_mass));
    }
    return problem;
}

}  // namespace rigid
