// Chapter 23. Faces that touch: the program.
#include "chapters/23_faces_that_touch/program/scenes.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "23_faces_that_touch";
        program.title = "Chapter 23. Faces that touch";
        program.scenes = {stack_scene(), over_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
