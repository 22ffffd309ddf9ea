/// \file scenes.hpp
/// The samples: a world each, and what may be chosen of it.
#pragma once

#include "chapters/19_engine/furniture.hpp"
#include "chapters/19_engine/program/world_run.hpp"

namespace rigid {

/// A scene with one number of its own.
inline Demo sample(const std::string& name, const std::string& summary,
                   const View& view, const Tunable& number, World (*make)(Real))
{
    Demo scene = world_demo(name, summary, view,
                            [make, key = number.name](const Settings& s) {
                                return WorldSetup{make(s[key])};
                            });
    scene.tunables.insert(scene.tunables.begin(), number);
    return scene;
}

inline Tunable count_of(const char* name, const char* help, Real value, Real low,
                        Real high)
{
    return {name, "", help, value, low, high, Numbers::whole, OnChange::restarts};
}

inline int whole(Real value) { return static_cast<int>(value); }

inline std::vector<Demo> samples()
{
    std::vector<Demo> all;
    all.push_back(sample("pyramid", "A pyramid of boxes", {{0, 5}, {8, 6}},
                         count_of("base", "boxes at its foot", 10, 1, 60),
                         [](Real n) { return pyramid_world(whole(n)); }));
    all.push_back(sample("house", "A house of cards", {{0, 2.2}, {3.4, 2.6}},
                         count_of("storeys", "of the house", 4, 1, 10),
                         [](Real n) { return house_world(whole(n)); }));
    all.push_back(sample("heavy", "A heavy box on ten light ones",
                         {{0, 5.5}, {7, 6.5}},
                         {"ratio", "", "its mass over that of one of them", 1000, 1,
                          1e4, Numbers::real, OnChange::restarts},
                         [](Real ratio) { return column_world(10, ratio); }));
    all.push_back(sample("column", "A column of boxes", {{0, 10}, {12, 12}},
                         count_of("boxes", "in the column", 20, 1, 80),
                         [](Real n) { return column_world(whole(n) - 1); }));
    all.push_back(sample("chain", "A heavy weight on a light chain",
                         {{0.8, -2.6}, {3.4, 3.2}},
                         {"ratio", "", "mass of the weight over that of a link",
                          1000, 1, 1e5, Numbers::real, OnChange::restarts},
                         [](Real ratio) { return chain_world(50, ratio); }));
    all.push_back(sample("bridge", "Balls on a bridge of planks", {{0, 0}, {5, 4}},
                         count_of("planks", "of the bridge", 20, 2, 80),
                         [](Real n) { return bridge_world(whole(n)); }));
    all.push_back(sample("grid", "A net of discs on pins", {{2.2, -3}, {5, 4}},
                         count_of("side", "discs of a side", 10, 2, 40),
                         [](Real n) { return grid_world(whole(n)); }));
    all.push_back(sample("dolls", "Dolls fall down a staircase",
                         {{2.4, 2.6}, {4, 3.2}},
                         count_of("dolls", "ragdolls", 3, 1, 60),
                         [](Real n) { return dolls_world(whole(n)); }));
    all.push_back(sample("poured", "Boxes and discs are poured into a trough",
                         {{0, 4}, {6, 4.6}},
                         count_of("bodies", "that are poured", 100, 1, 3000),
                         [](Real n) { return poured_world(whole(n)); }));
    Demo tumbler =
        world_demo("tumbler", "Boxes in a drum that turns", {{0, 0}, {3.4, 3.2}},
                   [](const Settings& settings) {
                       return WorldSetup{tumbler_world(whole(settings["boxes"]),
                                                       settings["spin"]),
                                         [](World& here, const Settings& s) {
                                             turn_tumbler(here, s["spin"], s.h);
                                         }};
                   });
    tumbler.tunables.insert(tumbler.tunables.begin(),
                            {count_of("boxes", "in the drum", 40, 1, 64),
                             {"spin", "rad/s", "of the drum", 0.5, -3, 3}});
    all.push_back(tumbler);
    all.push_back(sample("piles", "Piles that fall asleep", {{9, 4}, {11, 6}},
                         count_of("piles", "of five boxes", 10, 1, 1000),
                         [](Real n) { return piles_world(whole(n)); }));
    all.push_back(sample("dominoes", "Dominoes", {{4, 1.5}, {6, 3}},
                         count_of("dominoes", "in a row", 16, 2, 100),
                         [](Real n) { return domino_world(whole(n)); }));
    all.push_back(sample("bricks", "A ball against a wall of bricks",
                         {{-1, 1.6}, {4.5, 3}},
                         count_of("rows", "of bricks", 8, 1, 20),
                         [](Real n) { return bricks_world(whole(n), 5); }));
    all.push_back(sample("wrecker", "A ball on a chain swings into a wall",
                         {{-0.8, 2.6}, {5, 3.4}},
                         count_of("rows", "of bricks", 8, 1, 20),
                         [](Real n) { return wrecker_world(whole(n)); }));
    all.push_back(
        sample("seesaw", "A heavy box falls on a seesaw", {{0, 3}, {5, 4}},
               {"ratio", "", "its mass over that of one of the light ones", 20, 1,
                1000, Numbers::real, OnChange::restarts},
               [](Real ratio) { return seesaw_world(ratio); }));
    all.push_back(sample("arch", "An arch of stones", {{0, 0.55}, {1.5, 0.9}},
                         count_of("stones", "of the arch", 12, 4, 60),
                         [](Real n) { return arch_world(2 * (whole(n) / 2)); }));
    all.push_back(sample("rubble", "Rubble of all shapes", {{0, 2.5}, {5, 4}},
                         count_of("bodies", "in the trough", 60, 1, 400),
                         [](Real n) { return rubble_world(whole(n), 1); }));
    all.push_back(
        world_demo("cart", "A cart on sprung rollers with tracks", {{6, 1}, {9, 5}},
                   [](const Settings&) { return WorldSetup{cart_world()}; }));
    all.push_back(world_demo(
        "gates", "Two kinds of balls, a ledge for each", {{0, 1}, {5, 4.6}},
        [](const Settings&) { return WorldSetup{gates_world()}; }));
    all.push_back(sample("furniture", "Tables and wheels of several shapes",
                         {{0, 3}, {5, 4}},
                         count_of("bodies", "in the trough", 24, 1, 400),
                         [](Real n) { return furniture_world(whole(n), 1); }));
    all.push_back(
        world_demo("bullets", "Bullets and thin walls", {{0, 2.4}, {6, 4}},
                   [](const Settings&) { return WorldSetup{bullets_world()}; }));
    return all;
}

}  // namespace rigid
