/// \file tree_run.hpp
/// One scene with joints, under one of this chapter's methods.
#pragma once

#include "chapters/14_joints/program/joint_run.hpp"
#include "chapters/15_trees/tree_method.hpp"

#include <array>
#include <string>

namespace rigid {

/// The methods of this chapter, and the sweeps of the last.
struct TreeMethods {
    JointTrees<Manifolds> trees;
    SkippingJoints sleeping;
    JointSweeps<Manifolds> sweeps;
    JointRattle<Manifolds> rattle;

    std::array<Manifolds*, 4> touching()
    {
        return {&trees.contacts, &sleeping.contacts.touching, &sweeps.contacts,
                &rattle.contacts};
    }

    void step(JointState& state, const StepSettings& how, const Settings& settings)
    {
        const int count = static_cast<int>(settings["sweeps"]);
        if (settings.tunables.contains("restitution"))
            trees.correction.restitution = sleeping.correction.restitution =
                sweeps.correction.restitution = rattle.correction.restitution =
                    settings["restitution"];
        if (settings.method == "rattle") {
            rattle.solver.sweeps = count;
            rigid::step(state.scene, how, rattle, state.now);
            state.tree_rows = rattle.solver.joints.tree.work.solved_rows;
        } else if (settings.method == "sweeps") {
            JointMethods::by_sweeps(state, how, settings, sweeps);
        } else if (settings.method == "sleeping") {
            by_trees(state, how, settings, sleeping);
            const auto& set = sleeping.contacts.set;
            state.asleep = 0;
            for (Index k = 0; k < state.scene.bodies.count(); ++k)
                state.asleep += state.scene.bodies.can_move(k) && set.is_asleep(k);
        } else by_trees(state, how, settings, trees);
    }

private:
    template <class Method>
    static void by_trees(JointState& state, const StepSettings& how,
                         const Settings& settings, Method& method)
    {
        method.correction.stiff = settings["stiff"] > 0;
        method.solver.sweeps = static_cast<int>(settings["sweeps"]);
        rigid::step(state.scene, how, method, state.now);
        state.tree_rows = method.solver.joints.tree.work.solved_rows;
        state.rounds = method.solver.sweeps_made;
    }
};

/// A scene with the methods and the tunables that all of them have.
inline Demo tree_demo(const std::string& name, const std::string& summary,
                      const View& view, Real h,
                      const std::function<JointSetup(const Settings&)>& setup)
{
    Demo scene = turning_demo<JointRunBy<TreeMethods>>(
        name, summary, view, h, {"trees", "sweeps", "rattle"}, setup);
    scene.tunables.push_back({"stiff", "",
                              "1: what a load stiffens gets inertia, (15.15)", 1, 0,
                              1, Numbers::whole});
    return scene;
}

}  // namespace rigid
