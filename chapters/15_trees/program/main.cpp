// Chapter 15. Trees: the program.
#include "chapters/15_trees/program/scene_dolls.hpp"
#include "chapters/15_trees/program/scene_machines.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "15_trees";
        program.title = "Chapter 15. Trees";
        program.scenes = {chain_demo(),  bridge_demo(), dolls_demo(), crane_demo(),
                          engine_demo(), leg_demo(),    cradle_demo()};
        return program;
    };
    return run_program(make, argc, argv);
}
