// Chapter 17. Wide sweeps: the program.
#include "chapters/17_wide_sweeps/program/scenes.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "17_wide_sweeps";
        program.title = "Chapter 17. Wide sweeps";
        program.scenes = {wide_pyramid_scene(), column_scene(), wide_pile_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
