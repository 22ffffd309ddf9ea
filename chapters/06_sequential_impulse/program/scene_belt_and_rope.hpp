/// \file scene_belt_and_rope.hpp
/// A belt that drags, a rope that is taut or slack: more that a bias and two bounds can say.
#pragma once

#include "chapters/06_sequential_impulse/program/scene_machines.hpp"
#include "common/elementary.hpp"

#include <memory>
#include <vector>

namespace rigid {

/// Discs on a belt, each dragged with no more than a force, towards a wall.
inline DiscScene discs_on_belt()
{
    DiscScene scene;
    scene.bodies = Bodies<2>(3);
    scene.radius = VecX::Constant(3, 0.1);
    for (Index k = 0; k < 3; ++k)
        scene.bodies.position(k) = Vec2(-1.2 + 0.3 * static_cast<Real>(k), 0.1);
    scene.walls = {{{0, 1}, 0}, {{-1, 0}, -1.2}};
    return scene;
}

inline void draw_belt(Canvas& canvas, const SceneState& state)
{
    const Real speed = state.scene.joints.empty() ? 0 : state.scene.joints[0].speed;
    canvas.segment({-1.5, 0}, {1.2, 0}, paint::wall);
    canvas.segment({1.2, 0}, {1.2, 0.6}, paint::wall);
    for (Real x = -1.5 + std::fmod(speed * state.t(), 0.2); x < 1.2; x += 0.2)
        canvas.segment({x, 0}, {x - 0.05, -0.06}, paint::grid);
    for (Index k = 0; k < 3; ++k) {
        const Vec2 p = state.scene.bodies.position(k);
        canvas.disc(p, 0.1, paint::body);
        const Real drag = state.force_of_joint(static_cast<int>(k));
        if (std::abs(drag) > 0.01)
            canvas.arrow(p - Vec2(0, 0.1), p + Vec2(0.15 * drag, -0.1),
                         {Colour::green, 2.5, 1});
    }
    canvas.text({-1.5, 0.7},
                "belt " + significant(speed, 3) +
                    " m/s; green: its force on each disc",
                14, paint::label);
}

inline Demo belt_scene()
{
    Demo demo = machine_demo(
        "belt",
        "A belt drags three discs with a limited force until a wall stops them",
        {{-0.15, 0.3}, {1.5, 0.6}},
        {tunables::number("speed", "m/s", "of the belt", 1, -2, 2,
                          Keys::up_and_down),
         tunables::number("force", "N", "on each disc, at most", 1, 0, 10)});
    run_scene<WrongClampingMethod>(
        demo,
        {columns::velocity("speed_1", "of the first disc", 0),
         columns::velocity("speed_2", "of the second", 2),
         columns::velocity("speed_3", "of the third", 4),
         columns::joint_force("force_1", "of the belt on the first disc", 0),
         columns::joint_force("force_2", "of the belt on the second", 1),
         columns::joint_force("force_3", "of the belt on the third", 2)},
        [](const Settings&) {
            ImpulseSetup setup = machine(
                discs_on_belt(), [](const Settings& settings, DiscScene& scene) {
                    for (Index k = 0; k < 3; ++k)
                        scene.joints.push_back({Joint::Kind::motor, world, k,
                                                Vec2(1, 0), 0, settings["speed"],
                                                settings["force"]});
                });
            setup.draw = draw_belt;
            return setup;
        });
    return demo;
}

inline constexpr Real rope_length = 1;

/// A disc on a rope: it flies free while the rope is slack, and past its pivot.
inline DiscScene disc_on_rope(Real speed)
{
    DiscScene scene = never_meeting(hanging_chain(1));
    scene.links.clear();
    scene.radius << 0.03, 0.1;
    scene.bodies.position(1) = Vec2(-0.5, 0.2);
    scene.bodies.velocity(1) = Vec2(speed, 1);
    return scene;
}

/// \param trail  where the disc has been
inline void draw_rope(Canvas& canvas, const SceneState& state,
                      const std::vector<Vec2>& trail)
{
    std::vector<Vec2> circle;
    for (int i = 0; i <= 90; ++i)
        circle.push_back(rope_length * Vec2(cos(pi * i / 45), sin(pi * i / 45)));
    canvas.polyline(circle, paint::grid);
    const Vec2 p = state.scene.bodies.position(1);
    const Real tension = state.force_of_joint(0);
    const bool taut = tension > 0;
    canvas.segment({0, 0}, p,
                   {taut ? Colour::red : Colour::faint, taut ? 2.5 : 1.5, 1,
                    !taut ? Paint::dashed : Paint::outline});
    canvas.polyline(trail, {Colour::blue, 1, 0.6});
    canvas.disc({0, 0}, 0.03, paint::fixed_body);
    canvas.disc(p, 0.1, paint::body);
    canvas.text({-1.25, 1.1},
                taut ? "taut: " + significant(tension, 3) + " N" : "slack", 15,
                paint::label);
}

inline Demo rope_scene()
{
    Demo demo = machine_demo(
        "rope",
        "A disc on a rope: free while it is slack, on the circle while it is taut",
        {{0, 0}, {1.35, 1.3}},
        {tunables::at_start("throw", "m/s", "to the right, at the beginning", 2, -4,
                            4, Keys::up_and_down)});
    demo.h = 1.0 / 240;
    const Measured<SceneState> slack = {
        {"slack", "m", "length of the rope less the distance", Plot::linear},
        [](const SceneState& s) {
            return rope_length -
                   (s.scene.bodies.position(1) - s.scene.bodies.position(0)).norm();
        }};
    run_scene<WrongClampingMethod>(
        demo,
        {slack, columns::joint_force("tension", "of the rope", 0),
         columns::position("x", "of the disc", 2, Plot::none),
         columns::position("y", "of the disc", 3, Plot::linear),
         columns::energy().plotted()},
        [](const Settings& at_start) {
            const auto trail = std::make_shared<std::vector<Vec2>>();
            ImpulseSetup setup =
                machine(disc_on_rope(at_start["throw"]),
                        [trail](const Settings&, DiscScene& scene) {
                            scene.joints = {{Joint::Kind::rope, 0, 1, Vec2(0, 1),
                                             rope_length, 0, 0}};
                            trail->push_back(scene.bodies.position(1));
                            if (trail->size() > 600) trail->erase(trail->begin());
                        });
            setup.draw = [trail](Canvas& canvas, const SceneState& state) {
                draw_rope(canvas, state, *trail);
            };
            return setup;
        });
    return demo;
}

}  // namespace rigid
