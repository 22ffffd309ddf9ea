/// \file scene_linkage.hpp
/// Linkages whose exact energy never changes, under RATTLE, the exact split and C/h.
#pragma once

#include "chapters/03_mlcp_formulation/program/scene_drawing.hpp"
#include "chapters/03_mlcp_formulation/program/scene_run.hpp"
#include "chapters/09_active_sets/linkages.hpp"
#include "chapters/09_active_sets/rattle.hpp"
#include "common/text.hpp"

#include <memory>
#include <vector>

namespace rigid {

namespace linkage {

inline DiscScene scene_of(const Settings& settings)
{
    switch (static_cast<int>(settings["kind"])) {
    case 0:
        return four_bar();
    case 1:
        return linked_discs(static_cast<Index>(settings["rods"]));
    default:
        return free_swinging_chain();
    }
}

/// The links, the discs, and the path that the last one has left behind.
inline void draw(Canvas& canvas, const SceneState& state,
                 const std::vector<Vec2>& path)
{
    if (path.size() > 1) canvas.polyline(path, {Colour::faint, 1.5, 1});
    paint::draw_links(canvas, state, [](const Link&) { return paint::link; });
    for (Index k = 0; k < state.scene.bodies.count(); ++k)
        canvas.disc(paint::shown(state, k), 0.03,
                    state.scene.bodies.can_move(k) ? paint::body
                                                   : paint::fixed_body);
    canvas.text(
        {0, -1.1},
        "energy off by " +
            significant(mechanical_energy(state.scene) - state.start.energy, 2) +
            " J",
        14, paint::label, Align::centre);
}

/// The columns, of a run by any method.
/// \param passes  of Newton's method in the last step
template <class Method>
std::vector<Measured<RunState<Method>>>
columns_of(std::function<Real(const RunState<Method>&)> passes)
{
    using State = RunState<Method>;
    return {Measured<State>({"energy_error", "J", "energy minus that of the start",
                             Plot::linear},
                            columns::energy_gained().value),
            columns::kinetic(), columns::link_error(),
            Measured<State>(
                {"passes", "", "of Newton's method in the last step, of rattle"},
                std::move(passes)),
            columns::unsolved()};
}

template <class Method>
std::unique_ptr<Run> run_of(const View& view, const Settings& settings,
                            const Method& method,
                            std::function<Real(const RunState<Method>&)> passes)
{
    SceneSetup<Method> setup;
    setup.scene = scene_of(settings);
    setup.method = method;
    setup.zoom = 1 / setup.scene.half_size.maxCoeff();
    setup.pointer = Pointer::ignored;
    setup.tune = [](const Settings& now, RunState<Method>& state) {
        state.step.substeps = static_cast<int>(now["substeps"]);
    };
    const auto path = std::make_shared<std::vector<Vec2>>();
    setup.after = [path](RunState<Method>& state) {
        path->push_back(paint::shown(state, state.scene.bodies.count() - 1));
        if (path->size() > 400) path->erase(path->begin());
    };
    setup.draw = [path](Canvas& canvas, const RunState<Method>& state) {
        draw(canvas, state, *path);
    };
    return std::make_unique<SceneRun<Method>>(
        view, columns_of<Method>(std::move(passes)), std::move(setup));
}

inline std::unique_ptr<Run> start(const View& view, const Settings& settings)
{
    if (settings.method == "rattle")
        return run_of<RattleMethod>(
            view, settings, {}, [](const RunState<RattleMethod>& state) {
                return static_cast<Real>(state.method.correction.iterations);
            });
    ExactMethod method;
    method.correction = exact_correction();
    if (settings.method != "split")
        method.correction.method = Stabilizer::baumgarte;
    return run_of<ExactMethod>(
        view, settings, method,
        [](const RunState<ExactMethod>&) { return Real{0}; });
}

}  // namespace linkage

inline Demo linkage_scene()
{
    Demo demo;
    demo.name = "linkage";
    demo.summary = "A linkage that nothing brakes: which step keeps its energy?";
    demo.view = {{0, -0.05}, {1.15, 1.15}};
    demo.h = 1.0 / 60;
    demo.h_low = 1e-4;
    demo.h_high = 1.0 / 60;
    demo.methods = {"rattle", "split", "whole_error"};
    demo.side_by_side = {"rattle", "split"};
    demo.tunables = {
        {"kind",
         "",
         "0 the four-bar linkage, 1 a pendulum of rods, 2 a chain of ten",
         0,
         0,
         2,
         Numbers::whole,
         OnChange::restarts,
         Keys::none,
         {"four bars", "pendulum", "chain"}},
        {"rods", "", "of the pendulum", 2, 1, 20, Numbers::whole,
         OnChange::restarts},
        {"substeps", "", "parts of each step", 1, 1, 64, Numbers::whole}};
    for (const auto& one : linkage::columns_of<ExactMethod>({}))
        demo.columns.push_back(one.column);
    demo.start = [view = demo.view](const Settings& settings) {
        return linkage::start(view, settings);
    };
    return demo;
}

}  // namespace rigid
