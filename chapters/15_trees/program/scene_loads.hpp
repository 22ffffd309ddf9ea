/// \file scene_loads.hpp
/// Chains and bridges under loads that sweeps cannot hold.
#pragma once

#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/15_trees/program/tree_run.hpp"

namespace rigid {

inline std::vector<Column> load_columns()
{
    return {
        {"gap", "m", "largest error of a joint", Plot::logarithmic},
        {"energy", "J", "kinetic and potential, from the start on", Plot::linear},
        {"residual", "m/s", "what the solver left", Plot::logarithmic},
        {"tree_rows", "", "rows of trees solved, so far"}};
}

inline std::vector<Real> load_measures(const JointState& s)
{
    return {largest_gap(s.scene), energy(s.scene) - s.energy_at_start, s.residual(),
            static_cast<Real>(s.tree_rows)};
}

/// A chain with a weight of 1000 links at its end.
inline Demo chain_demo()
{
    Demo scene =
        tree_demo("chain", "A chain holds a weight of a thousand links",
                  {{0, -2.6}, {3.2, 3.2}}, 1.0 / 60, [](const Settings& settings) {
                      JointSetup setup;
                      setup.scene = chain_scene(
                          {static_cast<int>(settings["links"]), 0.1, 0.1,
                           settings["ratio"], settings["angle"] * pi / 180});
                      setup.measure = load_measures;
                      return setup;
                  });
    scene.tunables.push_back({"links", "", "of the chain", 50, 1, 400,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"ratio", "", "mass of the weight over that of a link",
                              1000, 0.01, 1e6, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"angle", "°", "of the chain at the start", 20, -90,
                              90, Numbers::real, OnChange::restarts});
    scene.columns = load_columns();
    return scene;
}

/// A bridge of planks: pinned at both ends, a loop through the world.
inline Demo bridge_demo()
{
    Demo scene = tree_demo(
        "bridge", "Planks between two banks: a loop through the world",
        {{0, -1}, {4.6, 2}}, 1.0 / 60, [](const Settings& settings) {
            JointSetup setup;
            setup.scene = bridge_scene(static_cast<int>(settings["planks"]));
            for (int i = 0; i < 3; ++i)
                add_body(setup.scene, box(0.5, 0.5), settings["load"] / 0.25,
                         {-2.0 + 2 * i, i == 1 ? -0.8 : -0.2});
            cover(setup.scene, {0.5, 0, 0, 0});
            if (settings["strength"] > 0)
                for (PlacedJoint& placed : setup.scene.placed)
                    placed.joint.breaking_force = 1000 * settings["strength"];
            setup.touches = true;
            setup.measure = load_measures;
            return setup;
        });
    scene.tunables.push_back({"strength", "kN",
                              "a pin that bears more breaks; 0: none breaks", 0, 0,
                              50, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"planks", "", "of the bridge", 20, 2, 200,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"load", "kg", "of each of three boxes", 100, 1, 5000,
                              Numbers::real, OnChange::restarts});
    scene.columns = load_columns();
    return scene;
}

}  // namespace rigid
