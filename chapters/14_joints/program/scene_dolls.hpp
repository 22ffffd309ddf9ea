/// \file scene_dolls.hpp
/// Dolls fall down a staircase.
#pragma once

#include "chapters/14_joints/program/joint_run.hpp"
#include "chapters/14_joints/ragdoll.hpp"

namespace rigid {

inline Demo dolls_demo()
{
    Demo scene = joint_demo(
        "dolls", "Dolls of ten limbs fall down a staircase", {{2.5, 2.2}, {4.2, 3}},
        1.0 / 60, [](const Settings& settings) {
            JointSetup setup;
            const int count = static_cast<int>(settings["dolls"]);
            add_stairs(setup.scene, 8);
            std::vector<std::pair<Index, Index>> pairs;
            for (int i = 0; i < count; ++i)
                forbid_itself(add_ragdoll(setup.scene,
                                          {-0.1 + 0.15 * (i % 3), 3.4 + 1.8 * i},
                                          settings["friction"]),
                              [&pairs](Index a, Index b) {
                                  pairs.push_back({a, b});
                              });
            setup.filter = forbid_pairs(setup.scene.bodies.count(), pairs);
            cover(setup.scene, {settings["mu"], 0, 0, 0});
            setup.touches = true;
            setup.measure = [](const JointState& s) -> std::vector<Real> {
                return {largest_joint_error(s.scene), energy(s.scene), s.residual(),
                        static_cast<Real>(s.now.contacts.size())};
            };
            return setup;
        });
    scene.tunables.push_back(
        {"dolls", "", "how many", 2, 1, 100, true, true, false});
    scene.tunables.push_back(
        {"friction", "N m", "torque of the joints", 2, 0, 50, false, true, false});
    scene.tunables.push_back(
        {"mu", "", "friction of all surfaces", 0.6, 0, 2, false, true, false});
    scene.columns = {{"gap", "m", "largest error of a joint", true, true},
                     {"energy", "J", "kinetic and potential", true, false},
                     {"residual", "m/s", "what the solver left", true, true},
                     {"contacts", "", "points", false, false}};
    return scene;
}

}  // namespace rigid
