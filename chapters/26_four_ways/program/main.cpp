// Chapter 26. Four ways to say a constraint: the program.
#include "chapters/26_four_ways/program/ways_run.hpp"

namespace {

using namespace rigid;

WayScene bead_scene()
{
    WayScene way;
    way.scene = bead_on_a_wire();
    way.stiffness = 1e4;
    way.error = [](const JointedScene& s) {
        return std::abs(s.bodies.position(0).head<2>().norm() - 1);
    };
    return way;
}

/// A wheel that a proportional-derivative controller turns back to zero.
Demo controlled_scene()
{
    const auto make = [](const Settings& settings) {
        WayScene way;
        way.scene.gravity = {0, 0};
        add_body(way.scene, disc(0.5), Mass{1, {0, 0}, 1}, {0, 0}, 0.5);
        RigidJoint joint;
        joint.b = 0;
        joint.spring.stiffness = settings["gain"];
        joint.spring.damping = settings["rate_gain"];
        add_joint(way.scene, joint);
        way.stiffness = 1e4;
        return way;
    };
    Demo demo = demo_of<WaysRun, WayScene>(
        "controlled", "A wheel and its controller: as a force, and as a row",
        {{0, 0}, {0.8, 0.6}}, 1.0 / 240, {"spring", "impulses"},
        {{"stiffness", "N/m", "of the pin in place of its rows", 1e4, 10, 1e5,
          Numbers::real, OnChange::restarts},
         {"sweeps", "", "of positions: not used here", 20, 1, 200, Numbers::whole,
          OnChange::restarts},
         {"gain", "N m", "k of the controller", 1e5, 1, 1e9, Numbers::real,
          OnChange::restarts},
         {"rate_gain", "N m s", "d of the controller", 100, 0, 1e5, Numbers::real,
          OnChange::restarts}},
        make);
    demo.columns = {{"joint", "m", "the largest error of the pin"},
                    {"overlap", "m", "none here"},
                    {"energy", "J", "gained since the start", Plot::linear}};
    return demo;
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "26_four_ways";
        program.title = "Chapter 26. Four ways to say a constraint";
        program.scenes = {
            ways_demo("pendulum", "A rod on a pin, from level",
                      {{0, -0.2}, {1.6, 1.2}}, pendulum),
            ways_demo("bead", "A bead on a circular wire", {{0, 0}, {1.8, 1.3}},
                      bead_scene),
            ways_demo("double_pendulum", "Two rods in a row, from level",
                      {{0, -0.3}, {2.8, 2.1}}, double_pendulum),
            ways_demo("slider_crank", "A crank, a rod and a slider: a loop",
                      {{0.3, 0}, {0.7, 0.5}}, slider_crank_loop),
            ways_demo("chain", "Twenty light rods and a heavy end",
                      {{0, -1.1}, {2, 1.5}}, heavy_chain),
            ways_demo("slope", "A block slides down a slope", {{1, -0.5}, {2, 1.5}},
                      sliding_block),
            ways_demo("ball", "A ball bounces to rest", {{0, 0.6}, {1, 0.75}},
                      bouncing_ball),
            ways_demo("stack", "Five boxes", {{0, 2.5}, {3.8, 2.8}}, stack_of_five),
            ways_demo("rod", "The rod that jams: a law without a finite force",
                      {{0, 0.5}, {1, 0.75}}, jammed_rod),
            ways_demo("cradle", "Five balls in a row", {{0.4, 0}, {0.8, 0.6}},
                      newtons_cradle),
            ways_demo("doll", "A doll falls on a floor", {{0, 0.9}, {1.6, 1.2}},
                      falling_doll),
            controlled_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
