// The functions of car.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/car.hpp"

namespace rigid {

static void require_valid(const Car& car)
{
    require_positive("the mass of a car", car.mass);
    require_positive("the mass of a car's wheel", car.wheel_mass);
    require_positive("the radius of a car's wheel", car.radius);
    require_positive("the way that a car sinks", car.sink);
    if (!(car.damping >= 0 && car.torque >= 0) || !std::isfinite(car.damping) ||
        !std::isfinite(car.torque) || !std::isfinite(car.speed))
        throw std::invalid_argument(
            "a car has the damping " + shortest(car.damping) + ", the torque " +
            shortest(car.torque) + " N m and the speed " + shortest(car.speed) +
            " m/s; none may be infinite, and the first two not negative");
}

SpaceScene car_on_floor(const Car& car, Real mu)
{
    require_valid(car);
    SpaceScene scene;
    const Vec3 size(3, 0.5, 1.3);
    add_body(scene, {solid_box(size)}, car.mass / size.prod(),
             {0, car.radius + 0.25, 0});
    const Hull wheel = solid_capsule(0.06, car.radius);
    const Real density = car.wheel_mass / mass_of(wheel, 1).mass;
    for (const Real x : {-1.1, 1.1})
        for (const Real z : {-1.1, 1.1}) {
            const Vec3 at(x, car.radius, z), axle(0, 0, -1);
            const Index k =
                add_body(scene, {wheel}, density, at, frame_along(axle));
            SpaceJoint joint = joint_at(scene, 0, k, at, axle);
            joint.lock({along_x, along_z, swing_y, swing_z});
            joint.lo[along_y] = -0.1, joint.hi[along_y] = 0.2;
            joint.motor = twist;
            joint.speed = car.speed / car.radius, joint.force = car.torque;
            scene.joints.push_back(joint);
        }
    add_floor(scene, mu);
    return scene;
}

static void require_car(const SpaceScene& scene)
{
    for (std::size_t i = 0; i < 4; ++i)
        if (i >= scene.joints.size() || scene.joints[i].a != 0 ||
            scene.joints[i].b != static_cast<Index>(i) + 1 ||
            scene.joints[i].b >= scene.bodies.count())
            throw std::invalid_argument(
                "joint " + std::to_string(i) + " of the scene holds no wheel " +
                std::to_string(i + 1) + " of a car on body 0");
}

//! [struts]
void push_struts(SpaceScene& scene, const Car& car, Real h)
{
    require_valid(car);
    require_step(h);
    require_car(scene);
    Bodies<6>& bodies = scene.bodies;
    const VecX u = bodies.u;  // no strut sees what another has pushed
    for (std::size_t i = 0; i < 4; ++i) {
        const SpaceJoint& joint = scene.joints[i];
        const Constraint<6> strut =
            coordinate_of(frames_of(bodies.x, joint), joint, along_y);
        const Real rate = strut.Ja.dot(u.segment<6>(6 * joint.a)) +
                          strut.Jb.dot(u.segment<6>(6 * joint.b));
        const Real impulse =
            -h * (car.stiffness() * strut.C + car.resistance() * rate);
        bodies.velocity(joint.a) +=
            bodies.apply_inverse_mass(joint.a, strut.Ja.transpose() * impulse);
        bodies.velocity(joint.b) +=
            bodies.apply_inverse_mass(joint.b, strut.Jb.transpose() * impulse);
    }
}
//! [struts]

}  // namespace rigid
