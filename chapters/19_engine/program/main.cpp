// Chapter 19. The engine: the program.
#include "chapters/19_engine/program/scenes.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "19_engine";
        program.title = "Chapter 19. The engine";
        program.scenes = samples();
        return program;
    };
    return run_program(make, argc, argv);
}
