/// Chapter 13: exact friction beside others, and what a friction row costs a sweep.
///
///     rubble/SOLVER/N   20 problems of N contacts of random rubble: solved to a residual (13.5) of 1e-8 m/s, and the
///                       time of those that were [µs each]; guesses and factorisations of ours
///     thousand          1,000 problems of 1 to 2,000 contacts: solved to 1e-8 m/s, not solved and said so (unsolved),
///                       called solved and not (broken); half an hour
///     heaps             1,000 random heaps that fall, 120 steps each: steps that break (13.14) or, where fast bodies are
///                       stopped or overlaps repaid, that raise the energy, and steps without an answer
///     visit             a row visit [ns] of sweeps over rows of which half are friction, beside the same rows with
///                       fixed bounds

#include "chapters/13_friction/friction_problems.hpp"
#include "chapters/13_friction/impact_laws.hpp"
#include "chapters/13_friction/moving_scenes.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <iostream>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#ifdef RIGID_HAS_SICONOS
#include "chapters/13_friction/benchmark/peers_siconos.hpp"
#include <dlfcn.h>
#endif

using namespace rigid;

namespace {

constexpr int problems = 20;
constexpr Real wanted = 1e-8;

struct Given {
    Mlcp mlcp;
    std::vector<FrictionBox> boxes;
};

/// \param i  an even one is jostled a little, an odd one much
Given rubble(Random& random, int contacts, int i)
{
    const Real mu = random.uniform(0.1, 1);
    const FrictionRows rows =
        random_rubble(random, contacts, mu, i % 2 == 0 ? 0.1 : 1);
    Given given{assemble(rows.rows, rows.u_star), {}};
    boxes_of(rows.rows, given.boxes);
    return given;
}

std::vector<Given> rubble(int contacts)
{
    Random random(1300 + static_cast<std::uint64_t>(contacts));
    std::vector<Given> all;
    for (int i = 0; i < problems; ++i) all.push_back(rubble(random, contacts, i));
    return all;
}

Real microseconds(const std::function<void()>& act)
{
    const auto start = std::chrono::steady_clock::now();
    act();
    return std::chrono::duration<Real, std::micro>(
               std::chrono::steady_clock::now() - start)
        .count();
}

/// A table has the same counters in each row; what was not measured is no number.
void report(benchmark::State& state,
            const std::vector<std::pair<std::string, Real>>& counters)
{
    for (const char* const name :
         {"solved", "failed", "us_each", "steps", "broken", "unsolved", "ns_each"})
        state.counters[name] = std::numeric_limits<Real>::quiet_NaN();
    for (const auto& [name, value] : counters) state.counters.at(name) = value;
}

/// \param solve  the λ that it finds for a problem, and how long that took
void measure(benchmark::State& state,
             const std::function<Real(Given&, VecX&)>& solve)
{
    std::vector<Given> all = rubble(static_cast<int>(state.range(0)));
    int solved = 0;
    Real time = 0;
    for (auto _ : state) {
        solved = 0, time = 0;
        for (Given& given : all) {
            VecX lambda;
            const Real needed = solve(given, lambda);
            if (!(coulomb_residual(given.mlcp, given.boxes, lambda) <= wanted))
                continue;
            ++solved;
            time += needed;
        }
    }
    report(state, {{"solved", solved},
                   {"failed", problems - solved},
                   {"us_each", solved > 0 ? time / solved : infinity}});
}

/// Is each of a thousand problems solved, or not called solved?
void thousand(benchmark::State& state)
{
    int solved = 0, unsolved = 0, broken = 0;
    Real time = 0;
    for (auto _ : state) {
        Random random(1301);
        FrictionMemory memory;
        for (int i = 0; i < 1000; ++i) {
            const int contacts = 1 + static_cast<int>(random.index(2000));
            Given given = rubble(random, contacts, i);
            Solution solution;
            const Real needed = microseconds([&] {
                friction_active_sets(given.mlcp, given.boxes, {}, memory, solution);
            });
            const Real left =
                coulomb_residual(given.mlcp, given.boxes, solution.lambda);
            if (solution.status != Status::solved) ++unsolved;
            else if (left <= wanted) ++solved, time += needed;
            else ++broken;
            std::clog << i << ": " << contacts << " contacts, "
                      << to_string(solution.status) << ", " << left << " m/s, "
                      << 1e-6 * needed << " s\n";
        }
    }
    report(state, {{"solved", solved},
                   {"unsolved", unsolved},
                   {"broken", broken},
                   {"us_each", solved > 0 ? time / solved : infinity}});
}

/// Heaps in motion by exact friction: does a step ever keep more energy than (13.14)?
/// \param repay  with Baumgarte's bias, which (13.14) leaves out
/// \param stop   fast bodies are stopped; with either a step counts that raises the
///               energy
void heaps(benchmark::State& state, bool repay, bool stop)
{
    int broken = 0, unsolved = 0, steps = 0;
    for (auto _ : state) {
        Random random(2024);
        for (int round = 0; round < 1000; ++round) {
            const Real mu = random.uniform(0, 1.2);
            RoughScene scene = random_heap(random, 9, mu);
            ExactFriction<Manifolds> method;
            if (!repay) method.correction.method = Stabilizer::none;
            method.contacts.fast.stop = stop;
            StepData<3> now;
            Real before = energy(scene);
            const Real rounding = 1e-9 * std::abs(before);
            for (int i = 0; i < 120; ++i, ++steps) {
                const VecX u = scene.bodies.u;
                step(scene, {.h = 1.0 / 120}, method, now);
                unsolved += method.solver.unsolved;
                const Real after = energy(scene),
                           lost = repay || stop
                                      ? 0
                                      : kinetic_energy(scene.bodies.u - u,
                                                       scene.bodies.inverse_mass);
                broken += !(after <= before - lost + rounding);
                before = after;
            }
        }
    }
    report(state, {{"steps", steps}, {"broken", broken}, {"unsolved", unsolved}});
}

/// Rows of rubble for sweeps; without friction the same rows with fixed bounds.
void visits(benchmark::State& state, bool friction)
{
    Random random(7);
    FrictionRows problem = random_rubble(random, 500, 0.5, 0.1);
    if (!friction)
        for (Row<3>& row : problem.rows)
            if (row.bounded_by >= 0) {
                row.bounded_by = -1;
                row.lo = -0.05, row.hi = 0.05;
            }
    Colouring colouring;
    std::vector<int> order;
    colour_rows(problem.rows, problem.u_star.size() / 3, colouring, order);
    ImpulseMemory<3> memory;
    Solution solution;
    VecX u = problem.u_star;
    sequential_impulse<3>(problem.rows, order, {1, 0}, memory, u, solution);
    constexpr int sweeps = 1000;
    Real best = infinity;
    for (auto _ : state)
        for (int run = 0; run < 9; ++run)
            best = std::min(best, microseconds([&] {
                                for (int i = 0; i < sweeps; ++i)
                                    sweep<3>(memory.rows, memory.feedback, memory.u,
                                             0);
                            }));
    report(state,
           {{"ns_each",
             1e3 * best / (sweeps * static_cast<Real>(problem.rows.size()))}});
}

}  // namespace

int main(int argc, char** argv)
{
    const auto add = [](const std::string& name, const std::vector<int>& sizes,
                        const std::function<Real(Given&, VecX&)>& solve) {
        auto* const made = benchmark::RegisterBenchmark(
            ("rubble/" + name).c_str(),
            [solve](benchmark::State& state) { measure(state, solve); });
        for (const int size : sizes) made->Arg(size);
        made->Iterations(1)->Unit(benchmark::kMillisecond);
    };
    add("ours", {5, 20, 50, 100, 200, 500, 1000, 2000},
        [](Given& given, VecX& lambda) {
            static FrictionMemory memory;
            Solution solution;
            const Real needed = microseconds([&] {
                friction_active_sets(given.mlcp, given.boxes, {}, memory, solution);
            });
            lambda = solution.lambda;
            return needed;
        });
    add("ours_lemke", {5, 20, 50}, [](Given& given, VecX& lambda) {
        Solution solution;
        const Real needed = microseconds(
            [&] { FindByStewartTrinkle{}(given.mlcp, given.boxes, 0, solution); });
        lambda = solution.lambda;
        return needed;
    });
#ifdef RIGID_HAS_SICONOS
    using SetThreads = void (*)(int);
    if (void* const found = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
        reinterpret_cast<SetThreads>(found)(1);
    const auto add_siconos = [&](const std::string& name, int solver,
                                 const std::vector<int>& sizes) {
        add(name, sizes, [solver](Given& given, VecX& lambda) {
            return peers::siconos(given.mlcp, given.boxes, solver, 20000, lambda);
        });
    };
    add_siconos("siconos_nsgs", SICONOS_FRICTION_2D_NSGS,
                {5, 20, 50, 100, 200, 500, 1000, 2000});
    add_siconos("siconos_lemke", SICONOS_FRICTION_2D_LEMKE, {5, 20, 50, 100});
    add_siconos("siconos_enum", SICONOS_FRICTION_2D_ENUM, {5});
#endif
    benchmark::RegisterBenchmark("thousand", thousand)
        ->Iterations(1)
        ->Unit(benchmark::kMillisecond);
    for (const char* const what : {"not_repaid", "stopped", "repaid"})
        benchmark::RegisterBenchmark((std::string("heaps/") + what).c_str(),
                                     [what](benchmark::State& state) {
                                         heaps(state, what == std::string("repaid"),
                                               what != std::string("not_repaid"));
                                     })
            ->Iterations(1)
            ->Unit(benchmark::kMillisecond);
    for (const char* const what : {"fixed_bounds", "friction"})
        benchmark::RegisterBenchmark((std::string("visit/") + what).c_str(),
                                     [what](benchmark::State& state) {
                                         visits(state,
                                                what == std::string("friction"));
                                     })
            ->Iterations(1);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
