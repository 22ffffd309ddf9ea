/// \file scene_walkers.hpp
/// Walkers cross a bridge.
#pragma once

#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/14_joints/program/joint_run.hpp"
#include "chapters/14_joints/walker.hpp"

namespace rigid {

inline JointSetup walkers_setup(const Settings& settings)
{
    JointSetup setup;
    setup.touches = true;
    setup.scene =
        bridge_scene(static_cast<int>(settings["planks"]), settings["plank"], 8.03);
    JointedScene& all = setup.scene;
    const Index planks = all.bodies.count();
    for (const Real side : {-1.0, 1.0})  // the banks
        add_body(all, box(6, 1), Mass{}, {7.02 * side, -0.45});
    const Index first = all.bodies.count();
    std::vector<std::size_t> motors;
    std::vector<Index> feet;
    Index chassis = 0;
    for (int i = 0; i < static_cast<int>(settings["walkers"]); ++i) {
        const Walker walker =
            add_walker(all, -5.2 - 1.7 * i, 0.06, {0, settings["torque"], 0, 0, 0});
        if (i == 0) chassis = walker.chassis;
        motors.push_back(walker.motor);
        feet.insert(feet.end(), walker.feet.begin(), walker.feet.end());
    }
    cover(all, {1, 0, 0, 0});
    // of a walker only its feet touch anything, and not each other
    setup.filter.group.assign(static_cast<std::size_t>(all.bodies.count()), 0);
    for (Index k = first; k < all.bodies.count(); ++k)
        setup.filter.group[static_cast<std::size_t>(k)] = 1;
    for (const Index k : feet) setup.filter.group[static_cast<std::size_t>(k)] = 2;
    setup.filter.set_meets(0, 1, false);
    setup.filter.set_meets(1, 1, false);
    setup.filter.set_meets(1, 2, false);
    setup.filter.set_meets(2, 2, false);
    setup.change = [motors](JointedScene& moved, const Settings& now) {
        for (const std::size_t motor : motors)
            set_motor(moved, motor, -now["speed"]);
    };
    setup.measure = [=](const JointState& s) -> std::vector<Real> {
        Real sag = 0;
        for (Index k = 0; k < planks; ++k)
            sag = std::min(sag, s.scene.bodies.x[3 * k + 1]);
        return {s.scene.bodies.x[3 * chassis], -sag, largest_gap(s.scene),
                s.residual()};
    };
    return setup;
}

inline Demo walkers_demo()
{
    Demo scene = joint_demo("walkers", "Machines on Jansen's legs cross a bridge",
                            {{-1.5, 0.2}, {7.5, 2.4}}, 1.0 / 240, walkers_setup);
    scene.tunables.push_back(
        {"walkers", "", "how many", 2, 1, 3, Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"planks", "", "of the bridge", 20, 8, 40,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back(
        {"plank", "kg", "of each", 20, 1, 200, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"speed", "rad/s", "of the cranks", 4, -8, 8,
                              Numbers::real, OnChange::goes_on, Keys::up_and_down});
    scene.tunables.push_back({"torque", "N m", "of each motor, at most", 300, 1,
                              3000, Numbers::real, OnChange::restarts});
    scene.columns = {{"x", "m", "of the first walker", Plot::linear},
                     {"sag", "m", "of the bridge", Plot::linear},
                     {"gap", "m", "largest error of a joint", Plot::logarithmic},
                     {"residual", "m/s", "what the solver left"}};
    return scene;
}

}  // namespace rigid
