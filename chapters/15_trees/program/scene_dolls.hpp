/// \file scene_dolls.hpp
/// Dolls fall down a staircase.
#pragma once

#include "chapters/14_joints/ragdoll.hpp"
#include "chapters/15_trees/program/tree_run.hpp"

namespace rigid {

inline Demo dolls_demo()
{
    Demo scene = tree_demo(
        "dolls", "Dolls of ten limbs fall down a staircase", {{2.5, 2.2}, {4.2, 3}},
        1.0 / 60, [](const Settings& settings) {
            JointSetup setup;
            const int count = static_cast<int>(settings["dolls"]);
            add_stairs(setup.scene, 8);
            std::vector<std::pair<Index, Index>> pairs;
            for (int i = 0; i < count; ++i) {
                const Index first =
                    add_ragdoll(setup.scene, {-0.1 + 0.15 * (i % 3), 3.5 + 1.8 * i},
                                settings["friction"]);
                for (Index k = first; k < first + 10; ++k)
                    setup.scene.bodies.velocity(k)[0] = settings["push"];
                forbid_itself(first, [&pairs](Index a, Index b) {
                    pairs.push_back({a, b});
                });
            }
            setup.filter = forbid_pairs(setup.scene.bodies.count(), pairs);
            cover(setup.scene, {settings["mu"], 0, 0, 0});
            setup.touches = true;
            setup.measure = [](const JointState& s) -> std::vector<Real> {
                return {largest_gap(s.scene),
                        energy(s.scene),
                        s.residual(),
                        static_cast<Real>(s.now.contacts.size()),
                        static_cast<Real>(s.asleep),
                        static_cast<Real>(s.rounds)};
            };
            return setup;
        });
    scene.methods.insert(scene.methods.begin(), "sleeping");
    for (Tunable& tunable : scene.tunables)
        if (tunable.name == "sweeps") tunable.value = 40;  // of large heaps
    scene.tunables.push_back(
        {"dolls", "", "how many", 2, 1, 100, Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"friction", "N m", "torque of the joints", 2, 0, 50,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"push", "m/s", "to the right, at the start", 0.8, -3,
                              3, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"mu", "", "friction of all surfaces", 0.6, 0, 2,
                              Numbers::real, OnChange::restarts});
    scene.columns = {{"gap", "m", "largest error of a joint", Plot::logarithmic},
                     {"energy", "J", "kinetic and potential", Plot::linear},
                     {"residual", "m/s", "what the solver left", Plot::logarithmic},
                     {"contacts", "", "points"},
                     {"asleep", "", "bodies, under sleeping", Plot::linear},
                     {"rounds", "", "of (15.9), where guesses had no answer"}};
    return scene;
}

}  // namespace rigid
