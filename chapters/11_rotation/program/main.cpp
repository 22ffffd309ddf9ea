// Chapter 11. Rotation: the program.
#include "chapters/11_rotation/program/scene_mechanisms.hpp"
#include "chapters/11_rotation/program/scene_pendulums.hpp"
#include "chapters/11_rotation/program/scene_rods.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "11_rotation";
        program.title = "Chapter 11. Rotation";
        program.scenes = {rod_scene(),    percussion_scene(), pendulum_scene(),
                          double_scene(), ladder_scene(),     seesaw_scene(),
                          gears_scene(),  crank_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
