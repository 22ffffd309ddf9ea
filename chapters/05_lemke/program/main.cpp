/// Chapter 5: Lemke's algorithm.

#include "chapters/03_mlcp_formulation/program/problem_file.hpp"
#include "chapters/04_pgs/program/disc_run.hpp"
#include "chapters/05_lemke/program/scene_plane.hpp"
#include "chapters/05_lemke/program/scene_stack.hpp"
#include "chapters/05_lemke/program/walk_run.hpp"

using namespace rigid;

namespace {

/// A scene of discs: chapter 3's step, solved exactly, or by chapter 4's sweeps to compare.
class ExactDiscRun : public DiscRun {
public:
    using DiscRun::DiscRun;

    //! [step]
    void step(const Settings& settings, const Input& input) override
    {
        if (settings.method != "lemke") return DiscRun::step(settings, input);
        counted_ = "pivots";
        listen(settings, input);
        const auto solve = [](const Mlcp& mlcp) { return lemke(mlcp); };
        advance(solve);
        if (!scene_.bodies.x.allFinite()) throw StepFailure(first_lost_body());
        unsolved_ += now_.solution.status != Status::solved;
    }
    //! [step]
};

Demo disc_scene(const std::string& name, const std::string& summary)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.h = 1.0 / 480;
    scene.h_low = 1e-4;
    scene.h_high = 1.0 / 60;
    scene.methods = {"lemke", "gauss_seidel"};
    scene.side_by_side = scene.methods;
    scene.tunables = {{"max_sweeps", "", "of gauss_seidel: after so many it makes do with what it has", 10, 1,
                       2000, true, false, false},
                      {"digits", "", "of gauss_seidel: the residual is to be below 10^-digits m/s", 6, 1, 12,
                       false, false, false},
                      {"order", "", "of gauss_seidel: 0 as the rows come, 1 reversed, 2 shuffled", 0, 0, 2,
                       true, false, false}};
    scene.columns = {{"iterations", "", "pivots, or sweeps, of the step", true, false},
                     {"residual", "m/s", "natural residual of the step's answer", true, true},
                     {"row_visits", "", "of gauss_seidel: rows visited", false, false},
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
    Demo scene =
        disc_scene("ten_discs", "Seven discs on a chain and three free ones, each step solved exactly");
    set_up_ten_discs(scene);
    scene.start = [view = scene.view](const Settings&) {
        return std::make_unique<ExactDiscRun>(ten_discs(), 1, view, true);
    };
    return scene;
}

Demo heavy_top_scene()
{
    Demo scene = disc_scene("heavy_top",
                            "A column with a heavy disc on top: exact impulses hold what sweeps let sink");
    scene.view = {{0, 1.1}, {0.9, 1.25}};
    scene.tunables.insert(scene.tunables.begin(),
                          {{"rows", "", "discs in the column", 10, 1, 100, true, true, false},
                           {"top_mass", "kg", "mass of the uppermost disc; the others have 1 kg", 1000, 0.01,
                            1000, false, true, false}});
    scene.start = [view = scene.view](const Settings& settings) {
        const auto N = static_cast<Index>(settings["rows"]);
        return std::make_unique<ExactDiscRun>(column(N, settings["top_mass"]), 10 / static_cast<Real>(N),
                                              view);
    };
    return scene;
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
        program.scenes = {plane_scene(), tableau_scene(), stack_scene(), ten_discs_scene(),
                          heavy_top_scene()};
        program.problem_methods = names_of(problem_methods());
        program.solve_problem = [](const std::string& file, const std::string& method) {
            return solve_problem_file(file, method, problem_methods());
        };
        return program;
    };
    return run_program(make, argc, argv);
}
