// Chapter 18. Islands: the program.
#include "chapters/18_islands/island_scenes.hpp"
#include "chapters/18_islands/program/island_run.hpp"

namespace {

using namespace rigid;

Tunable number(const char* name, const char* unit, const char* help, Real value,
               Real low, Real high, Numbers numbers = Numbers::whole)
{
    return {name, unit, help, value, low, high, numbers, OnChange::restarts};
}

std::vector<Demo> scenes()
{
    const auto whole = [](Real value) { return static_cast<int>(value); };
    return {
        island_demo("struck",
                    "A ball, a heavy box on two, a tower; a disc strikes the tower",
                    {{-4, 11.5}, {17, 13.5}},
                    number("speed", "m/s", "of the disc; 0: none", 15, 0, 40,
                           Numbers::real),
                    [](Real speed) { return struck_tower_scene(speed); }),
        island_demo("mixed",
                    "A heap that is poured, a net on pins, a pile: one floor",
                    {{0.8, 4}, {8.5, 5}},
                    number("bodies", "", "that are poured", 80, 1, 1000),
                    [=](Real n) { return mixed_scene(whole(n), 6); }),
        island_demo("poured", "Boxes and discs are poured into a trough",
                    {{0, 4}, {6, 4.6}},
                    number("bodies", "", "that are poured", 100, 1, 3000),
                    [=](Real n) { return poured_scene(whole(n)); }),
        island_demo(
            "heavy", "A heavy box on ten light ones", {{0, 5.5}, {7, 6.5}},
            number("ratio", "", "its mass over that of one of them", 1000, 1, 1e4,
                   Numbers::real),
            [](Real ratio) { return rough_scene(loaded_column(10, ratio)); }),
        island_demo("pyramid", "A pyramid of boxes", {{0, 5}, {8, 6}},
                    number("base", "", "boxes at its foot", 10, 1, 60),
                    [=](Real n) { return rough_scene(box_pyramid(whole(n))); }),
        island_demo("net", "A net of discs on pins", {{2.2, -3}, {5, 4}},
                    number("side", "", "discs of a side", 10, 2, 40),
                    [=](Real n) { return net_scene(whole(n)); })};
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "18_islands";
        program.title = "Chapter 18. Islands";
        program.scenes = scenes();
        return program;
    };
    return run_program(make, argc, argv);
}
