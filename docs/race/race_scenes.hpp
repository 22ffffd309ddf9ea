/// \file race_scenes.hpp
/// The scenes of the race: what is where, what is right, and what of it is the error.
#pragma once

#include "chapters/13_friction/houses.hpp"
#include "chapters/13_friction/moving_scenes.hpp"
#include "chapters/14_joints/joint_scenes.hpp"
#include "common/elementary.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace rigid::race {

/// What is measured of positions; the right answer is 0 in all scenes.
enum class Error {
    moved,    ///< of what should rest: how far the body that has moved most is from its start [m]
    overlap,  ///< how deep two bodies, or a body and a wall, are in each other [m]
    gap       ///< how far apart the two points of a pin are [m]
};

struct RaceScene {
    const char *name, *title, *summary;
    Vec2 centre, half_size;  ///< of the picture [m]
    Error error;
    int steps;     ///< of the fixed run
    bool touches;  ///< false: joints alone
    JointedScene scene;
};

inline JointedScene rough(const RigidScene& scene, Real mu)
{
    JointedScene all;
    static_cast<RigidScene&>(all) = scene;
    cover(all, {mu, 0, 0, 0});
    return all;
}

inline JointedScene jointed(const RoughScene& scene)
{
    JointedScene all;
    static_cast<RoughScene&>(all) = scene;
    return all;
}

/// Boxes of 1 kg, and one of `top` kg on them.
inline JointedScene loaded_stack(int boxes, Real top)
{
    JointedScene scene = rough(box_stack(boxes), 0.5);
    scene.bodies.inverse_mass.tail<3>() /= top;
    return scene;
}

/// What rests is set off by a nanometre, body by body in directions drawn by lot: nothing rests by symmetry alone.
inline void set_off(JointedScene& scene, Random& random)
{
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Real angle = random.uniform(0, 2 * pi);
        scene.bodies.position(k).head<2>() += 1e-9 * Vec2(cos(angle), sin(angle));
    }
}

inline std::vector<RaceScene> race_scenes()
{
    Random random(1);
    std::vector<RaceScene> scenes = {
        {"stack",
         "a stack of 20 boxes",
         "Twenty boxes of 1 m on one another: they should stay where they are",
         {0, 10},
         {12, 11},
         Error::moved,
         240,
         true,
         loaded_stack(20, 1)},
        {"heavy",
         "1000 kg on a stack of four",
         "Four boxes of 1 kg, and on them one of 1000 kg",
         {0, 2.6},
         {4.5, 3.2},
         Error::moved,
         240,
         true,
         loaded_stack(5, 1000)},
        {"pyramid",
         "a pyramid of 210 boxes",
         "A pyramid of 210 boxes of 1 m, 5 cm apart in each row",
         {0, 10},
         {12, 11},
         Error::moved,
         120,
         true,
         rough(box_pyramid(20), 0.5)},
        {"arch",
         "an arch of stones",
         "Ten stones, held by their own thrust and by friction of 0.4",
         {0, 0.55},
         {1.5, 0.8},
         Error::moved,
         240,
         true,
         jointed(stone_arch(10, 0.3, 0.4))},
        {"rubble",
         "rubble in a trough",
         "Discs, boxes, capsules and triangles fall into a trough",
         {0, 2.6},
         {4.2, 3},
         Error::overlap,
         360,
         true,
         jointed(random_heap(random, 40, 0.5))},
        {"chain",
         "a chain with a heavy weight",
         "Fifty rods on pins carry a weight of a thousand of them",
         {0, -2.6},
         {3.2, 3.2},
         Error::gap,
         240,
         false,
         chain_scene({50, 0.1, 0.1, 1000, 20 * pi / 180})},
    };
    for (RaceScene& one : scenes)
        if (one.error == Error::moved) set_off(one.scene, random);
    return scenes;
}

/// The error of a scene at these positions. \param referee  finds contacts, and keeps nothing that counts
inline Real error_of(const RaceScene& race, const VecX& x, Manifolds& referee, StepData<3>& now)
{
    if (!x.allFinite()) return infinity;
    JointedScene scene = race.scene;
    scene.bodies.x = x;
    Real most = 0;
    if (race.error == Error::gap) most = largest_joint_error(scene);
    else if (race.error == Error::moved)
        for (Index k = 0; k < scene.bodies.count(); ++k)
            most = std::max(most, (x - race.scene.bodies.x).segment<2>(3 * k).norm());
    else {
        referee.begin(scene, StepSettings{}, referee, now);
        for (const Contact& contact : now.contacts) most = std::max(most, -contact.gap);
    }
    return most;
}

}  // namespace rigid::race
