/// \file world_text.hpp
/// A world as JSON: all that another engine needs to build the same one.
///
///     {"bodies": [{"x": [x, y, θ], "u": [v_x, v_y, ω], "mass": m, "inertia": I, "radius": r, "vertices": [[x, y], …],
///                  "friction": μ, "group": 0}, …],
///      "walls": [[n_x, n_y, offset], …], "friction": μ of the walls,
///      "pins": [{"a": −1 or a body, "b": a body, "at_a": […], "at_b": […], "angle": θ, "limits": [lower, upper],
///                "motor": [speed, torque]}, …],
///      "gravity": […], "touches": true}
///
/// A mass of null: nothing pushes the body. Limits of null: there are none. touches: false where no body can meet another one.
#pragma once

#include "chapters/19_engine/world.hpp"
#include "docs/race/texts.hpp"

#include <stdexcept>
#include <vector>

namespace rigid::race {

/// \param wall_friction  a world tells it of bodies only
inline std::string world_text(const World& world, Real wall_friction)
{
    const std::vector<BodyId> ids = world.bodies();
    std::vector<int> place;
    Listed bodies, walls, pins;
    bool touches = !world.walls().empty();
    for (const BodyId& id : ids) {
        place.resize(std::max<std::size_t>(place.size(), id.place + 1u));
        place[id.place] = static_cast<int>(&id - ids.data());
        const Vec2 at = world.position(id), v = world.velocity(id);
        if (world.shapes(id).size() > 1)
            throw std::invalid_argument("the bodies of the race have one shape each");
        const Polygon& shape = world.shape(id);
        const int group = world.filter(id).group;
        touches = touches || group >= 0 || group != world.filter(ids.front()).group;
        Listed vertices;
        for (const Vec2& p : shape.vertices) vertices.add(list({p.x(), p.y()}));
        bodies.add("{\"x\":" + list({at.x(), at.y(), world.angle(id)}) +
                   ",\"u\":" + list({v.x(), v.y(), world.spin(id)}) + ",\"mass\":" + number(world.mass(id)) +
                   ",\"inertia\":" + number(world.inertia(id)) + ",\"radius\":" + number(shape.radius) +
                   ",\"vertices\":" + vertices.text() + ",\"friction\":" +
                   number(world.surface(id).friction) + ",\"group\":" + std::to_string(group) + '}');
    }
    for (const WallId id : world.walls()) {
        const HalfSpace& wall = world.wall(id);
        walls.add(list({wall.normal.x(), wall.normal.y(), wall.offset}));
    }
    for (const JointId id : world.joints()) {
        const RigidJoint& joint = world.joint(id);
        if (joint.kind != JointKind::revolute)
            throw std::invalid_argument("the scenes of the race have pins alone");
        const BodyId a = world.body_a(id);
        pins.add("{\"a\":" + std::to_string(a ? place[a.place] : -1) +
                 ",\"b\":" + std::to_string(place[world.body_b(id).place]) +
                 ",\"at_a\":" + list({joint.at_a.x(), joint.at_a.y()}) +
                 ",\"at_b\":" + list({joint.at_b.x(), joint.at_b.y()}) + ",\"angle\":" + number(joint.angle) +
                 ",\"limits\":" + list({joint.lower, joint.upper}) +
                 ",\"motor\":" + list({joint.motor.speed, joint.motor.force}) + '}');
    }
    const Vec2 g = world.settings().gravity;
    return "{\"bodies\":" + bodies.text() + ",\"walls\":" + walls.text() +
           ",\"friction\":" + number(wall_friction) + ",\"pins\":" + pins.text() +
           ",\"gravity\":" + list({g.x(), g.y()}) + ",\"touches\":" + (touches ? "true" : "false") + '}';
}

}  // namespace rigid::race
