// Chapter 28. Cloth that touches: the program.
#include "chapters/28_cloth_that_touches/program/scenes.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "28_cloth_that_touches";
        program.title = "Chapter 28. Cloth that touches";
        program.scenes = {ball_demo(),  tablecloth_demo(), trampoline_demo(),
                          goal_demo(),  bridge_demo(),     fold_demo(),
                          hills_demo(), drum_demo(),       pole_demo()};
        return program;
    };
    return run_program(make, argc, argv);
}
