/// Chapter 14: one step of a chain with a weight at its end, by all that can solve its rows.
///
///     chain/METHOD/LINKS/RATIO   time of one solve [µs], and how far the velocities are from those in coordinates of
///                                the joints [m/s]; sweeps or steps that it took
///     per_sweep/LINKS            a factor and a solve of the tree, each over one sweep over the same rows

#include "chapters/04_pgs/conjugate_gradients.hpp"
#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/14_joints/joint_factor.hpp"
#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/14_joints/reduced.hpp"

#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include <string>
#include <vector>

using namespace rigid;

namespace {

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
    state.counters["us"] = time;
    state.counters["error"] = (u - given.truth).lpNorm<Eigen::Infinity>();
    state.counters["count"] = count;
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
    state.counters["us_sweep"] = sweep_time;
    state.counters["factor"] = factor_time / sweep_time;
    state.counters["solve"] = solve_time / sweep_time;
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
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
