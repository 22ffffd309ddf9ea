/// Chapter 9: active sets.

#include "chapters/03_mlcp_formulation/program/problem_file.hpp"
#include "chapters/09_active_sets/dantzig.hpp"
#include "chapters/09_active_sets/program/exact_scenes.hpp"
#include "chapters/09_active_sets/program/scene_cycle.hpp"
#include "chapters/09_active_sets/program/scene_fill.hpp"
#include "chapters/09_active_sets/program/scene_guess.hpp"
#include "chapters/09_active_sets/program/scene_linkage.hpp"
#include "chapters/09_active_sets/program/scene_long_chain.hpp"
#include "chapters/09_active_sets/program/scene_plane.hpp"

using namespace rigid;

namespace {

/// What --problem FILE --method NAME can solve by.
ProblemMethods problem_methods()
{
    return {{"active_sets", [](const Mlcp& mlcp) { return active_sets(mlcp); }},
            {"dantzig", [](const Mlcp& mlcp) { return dantzig(mlcp); }}};
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "09_active_sets";
        program.title = "Chapter 9. Active sets";
        program.scenes = {plane_scene(),
                          cycle_scene(),
                          guess_scene(),
                          fill_scene(),
                          ten_discs_exactly_scene(),
                          long_chain_scene(),
                          linkage_scene()};
        program.problem_methods = names_of(problem_methods());
        program.solve_problem = [](const std::string& file,
                                   const std::string& method) {
            return solve_problem_file(file, method, problem_methods());
        };
        return program;
    };
    return run_program(make, argc, argv);
}
