// Chapter 29. Waves: the program.
#include "chapters/29_waves/program/basin_run.hpp"
#include "chapters/29_waves/program/dispersion_run.hpp"
#include "chapters/29_waves/program/pond_run.hpp"
#include "chapters/29_waves/program/pool_run.hpp"

int main(int argc, char** argv)
{
    using namespace rigid;
    const auto make = [] {
        Program program;
        program.name = "29_waves";
        program.title = "Chapter 29. Waves";
        program.scenes = {string_demo(), dispersion_demo(), pool_demo(),
                          dam_demo(),    basin_demo(),      boxes_demo(),
                          boat_demo(),   raft_demo(),       duck_demo()};
        return program;
    };
    return run_program(make, argc, argv);
}
