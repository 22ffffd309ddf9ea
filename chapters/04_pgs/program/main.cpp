/// Chapter 4: projected Gauss-Seidel.

#include "chapters/03_mlcp_formulation/program/problem_file.hpp"
#include "chapters/04_pgs/program/disc_run.hpp"
#include "chapters/04_pgs/program/scene_sweeps.hpp"
#include "chapters/04_pgs/program/scene_zigzag.hpp"

using namespace rigid;

namespace {

/// What all scenes of discs have in common.
Demo disc_scene(const std::string& name, const std::string& summary, int max_sweeps)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.h = scene.h_high = 1.0 / 60;
    scene.h_low = 1e-4;
    scene.methods = {"gauss_seidel", "sor", "symmetric", "jacobi"};
    scene.tunables = {
        {"max_sweeps", "", "after so many sweeps a step makes do with what it has",
         static_cast<Real>(max_sweeps), 5, 2000, true, false, false},
        {"digits", "", "the residual is to be below 10^-digits m/s", 6, 1, 12, false, false, false},
        {"omega", "", "relaxation of method sor", 1.5, 0.2, 1.7, false, false, false},
        {"order", "", "order of the visits: 0 as the rows come, 1 reversed, 2 shuffled", 0, 0, 2, true, false,
         false}};
    scene.columns = {{"sweeps", "", "sweeps of the step", true, false},
                     {"residual", "m/s", "natural residual of the step's answer", true, true},
                     {"row_visits", "", "rows visited: sweeps and computed residuals", false, false},
                     {"rows", "", "links and contacts", false, false},
                     {"unsolved", "", "steps so far that did not meet the tolerance", false, false},
                     {"link_error", "m", "largest difference of a link from its length", true, true},
                     {"penetration", "m", "deepest overlap", true, true},
                     {"kinetic", "J", "kinetic energy", true, false},
                     {"energy", "J", "kinetic energy and that of the weight", false, false}};
    return scene;
}

Demo ten_discs_scene()
{
    Demo scene = disc_scene(
        "ten_discs", "Seven discs on a chain and three free ones in a box that the pointer tilts", 2000);
    set_up_ten_discs(scene);
    scene.start = [view = scene.view](const Settings&) {
        return std::make_unique<DiscRun>(ten_discs(), 1, view, true);
    };
    return scene;
}

/// The scenes that show where sweeps do not suffice: few sweeps, long steps.
Demo failing_scene(const std::string& name, const std::string& summary, const Tunable& size,
                   const Tunable& mass)
{
    Demo scene = disc_scene(name, summary, 10);
    scene.side_by_side = {"gauss_seidel", "sor"};
    scene.tunables.insert(scene.tunables.begin(), mass);
    if (!size.name.empty()) scene.tunables.insert(scene.tunables.begin(), size);
    return scene;
}

Demo column_scene()
{
    Demo scene =
        failing_scene("column", "A column of N discs with a heavy one on top: too few sweeps and it sinks",
                      {"rows", "", "N, discs in the column", 15, 1, 100, true, true, false},
                      {"top_mass", "kg", "mass of the uppermost disc; the others have 1 kg", 10, 0.01, 1000,
                       false, true, false});
    scene.view = {{0, 1.05}, {0.9, 1.2}};
    scene.start = [view = scene.view](const Settings& settings) {
        const auto N = static_cast<Index>(settings["rows"]);
        return std::make_unique<DiscRun>(column(N, settings["top_mass"]), 10 / static_cast<Real>(N), view);
    };
    return scene;
}

Demo chain_scene()
{
    Demo scene = failing_scene(
        "hanging_chain", "N links with a heavy end: pull it with the mouse; too few sweeps and it stretches",
        {"links", "", "N, links of 0.1 m", 30, 1, 60, true, true, false},
        {"end_mass", "kg", "mass of the lowest disc; the others have 1 kg", 10, 0.01, 1000, false, true,
         false});
    scene.view = {{0, -1.05}, {1, 1.45}};
    scene.methods.push_back("cg");
    scene.side_by_side.push_back("cg");
    scene.start = [view = scene.view](const Settings& settings) {
        const auto N = static_cast<Index>(settings["links"]);
        DiscScene chain = hanging_chain(N, settings["end_mass"]);
        // It starts a little aside, as a pendulum, and its discs never meet.
        for (Index k = 1; k <= N; ++k)
            chain.bodies.position(k) = 0.1 * static_cast<Real>(k) * Vec2(std::sin(0.2), -std::cos(0.2));
        chain.linked = PairSet::all();
        return std::make_unique<DiscRun>(std::move(chain), 20 / static_cast<Real>(N), view);
    };
    return scene;
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
    Demo scene = failing_scene(
        "mass_ratio", "Left a heavy disc on a light one, right the reverse, with the same sweeps", {},
        {"ratio", "", "R, the mass of the heavy ones over that of the light ones", 100, 1, 10000, false, true,
         false});
    scene.view = {{0, 0.42}, {0.9, 0.5}};
    scene.start = [view = scene.view](const Settings& settings) {
        return std::make_unique<DiscRun>(two_columns(settings["ratio"]), 1.5, view);
    };
    return scene;
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
    return {{"pgs", sweeping(Sweeps::gauss_seidel, 1)},
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
        program.solve_problem = [](const std::string& file, const std::string& method) {
            return solve_problem_file(file, method, problem_methods());
        };
        return program;
    };
    return run_program(make, argc, argv);
}
