// Chapter 14. Joints: the program.
#include "chapters/14_joints/program/scene_excavator.hpp"
#include "chapters/14_joints/program/scene_vehicles.hpp"
#include "chapters/14_joints/program/scene_walkers.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "14_joints";
        program.title = "Chapter 14. Joints";
        program.scenes = {car_demo(), trebuchet_demo(), walkers_demo(),
                          excavator_demo()};
        return program;
    };
    return run_program(make, argc, argv);
}
