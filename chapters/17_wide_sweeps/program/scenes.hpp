/// \file scenes.hpp
/// A column, a pyramid, a pile.
#pragma once

#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/17_wide_sweeps/program/wide_run.hpp"

namespace rigid {

inline JointedScene rough(const RigidScene& smooth)
{
    JointedScene scene;
    static_cast<RigidScene&>(scene) = smooth;
    cover(scene, {0.6, 0, 0, 0});
    return scene;
}

inline Demo column_scene()
{
    Demo scene =
        wide_demo("column", "Boxes in a line: two colours, whatever its length",
                  {{0, 2.4}, {2.4, 2.6}}, [](const Settings& settings) {
                      return rough(box_stack(static_cast<int>(settings["boxes"])));
                  });
    scene.tunables.push_back(
        wide_tunable("boxes", "of the column", 5, 1, 40, OnChange::restarts));
    return scene;
}

inline Demo wide_pyramid_scene()
{
    Demo scene =
        wide_demo("pyramid", "Contacts of one colour share no box",
                  {{0, 4.2}, {5.2, 4.6}}, [](const Settings& settings) {
                      return rough(box_pyramid(static_cast<int>(settings["base"])));
                  });
    scene.tunables.push_back(wide_tunable("base", "boxes of the lowest row", 8, 1,
                                          30, OnChange::restarts));
    return scene;
}

inline Demo wide_pile_scene()
{
    Demo scene =
        wide_demo("pile", "Shapes of all kinds fall into a trough",
                  {{0, 3}, {5, 3.6}}, [](const Settings& settings) {
                      return rough(pile(static_cast<int>(settings["bodies"])));
                  });
    scene.tunables.push_back(
        wide_tunable("bodies", "that fall", 60, 1, 300, OnChange::restarts));
    return scene;
}

}  // namespace rigid
