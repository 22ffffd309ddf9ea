/// Chapter 3: contact is either/or.

#include "chapters/03_mlcp_formulation/program/problem_file.hpp"
#include "chapters/03_mlcp_formulation/program/scene_discs.hpp"
#include "chapters/03_mlcp_formulation/program/scene_impact.hpp"

using namespace rigid;

int main(int argc, char** argv)
{
    const auto make = [] {
        const ProblemMethods methods = {
            {"enumerate", [](const Mlcp& mlcp) { return enumerate(mlcp); }},
            {"schur", [](const Mlcp& mlcp) { return schur(mlcp); }},
            {"direct", [](const Mlcp& mlcp) { return direct(mlcp); }}};
        Program program;
        program.name = "03_mlcp_formulation";
        program.title = "Chapter 3. MLCP formulation";
        program.scenes = {bounce_scene(), corner_scene(), ten_discs_scene()};
        program.problem_methods = names_of(methods);
        program.solve_problem = [methods](const std::string& file,
                                          const std::string& method) {
            return solve_problem_file(file, method, methods);
        };
        return program;
    };
    return run_program(make, argc, argv);
}
