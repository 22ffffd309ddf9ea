/// \file stabilization.hpp
/// What to do about a position error C, which velocity rows do not see: five ways to repay it.
///
///     none           b = 0: the row forgets C, and C drifts
///     baumgarte      b = β C / h: the velocity repays the part β in each step \cite baumgarte1972
///     relaxation     the same; once the positions have moved, the sweeps go on with b = 0 and take the
///                    repaying velocity away again
///     split_impulse  b = 0; a second, pseudo-velocity v repays β C', is added to x, and is forgotten
///     projection     b = 0; after the step x itself is moved along M⁻¹ Jᵀ, C and J anew at each visit
///
/// A gap, C > 0 of a contact, is no error: all five let it close and no more, b = C / h (3.30).
#pragma once

#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "common/text.hpp"

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rigid {

enum class Stabilizer { none, baumgarte, relaxation, split_impulse, projection };

struct StabilizerSettings {
    Stabilizer method = Stabilizer::baumgarte;
    Real beta = 0.2;           ///< part of an error that is repaid in a step; stable below 2, monotone to 1
    Real slop = 0;             ///< an overlap of up to this much is left alone [m]
    Real bilateral_slop = 0;   ///< the same for a bilateral row, to both sides [m]
    Real fastest = infinity;   ///< an error is repaid at this speed at most [m/s]
    int repaying_sweeps = 10;  ///< at most, for relaxation, pseudo-velocities, projection
    Real tolerance = 1e-9;     ///< these sweeps end when none of them changes a row by more than this [m/s]
};

constexpr std::string_view to_string(Stabilizer method)
{
    switch (method) {
    case Stabilizer::none:
        return "none";
    case Stabilizer::baumgarte:
        return "baumgarte";
    case Stabilizer::relaxation:
        return "relaxation";
    case Stabilizer::split_impulse:
        return "split_impulse";
    case Stabilizer::projection:
        return "projection";
    }
    return "unknown";
}

/// Throws std::invalid_argument, naming the setting and its value, unless all of them make sense. A β of 2 or
/// more is let through: it is unstable, and seeing that is part of the chapter.
inline void require_valid(const StabilizerSettings& settings)
{
    const auto at_least_zero = [](Real value, const char* name, bool finite) {
        if (!(value >= 0) || (finite && !std::isfinite(value)))
            throw std::invalid_argument(std::string(name) + " is " + shortest(value) +
                                        "; it must be zero or positive" + (finite ? " and finite" : ""));
    };
    at_least_zero(settings.beta, "beta", true);
    at_least_zero(settings.slop, "slop", true);
    at_least_zero(settings.bilateral_slop, "bilateral_slop", true);
    at_least_zero(settings.fastest, "fastest", false);
    at_least_zero(settings.tolerance, "the tolerance of the repaying sweeps", false);
    if (settings.repaying_sweeps < 0)
        throw std::invalid_argument("repaying_sweeps is " + std::to_string(settings.repaying_sweeps) +
                                    "; it must be zero or positive");
}

//! [error]
/// (7.16): the part of C that is to be repaid [m]: what lies beyond the slop; of a contact only an overlap, C < 0.
inline Real position_error(Real C, bool bilateral, const StabilizerSettings& settings)
{
    if (!bilateral) return std::min(Real{0}, C + settings.slop);
    return C - std::clamp(C, -settings.bilateral_slop, settings.bilateral_slop);
}
//! [error]

//! [baumgarte]
/// (7.4): the bias that repays the part β of C in one step, at no more than the greatest speed.
/// \param C  position error of the row [m]
/// \param h  time step [s]
/// \return   velocity bias b [m/s]
inline Real baumgarte_bias(Real C, bool bilateral, const StabilizerSettings& settings, Real h)
{
    const Real repaid = settings.beta / h * position_error(C, bilateral, settings);
    return std::clamp(repaid, -settings.fastest, settings.fastest);
}
//! [baumgarte]

//! [velocity_bias]
/// The bias of a row in the sweeps that find the velocity.
inline Real velocity_bias(Real C, bool bilateral, const StabilizerSettings& settings, Real h)
{
    if (!bilateral && C > 0) return C / h;
    const bool repays = settings.method == Stabilizer::baumgarte || settings.method == Stabilizer::relaxation;
    return repays ? baumgarte_bias(C, bilateral, settings, h) : 0;
}
//! [velocity_bias]

/// The rows of these constraints, the first `links` of them bilateral, the others unilateral.
/// \param h  time step [s]
template <int Dof>
void stabilized_rows(std::span<const Constraint<Dof>> constraints, std::size_t links,
                     const VecX& inverse_mass, const StabilizerSettings& settings, Real h,
                     std::vector<Row<Dof>>& rows)
{
    rows.clear();
    for (std::size_t i = 0; i < constraints.size(); ++i) {
        const Real b = velocity_bias(constraints[i].C, i < links, settings, h);
        rows.push_back(i < links ? bilateral(constraints[i], inverse_mass, b)
                                 : unilateral(constraints[i], inverse_mass, b));
    }
}

/// C as it will be after a step h with velocities u, to first order: C + h J u [m].
template <int Dof>
Real predicted(const SolverRow<Dof>& row, Real C, const VecX& u, Real h)
{
    return C + h * (row.Ja.dot(u.template segment<Dof>(row.a)) + row.Jb.dot(u.template segment<Dof>(row.b)));
}

/// The sweeps go on over rows that are prepared, from their present λ and u, until one of them finds no row off by
/// more than the tolerance.
/// \return  rows visited
template <int Dof>
std::int64_t sweep_on(std::vector<SolverRow<Dof>>& rows, const StabilizerSettings& settings, VecX& u)
{
    int sweeps = 0;
    for (int changed = 1; sweeps < settings.repaying_sweeps && changed > 0; ++sweeps)
        changed = sweep(rows, u, settings.tolerance);
    return static_cast<std::int64_t>(rows.size()) * sweeps;
}

/// The λ of rows in the order of the visits, back to their numbers.
template <int Dof>
void read_impulses(const ImpulseMemory<Dof>& memory, std::span<const int> order, VecX& lambda)
{
    for (std::size_t k = 0; k < memory.rows.size(); ++k)
        lambda[order.empty() ? static_cast<Index>(k) : order[k]] = memory.rows[k].lambda;
}

//! [relax]
/// Takes back the velocity that was only there to repay: the rows go on from their λ, now with b = 0, or with
/// what is left of a gap.
/// \param memory  as sequential_impulse() left it; its rows and its u change
/// \param order   the order that it was given
/// \return        rows visited
template <int Dof>
std::int64_t relax(std::span<const Constraint<Dof>> constraints, std::span<const int> order,
                   std::size_t links, const StabilizerSettings& settings, Real h, ImpulseMemory<Dof>& memory)
{
    for (std::size_t k = 0; k < memory.rows.size(); ++k) {
        const std::size_t i = order.empty() ? k : static_cast<std::size_t>(order[k]);
        SolverRow<Dof>& row = memory.rows[k];
        if (i >= constraints.size()) continue;  // a machine: its speed is wanted
        if (row.bias < velocity_bias(constraints[i].C, i < links, settings, h)) continue;  // it bounces
        const Real C = i < links ? 0 : predicted(row, constraints[i].C, memory.u, h);
        row.bias = std::max(Real{0}, C) / h;
    }
    return sweep_on(memory.rows, settings, memory.u);
}
//! [relax]

//! [split]
/// (7.17): pseudo-velocities v that repay the part β of the error that the step will leave, C' = C + h J u. They are
/// found by the same sweeps over the same rows, and only ever added to x.
/// \param memory  as sequential_impulse() left it. Its rows' λ are those of v afterwards
/// \param v       out: Dof·K [m/s]
/// \return        rows visited
template <int Dof>
std::int64_t split_impulse(std::span<const Constraint<Dof>> constraints, std::span<const int> order,
                           std::size_t links, const StabilizerSettings& settings, Real h,
                           ImpulseMemory<Dof>& memory, VecX& v)
{
    for (std::size_t k = 0; k < memory.rows.size(); ++k) {
        const std::size_t i = order.empty() ? k : static_cast<std::size_t>(order[k]);
        SolverRow<Dof>& row = memory.rows[k];
        row.lambda = 0;
        if (i >= constraints.size()) {  // a machine: it has no error to repay
            row.mass = 0;
            continue;
        }
        const Real C = predicted(row, constraints[i].C, memory.u, h);
        row.bias = i >= links && C > 0 ? C / h : baumgarte_bias(C, i < links, settings, h);
    }
    v.setZero(memory.u.size());
    return sweep_on(memory.rows, settings, v);
}
//! [split]

}  // namespace rigid
