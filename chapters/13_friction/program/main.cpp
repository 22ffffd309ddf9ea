// Chapter 13. Friction: the program.
#include "chapters/13_friction/program/scene_stick_slip.hpp"
#include "chapters/13_friction/program/scenes.hpp"
#include "chapters/13_friction/program/structures.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "13_friction";
        program.title = "Chapter 13. Friction";
        program.scenes = {slope_scene(),    disc_scene(),       rod_scene(),
                          conveyor_scene(), stick_slip_scene(), house_scene(),
                          arch_scene(),     domino_scene(),     pool_scene(),
                          wall_scene(),     rubble_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
