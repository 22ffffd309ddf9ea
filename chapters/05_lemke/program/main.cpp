/// Chapter 5: Lemke's algorithm.

#include "chapters/03_mlcp_formulation/program/problem_file.hpp"
#include "chapters/03_mlcp_formulation/program/scene_run.hpp"
#include "chapters/04_pgs/program/cold_sweeps.hpp"
#include "chapters/04_pgs/program/scene_picture.hpp"
#include "chapters/04_pgs/program/tunables.hpp"
#include "chapters/05_lemke/program/scene_plane.hpp"
#include "chapters/05_lemke/program/scene_stack.hpp"
#include "chapters/05_lemke/program/walk_run.hpp"

using namespace rigid;

namespace {

/// A solver of the MLCP: Lemke's algorithm, or chapter 4's sweeps to compare.
struct LemkeOrSweeps : ColdSweeps {
    bool by_pivots = true;

    void operator()(const Mlcp& mlcp, Solution& solution)
    {
        if (by_pivots) solution = lemke(mlcp);
        else ColdSweeps::operator()(mlcp, solution);
    }
};

using PivotMethod = MatrixMethod<LemkeOrSweeps>;

SceneSetup<PivotMethod> solved_exactly(DiscScene scene, Real zoom,
                                       Pointer pointer = Pointer::pulls)
{
    SceneSetup<PivotMethod> setup;
    setup.scene = std::move(scene);
    setup.zoom = zoom;
    setup.pointer = pointer;
    setup.tune = [](const Settings& settings, RunState<PivotMethod>& state) {
        tune_sweeps(settings, state.method.solver.find);
        state.method.solver.find.by_pivots = settings.method == "lemke";
    };
    setup.draw = [](Canvas& canvas, const RunState<PivotMethod>& state) {
        paint::draw_scene(canvas, state,
                          state.method.solver.find.by_pivots ? "pivots" : "sweeps");
    };
    return setup;
}

/// What both scenes of discs have in common.
/// \param own  what the reader may change in this one alone
Demo exact_demo(
    const std::string& name, const std::string& summary, const View& view,
    const std::vector<Tunable>& own,
    const std::function<SceneSetup<PivotMethod>(const Settings&)>& set_up)
{
    Demo demo;
    demo.name = name;
    demo.summary = summary;
    demo.view = view;
    demo.h = 1.0 / 480;
    demo.h_low = 1e-4;
    demo.h_high = 1.0 / 60;
    demo.methods = demo.side_by_side = {"lemke", "gauss_seidel"};
    demo.tunables = with(own, tunables::sweeps_to_compare());
    run_scene<PivotMethod>(demo,
                           matrix_columns<LemkeOrSweeps>(
                               "iterations", "pivots, or sweeps, of the step"),
                           set_up);
    return demo;
}

Demo ten_discs_scene()
{
    Demo demo = exact_demo(
        "ten_discs",
        "Seven discs on a chain and three free ones, each step solved exactly",
        ten_discs_view, ten_discs_tunables(), [](const Settings&) {
            return solved_exactly(ten_discs(), 1, Pointer::steers);
        });
    set_up_ten_discs(demo);
    return demo;
}

Demo heavy_top_scene()
{
    return exact_demo("heavy_top",
                      "A column with a heavy disc on top: exact impulses hold what "
                      "sweeps let sink",
                      {{0, 1.1}, {0.9, 1.25}},
                      {tunables::in_column("rows", 10), tunables::top_mass(1000)},
                      [](const Settings& settings) {
                          const auto N = static_cast<Index>(settings["rows"]);
                          return solved_exactly(column(N, settings["top_mass"]),
                                                10 / static_cast<Real>(N));
                      });
}

/// What --problem FILE --method NAME can solve by: one walk for each tie rule.
ProblemMethods problem_methods()
{
    const auto walking = [](TieRule ties) {
        return [ties](const Mlcp& mlcp) {
            LemkeSettings settings;
            settings.ties = ties;
            return lemke(mlcp, settings);
        };
    };
    return {{"lemke", walking(TieRule::lexicographic)},
            {"lemke_first_row", walking(TieRule::first_row)},
            {"lemke_last_row", walking(TieRule::last_row)}};
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "05_lemke";
        program.title = "Chapter 5. Lemke's algorithm";
        program.scenes = {plane_scene(), tableau_scene(), stack_scene(),
                          ten_discs_scene(), heavy_top_scene()};
        program.problem_methods = names_of(problem_methods());
        program.solve_problem = [](const std::string& file,
                                   const std::string& method) {
            return solve_problem_file(file, method, problem_methods());
        };
        return program;
    };
    return run_program(make, argc, argv);
}
