// Chapter 22. The distance of solids: the program.
#include "chapters/22_distance_of_solids/program/scenes.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "22_distance_of_solids";
        program.title = "Chapter 22. The distance of solids";
        program.scenes = {pass_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
