// Chapter 20. Turning in space: the program.
#include "chapters/20_turning_in_space/program/scenes.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "20_turning_in_space";
        program.title = "Chapter 20. Turning in space";
        program.scenes = {book_scene(), spin_scene(), handle_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
