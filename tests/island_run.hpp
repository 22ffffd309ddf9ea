/// \file island_run.hpp
/// A scene under the method of chapter 18, and what its last step did.
#pragma once

#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/14_joints/ragdoll.hpp"
#include "chapters/18_islands/island_method.hpp"
#include "chapters/18_islands/island_scenes.hpp"

namespace rigid {

struct IslandsUnderTest {
    JointedScene scene;
    IslandSettings settings;
    IslandMethod method;
    StepData<3> now;

    explicit IslandsUnderTest(const JointedScene& of, const IslandSettings& how = {})
        : scene(of), settings(how), method(island_method(of, how))
    {
        scene.length = 1;
    }
    void step() { rigid::step(scene, {.h = 1.0 / 60, .substeps = settings.substeps}, method, now); }
    void change(const IslandSettings& other)
    {
        settings = other;
        rigid::change(method, other);
    }
    int awake() const { return static_cast<int>(now.active.size()); }
    /// of the last step, none if nothing is awake
    int unsolved() const
    {
        return awake() == 0 ? 0 : std::max(method.solver.unsolved, method.correction.unmet);
    }
    bool answered() const
    {
        const IslandChoice& solver = method.solver;
        return awake() > 0 && solver.exact_count > 0 && solver.answered_count == solver.exact_count;
    }
    std::int64_t price() { return awake() == 0 ? 0 : price_of_step(method, now); }
    std::int64_t entries() { return awake() == 0 ? 0 : method.solver.all_entries(); }
    Real residual() const { return awake() == 0 ? 0 : now.solution.residual; }

    auto position(Index k) const { return scene.bodies.x.segment<2>(3 * k); }
    /// The deepest overlap, when the step began [m]
    Real deepest() const
    {
        Real most = 0;
        if (awake() > 0)
            for (const Contact& contact : now.contacts) most = std::max(most, -contact.gap);
        return most;
    }
    /// The largest error of a joint, a limit included [m], [rad]
    Real joint_error() const
    {
        Real largest = 0;
        for (const PointJoint& row : scene.joints) {
            const Real C = joint_constraint(scene.bodies.x, row).C;
            if (row.kind == ConstraintKind::bilateral) largest = std::max(largest, std::abs(C));
            if (row.kind == ConstraintKind::unilateral) largest = std::max(largest, -C);
        }
        return largest;
    }
};

/// A chain of fifty rods with a thousand rods' mass at its end, which swings. No shape of it touches another.
inline IslandsUnderTest hanging_chain(const IslandSettings& how = {})
{
    IslandsUnderTest run(chain_scene({50, 0.1, 0.1, 1000, 0.3}), how);
    run.method.contacts.touching.finder.filter.set_meets(0, 0, false);
    return run;
}

/// Dolls that fall down a staircase; none meets itself.
inline IslandsUnderTest falling_dolls(int dolls, const IslandSettings& how = {})
{
    JointedScene scene;
    std::vector<std::pair<Index, Index>> pairs;
    add_stairs(scene, 8);
    for (int i = 0; i < dolls; ++i) {
        const Index first = add_ragdoll(scene, {-0.1 + 0.15 * (i % 3), 3.5 + 1.8 * i});
        for (Index k = first; k < first + 10; ++k) scene.bodies.velocity(k)[0] = 0.8;
        forbid_itself(first, [&pairs](Index a, Index b) { pairs.push_back({a, b}); });
    }
    cover(scene, {0.6, 0, 0, 0});
    IslandsUnderTest run(scene, how);
    run.method.contacts.touching.finder.filter = forbid_pairs(scene.bodies.count(), pairs);
    return run;
}

}  // namespace rigid
