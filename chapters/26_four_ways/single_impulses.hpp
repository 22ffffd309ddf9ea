/// \file single_impulses.hpp
/// Impulses one at a time: bodies fly, and where two meet first they get the impulse of their one contact.
///
///     fly to the first contact in time;  λ of this contact alone, with friction;  fly on
///
/// (26.6). What would rest bounces: an approach below v_m = √(2 g δ) leaves with v_m, a hop of the height δ, a
/// microcollision. Nothing is solved together, so nothing needs a matrix; joints, which never part, cannot be said this way.
/// \cite hahn1988 \cite mirtich1996thesis
#pragma once

#include "chapters/26_four_ways/push_joints.hpp"

namespace rigid {

struct SingleImpulseSettings {
    Real hop = 1e-4;               ///< δ, the height of a microcollision [ℓ]
    int most_collisions = 100000;  ///< in a step
};

/// Throws std::invalid_argument, naming the setting and its value, unless both make sense.
void require_valid(const SingleImpulseSettings& settings);

struct OneImpulse {
    Real n = 0, t = 0;  ///< along the normal and along t [N s]
};

//! [one_contact]
/// The impulses of one contact with friction that bring its normal velocity to v.
/// \param A     of its rows n and t [1/kg]
/// \param u     its velocities v_n, v_t before [m/s]
/// \param v     wanted, at least u.n
/// \throws std::invalid_argument  for a contact that nothing can move, a μ below zero, and what is not finite
inline OneImpulse one_contact(const Eigen::Matrix<Real, 2, 2>& A,
                              const OneImpulse& u, Real mu, Real v)
{
    require_positive({{"A_nn", A(0, 0)}});
    require_not_negative({{"μ", mu}, {"what the contact has to gain", v - u.n}});
    if (!A.allFinite() || !std::isfinite(u.t))
        throw std::invalid_argument("a contact's A or its v_t is not finite");
    const Real lift = v - u.n;
    if (!(mu > 0)) return {lift / A(0, 0), 0};
    // sticks: both rows at once
    const Real det = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
    if (det > 1e-14 * A(0, 0) * A(1, 1)) {
        const OneImpulse both{(A(1, 1) * lift + A(0, 1) * u.t) / det,
                              (-A(1, 0) * lift - A(0, 0) * u.t) / det};
        if (both.n >= 0 && std::abs(both.t) <= mu * both.n) return both;
    }
    // slides: λ_t = −μ λ_n against what is left of v_t
    for (const Real sign : {1.0, -1.0}) {
        const Real reach = A(0, 0) - sign * mu * A(0, 1);
        if (!(reach > 0)) continue;
        const Real n = lift / reach, t = -sign * mu * n;
        if (sign * (u.t + A(1, 0) * n + A(1, 1) * t) >= 0) return {n, t};
    }
    return {lift / A(0, 0), 0};
}
//! [one_contact]

class SingleImpulses {
public:
    SingleImpulseSettings settings;
    CollisionFilter filter;
    std::int64_t collisions = 0, micro = 0;  ///< so far

    /// Advances by h seconds. `iteration limit` where more collisions than allowed came first; the scene then stands at the
    /// time of the last one.
    /// \throws std::invalid_argument  for settings, a step or a scene that make no sense, and for joints
    Status advance(JointedScene& scene, Real h);

    /// What advance() asks of settings and scene. \throws std::invalid_argument  as it does
    void require_valid(const JointedScene& scene) const;

private:
    std::vector<PushJoint> near_;
};

}  // namespace rigid
