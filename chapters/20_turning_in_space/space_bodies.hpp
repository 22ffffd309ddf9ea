/// \file space_bodies.hpp
/// `Bodies<6>`: the same four vectors, with six numbers to a body.
///
///     x = (position, rotation vector θ)     u = (v in the world's axes, ω in the body's own principal axes)
///     M⁻¹ = diag(1/m, 1/m, 1/m, 1/I₁, 1/I₂, 1/I₃)
///
/// In its own axes a body's inertia is a diagonal that never changes, so every row, solver and island of the book
/// runs as it is. What is left is the way that an angle is added, integrate(): the body turns, and ω is written in
/// the axes that have turned (20.9).
#pragma once

#include "chapters/20_turning_in_space/tumbling.hpp"
#include "common/bodies.hpp"

namespace rigid {

//! [integrate]
/// x ← x + h v, θ ← θ ⊕ hξ, (20.8) and (20.9): the turn is that of the middle of
/// the step, and u is rewritten so that the angular momentum R I ω stays. A body of
/// infinite inertia, whose 1/I is zero, turns by hω and keeps its ω.
template <>
template <class Velocity>
void Bodies<6>::integrate(Index k, const Velocity& v, Real h)
{
    position(k).head<3>() += h * v.template head<3>();
    const Vec3 inverse = inverse_mass.segment<3>(6 * k + 3);
    const Vec3 spin = v.template tail<3>();
    auto theta = x.segment<3>(6 * k + 3);
    if (!(inverse.minCoeff() > 0)) {
        theta = add_rotation(theta, h * spin);
        return;
    }
    const Vec3 inertia = inverse.cwiseInverse();
    const Vec3 turn = turn_through_the_middle(inertia, spin, h);
    theta = add_rotation(theta, turn);
    auto omega = u.segment<3>(6 * k + 3);
    omega = spin_in_turned_axes(inertia, omega, turn);
}
//! [integrate]

/// R of body k at the positions x; that of the world is 1.
inline Mat3 rotation_of(const VecX& x, Index k)
{
    if (k == world) return Mat3::Identity();
    return rotation_matrix(Vec3(x.segment<3>(6 * k + 3)));
}

/// Where the origin of body k's axes is; that of the world is 0.
inline Vec3 centre_of(const VecX& x, Index k)
{
    return k == world ? Vec3(0, 0, 0) : Vec3(x.segment<3>(6 * k));
}

/// (20.1): where a point fixed in body k is.
inline Vec3 point_of_solid(const VecX& x, Index k, const Vec3& at)
{
    return centre_of(x, k) + rotation_of(x, k) * at;
}

//! [world_inertia]
/// (20.6): R I Rᵀ, the inertia of body k in the world's axes [kg m²]; of a body
/// whose inertia is not infinite.
inline Mat3 world_inertia(const Bodies<6>& bodies, Index k)
{
    const Mat3 R = rotation_of(bodies.x, k);
    const Vec3 I = bodies.inverse_mass.segment<3>(6 * k + 3).cwiseInverse();
    return R * I.asDiagonal() * R.transpose();
}
//! [world_inertia]

/// The angular velocity of body k in the world's axes [rad/s]; the world has none.
inline Vec3 world_spin(const Bodies<6>& bodies, Index k)
{
    if (k == world) return {0, 0, 0};
    return rotation_of(bodies.x, k) * bodies.u.segment<3>(6 * k + 3);
}

/// Momentum and, about the origin, angular momentum of the bodies that can move
/// [N s, N m s], (20.5).
Vec<6> momenta(const Bodies<6>& bodies);

/// ½ uᵀ M u of the bodies that can move [J].
Real kinetic_energy(const Bodies<6>& bodies);

}  // namespace rigid
