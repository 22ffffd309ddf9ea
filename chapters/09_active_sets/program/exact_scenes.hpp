/// \file exact_scenes.hpp
/// Scenes of discs whose every step is solved exactly, beginning with the set of the step before; sweeps to compare.
#pragma once

#include "chapters/02_velocity_constraints/program/scene_hand.hpp"
#include "chapters/03_mlcp_formulation/program/scene_run.hpp"
#include "chapters/04_pgs/program/cold_sweeps.hpp"
#include "chapters/04_pgs/program/scene_picture.hpp"
#include "chapters/04_pgs/program/tunables.hpp"
#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/09_active_sets/dantzig.hpp"

#include <string>
#include <vector>

namespace rigid {

/// A solver of the MLCP: active sets, Dantzig's method, or chapter 4's sweeps to compare.
struct ExactOrSweeps : ColdSweeps {
    std::string method;   ///< as the command line has it
    ActiveSetMemory set;  ///< has the set of the step before

    void operator()(const Mlcp& mlcp, Solution& solution)
    {
        if (method == "gauss_seidel") return ColdSweeps::operator()(mlcp, solution);
        if (method == "dantzig") {
            solution = dantzig(mlcp);
            return;
        }
        if (method == "cold") set.cases.clear();
        active_sets(mlcp, {}, set, solution);
    }

    /// What it counts.
    std::string counted(int iterations) const
    {
        if (method == "gauss_seidel") return "sweeps";
        if (method == "dantzig") return "pivots";
        return iterations == 1 ? "guess" : "guesses";
    }
};

using ActiveSetMethod = MatrixMethod<ExactOrSweeps>;
using ExactState = RunState<ActiveSetMethod>;
using ExactSetup = SceneSetup<ActiveSetMethod>;

inline void draw_exact(Canvas& canvas, const ExactState& state)
{
    paint::draw_scene(
        canvas, state,
        state.method.solver.find.counted(state.now.solution.iterations));
}

inline ExactSetup solved_exactly(DiscScene scene, Real zoom)
{
    ExactSetup setup;
    setup.scene = std::move(scene);
    setup.zoom = zoom;
    setup.tune = [](const Settings& settings, ExactState& state) {
        tune_sweeps(settings, state.method.solver.find);
        state.method.solver.find.method = settings.method;
    };
    setup.draw = draw_exact;
    return setup;
}

/// \param stretch  the last column
/// \param own      what the reader may change in this one alone
inline Demo exact_demo(const std::string& name, const std::string& summary,
                       const View& view, const std::vector<Tunable>& own,
                       const std::function<Real(const SceneState&)>& stretch,
                       const std::function<ExactSetup(const Settings&)>& set_up)
{
    Demo demo;
    demo.name = name;
    demo.summary = summary;
    demo.view = view;
    demo.h = 1.0 / 480;
    demo.h_low = 1e-4;
    demo.h_high = 1.0 / 120;
    demo.steered = true;
    demo.methods = {"active_sets", "cold", "dantzig", "gauss_seidel"};
    demo.side_by_side = {"active_sets", "gauss_seidel"};
    demo.tunables = with(own, tunables::sweeps_to_compare());
    auto columns = matrix_columns<ExactOrSweeps>(
        "iterations", "guesses, pivots or sweeps of the step");
    for (Measured<ExactState>& one : columns)
        if (one.column.name == "penetration") one = one.plotted(Plot::none);
    columns.push_back(
        {{"factorisations", "", "of active_sets: of the active rows in this step",
          Plot::linear},
         [](const ExactState& s) {
             return static_cast<Real>(s.method.solver.find.set.work.factorisations);
         }});
    columns.push_back(
        {{"flips", "", "of active_sets: rows that changed their case in this step"},
         [](const ExactState& s) {
             return static_cast<Real>(s.method.solver.find.set.work.flips);
         }});
    columns.push_back(
        {{"stretch", "", "of a chain: its length over that of its links",
          Plot::linear},
         stretch});
    run_scene<ActiveSetMethod>(demo, columns, set_up);
    return demo;
}

inline Demo ten_discs_exactly_scene()
{
    Demo demo = exact_demo(
        "ten_discs",
        "The ten discs, each step solved exactly from the previous set",
        ten_discs_view, ten_discs_tunables(),
        [](const SceneState&) { return Real{0}; },
        [](const Settings&) {
            ExactSetup setup = solved_exactly(ten_discs(), 1);
            setup.pointer = Pointer::steers;
            return setup;
        });
    set_up_ten_discs(demo);
    return demo;
}

}  // namespace rigid
