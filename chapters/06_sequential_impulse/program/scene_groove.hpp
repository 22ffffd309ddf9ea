/// \file scene_groove.hpp
/// A disc falls into a groove: two contacts that help each other, and what the two ways of clamping make of it.
#pragma once

#include "chapters/06_sequential_impulse/program/impulse_scenes.hpp"
#include "chapters/06_sequential_impulse/small_scenes.hpp"
#include "common/elementary.hpp"

#include <memory>
#include <vector>

namespace rigid {

/// Where the disc lies still: it touches both sides.
inline Vec2 place_of_rest(const SceneState& state)
{
    return {0, state.scene.radius[0] / state.scene.walls[0].normal.y()};
}

inline Real speed_in_gh(const SceneState& state)
{
    return state.scene.bodies.velocity(0).norm() / (9.81 * state.step.h);
}

/// Beside the groove: the place of rest, and the disc's centre and its way of the last steps as under a lens. What is
/// outside of the lens is left out.
inline void draw_lens(Canvas& canvas, const Vec2& disc, const Vec2& rest,
                      const std::vector<Vec2>& trail)
{
    constexpr Real magnified = 60, radius = 0.085;
    const Vec2 middle(0.42, 0.36);
    const auto in_lens = [&](const Vec2& x) {
        return Vec2(middle + magnified * (x - rest));
    };
    const auto shows = [&](const Vec2& x) {
        return (in_lens(x) - middle).norm() <= radius;
    };
    canvas.disc(middle, radius, {Colour::faint, 1.5});
    for (const Vec2& way : {Vec2(0.012, 0), Vec2(0, 0.012)})
        canvas.segment(middle - way, middle + way, {Colour::faint, 1});
    std::vector<Vec2> way;
    const std::size_t recent = 120;
    for (std::size_t i = trail.size() - std::min(trail.size(), recent);
         i < trail.size(); ++i) {
        if (shows(trail[i])) way.push_back(in_lens(trail[i]));
        if ((!shows(trail[i]) || i + 1 == trail.size()) && !way.empty()) {
            canvas.polyline(way, {Colour::blue, 1, 0.7});
            way.clear();
        }
    }
    if (shows(disc)) canvas.disc(in_lens(disc), 0.006, paint::body);
    canvas.text(middle + Vec2(-radius, 0.055),
                "its centre, × " + fixed(magnified, 0), 12, paint::label,
                Align::right);
}

/// \param trail  where the disc has been
inline void draw_groove(Canvas& canvas, const SceneState& state, Real angle,
                        const std::vector<Vec2>& trail)
{
    const Vec2 rest = place_of_rest(state), disc = state.scene.bodies.position(0);
    for (const Real side : {-1.0, 1.0})
        canvas.segment({0, 0}, 0.55 * Vec2(side * cos(angle), sin(angle)),
                       paint::wall);
    canvas.disc(rest, 0.1, {Colour::faint, 1, 1, Paint::dashed});
    canvas.disc(disc, 0.1, paint::body);
    canvas.polyline(trail, {Colour::blue, 1.5, 0.7});
    for (std::size_t i = 0; i < state.now.rows.size(); ++i) {
        const Vec2 n = state.now.rows[i].Jb.transpose(), touch = disc - 0.1 * n;
        const Real force = state.lambda(i) / state.step.h;
        if (force > 0.1)
            canvas.arrow(touch, touch + std::min(0.3, 0.015 * force) * n,
                         paint::impulse);
    }
    draw_lens(canvas, disc, rest, trail);
    const Vec2 off = 1000 * (disc - rest);
    canvas.text({-0.52, 0.42},
                "off its place by " + fixed(off.x(), 2) + ", " + fixed(off.y(), 2) +
                    " mm",
                14, paint::label);
    canvas.text({-0.52, 0.375},
                "speed " + significant(speed_in_gh(state), 3) + " g h", 14,
                paint::label);
}

/// A column: how far the disc is off its place of rest.
inline Measured<SceneState> off_rest(const std::string& name, Index axis)
{
    return {{name, "m", "off its place of rest", Plot::linear},
            [axis](const SceneState& s) {
                return s.scene.bodies.position(0)[axis] - place_of_rest(s)[axis];
            }};
}
/// A column: the force of a side, where both have a row.
inline Measured<SceneState> side_force(const std::string& name,
                                       const std::string& help, std::size_t row)
{
    return {{name, "N", help, Plot::linear}, [row](const SceneState& s) {
                return s.now.rows.size() == 2 ? s.lambda(row) / s.step.h : 0;
            }};
}

inline Demo groove_scene()
{
    Demo demo;
    demo.name = "groove";
    demo.summary = "A disc falls into a groove: clamp the sum of the impulses, or "
                   "each correction";
    demo.view = {{0, 0.2}, {0.56, 0.27}};
    demo.h_high = 1.0 / 30;
    demo.methods = impulse_methods();
    demo.side_by_side = {"given", "correction"};
    demo.tunables =
        with(sweep_tunables(10, 0),
             {tunables::at_start("angle", "°", "of the sides of the groove", 30, 1,
                                 85, Keys::up_and_down),
              tunables::at_start("drop", "m", "height to fall from", 0.2, 0, 0.3),
              tunables::margin(1e-9)});
    const Measured<SceneState> speed = {
        {"speed_gh", "", "speed, in units of g h", Plot::linear}, speed_in_gh};
    run_scene<WrongClampingMethod>(
        demo,
        {off_rest("x", 0), off_rest("y", 1),
         columns::velocity("u_x", "velocity", 0).plotted(Plot::none),
         columns::velocity("u_y", "velocity", 1).plotted(Plot::none), speed,
         side_force("force_1", "of the side that rises to the left; visited first",
                    0),
         side_force("force_2", "of the other side", 1)},
        [](const Settings& at_start) {
            const Real angle = at_start["angle"] * pi / 180;
            ImpulseSetup setup = by_impulses(groove(angle));
            setup.scene.bodies.x[1] += at_start["drop"];
            setup.pointer = Pointer::ignored;
            setup.before = [](const Settings& settings, const Input&,
                              ImpulseState& state) {
                state.step.margin = settings["margin"];
            };
            const auto trail = std::make_shared<std::vector<Vec2>>();
            setup.after = [trail](const ImpulseState& s) {
                trail->push_back(s.scene.bodies.position(0));
            };
            setup.draw = [angle, trail](Canvas& canvas, const SceneState& state) {
                draw_groove(canvas, state, angle, *trail);
            };
            return setup;
        });
    return demo;
}

}  // namespace rigid
