/// Chapter 4: projected Gauss-Seidel.

#include "chapters/03_mlcp_formulation/program/problem_file.hpp"
#include "chapters/03_mlcp_formulation/program/scene_run.hpp"
#include "chapters/04_pgs/program/cold_sweeps.hpp"
#include "chapters/04_pgs/program/scene_picture.hpp"
#include "chapters/04_pgs/program/scene_sweeps.hpp"
#include "chapters/04_pgs/program/scene_zigzag.hpp"
#include "chapters/04_pgs/program/tunables.hpp"

using namespace rigid;

namespace {

using SweptMethod = MatrixMethod<ColdSweeps>;

/// A scene whose every step is swept, from the reader's settings.
SceneSetup<SweptMethod> swept(DiscScene scene, Real zoom,
                              Pointer pointer = Pointer::pulls)
{
    SceneSetup<SweptMethod> setup;
    setup.scene = std::move(scene);
    setup.zoom = zoom;
    setup.pointer = pointer;
    setup.tune = [](const Settings& settings, RunState<SweptMethod>& state) {
        tune_sweeps(settings, state.method.solver.find);
    };
    setup.draw = [](Canvas& canvas, const SceneState& state) {
        paint::draw_scene(canvas, state);
    };
    return setup;
}

/// What all scenes of discs have in common.
/// \param own  what the reader may change in this one alone
Demo swept_demo(
    const std::string& name, const std::string& summary, const View& view,
    const std::vector<Tunable>& own, int max_sweeps,
    const std::function<SceneSetup<SweptMethod>(const Settings&)>& set_up)
{
    Demo demo;
    demo.name = name;
    demo.summary = summary;
    demo.view = view;
    demo.h = demo.h_high = 1.0 / 60;
    demo.h_low = 1e-4;
    demo.methods = {"gauss_seidel", "sor", "symmetric", "jacobi"};
    demo.side_by_side = {"gauss_seidel", "sor"};
    demo.tunables = with(
        own,
        {tunables::max_sweeps(max_sweeps, 5), tunables::digits(),
         tunables::number("omega", "", "relaxation of method sor", 1.5, 0.2, 1.7),
         tunables::order()});
    run_scene<SweptMethod>(
        demo, matrix_columns<ColdSweeps>("sweeps", "sweeps of the step"), set_up);
    return demo;
}

Demo ten_discs_scene()
{
    Demo demo =
        swept_demo("ten_discs",
                   "Seven discs on a chain and three free ones in a box that the "
                   "pointer tilts",
                   ten_discs_view, ten_discs_tunables(), 2000, [](const Settings&) {
                       return swept(ten_discs(), 1, Pointer::steers);
                   });
    set_up_ten_discs(demo);
    demo.side_by_side.clear();
    return demo;
}

// The scenes that show where sweeps do not suffice: few sweeps, long steps.

Demo column_scene()
{
    return swept_demo(
        "column",
        "A column of N discs with a heavy one on top: too few sweeps and it sinks",
        {{0, 1.05}, {0.9, 1.2}},
        {tunables::in_column("rows", 15), tunables::top_mass(10)}, 10,
        [](const Settings& settings) {
            const auto N = static_cast<Index>(settings["rows"]);
            return swept(column(N, settings["top_mass"]),
                         10 / static_cast<Real>(N));
        });
}

Demo chain_scene()
{
    Demo demo = swept_demo("hanging_chain",
                           "N links with a heavy end: pull it with the mouse; too "
                           "few sweeps and it stretches",
                           {{0, -1.05}, {1, 1.45}},
                           {tunables::links(30, 1, 60), tunables::end_mass(10)}, 10,
                           [](const Settings& settings) {
                               const auto N = static_cast<Index>(settings["links"]);
                               return swept(leaning_chain(N, settings["end_mass"]),
                                            20 / static_cast<Real>(N));
                           });
    demo.methods.push_back("cg");
    demo.side_by_side.push_back("cg");
    return demo;
}

/// Two columns of two: R on 1 kg and 1 kg on R.
DiscScene two_columns(Real R)
{
    DiscScene scene;
    scene.bodies = Bodies<2>(4);
    scene.bodies.x << -0.3, 0.1, -0.3, 0.3, 0.3, 0.1, 0.3, 0.3;
    scene.bodies.inverse_mass.segment<2>(2).setConstant(1 / R);
    scene.bodies.inverse_mass.segment<2>(4).setConstant(1 / R);
    scene.radius = VecX::Constant(4, 0.1);
    scene.walls = {{{0, 1}, 0}};
    return scene;
}

Demo mass_ratio_scene()
{
    return swept_demo(
        "mass_ratio",
        "Left a heavy disc on a light one, right the reverse, with the same sweeps",
        {{0, 0.42}, {0.9, 0.5}},
        {tunables::at_start(
            "ratio", "",
            "R, the mass of the heavy ones over that of the light ones", 100, 1,
            10000)},
        10, [](const Settings& settings) {
            return swept(two_columns(settings["ratio"]), 1.5);
        });
}

/// What --problem FILE --method NAME can solve by. Ten digits, or all the sweeps that patience allows.
ProblemMethods problem_methods()
{
    const auto sweeping = [](Sweeps sweeps, Real omega) {
        PgsSettings settings;
        settings.tolerance = 1e-10;
        settings.max_sweeps = 200000;
        settings.sweeps = sweeps;
        settings.omega = omega;
        return [settings](const Mlcp& mlcp) { return pgs(mlcp, settings); };
    };
    return {
        {"pgs", sweeping(Sweeps::gauss_seidel, 1)},
        {"sor", sweeping(Sweeps::gauss_seidel, 1.3)},
        {"jacobi", sweeping(Sweeps::jacobi, 1)},
        {"symmetric", sweeping(Sweeps::symmetric, 1)},
        {"cg", [](const Mlcp& mlcp) { return conjugate_gradients(mlcp, 1e-10); }}};
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "04_pgs";
        program.title = "Chapter 4. Projected Gauss-Seidel";
        program.scenes = {ten_discs_scene(),  column_scene(), chain_scene(),
                          mass_ratio_scene(), sweeps_scene(), zigzag_scene()};
        program.problem_methods = names_of(problem_methods());
        program.solve_problem = [](const std::string& file,
                                   const std::string& method) {
            return solve_problem_file(file, method, problem_methods());
        };
        return program;
    };
    return run_program(make, argc, argv);
}
