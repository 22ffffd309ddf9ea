/// Chapter 16: everything that can hold a scene, by sub-steps: run time against error.
///
///     SCENE/METHOD/SUBSTEPS   time of a step [µs], and in steps of the hard sweeps without sub-steps of the same scene;
///                             the largest error over four seconds [m]; rows visited in a step
///
/// pyramid, house: how far the body that moved most is from where it was built; chain: the largest gap of a joint; dolls: the
/// largest gap or overlap. Four sweeps a sub-step; `equal` are hard sweeps, 16 in a step however many sub-steps it has. Each
/// place has 1e-9 m of noise: nothing is at rest to the last bit.

#include "chapters/13_friction/houses.hpp"
#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/14_joints/ragdoll.hpp"
#include "chapters/15_trees/tree_method.hpp"
#include "chapters/16_soft_constraints/soft_method.hpp"
#include "chapters/16_soft_constraints/soft_scenes.hpp"
#include "common/random.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include <map>
#include <string>
#include <vector>

using namespace rigid;

namespace {

constexpr int sweeps = 4;

struct Given {
    JointedScene scene;
    CollisionFilter filter;
    bool at_rest = false;
};

Given given(const std::string& name)
{
    Given all;
    if (name == "pyramid") {
        static_cast<RigidScene&>(all.scene) = box_pyramid(10);
        cover(all.scene, {0.6, 0, 0, 0});
    } else if (name == "house") {
        static_cast<RoughScene&>(all.scene) = card_house(3, 0.6);
    } else if (name == "chain") {
        all.scene = chain_scene({20, 0.1, 0.1, 100, 20 * pi / 180});
        all.filter.set_meets(0, 0, false);
    } else {
        add_stairs(all.scene, 8);
        std::vector<std::pair<Index, Index>> pairs;
        for (int i = 0; i < 2; ++i)
            forbid_itself(
                add_ragdoll(all.scene, {-0.1 + 0.15 * i, 3.4 + 1.8 * i}, 2),
                [&pairs](Index a, Index b) {
                    pairs.push_back({a, b});
                });
        all.filter = forbid_pairs(all.scene.bodies.count(), pairs);
        cover(all.scene, {0.6, 0, 0, 0});
    }
    all.at_rest = name == "pyramid" || name == "house";
    Random random(1);
    for (Index i = 0; i < all.scene.bodies.x.size(); ++i)
        if (all.scene.bodies.inverse_mass[i] > 0)
            all.scene.bodies.x[i] += 1e-9 * random.uniform(-1, 1);
    return all;
}

struct Measured {
    Real microseconds = 0, error = 0, visits = 0;
};

template <class Method>
Measured measure(Method method, const Given& start, int substeps)
{
    JointedScene scene = start.scene;
    Manifolds& touching = method.contacts;
    touching.finder.filter = start.filter;
    touching.fast.stop = false;
    StepData<3> now;
    Measured result;
    constexpr int steps = 240;
    std::chrono::duration<Real, std::micro> time{0};
    for (int i = 0; i < steps; ++i) {
        const auto before = std::chrono::steady_clock::now();
        try {
            step(scene, {.h = 1.0 / 60, .substeps = substeps}, method, now);
        } catch (const std::exception&) {  // it has left all bounds
            result.error = infinity;
            break;
        }
        time += std::chrono::steady_clock::now() - before;
        result.visits += static_cast<Real>(now.visits) / steps;
        Real error = largest_joint_error(scene);
        if (start.at_rest)
            for (Index k = 0; k < scene.bodies.count(); ++k)
                error = std::max(error, (scene.bodies.x - start.scene.bodies.x)
                                            .segment<2>(3 * k)
                                            .norm());
        else
            for (const Contact& contact : now.contacts)
                error = std::max(
                    error,
                    -contact_constraint(contact, now.x_found, scene.bodies.x).C);
        result.error = std::max(result.error, error);
    }
    result.microseconds = time.count() / steps;
    return result;
}

template <class Method>
Method swept(Method method)
{
    method.solver.sweeps = {sweeps, 0};
    return method;
}

Measured run(const std::string& method, const Given& start, int substeps)
{
    if (method == "soft" || method == "preloaded") {
        auto soft = swept(SoftSweeps<Manifolds>{});
        soft.correction.preloaded = method == "preloaded";
        return measure(soft, start, substeps);
    }
    if (method == "xpbd") {
        PositionSweeps<Manifolds> positions;
        positions.correction.sweeps = sweeps;
        return measure(positions, start, substeps);
    }
    if (method == "bodies") {
        BodyDescent<Manifolds> bodies;
        bodies.correction.sweeps = sweeps;
        return measure(bodies, start, substeps);
    }
    if (method == "exact")
        return measure(ExactJoints<Manifolds>{}, start, substeps);
    if (method == "trees") {
        JointTrees<Manifolds> trees;
        trees.solver.sweeps = sweeps;
        return measure(trees, start, substeps);
    }
    auto hard = swept(JointSweeps<Manifolds>{});
    if (method == "equal") hard.solver.sweeps = {16 / substeps, 0};
    hard.correction = steady_contacts();
    return measure(hard, start, substeps);
}

const bool registered = [] {
    for (const char* scene : {"pyramid", "house", "chain", "dolls"})
        for (const char* method : {"hard", "equal", "soft", "preloaded", "xpbd",
                                   "bodies", "exact", "trees"}) {
            if (std::string(method) == "trees" && std::string(scene) != "chain")
                continue;
            auto* const one = benchmark::RegisterBenchmark(
                (std::string(scene) + "/" + method).c_str(),
                [scene, method](benchmark::State& state) {
                    static std::map<std::string, Real> unit;
                    const Given start = given(scene);
                    const int substeps = static_cast<int>(state.range(0));
                    Measured found;
                    for (auto _ : state) found = run(method, start, substeps);
                    if (!unit.contains(scene)) unit[scene] = found.microseconds;
                    state.counters["us"] = found.microseconds;
                    state.counters["ratio"] = found.microseconds / unit[scene];
                    state.counters["error"] = found.error;
                    state.counters["visits"] = found.visits;
                });
            for (const int substeps : {1, 2, 4, 8, 16}) one->Args({substeps});
            one->Iterations(1);
        }
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
