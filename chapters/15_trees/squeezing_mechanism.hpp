/// \file squeezing_mechanism.hpp
/// Andrews' squeezing mechanism: seven bodies, three loops, one degree of freedom, and a motion whose end is published to
/// many digits.
///
///     K1 crank at the origin · K2 on its end · K3, K4, K6 on the other end of K2 · K5, K7 on a pivot, joined to K4, K6
///
/// A constant torque drives the crank, a spring pulls K3 to a fixed point. Lengths, masses and the start are those of the
/// literature, digit by digit as public test sets have them. \cite schiehlen1990 \cite hairer1996 \cite mazzia2008
#pragma once

#include "chapters/14_joints/placed_joints.hpp"
#include "common/elementary.hpp"

#include <array>

namespace rigid {

//! [squeezer]
struct SqueezingMechanism {
    /// β, Θ, γ, Φ, δ, Ω, ε at the start [rad]
    static constexpr std::array<Real, 7> start = {
        -0.0617138900142764496, 0,
        0.455279819163070380,   0.222668390165885885,
        0.487364979543842550,   -0.222668390165885885,
        1.23054744454982119};
    static constexpr Real torque = 0.033;                      ///< [N m]
    static constexpr Real stiffness = 4530, length = 0.07785;  ///< [N/m, m]
    Vec2 A{-0.06934, -0.00227}, B{-0.03635, 0.03273}, C{0.014, 0.072};

    JointedScene scene;

    SqueezingMechanism()
    {
        scene.gravity = {0, 0};
        const auto [beta, theta, gamma, phi, delta, omega, epsilon] = start;
        const auto along = [](Real angle) { return Vec2(cos(angle), sin(angle)); };
        const auto left = [](Real angle) { return Vec2(-sin(angle), cos(angle)); };
        const Vec2 crank_end = 0.007 * along(beta);
        const Vec2 meeting = crank_end - 0.028 * along(beta + theta);
        const Vec2 knee4 = A + 0.04 * along(delta),
                   knee6 = A - 0.04 * left(epsilon);
        const auto body = [&](const Vec2& at, Real angle, Real mass, Real inertia) {
            return add_body(scene, disc(0.003), Mass{mass, {0, 0}, inertia}, at,
                            angle);
        };
        const Index k1 = body(0.00092 * along(beta), beta, 0.04325, 2.194e-6);
        const Index k2 = body(crank_end - 0.0115 * along(beta + theta),
                              beta + theta, 0.00365, 4.410e-7);
        const Index k3 = body(B - 0.01874 * left(gamma) + 0.01043 * along(gamma),
                              gamma, 0.02373, 5.255e-6);
        const Index k4 = body(knee4 - (0.02 - 0.01421) * left(phi + delta),
                              phi + delta, 0.00706, 5.667e-7);
        const Index k5 = body(A + 0.02308 * along(delta) + 0.00916 * left(delta),
                              delta, 0.07050, 1.169e-5);
        const Index k6 = body(knee6 + (0.02 - 0.01421) * along(omega + epsilon),
                              omega + epsilon, 0.00706, 5.667e-7);
        const Index k7 =
            body(A - 0.01228 * left(epsilon) - 0.00449 * along(epsilon), epsilon,
                 0.05498, 1.912e-5);
        const auto pin = [&](Index a, Index b, const Vec2& at) {
            add_joint(scene, joint_at(scene, JointKind::revolute, a, b, at));
        };
        pin(world, k1, {0, 0});
        pin(k1, k2, crank_end);
        pin(world, k3, B);
        pin(k2, k3, meeting);
        pin(k2, k4, meeting);
        pin(k4, k5, knee4);
        pin(world, k5, A);
        pin(k2, k6, meeting);
        pin(k6, k7, knee6);
        pin(world, k7, A);
        hook_ =
            local_point(scene, k3, B + 0.02 * along(gamma) - 0.018 * left(gamma));
    }

    /// M⁻¹ f of the torque and the spring.
    VecX accelerations(const VecX& x) const
    {
        VecX a = VecX::Zero(x.size());
        a[2] = torque * scene.bodies.inverse_mass[2];
        const Vec2 d = C - point_of(x, 2, hook_);
        const Vec2 pull = stiffness * (d.norm() - length) / d.norm() * d;
        const Vec2 arm = point_of(x, 2, hook_) - x.segment<2>(6);
        a.segment<3>(6) << pull, cross2(arm, pull);
        a.segment<3>(6) = a.segment<3>(6)
                              .cwiseProduct(scene.bodies.inverse_mass.segment<3>(6))
                              .eval();
        return a;
    }

    /// β, Θ, γ, Φ, δ, Ω, ε of the bodies [rad].
    static std::array<Real, 7> angles(const VecX& x)
    {
        return {x[2],  x[5] - x[2],   x[8], x[11] - x[14],
                x[14], x[17] - x[20], x[20]};
    }

private:
    Vec2 hook_ = {0, 0};  ///< where the spring is, in K3
};
//! [squeezer]

}  // namespace rigid
