/// \file space_sleep.hpp
/// Solids that rest sleep: chapters 10 and 12 with 6 in place of 2 and 3.
///
///     at rest   ‖(v, ω r)‖ ≤ v_rest,  r = the way from the centroid to the farthest point       (10.7), (25.5)
#pragma once

#include "chapters/12_contact_manifolds/awake_manifolds.hpp"
#include "chapters/25_world_in_space/space_method.hpp"
#include "chapters/25_world_in_space/space_watch.hpp"

namespace rigid {

//! [measured]
/// (25.5): no point of the body is faster than ‖v‖ + ‖ω‖ r. What has no hull has
/// the size that its inertia needs, and ℓ where its mass is infinite.
inline Vec<6> measured_velocity(const SpaceScene& scene, Index k, const Vec<6>& u)
{
    Real r = reach_of(scene.shapes[static_cast<std::size_t>(k)]);
    for (const SolidEllipsoid& e : scene.ellipsoids)
        if (e.body == k) r = std::max(r, e.at.norm() + e.stretch.norm());
    const Vec<6> inverse = scene.bodies.inverse_mass.segment<6>(6 * k);
    for (Index d = 3; d < 6; ++d)  // about axes that it turns about
        if (inverse[d] > 0) r = std::max(r, std::sqrt(inverse[0] / inverse[d]));
    if (!(r > 0)) r = typical_length(scene);
    Vec<6> measured = u;
    measured.tail<3>() *= r;
    return measured;
}
//! [measured]

//! [sleeping]
using AwakeSolids = AwakeStage<TouchingSolids, SpaceWatch>;

/// Solids that touch, and sleep where they are at rest.
using SleepingBoxes = TouchingMethod<ImpulseSolver<6>, AwakeSolids>;
using SleepingCones = TouchingMethod<LevelCones, AwakeSolids>;
//! [sleeping]

}  // namespace rigid
