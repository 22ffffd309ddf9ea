// The functions of soft_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/16_soft_constraints/soft_scenes.hpp"

namespace rigid {

void add_linear_spring(RigidScene& scene, Index a, Index b, const Vec2& n,
                       Real length, const SpringConstants& spring)
{
    PointJoint joint;
    joint.measure = PointJoint::Measure::along;
    joint.a = a, joint.b = b;
    joint.direction = n;
    joint.length = length;
    joint.kind = ConstraintKind::spring;
    joint.stiffness = spring.stiffness, joint.damping = spring.damping;
    scene.joints.push_back(joint);
}

//! [hanging]
JointedScene hanging_masses(const std::vector<Real>& masses,
                            const SpringConstants& spring)
{
    JointedScene scene;
    for (std::size_t k = 0; k < masses.size(); ++k) {
        const auto b = static_cast<Index>(k);
        add_body(scene, disc(0.2), Mass{masses[k], {0, 0}, 0.02 * masses[k]},
                 {0, -1.0 * static_cast<Real>(k + 1)});
        add_linear_spring(scene, b - 1, b, {0, -1}, 1, spring);
    }
    return scene;
}
//! [hanging]

//! [net]
Index add_net(JointedScene& scene, const Net& net)
{
    if (net.columns < 1 || net.rows < 1)
        throw std::invalid_argument("the net has " + std::to_string(net.columns) +
                                    " columns and " + std::to_string(net.rows) +
                                    " rows; it needs one or more of each");
    const Index first = scene.bodies.count();
    const Real r = 0.3 * net.spacing;
    for (int j = 0; j < net.rows; ++j)
        for (int i = 0; i < net.columns; ++i)
            add_body(scene, disc(r), Mass{net.mass, {0, 0}, net.mass * r * r / 2},
                     net.corner + net.spacing * Vec2(i, j));
    const auto join = [&](int i, int j, int di, int dj) {
        if (i + di < 0 || i + di >= net.columns || j + dj >= net.rows) return;
        RigidJoint joint;
        joint.kind = JointKind::distance;
        joint.a = first + j * net.columns + i;
        joint.b = first + (j + dj) * net.columns + i + di;
        joint.spring = {0, 0, net.spring.stiffness, net.spring.damping,
                        net.spacing * Vec2(di, dj).norm()};
        add_joint(scene, joint);
    };
    for (int j = 0; j < net.rows; ++j)
        for (int i = 0; i < net.columns; ++i)
            for (const auto& [di, dj] : {std::pair{1, 0}, std::pair{0, 1},
                                         std::pair{1, 1}, std::pair{-1, 1}})
                join(i, j, di, dj);
    return first;
}
//! [net]

JointedScene soft_body(const Net& net)
{
    JointedScene scene;
    scene.walls.push_back({{0, 1}, 0});
    add_net(scene, net);
    cover(scene, {0.5, 0, 0, 0});
    return scene;
}

JointedScene hung_net(const Net& net)
{
    JointedScene scene;
    const Index first = add_net(scene, net);
    for (const Index k : {first + (net.rows - 1) * net.columns,
                          first + net.rows * net.columns - 1}) {
        RigidJoint pin = joint_at(scene, JointKind::revolute, world, k,
                                  scene.bodies.position(k).head<2>());
        add_joint(scene, pin);
    }
    return scene;
}

//! [suspension]
JointedScene quarter_car(const Softness& how, Real lift)
{
    JointedScene scene;
    scene.walls.push_back({{0, 1}, 0});
    const Index body = add_body(scene, box(1.4, 0.5), 400 / 0.7, {0, 1.2 + lift}),
                tyre =
                    add_body(scene, disc(0.35), Mass{40, {0, 0}, 2.5}, {0, 0.35});
    RigidJoint leg;
    leg.kind = JointKind::prismatic;
    leg.a = tyre, leg.b = body;
    leg.axis = {0, 1};
    // what hangs at the spring's row: both masses, 1/m = 1/400 + 1/40
    const SpringConstants spring = spring_of(how, 1.0 / 400 + 1.0 / 40);
    leg.spring = {0, 0, spring.stiffness, spring.damping, 0.85};
    leg.lower = 0.4, leg.upper = 2;
    add_joint(scene, leg);
    cover(scene, {0.8, 0, 0, 0});
    return scene;
}
//! [suspension]

JointedScene heavy_top(int boxes, Real ratio)
{
    JointedScene scene;
    static_cast<RigidScene&>(scene) = box_stack(boxes);
    add_body(scene, box(1, 1), ratio, {0, 0.5 + boxes});
    cover(scene, {0.6, 0, 0, 0});
    return scene;
}

JointedScene box_chain(int boxes, Real weight)
{
    JointedScene scene;
    RigidJoint pin;
    for (int k = 0; k < boxes; ++k) {
        pin.a = k - 1;
        pin.b = add_body(scene, box(1, 0.5), 1, {k + 0.5, 0});
        pin.at_a = k == 0 ? Vec2(0, 0) : Vec2(0.5, 0);
        pin.at_b = {-0.5, 0};
        add_joint(scene, pin);
    }
    pin.a = pin.b;
    pin.b = add_body(scene, box(2, 2), weight / 4, {boxes + 1.0, 0});
    pin.at_a = {0.5, 0};
    pin.at_b = {-1, 0};
    add_joint(scene, pin);
    return scene;
}

}  // namespace rigid
