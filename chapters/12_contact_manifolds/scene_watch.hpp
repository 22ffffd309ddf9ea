/// \file scene_watch.hpp
/// What has been changed in a scene since the last step, by any code that may change it: the bodies that this concerns are to
/// be woken.
///
/// A sleeper is not looked at, so nothing in the step itself would notice that the body under it is gone. The watch keeps a
/// copy of all that rest depends on and compares: two passes over numbers in a row, some microseconds for a thousand
/// bodies. Nobody has to call anything when he changes a scene.
#pragma once

#include "chapters/11_rotation/rigid_constraints.hpp"

#include <algorithm>
#include <utility>
#include <vector>

namespace rigid {

inline bool operator==(const PointJoint& a, const PointJoint& b)
{
    return a.measure == b.measure && a.a == b.a && a.b == b.b && a.at_a == b.at_a &&
           a.at_b == b.at_b && a.direction == b.direction && a.gear_a == b.gear_a &&
           a.gear_b == b.gear_b && a.length == b.length && a.sense == b.sense &&
           a.kind == b.kind && a.speed == b.speed && a.force == b.force &&
           a.stiffness == b.stiffness && a.damping == b.damping &&
           a.over_a == b.over_a && a.over_b == b.over_b && a.collides == b.collides;
}

/// Calls changed(k) for both bodies of each joint that is another than it was, gone or new.
/// \param bodies  how many there are now
template <class Joint, class Changed>
void compare_joints(const std::vector<Joint>& was, const std::vector<Joint>& is,
                    Index bodies, const Changed& changed)
{
    for (std::size_t i = 0; i < std::max(was.size(), is.size()); ++i) {
        const bool had = i < was.size(), has = i < is.size();
        if (had && has && was[i] == is[i]) continue;
        for (const Joint* const joint :
             {had ? &was[i] : nullptr, has ? &is[i] : nullptr})
            if (joint)
                for (const Index k : {joint->a, joint->b})
                    if (k != world && k < bodies) changed(k);
    }
}

/// What there is for all bodies of a scene, as it was.
struct Surroundings {
    std::vector<HalfSpace> walls;
    std::vector<Chain> chains;
    Vec2 gravity = {0, 0};

    void remember(const RigidScene& scene)
    {
        gravity = scene.gravity;
        walls = scene.walls;
        chains = scene.chains;
    }

    bool differ(const RigidScene& scene) const;
};

struct SceneWatch {
    using Scene = RigidScene;
    static constexpr bool is_told = false;  ///< it compares
    VecX x, u, inverse_mass;                ///< as the last step left them
    std::vector<Polygon> shapes;
    std::vector<PointJoint> joints;
    Surroundings around;

    /// something was another than it is here
    mutable bool stale = true;

    bool is_new() const { return x.size() == 0; }
    static void require(const RigidScene& scene) { require_bodies(scene); }

    void remember(const RigidScene& scene);

    //! [watch]
    /// What is there for all bodies is another than it was: gravity, a wall.
    bool all_concerned(const RigidScene& scene) const
    {
        const bool concerned = around.differ(scene);
        stale = stale || concerned || scene.bodies.x.size() != x.size();
        return concerned;
    }

    /// Calls changed(k) for each body with another place, velocity, mass or shape,
    /// and for those of each joint that is another. (New bodies are not compared.)
    /// Returns how many it has looked at.
    template <class Changed>
    Index compare(const RigidScene& scene, const Changed& concerns) const
    {
        const auto changed = [&](Index k) {
            stale = true;
            concerns(k);
        };
        const Bodies<3>& bodies = scene.bodies;
        const Index K = std::min(bodies.count(), x.size() / 3);
        for (Index k = 0; k < K; ++k) {
            const auto i = static_cast<std::size_t>(k);
            if (bodies.position(k) != x.segment<3>(3 * k) ||
                bodies.velocity(k) != u.segment<3>(3 * k) ||
                bodies.inverse_mass.segment<3>(3 * k) !=
                    inverse_mass.segment<3>(3 * k) ||
                scene.shapes[i].radius != shapes[i].radius ||
                scene.shapes[i].vertices != shapes[i].vertices)
                changed(k);
        }
        compare_joints(joints, scene.joints, bodies.count(), changed);
        return K + static_cast<Index>(scene.joints.size());
    }
    //! [watch]
};

}  // namespace rigid
