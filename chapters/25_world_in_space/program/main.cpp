// Chapter 25. A world in space: the program.
#include "chapters/25_world_in_space/program/fall_scenes.hpp"
#include "chapters/25_world_in_space/program/joint_scenes.hpp"
#include "chapters/25_world_in_space/program/mesh_demo.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "25_world_in_space";
        program.title = "Chapter 25. A world in space";
        program.scenes = {cradle_scene(), heavy_scene(), wall_scene(),
                          cards_scene(),  pour_scene(),  dolls_scene(),
                          car_scene(),    hills_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
