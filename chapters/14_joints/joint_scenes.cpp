// The functions of joint_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/14_joints/joint_scenes.hpp"

namespace rigid {

//! [chain]
JointedScene chain_scene(const ChainShape& shape)
{
    if (shape.links < 1)
        throw std::invalid_argument("the chain has " + std::to_string(shape.links) +
                                    " links; it needs one or more");
    JointedScene scene;
    const Real L = shape.length;
    const Vec2 along(sin(shape.angle), -cos(shape.angle));
    RigidJoint pin;
    for (int k = 0; k < shape.links; ++k) {
        pin.a = k - 1;
        pin.b = add_body(scene, capsule(L, 0), thin_rod(L, shape.mass),
                         (k + 0.5) * L * along, shape.angle - pi / 2);
        pin.at_a = k == 0 ? Vec2(0, 0) : Vec2(L / 2, 0);
        pin.at_b = {-L / 2, 0};
        add_joint(scene, pin);
    }
    const Real weight = shape.ratio * shape.mass;
    pin.a = pin.b;
    pin.b = add_body(scene, disc(L), Mass{weight, {0, 0}, weight * L * L / 2},
                     (shape.links + 1) * L * along, shape.angle);
    pin.at_a = {L / 2, 0};
    pin.at_b = {0, L};
    add_joint(scene, pin);
    return scene;
}
//! [chain]

JointedScene catenary_scene(int rods)
{
    if (rods < 2)
        throw std::invalid_argument("the catenary has " + std::to_string(rods) +
                                    " rods; it needs two or more");
    JointedScene scene;
    const Real L = 1.25 / rods,
               level = rods % 2 * L;  // the middle one of an odd row
    const Real run = (1 - level) / 2, side = (1.25 - level) / 2,
               sag = std::sqrt(side * side - run * run);
    const Vec2 down = Vec2(run, -sag).normalized(), up(down.x(), -down.y());
    Vec2 end(0, 0);
    RigidJoint pin;
    for (int k = 0; k < rods; ++k) {
        const Vec2 along = 2 * k + 1 == rods ? Vec2(1, 0)
                           : 2 * k < rods    ? down
                                             : up;
        pin.a = k - 1;
        pin.b = add_body(scene, capsule(L, 0), thin_rod(L, 1.0 / rods),
                         end + L / 2 * along, atan2(along.y(), along.x()));
        pin.at_a = k == 0 ? Vec2(0, 0) : Vec2(L / 2, 0);
        pin.at_b = {-L / 2, 0};
        add_joint(scene, pin);
        end += L * along;
    }
    RigidJoint last;
    last.b = pin.b;
    last.at_a = {1, 0};
    last.at_b = {L / 2, 0};
    add_joint(scene, last);
    return scene;
}

JointedScene atwood_scene(Real left, Real right)
{
    JointedScene scene;
    const Real r = 0.5;
    const Index wheel =
        add_body(scene, disc(r), Mass{1, {0, 0}, r * r / 2}, {0, 0});
    RigidJoint axle;
    axle.b = wheel;
    add_joint(scene, axle);
    for (const Real side : {-1.0, 1.0}) {
        const Real m = side < 0 ? left : right;
        RigidJoint rope;
        rope.kind = JointKind::rack;
        rope.a = wheel;
        rope.b = add_body(scene, box(0.3, 0.3), Mass{m, {0, 0}, m * 0.015},
                          {side * r, -2});
        rope.axis = {0, 1};
        rope.ratio = -side * r;  // turned counterclockwise, the right side rises
        rope.length = -2;
        add_joint(scene, rope);
    }
    return scene;
}

JointedScene bridge_scene(int planks, Real mass, Real whole)
{
    if (planks < 2)
        throw std::invalid_argument("the bridge has " + std::to_string(planks) +
                                    " planks; it needs two or more");
    if (!(whole > 8 && std::isfinite(whole)))
        throw std::invalid_argument("the planks have " + shortest(whole) +
                                    " m together; the banks are 8 m apart");
    JointedScene scene;
    const Real L = whole / planks, level = planks % 2 * L,  // as above
        run = (8 - level) / 2, side = (whole - level) / 2,
               sag = std::sqrt(side * side - run * run);
    Vec2 end(-4, 0);
    for (int k = 0; k <= planks; ++k) {
        const bool bank = k == planks;
        const Vec2 along = 2 * k + 1 == planks
                               ? Vec2(1, 0)
                               : Vec2(run, 2 * k < planks ? -sag : sag) / side;
        const Index a = k - 1;
        if (bank) {
            RigidJoint last =
                joint_at(scene, JointKind::revolute, world, a, {4, 0});
            last.at_b = {L / 2, 0};
            add_joint(scene, last);
            break;
        }
        const Index b = add_body(scene, box(L, 0.1),
                                 Mass{mass, {0, 0}, mass * (L * L + 0.01) / 12},
                                 end + L / 2 * along, atan2(along.y(), along.x()));
        RigidJoint pin;
        pin.a = a, pin.b = b;
        pin.at_a = k == 0 ? end : Vec2(L / 2, 0);
        pin.at_b = {-L / 2, 0};
        add_joint(scene, pin);
        end += L * along;
    }
    return scene;
}

JointedScene crane_scene(int links, Real ratio, Real speed)
{
    JointedScene scene;
    const Real L = 0.1, m = 0.1;
    RigidJoint rail;
    rail.kind = JointKind::prismatic;
    rail.b =
        add_body(scene, box(0.6, 0.2), Mass{1000, {0, 0}, 1000.0 / 30}, {0, 0});
    rail.motor = {speed, 1e5, 0, 0, 0};
    rail.lower = -3, rail.upper = 3;
    add_joint(scene, rail);
    for (int k = 0; k <= links; ++k) {
        const bool load = k == links;
        const Index b =
            load ? add_body(scene, box(0.4, 0.4),
                            Mass{ratio * m, {0, 0}, ratio * m * 0.16 / 6},
                            {0, -L * links - 0.2})
                 : add_body(scene, capsule(L, 0), thin_rod(L, m),
                            {0, -L * (k + 0.5)}, -pi / 2);
        add_joint(scene,
                  joint_at(scene, JointKind::revolute, b - 1, b, {0, -L * k}));
    }
    return scene;
}

}  // namespace rigid
