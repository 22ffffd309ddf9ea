/// \file stabilized_scenes.hpp
/// What the scenes of discs of this program share: the step with any of the ways to correct, and the picture of its errors.
#pragma once

#include "chapters/03_mlcp_formulation/program/scene_drawing.hpp"
#include "chapters/03_mlcp_formulation/program/scene_run.hpp"
#include "chapters/07_baumgarte/program/scene_settings.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigid {

using StabilizedState = RunState<CorrectedMethod>;
using StabilizedSetup = SceneSetup<CorrectedMethod>;

namespace stabilized_picture {

inline constexpr Real visible = 0.001;  ///< errors above this are red [m]

/// A red bar where two discs, or a disc and a wall, overlap: as long as the part that they share is wide.
/// \param i  number of the contact's row
inline void draw_overlap(Canvas& canvas, const SceneState& state, std::size_t i)
{
    const Constraint<2> c =
        constraint_at(state.scene, state.now, i, state.scene.bodies.x);
    const Real radius = state.scene.radius[c.b], zoom = state.zoom;
    if (c.C > -visible) return;
    const Vec2 normal = c.Jb.transpose();
    const Real half = std::sqrt(std::max(Real{0}, -c.C * (radius + c.C / 4)));
    const Vec2 middle = paint::shown(state, c.b) -
                        zoom * normal * (radius + (c.a == world ? 1 : 0.5) * c.C);
    canvas.segment(middle - zoom * half * perpendicular(normal),
                   middle + zoom * half * perpendicular(normal), paint::impulse);
}

/// How high a single disc should hop, and how high it came.
inline void draw_hop(Canvas& canvas, const StabilizedState& state)
{
    const Real y = state.zoom * (state.scene.radius[0] + state.theory(state)),
               half = state.view.half_size.x();
    canvas.segment({-half, y}, {half, y}, paint::theory);
    canvas.disc({-0.7 * half, state.zoom * state.highest},
                0.012 * state.view.half_size.y(), paint::body);
}

inline void draw_caption(Canvas& canvas, const SceneState& state)
{
    const Real off = 1000 * std::max(largest_link_error(state.scene),
                                     deepest_penetration(state.scene));
    const auto line = [&](int number, const std::string& words,
                          const Style& style) {
        paint::draw_line_of_text(canvas, state, {-0.95, 0.93}, 0.056, number, words,
                                 style);
    };
    line(0,
         "off by " +
             (off < 10 ? significant(off, 2) : std::to_string(std::lround(off))) +
             " mm",
         off < 1 ? paint::label : paint::impulse);
    line(1, std::to_string(state.now.visits) + " row visits", paint::label);
}

inline void draw(Canvas& canvas, const StabilizedState& state)
{
    paint::draw_walls(canvas, state,
                      4 * state.view.half_size.maxCoeff() / state.zoom);
    paint::draw_links(canvas, state, [&](const Link& link) {
        const Real length =
            (paint::shown(state, link.b) - paint::shown(state, link.a)).norm() /
            state.zoom;
        return std::abs(length - link.length) > visible ? paint::impulse
                                                        : paint::link;
    });
    paint::draw_discs(canvas, state, [&](Index k) {
        return state.scene.bodies.inverse_mass[2 * k] > 0 ? paint::body
                                                          : paint::fixed_body;
    });
    for (std::size_t i = 0; i < state.now.sources.size(); ++i)
        if (state.is(i, Source::Of::contact)) draw_overlap(canvas, state, i);
    if (state.theory && state.steps > 0 && state.scene.links.empty() &&
        state.scene.bodies.count() == 1)
        draw_hop(canvas, state);
    draw_caption(canvas, state);
    paint::draw_hand(canvas, state);
}

}  // namespace stabilized_picture

/// What a scene should show by theory [m], from the settings of the step and its method.
using Theory = std::function<Real(const StepSettings&, const CorrectedMethod&)>;

/// A scene that is stepped by this chapter's method, from the reader's settings.
/// \param theory  may be empty
inline StabilizedSetup stabilized(DiscScene scene, Real zoom,
                                  const Theory& theory = {})
{
    StabilizedSetup setup;
    setup.scene = std::move(scene);
    setup.zoom = zoom;
    setup.tune = [](const Settings& settings, StabilizedState& state) {
        if (state.steps == 0) state.method.solver.random = Random(settings.seed);
        stabilized_settings(settings, state.step, state.method);
    };
    if (theory)
        setup.theory = [theory](const StabilizedState& state) {
            return state.steps > 0 ? theory(state.step, state.method) : 0;
        };
    setup.draw = stabilized_picture::draw;
    return setup;
}

/// What all scenes of discs have in common.
/// \param own  what the reader may change in this one alone
inline Demo
stabilized_demo(const std::string& name, const std::string& summary,
                const View& view, const std::vector<Tunable>& own, Real sweeps,
                const std::vector<std::string>& side_by_side,
                const std::function<StabilizedSetup(const Settings&)>& set_up)
{
    Demo demo;
    demo.name = name;
    demo.summary = summary;
    demo.view = view;
    demo.h_high = 1.0 / 20;
    demo.methods = stabilizer_names();
    demo.side_by_side = side_by_side;
    demo.tunables = with(own, stabilizer_tunables(sweeps));
    run_scene<CorrectedMethod>(demo, stabilized_columns(), set_up);
    return demo;
}

}  // namespace rigid
