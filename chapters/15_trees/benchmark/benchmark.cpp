/// Chapter 15: one step of a chain with a weight at its end, by all that can solve its rows.
///
///     chain/METHOD/LINKS/RATIO   time of one solve [µs], and how far the velocities are from those in coordinates of
///                                the joints [m/s]; sweeps or steps that it took
///     per_sweep/LINKS            a factor and a solve of the tree, each over one sweep over the same rows
///     beside/SCENE/WHO/SUBSTEPS  four seconds at 60 steps a second: the largest gap of a joint [m], the largest change of
///                                energy as a part of what the scene could lose, of dolls the largest gain, and the time
///                                of a step [µs]
///     leg/SWEEPS                 a second of Jansen's leg on its motor, by so many sweeps, 0 = exactly: how far the crank is
///                                from the motor's speed at the end [rad/s], and the time of a step [µs]
///     dolls/DOLLS                dolls fall on stairs until all sleep, or for a minute: the largest gap as a part of the
///                                shortest limb, steps without an exact answer, when the last fell asleep [s], and the time
///                                of a step [µs]

#include "chapters/04_pgs/conjugate_gradients.hpp"
#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/14_joints/bar_linkages.hpp"
#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/14_joints/ragdoll.hpp"
#include "chapters/15_trees/joint_factor.hpp"
#include "chapters/15_trees/reduced.hpp"
#include "chapters/15_trees/tree_method.hpp"

#ifdef RIGID_HAS_BOX2D
#include "chapters/15_trees/benchmark/peers_box2d.hpp"
#endif
#ifdef RIGID_HAS_BOX2D3
#include "chapters/15_trees/benchmark/peers_box2d3.hpp"
#endif
#ifdef RIGID_HAS_CHIPMUNK
#include "chapters/15_trees/benchmark/peers_chipmunk.hpp"
#endif

#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

using namespace rigid;

namespace {

/// Every row has every counter, or a table of them cannot be written; what was not measured is no number.
void report(benchmark::State& state,
            const std::vector<std::pair<std::string, Real>>& counters)
{
    for (const char* const name :
         {"us", "error", "count", "factor", "solve", "gap", "energy", "residual",
          "unsolved", "asleep_after", "awake", "rows"})
        state.counters[name] = std::numeric_limits<Real>::quiet_NaN();
    for (const auto& [name, value] : counters) state.counters.at(name) = value;
}

/// A chain at 0.3 rad, swinging at 1 rad/s, and the velocities that its weight would lead to in 1/60 s.
struct Given {
    JointedScene scene;
    std::vector<Row<3>> rows;
    VecX b, u_star, truth;

    Given(int links, Real ratio) : scene(chain_scene({links, 0.1, 0.1, ratio, 0.3}))
    {
        Bodies<3>& bodies = scene.bodies;
        for (Index k = 0; k < bodies.count(); ++k)
            bodies.velocity(k) << perpendicular(bodies.position(k).head<2>()), 1;
        for (const PointJoint& joint : scene.joints)
            rows.push_back(
                bilateral(joint_constraint(bodies.x, joint), bodies.inverse_mass));
        b.setZero(static_cast<Index>(rows.size()));
        u_star = bodies.u;
        for (Index k = 0; k < bodies.count(); ++k) u_star[3 * k + 1] -= 9.81 / 60;
        truth.setZero(u_star.size());
        ReducedTree tree(scene);
        tree.nearest(bodies.x, bodies.inverse_mass, u_star,
                     VecX::Zero(u_star.size()), truth);
    }
};

Real microseconds(const std::function<void()>& act)
{
    const auto start = std::chrono::steady_clock::now();
    act();
    return std::chrono::duration<Real, std::micro>(
               std::chrono::steady_clock::now() - start)
        .count();
}

/// The least of a few times.
Real least(const std::function<void()>& act)
{
    Real best = infinity;
    for (int i = 0; i < 9; ++i) best = std::min(best, microseconds(act));
    return best;
}

/// \param solve  velocities after; it returns how many sweeps or steps it took
void measure(benchmark::State& state,
             const std::function<int(const Given&, VecX&)>& solve)
{
    const Given given(static_cast<int>(state.range(0)),
                      static_cast<Real>(state.range(1)));
    VecX u;
    int count = 0;
    Real time = 0;
    for (auto _ : state) time = least([&] { count = solve(given, u); });
    report(state, {{"us", time},
                   {"error", (u - given.truth).lpNorm<Eigen::Infinity>()},
                   {"count", count}});
}

int by_sweeps(const Given& given, int sweeps, VecX& u)
{
    static ImpulseMemory<3> memory;
    Solution solution;
    u = given.u_star;
    sequential_impulse(given.rows, {}, {.max_sweeps = sweeps, .tolerance = 0},
                       memory, u, solution);
    return solution.iterations;
}

int by_tree(const Given& given, VecX& u)
{
    static JointFactor factor;
    VecX lambda = VecX::Zero(given.b.size());
    u = given.u_star;
    factor.factor(given.rows, given.scene.bodies.inverse_mass);
    factor.solve(given.rows, given.b, u, lambda);
    return 1;
}

int by_coordinates(const Given& given, VecX& u)
{
    static std::vector<std::pair<int, ReducedTree>> known;
    const int links = static_cast<int>(given.scene.bodies.count());
    if (known.empty() || known.back().first != links)
        known.emplace_back(links, ReducedTree(given.scene));
    u.setZero(given.u_star.size());
    known.back().second.nearest(given.scene.bodies.x,
                                given.scene.bodies.inverse_mass, given.u_star,
                                VecX::Zero(u.size()), u);
    return 1;
}

int by_matrix(const Given& given, bool gradients, VecX& u)
{
    static AssemblyScratch scratch;
    static ActiveSetMemory memory;
    static Mlcp mlcp;
    assemble(given.rows, given.u_star, scratch, mlcp);
    Solution solution;
    solution.lambda.setZero(mlcp.size());
    CgMemory cg;
    if (gradients) conjugate_gradients(mlcp, 1e-9, 100000, cg, solution);
    else active_sets(mlcp, {}, memory, solution);
    u = given.u_star;
    apply(given.rows, solution.lambda, u);
    return solution.iterations;
}

void per_sweep(benchmark::State& state)
{
    const Given given(static_cast<int>(state.range(0)), 1000);
    ImpulseMemory<3> memory;
    Solution solution;
    VecX u = given.u_star, lambda = VecX::Zero(given.b.size());
    begin_sweeps<3>(given.rows, {}, 0, memory, u, solution);
    TreeFactor tree;
    tree.factor(given.rows, given.scene.bodies.inverse_mass);
    Real sweep_time = 0, factor_time = 0, solve_time = 0;
    for (auto _ : state) {
        sweep_time = least([&] { sweep(memory, 0); });
        factor_time = least(
            [&] { tree.factor(given.rows, given.scene.bodies.inverse_mass); });
        solve_time = least([&] {
            u = given.u_star;
            tree.solve(given.b, u, lambda);
        });
    }
    report(state, {{"us", sweep_time},
                   {"factor", factor_time / sweep_time},
                   {"solve", solve_time / sweep_time}});
}

/// A chain at 20° under a weight of so many links, or a bridge with one plank of so many others.
JointedScene loaded(const std::string& name, Real ratio)
{
    if (name == "chain") return chain_scene({50, 0.1, 0.1, ratio, pi / 9});
    JointedScene scene = bridge_scene(40);
    scene.bodies.inverse_mass.segment<3>(60) /= ratio;
    return scene;
}

/// \param advance  one step of 1/60 s; afterwards the scene is where the bodies are
void follow(benchmark::State& state, JointedScene& scene, bool loses,
            const std::function<void()>& advance)
{
    const Real before = energy(scene);
    // what it would lose if its heaviest body fell by a metre
    Real scale = 0;
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if (scene.bodies.can_move(k))
            scale = std::max(scale, 9.81 / scene.bodies.inverse_mass[3 * k]);
    Real gap = 0, drift = 0, time = 0;
    for (auto _ : state)
        for (int i = 0; i < 240 && scene.bodies.x.allFinite(); ++i) {
            time += microseconds(advance);
            gap = std::max(gap, largest_joint_error(scene));
            const Real gained = (energy(scene) - before) / scale;
            // what falls on stairs may lose energy
            drift = std::max(drift, loses ? gained : std::abs(gained));
        }
    const bool finite = scene.bodies.x.allFinite();
    report(state, {{"gap", finite ? gap : infinity},
                   {"energy", finite ? drift : infinity},
                   {"us", time / 240}});
}

template <class Method>
void by_book(benchmark::State& state, JointedScene scene, Method method,
             bool loses = false)
{
    StepData<3> now;
    const int substeps = static_cast<int>(state.range(0));
    follow(state, scene, loses, [&] {
        step(scene, {.h = 1.0 / 60, .substeps = substeps}, method, now);
    });
}

#ifdef RIGID_HAS_BOX2D3
/// Its sub-steps are its own.
void by_box2d3(benchmark::State& state, JointedScene& scene, Box2d3Joints& engine,
               bool loses = false)
{
    follow(state, scene, loses, [&] {
        engine.step(1.0 / 60);
        engine.read(scene);
    });
}
#endif

/// \tparam Engine  with step(h) and read(scene)
template <class Engine>
void by_engine(benchmark::State& state, JointedScene& scene, Engine& engine,
               bool loses = false)
{
    const int substeps = static_cast<int>(state.range(0));
    follow(state, scene, loses, [&] {
        for (int k = 0; k < substeps; ++k) engine.step(1.0 / 60 / substeps);
        engine.read(scene);
    });
}

void register_beside(const std::string& name, int ratio)
{
    const std::string begin = "beside/" + name + "_" + std::to_string(ratio) + "/";
    const auto add = [&](const std::string& who,
                         const std::function<void(benchmark::State&)>& run) {
        benchmark::RegisterBenchmark((begin + who).c_str(), run)
            ->Arg(1)
            ->Arg(4)
            ->Arg(16)
            ->Iterations(1);
    };
    const auto scene = [name, ratio] { return loaded(name, ratio); };
    add("trees", [scene](benchmark::State& state) {
        by_book(state, scene(), JointTrees<AllBodies>{});
    });
    add("trees_not_stiff", [scene](benchmark::State& state) {
        JointTrees<AllBodies> method;
        method.correction.stiff = false;
        by_book(state, scene(), method);
    });
    add("sweeps_10", [scene](benchmark::State& state) {
        JointSweeps<AllBodies> method;
        method.correction.method = Stabilizer::projection;
        method.solver.sweeps.max_sweeps = 10;
        by_book(state, scene(), method);
    });
#ifdef RIGID_HAS_BOX2D
    add("box2d_8_3", [scene](benchmark::State& state) {
        JointedScene here = scene();
        Box2dJoints engine(here, 8, 3);
        by_engine(state, here, engine);
    });
#endif
#ifdef RIGID_HAS_CHIPMUNK
    add("chipmunk_10", [scene](benchmark::State& state) {
        JointedScene here = scene();
        ChipmunkJoints engine(here, 10);
        by_engine(state, here, engine);
    });
#endif
#ifdef RIGID_HAS_BOX2D3
    add("box2d3", [scene](benchmark::State& state) {
        JointedScene here = scene();
        Box2d3Joints engine(here, static_cast<int>(state.range(0)));
        by_box2d3(state, here, engine);
    });
    // as stiff as its sub-steps allow: the default is that for four
    add("box2d3_stiff", [scene](benchmark::State& state) {
        JointedScene here = scene();
        Box2d3Joints engine(here, static_cast<int>(state.range(0)), {}, 1e6);
        by_box2d3(state, here, engine);
    });
#endif
}

/// Dolls fall on stairs, no body sleeps.
struct Ragdolls {
    JointedScene scene;
    std::vector<std::pair<Index, Index>> apart;
    std::vector<int> group;

    explicit Ragdolls(int dolls)
    {
        add_stairs(scene, 8);
        group.assign(static_cast<std::size_t>(scene.bodies.count()), 0);
        for (int i = 0; i < dolls; ++i) {
            const Index first = add_ragdoll(
                scene, {0.2 + 0.9 * (i % 6), 3.6 + 1.9 * (i / 6) - 0.25 * (i % 6)});
            for (Index k = first; k < first + 10; ++k)
                scene.bodies.velocity(k)[0] = 0.8;
            forbid_itself(first, [this](Index a, Index b) {
                apart.push_back({a, b});
            });
            group.insert(group.end(), 10, i + 1);
        }
        cover(scene, {0.6, 0, 0, 0});
    }
};

void register_ragdolls(int dolls)
{
    const auto add = [&](const std::string& who,
                         const std::function<void(benchmark::State&)>& run) {
        benchmark::RegisterBenchmark(
            ("beside/ragdolls_" + std::to_string(dolls) + "/" + who).c_str(), run)
            ->Arg(1)
            ->Arg(4)
            ->Arg(16)
            ->Iterations(1);
    };
    const auto filtered = [](const Ragdolls& all, auto method) {
        auto& touching = method.contacts;
        touching.finder.filter = forbid_pairs(all.scene.bodies.count(), all.apart);
        never_stop(touching);
        return method;
    };
    add("trees", [=](benchmark::State& state) {
        const Ragdolls all(dolls);
        by_book(state, all.scene, filtered(all, JointTrees<Manifolds>{}), true);
    });
    add("sweeps_10", [=](benchmark::State& state) {
        const Ragdolls all(dolls);
        JointSweeps<Manifolds> method;
        method.correction.method = Stabilizer::projection;
        method.solver.sweeps.max_sweeps = 10;
        by_book(state, all.scene, filtered(all, method), true);
    });
#ifdef RIGID_HAS_BOX2D
    add("box2d_8_3", [=](benchmark::State& state) {
        const Ragdolls all(dolls);
        JointedScene here = all.scene;
        Box2dJoints engine(here, 8, 3, all.group);
        by_engine(state, here, engine, true);
    });
#endif
#ifdef RIGID_HAS_CHIPMUNK
    add("chipmunk_10", [=](benchmark::State& state) {
        const Ragdolls all(dolls);
        JointedScene here = all.scene;
        ChipmunkJoints engine(here, 10, all.group);
        by_engine(state, here, engine, true);
    });
#endif
#ifdef RIGID_HAS_BOX2D3
    add("box2d3", [=](benchmark::State& state) {
        const Ragdolls all(dolls);
        JointedScene here = all.scene;
        Box2d3Joints engine(here, static_cast<int>(state.range(0)), all.group);
        by_box2d3(state, here, engine, true);
    });
#endif
}

void leg(benchmark::State& state)
{
    JointedScene scene;
    const Index crank = add_jansen_leg(scene, 0.4, {6, 1e3, 0, 0, 0});
    JointTrees<AllBodies> method;
    if (state.range(0) > 0) method.solver.most_exact = 0;
    method.solver.sweeps = static_cast<int>(state.range(0));
    StepData<3> now;
    Real time = 0;
    for (auto _ : state)
        for (int i = 0; i < 240; ++i)
            time +=
                microseconds([&] { step(scene, {.h = 1.0 / 240}, method, now); });
    report(state, {{"error", std::abs(scene.bodies.u[3 * crank + 2] - 6)},
                   {"residual", now.solution.residual},
                   {"us", time / 240}});
}

/// Six dolls beside each other, and others above them.
JointedScene falling_dolls(int dolls, SkippingJoints& method)
{
    JointedScene scene;
    add_stairs(scene, 8);
    std::vector<std::pair<Index, Index>> pairs;
    for (int i = 0; i < dolls; ++i)
        forbid_itself(add_ragdoll(scene, {0.2 + 0.9 * (i % 6) + 0.05 * (i / 6 % 3),
                                          3.6 + 1.9 * (i / 6) - 0.25 * (i % 6)}),
                      [&pairs](Index a, Index b) {
                          pairs.push_back({a, b});
                      });
    cover(scene, {0.6, 0, 0, 0});
    auto& touching = method.contacts.touching;
    touching.finder.filter = forbid_pairs(scene.bodies.count(), pairs);
    never_stop(touching);
    return scene;
}

void dolls(benchmark::State& state)
{
    SkippingJoints method;
    JointedScene scene = falling_dolls(static_cast<int>(state.range(0)), method);
    const auto& awake = method.contacts.set.awake;
    StepData<3> now;
    Real gap = 0, time = 0;
    int steps = 0, unsolved = 0, largest = 0;
    bool finite = true;
    for (auto _ : state) do {
            time += microseconds(
                [&] { step(scene, {.h = 1.0 / 60, .substeps = 2}, method, now); });
            ++steps;
            unsolved += !awake.empty() && now.solution.status != Status::solved;
            gap = std::max(gap, largest_joint_error(scene));
            largest = std::max(largest, method.solver.bounded.islands.listed);
            finite = finite && scene.bodies.x.allFinite();
        } while (!awake.empty() && steps < 3600 && finite);
    report(state, {{"gap", finite ? gap / 0.22 : infinity},
                   {"count", steps},
                   {"unsolved", unsolved},
                   {"asleep_after", awake.empty() ? steps / 60.0 : -1},
                   {"awake", static_cast<Real>(awake.size())},
                   {"rows", largest},
                   {"us", time / steps}});
}

const bool registered = [] {
    using Solve = std::function<int(const Given&, VecX&)>;
    std::vector<std::pair<std::string, Solve>> methods = {
        {"tree", by_tree},
        {"coordinates", by_coordinates},
        {"sparse", [](const Given& g, VecX& u) { return by_matrix(g, false, u); }},
        {"gradients",
         [](const Given& g, VecX& u) { return by_matrix(g, true, u); }}};
    for (const int sweeps : {10, 100, 1000, 10000})
        methods.emplace_back(
            "sweeps_" + std::to_string(sweeps),
            [sweeps](const Given& g, VecX& u) { return by_sweeps(g, sweeps, u); });
    for (const auto& [name, solve] : methods) {
        const Solve copy = solve;
        auto* const one = benchmark::RegisterBenchmark(
            ("chain/" + name).c_str(),
            [copy](benchmark::State& state) { measure(state, copy); });
        for (const int links : {50, 200})
            for (const int ratio : {1, 1000, 1000000}) one->Args({links, ratio});
        one->Iterations(1);
    }
    auto* const ratio = benchmark::RegisterBenchmark("per_sweep", per_sweep);
    for (const int links : {50, 200, 500, 5000}) ratio->Args({links});
    ratio->Iterations(1);
    for (const char* const name : {"chain", "bridge"})
        for (const int heavy : {1, 1000}) register_beside(name, heavy);
    for (const int count : {1, 12}) register_ragdolls(count);
    auto* const walking = benchmark::RegisterBenchmark("leg", leg);
    for (const int sweeps : {0, 10, 200, 1000}) walking->Args({sweeps});
    walking->Iterations(1);
    auto* const falling = benchmark::RegisterBenchmark("dolls", dolls);
    for (const int count : {3, 12, 100}) falling->Args({count});
    falling->Iterations(1);
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
