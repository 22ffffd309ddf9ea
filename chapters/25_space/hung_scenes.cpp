// The functions of hung_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_space/hung_scenes.hpp"

namespace rigid {

SpaceScene newtons_cradle(const Cradle& cradle)
{
    SpaceScene scene;
    SolidMass ball;
    ball.mass = 1;
    ball.inertia = 0.4 * cradle.radius * cradle.radius * Mat3::Identity();
    const Real apart = 2 * cradle.radius + cradle.gap;
    for (int i = 0; i < cradle.balls; ++i) {
        const Vec3 hook((i - (cradle.balls - 1) / 2.0) * apart, cradle.length, 0);
        const Real angle = i < cradle.lifted ? -cradle.lift : 0;
        std::vector<Hull> shape = {solid_ball(cradle.radius)};
        for (const Real z : {-0.2, 0.2})
            shape.push_back(rod_between({0, 0, 0}, {0, cradle.length, z}, 0.003));
        const Vec3 down(sin(angle), -cos(angle), 0);
        const Index k = add_body(scene, shape, ball, hook + cradle.length * down,
                                 {0, 0, angle});
        scene.joints.push_back(hinge(scene, world, k, hook, {0, 0, 1}));
    }
    scene.length = 0.1;
    return scene;
}

SpaceScene plate_chain(int plates, Real aside)
{
    SpaceScene scene;
    for (int i = 0; i < plates; ++i) {
        const Vec3 end(i, 0, 0);
        const Index k = add_body(scene, {solid_box({0.9, 0.06, 0.5})}, 100.0,
                                 end + Vec3(0.5, 0, 0));
        scene.joints.push_back(
            hinge(scene, i == 0 ? world : k - 1, k, end, {0, 0, 1}));
    }
    scene.bodies.velocity(plates - 1).head<3>() = Vec3(0, 0, aside);
    return scene;
}

SpaceScene heavy_chain(int links, Real end_mass)
{
    SpaceScene scene;
    const Real length = 0.2;
    const Vec3 down(0.5, -std::sqrt(0.75), 0);
    const Hull link = solid_capsule(0.12, 0.03);
    const Real density = 1 / mass_of(link, 1).mass;
    for (int i = 0; i <= links; ++i) {
        const Vec3 end = i * length * down;
        Hull shape = link;
        Vec3 at = end + length / 2 * down;
        SolidMass mass = mass_of(link, density);
        if (i == links) {
            shape = solid_ball(0.4);
            mass = mass_of(shape, 1);
            mass.inertia *= end_mass / mass.mass, mass.mass = end_mass;
            at = end + 0.4 * down;
        }
        const Index k = add_body(scene, {shape}, mass, at, frame_along(down));
        scene.joints.push_back(ball_joint(scene, i == 0 ? world : k - 1, k, end));
    }
    scene.length = 0.1;
    return scene;
}

}  // namespace rigid
