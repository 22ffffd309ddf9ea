// The functions of built_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/built_scenes.hpp"
#include "common/scenes.hpp"

namespace rigid {

SpaceScene brick_wall(int rows, int columns, Real mu)
{
    require_count("rows of a wall", rows);
    require_count("columns of a wall", columns);
    SpaceScene scene;
    const Vec3 brick(0.4, 0.25, 0.25);
    for (int row = 0; row < rows; ++row) {
        const bool beside = row % 2 == 1;
        for (int i = 0; i < columns + beside; ++i) {
            // an odd row ends in half bricks
            const bool half = beside && (i == 0 || i == columns);
            Vec3 size = brick;
            Real x = (i - (beside ? 0.5 : 0)) * brick.x();
            if (half) size.x() /= 2, x += (i == 0 ? 0.25 : -0.25) * brick.x();
            add_body(
                scene, {solid_box(size)}, 1800.0,
                {x - (columns - 1) * brick.x() / 2, (row + 0.5) * brick.y(), 0});
        }
    }
    add_floor(scene, mu);
    return scene;
}

void add_wrecking_ball(SpaceScene& scene, const WreckingBall& ball, Real mu)
{
    if (ball.links < 0)
        throw std::invalid_argument("a wrecking ball hangs on " +
                                    std::to_string(ball.links) +
                                    " links; it must be zero or more");
    require_positive("the radius of a wrecking ball", ball.radius);
    require_positive("the mass of a wrecking ball", ball.mass);
    if (!(ball.link_length > 0.1) || !std::isfinite(ball.link_length))
        throw std::invalid_argument("a link of a wrecking ball's chain is " +
                                    shortest(ball.link_length) +
                                    " m long; it must be finite and more than "
                                    "the 0.1 m that its ends take");
    const Real way = ball.links * ball.link_length + ball.radius;
    const Vec3 hook(0, ball.height + way, ball.face - ball.radius);
    const Vec3 down(0, -cos(ball.lift), -sin(ball.lift));
    const Index first = scene.bodies.count();
    Index before = world;
    for (int i = 0; i <= ball.links; ++i) {
        const Vec3 end = hook + i * ball.link_length * down;
        const bool last = i == ball.links;
        const Hull shape = last ? solid_ball(ball.radius)
                                : solid_capsule(ball.link_length - 0.1, 0.04);
        SolidMass mass = mass_of(shape, 1);
        const Real scale = (last ? ball.mass : 5) / mass.mass;
        mass.mass *= scale, mass.inertia *= scale;
        const Real half = last ? ball.radius : ball.link_length / 2;
        const Index k =
            add_body(scene, {shape}, mass, end + half * down, frame_along(down));
        scene.joints.push_back(ball_joint(scene, before, k, end));
        before = k;
    }
    give_friction(scene, first, mu);
}

SpaceScene card_tower(int storeys, Real lean, Real mu)
{
    require_count("storeys of a tower", storeys);
    require_positive("the lean of a card", lean);
    if (!(lean < pi / 2))
        throw std::invalid_argument("the lean of a card is " + shortest(lean) +
                                    " rad; it must be below a quarter turn");
    SpaceScene scene;
    const Real thick = 0.02, c = cos(lean), s = sin(lean);
    const Vec3 card(thick, 1, 0.7), flat(1, thick, 0.7);
    // the upper corners are as high as this; those that touch lie lower
    const Real tall = c + thick * s, half = (s + thick * c) / 2;
    for (int storey = 0; storey < storeys; ++storey) {
        const Real floor = storey * (tall + thick);
        const int pairs = storeys - storey;
        for (int i = 0; i < pairs; ++i) {
            // a card across two tops ends over both, a millimetre from the next
            const Real x = (i - (pairs - 1) / 2.0) * (flat.x() + 0.001);
            for (const int side : {-1, 1})
                add_body(scene, {solid_box(card)}, 200.0,
                         {x + side * half, floor + tall / 2, 0},
                         {0, 0, side * lean});
            if (i > 0)
                add_body(scene, {solid_box(flat)}, 200.0,
                         {x - (flat.x() + 0.001) / 2, floor + tall + thick / 2, 0});
        }
    }
    add_floor(scene, mu);
    return scene;
}

}  // namespace rigid
