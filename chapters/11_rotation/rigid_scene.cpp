// The functions of rigid_scene.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/11_rotation/point_constraints.hpp"

namespace rigid {

Real typical_length(const RigidScene& scene)
{
    return typical_length(scene.bodies, scene.length, [&scene](Index k) {
        const Polygon& shape = scene.shapes[static_cast<std::size_t>(k)];
        Real farthest = 0;
        for (const Vec2& vertex : shape.vertices)
            farthest = std::max(farthest, vertex.norm());
        return farthest + shape.radius;
    });
}

Index add_body(RigidScene& scene, const Polygon& shape, const Mass& mass,
               const Vec2& at, Real angle)
{
    require_valid(shape);
    const auto no_number = [](Real value) {
        return !(value >= 0) || !std::isfinite(value);
    };
    if (no_number(mass.mass) || no_number(mass.inertia) ||
        (mass.mass > 0) != (mass.inertia > 0))
        throw std::invalid_argument(
            "a body has the mass " + shortest(mass.mass) + " kg and the inertia " +
            shortest(mass.inertia) +
            " kg m²; both must be positive, or both zero (it cannot move)");
    if (!at.allFinite() || !std::isfinite(angle))
        throw std::invalid_argument("a body is at (" + shortest(at.x()) + ", " +
                                    shortest(at.y()) + ") m at the angle " +
                                    shortest(angle) + " rad; they must be finite");
    if (!(mass.centroid.array().abs() <= largest_number).all())
        throw std::invalid_argument(
            "a body has its centroid at (" + shortest(mass.centroid.x()) + ", " +
            shortest(mass.centroid.y()) +
            ") m of its own axes; both must be numbers between -1e75 and 1e75");
    const Index k = scene.bodies.count();
    scene.bodies.resize(k + 1);
    scene.bodies.position(k) << at, angle;
    const bool moves = mass.mass > 0;
    scene.bodies.inverse_mass.segment<3>(3 * k) << (moves ? 1 / mass.mass : 0),
        (moves ? 1 / mass.mass : 0), (moves ? 1 / mass.inertia : 0);
    scene.shapes.push_back(shape);
    for (Vec2& vertex : scene.shapes.back().vertices) vertex -= mass.centroid;
    return k;
}

void add_pin(RigidScene& scene, Index a, const Vec2& at_a, Index b,
             const Vec2& at_b)
{
    for (const Vec2& n : {Vec2(1, 0), Vec2(0, 1)}) {
        PointJoint half;
        half.measure = PointJoint::Measure::along;
        half.a = a, half.b = b;
        half.at_a = at_a, half.at_b = at_b;
        half.direction = n;
        scene.joints.push_back(half);
    }
}

void add_gears(RigidScene& scene, Index a, Real radius_a, Index b, Real radius_b)
{
    PointJoint mesh;
    mesh.measure = PointJoint::Measure::angle;
    mesh.a = a, mesh.b = b;
    mesh.gear_a = radius_a, mesh.gear_b = radius_b;
    require_valid(mesh, scene.joints.size(), scene.bodies.count());
    mesh.length = radius_b * scene.bodies.x[3 * b + 2] +
                  (a == world ? 0 : radius_a * scene.bodies.x[3 * a + 2]);
    scene.joints.push_back(mesh);
}

void add_turning_motor(RigidScene& scene, Index a, Index b, Real speed, Real torque)
{
    PointJoint motor;
    motor.measure = PointJoint::Measure::angle;
    motor.a = a, motor.b = b;
    motor.kind = ConstraintKind::motor;
    motor.speed = speed, motor.force = torque;
    scene.joints.push_back(motor);
}

}  // namespace rigid
