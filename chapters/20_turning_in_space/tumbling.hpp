/// \file tumbling.hpp
/// What a body does that nothing pushes: Euler's equations in its own principal axes, and three ways to step them.
///
///     I ω′ + ω × I ω = 0                                     (20.7)
///     explicit     I ω₁ = I ω₀ − h ω₀ × I ω₀                 (20.19)   energy grows in every step
///     implicit     I ω₁ = I ω₀ − h ω₁ × I ω₁                 (20.20)   energy shrinks
///     the middle   exp(hξ/2) I ξ = I ω₀,  I ω₁ = exp(−hξ) I ω₀   (20.8)   angular momentum is kept, order two
///
/// ω in the body's axes, I the three principal moments: a vector, because in these axes the matrix is a diagonal.
#pragma once

#include "chapters/20_turning_in_space/rotation.hpp"

namespace rigid {

//! [explicit]
/// (20.19): ω × Iω of the beginning of the step.
inline Vec3 explicit_spin(const Vec3& inertia, const Vec3& omega, Real h)
{
    const Vec3 L = inertia.cwiseProduct(omega);
    return omega - h * cross(omega, L).cwiseQuotient(inertia);
}
//! [explicit]

//! [implicit]
/// (20.20), solved: one root x of (20.21), which is between −‖L₀‖ and ‖L₀‖, by
/// Newton's method; where a step does not halve g, the bracket is halved instead.
/// \param inertia  positive and finite, in any order
inline Vec3 implicit_spin(const Vec3& inertia, const Vec3& omega, Real h)
{
    const Vec3 L0 = inertia.cwiseProduct(omega);
    Index i = 0;
    inertia.minCoeff(&i);
    const Index j = (i + 1) % 3, k = (i + 2) % 3;
    const Vec3 less = h * inertia.cwiseInverse();
    const Real ai = less[j] - less[k], aj = less[k] - less[i],
               ak = less[i] - less[j];
    Real lo = -L0.norm(), hi = -lo, x = L0[i], last = infinity;
    Vec3 L = L0;
    for (int round = 0; round < 200; ++round) {
        const Real det = 1 - aj * ak * x * x;  // at least 1
        L[i] = x;
        L[j] = (L0[j] - aj * x * L0[k]) / det;
        L[k] = (L0[k] - ak * x * L0[j]) / det;
        const Real g = x + ai * L[j] * L[k] - L0[i];
        const Real slope_j = (2 * aj * ak * x * L[j] - aj * L0[k]) / det,
                   slope_k = (2 * aj * ak * x * L[k] - ak * L0[j]) / det;
        const Real slope = 1 + ai * (slope_j * L[k] + L[j] * slope_k);
        (g < 0 ? lo : hi) = x;
        Real next = x - g / slope;
        if (!(next >= lo && next <= hi) || !(std::abs(g) <= last / 2))
            next = lo + (hi - lo) / 2;
        if (g == 0 || !(std::abs(next - x) > 1e-16 * L0.norm())) break;
        last = std::abs(g), x = next;
    }
    return L.cwiseQuotient(inertia);
}
//! [implicit]

//! [middle]
/// (20.8): the turn hξ of one step, from the angular momentum at its beginning, by
/// Newton's method (20.23). Where the body turns by radians in a step and Newton's
/// method finds no root in eight rounds, the turn is another one, and may be many
/// times as long, but it is a number; L is kept all the same.
inline Vec3 turn_through_the_middle(const Vec3& inertia, const Vec3& omega, Real h)
{
    const Vec3 L = inertia.cwiseProduct(omega);
    const Mat3 I = inertia.asDiagonal();
    Vec3 xi = omega;
    if ((cross(omega, L).array() == 0).all()) return h * xi;  // about an axis
    for (int round = 0; round < 8; ++round) {
        const Vec3 half = h / 2 * xi;  // by this the axes have turned in the middle
        const Vec3 middle = rotation_matrix(half).transpose() * L;
        const Mat3 H = cross_matrix(half);
        const Mat3 J = I - h / 2 * cross_matrix(middle) *
                               (Mat3::Identity() - H / 2 + H * H / 6);
        const Vec3 change = solve3(J, inertia.cwiseProduct(xi) - middle);
        if (!std::isfinite((xi - change).squaredNorm())) break;  // J is singular
        xi -= change;
        if (!(change.squaredNorm() > 1e-30 * xi.squaredNorm())) break;
    }
    return h * xi;
}

/// What ω becomes when the axes turn by δ and the angular momentum stays where it
/// is.
inline Vec3 spin_in_turned_axes(const Vec3& inertia, const Vec3& omega,
                                const Vec3& delta)
{
    const Vec3 L = inertia.cwiseProduct(omega);
    return (rotation_matrix(delta).transpose() * L).cwiseQuotient(inertia);
}
//! [middle]

/// The three ways, and the first of them with the angular momentum put right afterwards.
enum class Tumbling { explicit_term, implicit_term, momentum_kept, middle };

/// One step of a free body: its rotation θ, and ω in its axes.
void tumble(Tumbling way, const Vec3& inertia, Real h, Vec3& theta, Vec3& omega);

}  // namespace rigid
