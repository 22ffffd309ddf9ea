/// \file scene_long_chain.hpp
/// Two hundred links, which sweeps cannot hold; the pointer leads the lowest disc.
#pragma once

#include "chapters/09_active_sets/program/exact_scenes.hpp"

#include <algorithm>
#include <vector>

namespace rigid {

namespace long_chain {

/// Of the links, one after the other [m].
inline Real reach(const DiscScene& chain)
{
    return static_cast<Real>(chain.links.size()) * 0.1;
}

/// Of the chain as it is [m].
inline Real length(const DiscScene& chain)
{
    Real sum = 0;
    for (const Link& link : chain.links)
        sum +=
            (chain.bodies.position(link.b) - chain.bodies.position(link.a)).norm();
    return sum;
}

/// The pointer leads the last disc all the time, or, pressed, the nearest one. The hand comes at 4 m/s at most: a pointer
/// may jump across the picture, a hand may not.
struct Lead {
    Index led = world;
    bool pressed = false;
    Vec2 hand = {0, 0};  ///< [m]

    void operator()(const Settings& settings, const Input& input, SceneState& state)
    {
        const Bodies<2>& bodies = state.scene.bodies;
        const Index before = led;
        const Vec2 pointer = input.pointer / state.zoom;
        if (!input.present) led = world;
        else if (!input.pressed) led = bodies.count() - 1;
        else if (!pressed) led = nearest_body(bodies, pointer);
        pressed = input.pressed;
        if (led != world) {
            if (led != before) hand = bodies.position(led);
            const Vec2 way = pointer - hand;
            hand += way * std::min(Real{1}, 4 * settings.h /
                                                std::max(way.norm(), Real{1e-9}));
        }
        state.step.pulled = led;
        state.step.hand = hand;
    }
};

/// The chain is a line; the circle is as far as its end can be.
inline void draw(Canvas& canvas, const ExactState& state)
{
    const DiscScene& chain = state.scene;
    canvas.disc(paint::shown(state, 0), state.zoom * reach(chain),
                {Colour::faint, 1.5, 1, Paint::dashed});
    std::vector<Vec2> line;
    for (Index k = 0; k < chain.bodies.count(); ++k)
        line.push_back(paint::shown(state, k));
    canvas.polyline(line, {Colour::blue, 3, 1});
    canvas.disc(line.front(), 0.02, paint::fixed_body);
    canvas.disc(line.back(), 0.03, {Colour::red, 1.5, 1, Paint::filled});
    paint::draw_hand(canvas, state);
    paint::draw_caption(
        canvas, state,
        state.method.solver.find.counted(state.now.solution.iterations));
    paint::draw_line_of_text(canvas, state, {-0.93, 0.92}, 0.056, 2,
                             "length " + fixed(length(chain), 2) + " m of " +
                                 fixed(reach(chain), 2) + " m");
}

}  // namespace long_chain

inline Demo long_chain_scene()
{
    Demo demo = exact_demo(
        "long_chain",
        "A chain of 200 links pulled by its end: exact, and by sweeps",
        {{0, -0.85}, {1.5, 1.35}},
        {tunables::links(200, 2, 1000), tunables::end_mass(100)},
        [](const SceneState& s) {
            return long_chain::length(s.scene) / long_chain::reach(s.scene);
        },
        [](const Settings& settings) {
            const auto N = static_cast<Index>(settings["links"]);
            ExactSetup setup = solved_exactly(
                never_meeting(hanging_chain(N, settings["end_mass"])),
                20 / static_cast<Real>(N));
            setup.pointer = Pointer::ignored;
            setup.before = long_chain::Lead{};
            setup.draw = long_chain::draw;
            return setup;
        });
    // a link that turns fast leaves its length by h²u²/2L in a step
    demo.h_high = 1.0 / 240;
    return demo;
}

}  // namespace rigid
