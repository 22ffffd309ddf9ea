/// \file grip.hpp
/// What two surfaces hold each other with, from what each is like: μ = √(μ_a μ_b), of two arms the longer one, as in
/// chapter 13. Arms are the bodies' alone: a wall has none.
#pragma once

#include "chapters/24_friction_is_a_disc/rough_solids.hpp"

namespace rigid {

/// √(μ_a μ_b), also where the product has no place among the numbers; where there is no list, nothing has friction.
inline Real both_rough(const std::vector<Real>& of_a, std::size_t a,
                       const std::vector<Real>& of_b, std::size_t b)
{
    if (of_a.empty() || of_b.empty()) return 0;
    const Real product = of_a[a] * of_b[b];
    return product > 0 && std::isfinite(product)
               ? std::sqrt(product)
               : std::sqrt(of_a[a]) * std::sqrt(of_b[b]);
}

inline Real longer_arm(const std::vector<Real>& arms, std::size_t a, std::size_t b)
{
    return arms.empty() ? 0 : std::max(arms[a], arms[b]);
}

/// Of two bodies.
inline Grip grip_of(const RoughSolids& scene, std::size_t a, std::size_t b)
{
    return {both_rough(scene.friction, a, scene.friction, b),
            longer_arm(scene.rolling, a, b), longer_arm(scene.spinning, a, b)};
}

/// Of a wall and a body.
inline Grip wall_grip(const RoughSolids& scene, std::size_t wall, std::size_t body)
{
    return {both_rough(scene.wall_friction, wall, scene.friction, body),
            longer_arm(scene.rolling, body, body),
            longer_arm(scene.spinning, body, body)};
}

}  // namespace rigid
