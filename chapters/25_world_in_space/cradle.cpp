// The functions of cradle.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/cradle.hpp"
#include "common/scenes.hpp"

namespace rigid {

JointedSolids newtons_cradle(const Cradle& cradle)
{
    require_count("balls of a cradle", cradle.balls);
    require_positive("the radius of a cradle's balls", cradle.radius);
    require_positive("the length of a cradle's rods", cradle.length);
    if (cradle.lifted < 0 || cradle.lifted > cradle.balls)
        throw std::invalid_argument("a cradle of " + std::to_string(cradle.balls) +
                                    " balls has " + std::to_string(cradle.lifted) +
                                    " of them lifted");
    if (!(cradle.gap >= 0) || !std::isfinite(cradle.gap))
        throw std::invalid_argument("the gap of a cradle's balls is " +
                                    shortest(cradle.gap) +
                                    " m; it must be zero or positive and finite");
    JointedSolids scene;
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

}  // namespace rigid
