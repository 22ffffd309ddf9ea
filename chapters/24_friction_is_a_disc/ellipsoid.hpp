/// \file ellipsoid.hpp
/// Where a smooth solid touches a wall: its lowest point, which wanders over it as it rolls.
///
///     r(n) = a − S Sᵀ n / ‖Sᵀ n‖                                                                            (24.11)
#pragma once

#include "chapters/23_faces_that_touch/space_contact.hpp"
#include "chapters/24_friction_is_a_disc/grip.hpp"

namespace rigid {

//! [lowest]
/// (24.11): the point of an ellipsoid that lies farthest against n, all in the
/// body's axes.
inline Vec3 lowest_point(const SolidEllipsoid& e, const Vec3& n)
{
    const Vec3 s = e.stretch.transpose() * n;
    return e.at - e.stretch * s / s.norm();
}
//! [lowest]

/// Its contact with a wall: a point on the wall and a point of the body, with no radius.
SpaceContact touch_of(const SolidWall& wall, const SolidEllipsoid& e,
                      const VecX& x);

/// All contacts of ellipsoids with walls. Their names are below zero: corners have the
/// others.
/// \param looks  bool(Index): whether the step looks at a body
template <class Looks>
void touch_ellipsoids(const RoughSolids& scene, Real margin, const Looks& looks,
                      StepData<6>& now)
{
    Index name = 0;
    for (const SolidEllipsoid& ellipsoid : scene.ellipsoids)
        for (std::size_t w = 0; w < scene.walls.size(); ++w) {
            --name;
            if (!scene.bodies.can_move(ellipsoid.body) || !looks(ellipsoid.body))
                continue;
            const VecX& x = scene.bodies.x;
            SpaceContact contact = touch_of(scene.walls[w], ellipsoid, x);
            const Vec3 p = point_of_solid(x, contact.b, contact.at_b);
            if (!(contact.normal.dot(p - contact.at_a) < margin)) continue;
            contact.feature = name;
            contact.grip = wall_grip(scene, w, static_cast<std::size_t>(contact.b));
            now.contacts.push_back(contact);
        }
}

}  // namespace rigid
