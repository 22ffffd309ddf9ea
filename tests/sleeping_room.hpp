/// \file sleeping_room.hpp
/// A scene whose bodies hang on joints and may fall asleep, under a method of chapters 14 or 15.
#pragma once

#include "chapters/14_joints/joint_method.hpp"

#include "tests/catch.hpp"

#include <algorithm>

namespace rigid {

template <class Method>
struct Room {
    JointedScene scene;
    Method method;
    StepData<3> now;
    Real worst = 0;  ///< the largest error of a joint so far [m]

    void run(int steps)
    {
        for (int i = 0; i < steps; ++i) {
            step(scene, {.h = 1.0 / 60}, method, now);
            REQUIRE(scene.bodies.x.allFinite());
            worst = std::max(worst, largest_joint_error(scene));
        }
    }
    bool asleep(Index k) const { return method.contacts.set.is_asleep(k); }
    bool all_asleep() const { return method.contacts.set.awake.empty(); }
    /// \return  the steps that it took
    int until_asleep(int most)
    {
        int steps = 0;
        do run(1);
        while (!all_asleep() && ++steps < most);
        return steps;
    }
};

}  // namespace rigid
