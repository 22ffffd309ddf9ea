/// \file softness.hpp
/// A spring that can't explode: stiffness and damping become the γ and the bias of a row.
///
///     v' = (v − h ω² x) / (1 + 2ζhω + h²ω²),   x' = x + h v'                     (16.4)
///     w = J u + b + γ λ = 0,   b = C ω/(2ζ + hω),   γ = A/(hω (2ζ + hω))         (16.8), A = J M⁻¹ Jᵀ
///
/// The force of the spring is taken at the end of the step, so no h and no ω makes it unstable. Limits: ω → ∞ is a hard row
/// that takes back the whole error, b = C/h, γ = 0; ζ → ∞ a hard row that forgets it, b = 0, γ = 0; ω → 0 no row at all.
/// γ has the unit of an inverse mass [1/kg], for an angle [1/(kg m²)]. \cite catto2011
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "common/text.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <string_view>

namespace rigid {

//! [softness]
/// How soft a row is, whatever the masses at its ends.
struct Softness {
    /// ω/2π of the spring [Hz]; infinite = hard
    Real frequency = infinity;
    /// ζ: 1 = back as fast as it can be without swinging over; 0 = no damping
    Real damping_ratio = 1;
};

/// What a row gets for it.
struct SoftTerms {
    Real rate = 0;      ///< b = rate · C [1/s]
    Real softness = 0;  ///< γ [1/kg]
};

/// (16.8). An infinite frequency needs no special case.
/// \param A  J M⁻¹ Jᵀ of the row, without any γ [1/kg]
/// \param h  time step [s]
inline SoftTerms soft_terms(const Softness& how, Real A, Real h)
{
    const Real omega = 2 * pi * how.frequency, zeta = how.damping_ratio;
    return {1 / (2 * zeta / omega + h), A / (h * omega * (2 * zeta + h * omega))};
}
//! [softness]

/// Throws std::invalid_argument, naming the value, unless it makes sense.
/// \param name  of what is soft: "contacts"
void require_valid(const Softness& how, std::string_view name);

//! [spring]
/// The same spring by its stiffness k [N/m] and damping c [N s/m].
struct SpringConstants {
    Real stiffness = 0, damping = 0;
};

/// (16.2): k = m ω², c = 2 ζ m ω with the effective mass m = 1/A of its row. A hard
/// row is a spring of k = ∞; what damps it makes no difference.
inline SpringConstants spring_of(const Softness& how, Real A)
{
    if (how.frequency == infinity) return {infinity, 0};
    const Real omega = 2 * pi * how.frequency;
    return {omega * omega / A, 2 * how.damping_ratio * omega / A};
}

/// The other way round: what a spring of k > 0 and c is to its row.
inline Softness softness_of(const SpringConstants& spring, Real A)
{
    if (spring.stiffness == infinity) return {};
    const Real omega = std::sqrt(spring.stiffness * A);
    return {omega / (2 * pi), spring.damping * A / (2 * omega)};
}

/// (16.6): the terms of a spring by k and c, in which no mass occurs; for k → ∞ those
/// of a hard row.
inline SoftTerms soft_terms(const SpringConstants& spring, Real h)
{
    if (spring.stiffness == infinity) return {1 / h, 0};
    const Real whole = h * spring.stiffness + spring.damping;
    return {spring.stiffness / whole, 1 / (h * whole)};
}
//! [spring]

//! [scales]
/// (16.13): the answer of one soft row in the form that engines use. λ changes by
/// −mass_scale (J u + b)/A − impulse_scale λ.
struct SoftScales {
    Real mass = 1, impulse = 0;  ///< pure numbers; they add up to 1
};
inline SoftScales soft_scales(const Softness& how, Real h)
{
    const Real omega = 2 * pi * how.frequency;
    const Real gamma = 1 / (h * omega * (2 * how.damping_ratio + h * omega));
    return {1 / (1 + gamma), gamma / (1 + gamma)};
}
//! [scales]

//! [oscillator]
/// (16.4): one implicit step of a single mass on a spring; for ω → ∞ it goes to the
/// rest.
/// \param x  out of its rest [m]
/// \return   its velocity after the step [m/s]; then x grows by h times that
inline Real implicit_velocity(Real x, Real v, const Softness& how, Real h)
{
    if (how.frequency == infinity) return -x / h;
    const Real omega = 2 * pi * how.frequency;
    if (!(omega < infinity)) return -x / h;  // hard: at rest after the step
    return (v - h * omega * omega * x) /
           (1 + 2 * how.damping_ratio * h * omega + h * h * omega * omega);
}
//! [oscillator]

//! [soften]
/// Makes a row soft, with C of its constraint.
/// \param most  the speed at which it corrects, at most [m/s]
template <int Dof>
void soften(const SoftTerms& terms, Real C, Real most, Row<Dof>& row)
{
    row.bias = std::clamp(terms.rate * C, -most, most);
    row.softness = terms.softness;
}
//! [soften]

}  // namespace rigid
