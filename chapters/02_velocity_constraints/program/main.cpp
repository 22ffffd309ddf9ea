// Chapter 2. Velocity constraints: the program. Each scene_*.hpp has a few scenes, each with its step().
#include "chapters/02_velocity_constraints/program/scene_atwood.hpp"
#include "chapters/02_velocity_constraints/program/scene_beads.hpp"
#include "chapters/02_velocity_constraints/program/scene_discs.hpp"
#include "chapters/02_velocity_constraints/program/scene_links.hpp"
#include "chapters/02_velocity_constraints/program/scene_pendulum.hpp"
#include "chapters/02_velocity_constraints/program/scene_plane.hpp"
#include "chapters/02_velocity_constraints/program/scene_wedge.hpp"
#include "common/program/program.hpp"

namespace {

using namespace rigid;

Demo ellipse_scene()
{
    Demo scene = bead_scene(
        "ellipse", "A bead on an ellipse", 9.81, [](const Settings& settings) {
            return ellipse_wire(settings["width"], settings["height"]);
        });
    scene.tunables.push_back({"width", "m", "semi-axis along x", 1.6, 0.2, 1.9,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"height", "m", "semi-axis along y", 0.8, 0.2, 1.6,
                              Numbers::real, OnChange::restarts});
    return scene;
}

}  // namespace

int main(int argc, char** argv)
{
    const auto make = [] {
        Program program;
        program.name = "02_velocity_constraints";
        program.title = "Chapter 2. Velocity constraints";
        program.scenes = {
            bead_scene("circle",
                       "A bead on a circular wire leaves it, by a closed form", 0,
                       [](const Settings&) { return circle_wire(); }),
            ellipse_scene(),
            bead_scene(
                "own_curve",
                "A bead on a curve of your own, its gradient found by the machine",
                9.81, [](const Settings&) { return own_wire(); }),
            pendulum_scene(),
            plane_scene(),
            discs_scene(),
            chain_scene(),
            conflict_scene(),
            atwood_scene(),
            wedge_scene()};
        return program;
    };
    return run_program(make, argc, argv);
}
