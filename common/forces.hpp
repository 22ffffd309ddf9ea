/// \file forces.hpp
/// Forces that scenes share: weight, torsional springs, and the hand that pulls.
/// Each function ADDS to `bodies.f`; clear it first.
#pragma once

#include "common/bodies.hpp"
#include "common/elementary.hpp"
#include "common/shapes.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

/// Throws std::invalid_argument, naming the setting and its value, unless what the forces of a step depend on is finite.
inline void require_forces(const Vec2& gravity, Real stiffness, Real damping, const Vec2& hand)
{
    const auto require_number = [](const char* name, Real value) {
        if (!std::isfinite(value))
            throw std::invalid_argument(std::string(name) + " is " + shortest(value) + "; it must be finite");
    };
    if (!gravity.allFinite()) throw std::invalid_argument("gravity is not finite");
    require_number("the stiffness of the bends", stiffness);
    require_number("the damping of the bends", damping);
    require_number("the x of the hand", hand.x());
    require_number("the y of the hand", hand.y());
}

/// Throws std::invalid_argument unless the margin within which contacts get their rows makes sense.
inline void require_margin(Real margin)
{
    if (!(margin >= 0))
        throw std::invalid_argument("the margin of contacts is " + shortest(margin) +
                                    "; it must be zero or positive");
}

/// Adds the weight \f$m g\f$ of each body that can move.
/// \param gravity  [m/s²]
inline void add_gravity(Bodies<2>& bodies, const Vec2& gravity)
{
    for (Index k = 0; k < bodies.count(); ++k) {
        const Real inverse_mass = bodies.inverse_mass[2 * k];
        if (inverse_mass > 0) bodies.force(k) += gravity / inverse_mass;
    }
}

/// The bend angle φ of three discs [rad], positive when the second link is turned
/// counterclockwise against the first; zero = straight.
inline Real bend_angle(const VecX& x, const Bend& bend)
{
    const Vec2 first = x.segment<2>(2 * bend.middle) - x.segment<2>(2 * bend.left);
    const Vec2 second = x.segment<2>(2 * bend.right) - x.segment<2>(2 * bend.middle);
    return atan2(cross2(first, second), first.dot(second));
}

/// Adds the torsional springs and dampers of a chain.
///
/// The torque on a joint is \f$\tau = -L F\f$ with \f$F = 10\, g\, k\, m \sin\varphi\f$ (held at its
/// greatest beyond 90°), plus a damper on \f$\dot\varphi\f$. It acts as a force of size
/// \f$\lvert\tau\rvert / \lvert d\rvert\f$ across each link on the neighbour at its end, the opposite sum on
/// the disc in the middle, so that linear and angular momentum balance whatever the link lengths.
/// \param stiffness  k, a pure number
/// \param damping    [1/s]; the damper's torque is damping·m·L²·dφ/dt
/// \param weight     g [m/s²], the size of gravity that the spring is measured in
inline void add_bend_springs(Bodies<2>& bodies, std::span<const Bend> bends, Real stiffness, Real damping,
                             Real weight = 9.81)
{
    for (const Bend& bend : bends) {
        const Vec2 first = bodies.position(bend.middle) - bodies.position(bend.left);
        const Vec2 second = bodies.position(bend.right) - bodies.position(bend.middle);
        const Real first2 = first.squaredNorm();
        const Real second2 = second.squaredNorm();
        const Real inverse_mass = bodies.inverse_mass[2 * bend.middle];
        if (first2 == 0 || second2 == 0 || inverse_mass == 0) continue;  // no angle, no torque

        const Real mass = 1 / inverse_mass;
        const Real angle = atan2(cross2(first, second), first.dot(second));
        const Real sine = sin(std::clamp(angle, -pi / 2, pi / 2));
        const Vec2 first_u = bodies.velocity(bend.middle) - bodies.velocity(bend.left);
        const Vec2 second_u = bodies.velocity(bend.right) - bodies.velocity(bend.middle);
        const Real rate = cross2(second, second_u) / second2 - cross2(first, first_u) / first2;

        const Real torque = -(10 * weight * stiffness * mass * sine * bend.length +
                              damping * mass * bend.length * bend.length * rate);
        const Vec2 on_right = perpendicular(second) * (torque / second2);
        const Vec2 on_left = perpendicular(first) * (torque / first2);
        bodies.force(bend.left) += on_left;
        bodies.force(bend.right) += on_right;
        bodies.force(bend.middle) -= on_left + on_right;
    }
}

inline void add_bend_springs(Bodies<2>& bodies, const std::vector<Bend>& bends, Real stiffness, Real damping,
                             Real weight = 9.81)
{
    add_bend_springs(bodies, std::span<const Bend>(bends), stiffness, damping, weight);
}

/// Adds the force of a hand that pulls body k towards a point: a critically damped spring with
/// the frequency rate, so that a heavy body follows as readily as a light one.
/// \param rate  [rad/s]; stable under symplectic Euler while rate·h is below about 0.8
inline void add_pull(Bodies<2>& bodies, Index k, const Vec2& towards, Real rate = 20)
{
    const Real inverse_mass = bodies.inverse_mass[2 * k];
    if (inverse_mass == 0) return;
    bodies.force(k) +=
        (rate * rate * (towards - bodies.position(k)) - 2 * rate * bodies.velocity(k)) / inverse_mass;
}

}  // namespace rigid
