// Chapter 12. Contact manifolds: the program.
#include "chapters/12_contact_manifolds/program/scene_chains.hpp"
#include "chapters/12_contact_manifolds/program/scene_corners.hpp"
#include "chapters/12_contact_manifolds/program/scene_stacks.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "12_contact_manifolds";
        program.title = "Chapter 12. Contact manifolds";
        program.scenes = {across_scene(),  stack_scene(),   overhang_scene(),
                          rocking_scene(), rolling_scene(), bullet_scene(),
                          pile_scene(),    chain_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
