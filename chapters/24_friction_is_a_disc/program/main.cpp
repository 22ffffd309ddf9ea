// Chapter 24. Friction is a disc: the program.
#include "chapters/24_friction_is_a_disc/program/spin_scenes.hpp"
#include "chapters/24_friction_is_a_disc/program/touch_scenes.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "24_friction_is_a_disc";
        program.title = "Chapter 24. Friction is a disc";
        program.scenes = {slide_scene(), stack_scene(),    heap_scene(),
                          table_scene(), low_ball_scene(), rattleback_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
