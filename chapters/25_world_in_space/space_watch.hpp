/// \file space_watch.hpp
/// What has been changed in a scene in space since the last step: chapter 12's watch, for what there is here.
#pragma once

#include "chapters/12_contact_manifolds/scene_watch.hpp"
#include "chapters/25_world_in_space/space_scene.hpp"

#include <algorithm>
#include <utility>

namespace rigid {

inline bool operator==(const SpaceJoint& p, const SpaceJoint& q)
{
    return p.a == q.a && p.b == q.b && p.at_a == q.at_a && p.at_b == q.at_b &&
           p.frame_a == q.frame_a && p.frame_b == q.frame_b && p.lo == q.lo &&
           p.hi == q.hi && p.motor == q.motor && p.speed == q.speed &&
           p.force == q.force;
}
inline bool operator==(const SolidWall& p, const SolidWall& q)
{
    return p.normal == q.normal && p.offset == q.offset;
}
inline bool operator==(const SolidEllipsoid& p, const SolidEllipsoid& q)
{
    return p.body == q.body && p.at == q.at && p.stretch == q.stretch;
}

//! [space_watch]
struct SpaceWatch {
    using Scene = SpaceScene;
    static constexpr bool is_told = false;  ///< it compares
    VecX x;                                 ///< as the last step left it
    std::vector<SpaceJoint> joints;
    SpaceScene seen;            ///< the rest of the scene
    mutable bool stale = true;  ///< something was another than it is here

    bool is_new() const { return x.size() == 0; }
    static void require(const SpaceScene& scene) { require_bodies(scene); }

    void remember(const SpaceScene& scene)
    {
        x = scene.bodies.x;
        seen.bodies.u = scene.bodies.u;
        if (!std::exchange(stale, false)) return;
        joints = scene.joints;
        seen = scene;
    }

    /// What is there for all bodies is another than it was: gravity, a wall, what
    /// it holds with.
    bool all_concerned(const SpaceScene& scene) const
    {
        const bool concerned = scene.gravity != seen.gravity ||
                               scene.walls != seen.walls ||
                               scene.meshes != seen.meshes ||
                               scene.mesh_friction != seen.mesh_friction ||
                               scene.ellipsoids != seen.ellipsoids ||
                               scene.wall_friction != seen.wall_friction;
        stale = stale || concerned || scene.bodies.x.size() != x.size();
        return concerned;
    }

    /// Calls changed(k) for each body with another place, velocity, mass, shape
    /// or surface,
    /// and for those of each joint that is another. (New bodies are not compared.)
    /// Returns how many it has looked at.
    template <class Changed>
    Index compare(const SpaceScene& scene, const Changed& concerns) const
    {
        const auto changed = [&](Index k) {
            stale = true;
            concerns(k);
        };
        const Bodies<6>&is = scene.bodies, &was = seen.bodies;
        for (Index k = 0; k < std::min(is.count(), x.size() / 6); ++k) {
            const auto i = static_cast<std::size_t>(k);
            if (is.position(k) != x.segment<6>(6 * k) ||
                is.velocity(k) != was.velocity(k) ||
                is.inverse_mass.segment<6>(6 * k) !=
                    was.inverse_mass.segment<6>(6 * k) ||
                scene.shapes[i] != seen.shapes[i] ||
                grip(scene, i) != grip(seen, i))
                changed(k);
        }
        compare_joints(joints, scene.joints, is.count(), changed);
        return is.count() + static_cast<Index>(scene.joints.size());
    }

private:
    /// What the surface of body i holds with.
    static std::array<Real, 3> grip(const SpaceScene& scene, std::size_t i)
    {
        const auto of = [i](const std::vector<Real>& list) {
            return i < list.size() ? list[i] : 0;
        };
        return {of(scene.friction), of(scene.rolling), of(scene.spinning)};
    }
};
//! [space_watch]

}  // namespace rigid
