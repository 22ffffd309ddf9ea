// Chapter 21. Joints in space: the program.
#include "chapters/21_joints_in_space/program/scenes.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "21_joints_in_space";
        program.title = "Chapter 21. Joints in space";
        program.scenes = {door_scene(), chain_scene(), plates_scene(), top_scene(),
                          gyroscope_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
