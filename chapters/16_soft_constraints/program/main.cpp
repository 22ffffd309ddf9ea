// Chapter 16. Soft constraints: the program.
#include "chapters/16_soft_constraints/program/scenes.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "16_soft_constraints";
        program.title = "Chapter 16. Soft constraints";
        program.scenes = {spring_scene(),    stack_scene(), suspension_scene(),
                          soft_body_scene(), cloth_scene(), soft_bridge_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
