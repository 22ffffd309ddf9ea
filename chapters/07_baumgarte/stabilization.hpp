/// \file stabilization.hpp
/// What to do about a position error C, which velocity rows do not contain: five ways to correct it.
///
///     none           b = 0: the row forgets C, and C drifts
///     baumgarte      b = β C / h: the velocity corrects the part β in each step \cite baumgarte1972
///     relaxation     the same; once the positions have moved, the sweeps go on with b = 0 and take the
///                    correcting velocity away again
///     split_impulse  b = 0; a second, pseudo-velocity v corrects β C', is added to x, and is forgotten
///     projection     b = 0; after the step x itself is moved along M⁻¹ Jᵀ, C and J computed again at each visit
///
/// A gap, C > 0 of a contact, is no error: all five let it close and no more, b = C / h (3.30).
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
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
    /// part of an error that is corrected in a step; stable below 2, monotone to 1
    Real beta = 0.2;
    Real slop = 0;            ///< an overlap of up to this much is left alone [ℓ]
    Real bilateral_slop = 0;  ///< the same for a bilateral row, to both sides [ℓ]
    /// an error is corrected at this speed at most [ℓ/s]
    Real max_correction_speed = infinity;
    /// at most, for relaxation, pseudo-velocities, projection
    int correction_sweeps = 10;
    /// these sweeps end when none of them changes a row by more than this [ℓ/s]
    Real tolerance = 1e-9;
};

/// What a step does with settings that are measured in the length ℓ of its scene [m]: all functions below take metres.
StabilizerSettings in_metres(StabilizerSettings settings, Real length);

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
void require_valid(const StabilizerSettings& settings);

//! [error]
/// (7.12): the part of C that is to be corrected [m]: what lies beyond the slop; of
/// a contact only an overlap, C < 0; of a motor nothing.
inline Real position_error(Real C, ConstraintKind kind,
                           const StabilizerSettings& settings)
{
    if (!has_error(kind)) return 0;
    if (kind == ConstraintKind::unilateral)
        return std::min(Real{0}, C + settings.slop);
    return C - std::clamp(C, -settings.bilateral_slop, settings.bilateral_slop);
}
//! [error]

//! [baumgarte]
/// (7.4): the bias that corrects the part β of C in one step, at no more than the
/// maximum speed.
/// \param C     position error of the row [m]
/// \param kind  of its constraint
/// \param h     time step [s]
/// \return      velocity bias b [m/s]
inline Real baumgarte_bias(Real C, ConstraintKind kind,
                           const StabilizerSettings& settings, Real h)
{
    const Real repaid = settings.beta / h * position_error(C, kind, settings);
    return std::clamp(repaid, -settings.max_correction_speed,
                      settings.max_correction_speed);
}
//! [baumgarte]

//! [velocity_bias]
/// The bias of a row in the sweeps that find the velocity.
template <int Dof>
Real velocity_bias(const Constraint<Dof>& c, const StabilizerSettings& settings,
                   Real h)
{
    if (!has_error(c.kind)) return own_bias(c, h);
    if (c.kind == ConstraintKind::unilateral && c.C > 0) return c.C / h;
    const bool corrects = settings.method == Stabilizer::baumgarte ||
                          settings.method == Stabilizer::relaxation;
    return corrects ? baumgarte_bias(c.C, c.kind, settings, h) : 0;
}
//! [velocity_bias]

/// C as it will be after a step h with velocities u, to first order: C + h J u [m].
template <int Dof>
Real predicted(const Row<Dof>& row, Real C, const VecX& u, Real h)
{
    Real change = row.Jb.dot(u.template segment<Dof>(Dof * row.b));
    if (row.a != world) change += row.Ja.dot(u.template segment<Dof>(Dof * row.a));
    return C + h * change;
}

/// As many rows as the step has, and the sweeps that the settings allow.
template <int Dof>
void begin_second(const StepData<Dof>& now, const StabilizerSettings& settings,
                  SecondProblem& second)
{
    second.bias.assign(now.rows.size(), 0);
    second.left_out.assign(now.rows.size(), 0);
    second.max_sweeps = settings.correction_sweeps;
    second.tolerance = settings.tolerance;
}

//! [relax]
/// The second problem of relaxation: it takes back the velocity that was only there
/// to correct. The rows keep their u*, and get b = 0, or what is left of a gap.
/// \param now  the rows, as they were solved
/// \param u    velocities of that answer [m/s]
template <int Dof>
void pose_relaxation(const StepData<Dof>& now, const StabilizerSettings& settings,
                     Real h, const VecX& u, SecondProblem& second)
{
    begin_second(now, settings, second);
    for (std::size_t i = 0; i < now.rows.size(); ++i) {
        const Constraint<Dof>& c = now.constraints[i];
        const Row<Dof>& row = now.rows[i];
        second.bias[i] = row.bias;
        // a speed is wanted, or a spring pulls
        if (!has_error(c.kind)) continue;
        if (row.bias < velocity_bias(c, settings, h)) continue;  // it bounces
        const Real C =
            c.kind == ConstraintKind::bilateral ? 0 : predicted(row, c.C, u, h);
        second.bias[i] = std::max(Real{0}, C) / h;
    }
}
//! [relax]

//! [split]
/// The second problem of split impulse, (7.13): pseudo-velocities v that correct
/// the part β of the error that the step will leave, C' = C + h J u. They are found
/// on the same rows, and only ever added to x.
template <int Dof>
void pose_split_impulse(const StepData<Dof>& now,
                        const StabilizerSettings& settings, Real h, const VecX& u,
                        SecondProblem& second)
{
    begin_second(now, settings, second);
    for (std::size_t i = 0; i < now.rows.size(); ++i) {
        const Constraint<Dof>& c = now.constraints[i];
        second.left_out[i] = !has_error(c.kind);
        if (second.left_out[i]) continue;
        const Real C = predicted(now.rows[i], c.C, u, h);
        second.bias[i] = c.kind == ConstraintKind::unilateral && C > 0
                             ? C / h
                             : baumgarte_bias(C, c.kind, settings, h);
    }
}
//! [split]

}  // namespace rigid
