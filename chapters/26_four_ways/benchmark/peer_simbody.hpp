/// \file peer_simbody.hpp
/// A scene of the ways in Simbody: coordinates of joints, by its Runge-Kutta-Merson integrator of order four with the step given, else
/// its own defaults. Joints alone: its contacts are elastic.
#pragma once

#include "chapters/26_four_ways/benchmark/peer_bodies.hpp"
#include "tests/peers/simbody_world.hpp"

namespace rigid {

/// Revolute and prismatic joints; one that closes a loop keeps its point by two constraints.
class SimbodyWays {
public:
    static constexpr const char* name = "Simbody";

    explicit SimbodyWays(const WayScene& way) : world_(world_of(way.scene)) {}

    static bool can_take(const WayScene& way)
    {
        return !meets_something(way.scene);
    }
    void step(Real h) { world_.step(h); }
    void read(JointedScene& scene) const
    {
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const std::array<double, 6> s = world_.state(static_cast<int>(k));
            scene.bodies.position(k) << s[0], s[1], s[2];
            scene.bodies.velocity(k) << s[3], s[4], s[5];
        }
    }

private:
    static std::array<double, 2> plain(const Vec2& p) { return {p.x(), p.y()}; }
    static SimbodyWorld world_of(const JointedScene& scene)
    {
        const HangingBodies hangs(scene);
        std::vector<SimbodyLink> links;
        for (std::size_t i = 0; i < hangs.links.size(); ++i) {
            const RigidJoint& joint = hangs.links[i].joint;
            SimbodyLink link;
            link.body = static_cast<int>(joint.b);
            link.parent = joint.a == world ? -1 : static_cast<int>(joint.a);
            link.mass = mass_of_body(scene, joint.b);
            link.inertia = inertia_of_body(scene, joint.b);
            link.slides = joint.kind == JointKind::prismatic;
            link.at_parent = plain(joint.at_a), link.at = plain(joint.at_b);
            link.angle = joint.angle;
            link.along = atan2(joint.axis.y(), joint.axis.x());
            link.q = hangs.q[static_cast<Index>(i)];
            link.dq = hangs.dq[static_cast<Index>(i)];
            links.push_back(link);
        }
        std::vector<SimbodyLoop> loops;
        for (const RigidJoint& loop : hangs.loops)
            loops.push_back({static_cast<int>(loop.a), static_cast<int>(loop.b),
                             plain(loop.at_a), plain(loop.at_b)});
        return {links, loops, plain(scene.gravity)};
    }

    SimbodyWorld world_;
};

}  // namespace rigid
