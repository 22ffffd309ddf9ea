// Chapter 27. Particles and cloth: the program.
#include "chapters/27_particles_and_cloth/program/scenes.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "27_particles_and_cloth";
        program.title = "Chapter 27. Particles and cloth";
        program.scenes = {hung_demo_of_cloth(), chain_demo(),   net_demo(),
                          flag_demo(),          curtain_demo(), banner_demo(),
                          tear_demo(),          strip_demo()};
        return program;
    };
    return run_program(make, argc, argv);
}
