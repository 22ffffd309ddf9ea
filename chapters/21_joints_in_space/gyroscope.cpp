// The functions of gyroscope.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/21_joints_in_space/gyroscope.hpp"

namespace rigid {

std::vector<Hull> ring_of_rods(const Vec3& axis, Real radius, Real thick)
{
    const Mat3 R = rotation_matrix(frame_along(axis));
    const auto point = [&](int i) -> Vec3 {
        const Real turn = 2 * pi * i / 24;
        return R * Vec3(0, radius * cos(turn), radius * sin(turn));
    };
    std::vector<Hull> ring;
    for (int i = 0; i < 24; ++i)
        ring.push_back(rod_between(point(i), point(i + 1), thick));
    return ring;
}

JointedSolids gyroscope_in_gimbal(const Gyroscope& gyroscope)
{
    JointedSolids scene;
    const Vec3 middle(0, 0, 0), x(1, 0, 0), y(0, 1, 0), z(0, 0, 1);
    const Real inner = gyroscope.radius + 0.03, outer = inner + 0.03;
    const auto add_ring = [&](const Vec3& axis, Real radius) {
        const std::vector<Hull> ring = ring_of_rods(axis, radius, 0.006);
        SolidMass mass = mass_of(ring, 1000);
        std::vector<Hull> shape = ring;
        if (radius == inner) {
            // the weight is a point: two centroids, (20.18)
            SolidMass all = mass;
            all.mass += gyroscope.weight;
            all.centroid = gyroscope.weight / all.mass * gyroscope.arm * x;
            const Vec3 c = all.centroid, p = gyroscope.arm * x - c;
            all.inertia += inertia_of(mass.mass * c * c.transpose()) +
                           inertia_of(gyroscope.weight * p * p.transpose());
            mass = all;
            Hull ball = solid_ball(0.03);
            ball.vertices[0] = gyroscope.arm * x;
            shape.push_back(ball);
        }
        return add_body(scene, shape, mass, middle);
    };
    const Index ring = add_ring(x, outer), frame = add_ring(y, inner);
    SolidMass disc;
    disc.mass = 1;
    const Real across = gyroscope.radius * gyroscope.radius / 4;
    disc.inertia = Vec3(2 * across, across, across).asDiagonal();
    std::vector<Hull> shape = ring_of_rods(x, gyroscope.radius - 0.01, 0.01);
    for (int i = 0; i < 4; ++i) {
        const Vec3 rim = rotation_matrix(Vec3(i * pi / 4, 0, 0)) *
                         Vec3(0, gyroscope.radius - 0.01, 0);
        shape.push_back(rod_between(-rim, rim, 0.004));
    }
    shape.push_back(rod_between(-inner * x, inner * x, 0.004));
    const Index wheel = add_body(scene, shape, disc, middle);
    scene.joints = {hinge(scene, world, ring, middle, y),
                    hinge(scene, ring, frame, middle, z),
                    hinge(scene, frame, wheel, middle, x)};
    const Vec3 turn = precession_of(gyroscope) * y;
    for (Index k = 0; k < 3; ++k) {
        const Vec3 spin = k == wheel ? Vec3(turn + gyroscope.spin * x) : turn;
        scene.bodies.velocity(k).head<3>() =
            cross(turn, centre_of(scene.bodies.x, k));
        scene.bodies.velocity(k).tail<3>() =
            rotation_of(scene.bodies.x, k).transpose() * spin;
    }
    scene.length = 0.1;
    return scene;
}

}  // namespace rigid
