/// \file peer_bodies.hpp
/// What the adapters of peer_ways.hpp ask a scene: masses, sizes, and which scenes are a tree on the world.
#pragma once

#include "chapters/26_four_ways/reduced_motion.hpp"
#include "chapters/26_four_ways/ways.hpp"
#include "common/elementary.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <vector>

namespace rigid {

inline Real mass_of_body(const JointedScene& scene, Index k)
{
    return 1 / scene.bodies.inverse_mass[3 * k];
}
inline Real inertia_of_body(const JointedScene& scene, Index k)
{
    return 1 / scene.bodies.inverse_mass[3 * k + 2];
}
/// Half its sides in the plane, of a box whose centre is its centroid; what is round at its corners is square here.
inline Vec2 half_sides(const Polygon& shape)
{
    Vec2 half(0, 0);
    for (const Vec2& vertex : shape.vertices)
        half = half.cwiseMax(vertex.cwiseAbs());
    return half + Vec2::Constant(shape.radius);
}
inline bool is_disc(const Polygon& shape) { return shape.vertices.size() == 1; }
inline bool is_capsule(const Polygon& shape) { return shape.vertices.size() == 2; }

/// No engine knows a rod without thickness: it gets this radius, and the walls stand back by as much [m].
inline constexpr Real thin = 1e-4;
inline Real radius_of(const Polygon& shape)
{
    return is_capsule(shape) && shape.radius == 0 ? thin : shape.radius;
}
inline Real length_of(const Polygon& capsule)
{
    return (capsule.vertices[1] - capsule.vertices[0]).norm();
}
inline Real stands_back(const JointedScene& scene)
{
    const bool any = std::any_of(scene.shapes.begin(), scene.shapes.end(),
                                 [](const Polygon& shape) {
                                     return is_capsule(shape) && shape.radius == 0;
                                 });
    return any ? thin : 0;
}

/// Chains of joints alone meet nothing; what is joined meets walls alone, what is not each other too.
inline bool meets_something(const JointedScene& scene)
{
    return scene.placed.empty() || !scene.walls.empty();
}
inline bool meet_each_other(const JointedScene& scene)
{
    return scene.placed.empty();
}
inline bool is_limited(const RigidJoint& joint)
{
    return joint.lower > -infinity || joint.upper < infinity;
}

/// Revolute joints from the world, no loop, no contact.
inline bool is_tree_of_pins(const WayScene& way)
{
    return way.name == "pendulum" || way.name == "double pendulum" ||
           way.name == "heavy chain";
}

/// The joints of a scene as a tree on the world, its coordinates and their rates, and the pins that close loops. None where there
/// are no joints.
struct HangingBodies {
    std::vector<ReducedLink> links;  ///< parents first
    VecX q, dq;
    std::vector<RigidJoint> loops;

    explicit HangingBodies(const JointedScene& scene)
    {
        if (scene.placed.empty()) return;
        const ReducedMotion motion(scene);
        links = links_of(split_loops(scene).tree);
        q = motion.q(), dq = motion.dq();
        for (const PlacedJoint& placed : scene.placed)
            if (std::none_of(links.begin(), links.end(),
                             [&](const ReducedLink& link) {
                                 return link.joint.a == placed.joint.a &&
                                        link.joint.b == placed.joint.b;
                             }))
                loops.push_back(placed.joint);
    }
};

}  // namespace rigid
