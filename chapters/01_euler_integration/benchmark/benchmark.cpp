// Chapter 1: work and time against error, and Boost.odeint beside it.
//
//   01_euler_integration_benchmark                  Google Benchmark: every method on every
//   problem 01_euler_integration_benchmark --table NAME     a table for a figure, as CSV
//   (see `tables` below);
//                                                   all but `pairs` are the same on every
//                                                   machine
#include "chapters/01_euler_integration/benchmark/measured.hpp"
#include "chapters/01_euler_integration/event.hpp"

#include <benchmark/benchmark.h>

#ifdef RIGID_HAS_ODEINT
#include "chapters/01_euler_integration/benchmark/peers_odeint.hpp"
#endif

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

namespace rigid {
namespace {

// ---- measuring
// ------------------------------------------------------------------------------------

constexpr Real tolerances[] = {1e-3, 1e-4,  1e-5,  1e-6,  1e-7, 1e-8,
                               1e-9, 1e-10, 1e-11, 1e-12, 1e-13};

/// Calls visit(name, problem) for the four problems.
template <class Visit>
void for_each_problem(const Visit& visit)
{
    visit("kepler_1_period", KeplerProblem{{}, 2 * pi});
    visit("kepler_10_periods", KeplerProblem{{}, 20 * pi});
    visit("pendulum", PendulumProblem{});
    visit("projectile", ThrowProblem{});
}

/// The numbers of evaluations to spend on a problem: a factor of two apart.
template <class Problem>
std::vector<Index> budgets(const Problem& problem)
{
    const Index least =
        static_cast<Index>(problem.T / 3 * (Problem::N == 1 ? 50 : 40));
    std::vector<Index> result;
    for (int i = 0; i < 10; ++i) result.push_back(least << i);
    return result;
}

template <class Problem>
void register_problem(const std::string& problem_name, const Problem& problem)
{
    constexpr int N = Problem::N;
    const State<N> s = problem.start();
    const Vec<N> exact = problem.exact();
    for (Method method : all_methods) {
        if (!can<typename Problem::A, N>(method)) continue;
        if (method == Method::dormand_prince) {
            for (Real tolerance : tolerances) {
                const Adaptive<N> prepared = start_at(s, tolerance, problem.a);
                const Adaptive<N> run =
                    run_adaptive(prepared, problem.T, tolerance, problem.a);
                const Real error = (run.s.x - exact).norm();
                const Real evaluations = static_cast<Real>(run.evaluations);
                char label[32];
                std::snprintf(label, sizeof label, "/tolerance:%g", tolerance);
                benchmark::RegisterBenchmark(
                    (problem_name + "/dormand_prince/ours" + label).c_str(),
                    [=](benchmark::State& state) {
                        for (auto _ : state)
                            benchmark::DoNotOptimize(
                                run_adaptive(s, problem.T, tolerance, problem.a));
                        state.counters["error"] = error;
                        state.counters["evaluations"] = evaluations;
                    })
                    ->Unit(benchmark::kMicrosecond)
                    ->MinTime(0.02);
#ifdef RIGID_HAS_ODEINT
                const Real first = prepared.h;
                const Real odeint_error =
                    (Odeint<Problem>::run_adaptive(s, problem.T, tolerance, first) -
                     exact)
                        .norm();
                benchmark::RegisterBenchmark(
                    (problem_name + "/dormand_prince/odeint" + label).c_str(),
                    [=](benchmark::State& state) {
                        for (auto _ : state)
                            benchmark::DoNotOptimize(Odeint<Problem>::run_adaptive(
                                s, problem.T, tolerance, first));
                        state.counters["error"] = odeint_error;
                    })
                    ->Unit(benchmark::kMicrosecond)
                    ->MinTime(0.02);
#endif
            }
            continue;
        }
        for (Index budget : budgets(problem)) {
            const Index steps = budget / evaluations_per_step(method);
            const Real h = problem.T / static_cast<Real>(steps);
            const Real error =
                (run_fixed(method, s, h, steps, problem.a).x - exact).norm();
            const std::string base = problem_name + "/" + name_of(method);
            const std::string label = "/steps:" + std::to_string(steps);
            benchmark::RegisterBenchmark(
                (base + "/ours" + label).c_str(),
                [=](benchmark::State& state) {
                    for (auto _ : state)
                        benchmark::DoNotOptimize(
                            run_fixed(method, s, h, steps, problem.a));
                    state.counters["error"] = error;
                    state.counters["evaluations"] =
                        static_cast<Real>(steps * evaluations_per_step(method));
                })
                ->Unit(benchmark::kMicrosecond)
                ->MinTime(0.02);
#ifdef RIGID_HAS_ODEINT
            if (!PositionAcceleration<typename Problem::A, N> &&
                method == Method::symplectic_euler)
                continue;  // odeint's takes no drag
            const Real odeint_error =
                (Odeint<Problem>::run_fixed(method, s, h, steps) - exact).norm();
            benchmark::RegisterBenchmark(
                (base + "/odeint" + label).c_str(),
                [=](benchmark::State& state) {
                    for (auto _ : state)
                        benchmark::DoNotOptimize(
                            Odeint<Problem>::run_fixed(method, s, h, steps));
                    state.counters["error"] = odeint_error;
                })
                ->Unit(benchmark::kMicrosecond)
                ->MinTime(0.02);
#endif
        }
    }
}

// ---- tables for the figures
// -----------------------------------------------------------------------

/// Error against evaluations.
void table_work_precision()
{
    std::puts("problem,method,evaluations,error");
    for_each_problem([](const std::string& name, const auto& problem) {
        using Problem = std::decay_t<decltype(problem)>;
        constexpr int N = Problem::N;
        for (Method method : all_methods) {
            if (!can<typename Problem::A, N>(method)) continue;
            if (method == Method::dormand_prince) {
                for (Real tolerance : tolerances) {
                    const Adaptive<N> run = run_adaptive(problem.start(), problem.T,
                                                         tolerance, problem.a);
                    std::printf("%s,%s,%ld,%.3e\n", name.c_str(), name_of(method),
                                static_cast<long>(run.evaluations),
                                (run.s.x - problem.exact()).norm());
                }
                continue;
            }
            for (Index budget : budgets(problem)) {
                const Index steps = budget / evaluations_per_step(method);
                const Real h = problem.T / static_cast<Real>(steps);
                const Real error =
                    (run_fixed(method, problem.start(), h, steps, problem.a).x -
                     problem.exact())
                        .norm();
                std::printf("%s,%s,%ld,%.3e\n", name.c_str(), name_of(method),
                            static_cast<long>(steps * evaluations_per_step(method)),
                            error);
            }
        }
    });
}

/// Errors over thousands of periods when every method evaluates the force equally often:
/// the largest within the last period, in place and in energy.
void table_long_time(Index per_period)
{
    const Kepler kepler;
    const Real e = 0.6;
    const State<2> start = kepler_perihelion(kepler, e);
    const std::vector<Index> samples = {1,   2,   5,   10,   20,   50,
                                        100, 200, 500, 1000, 2000, 5000};
    std::puts("method,evaluations_per_period,periods,position_error,energy_error");
    // The tolerance that makes the adaptive method spend as much, by bisection.
    Real low = -12, high = -2;
    for (int i = 0; i < 30; ++i) {
        const Real middle = (low + high) / 2;
        const Adaptive<2> run =
            run_adaptive(start, 20 * pi, std::pow(10, middle), kepler);
        (run.evaluations > 10 * per_period ? low : high) = middle;
    }
    const Tolerance allowed{std::pow(10, high), std::pow(10, high),
                            std::pow(10, high)};
    for (Method method : all_methods) {
        State<2> s = start;
        Vec2 now = kepler(s.x);
        Adaptive<2> run = start_adaptive(s, kepler, allowed);
        run.step_limit = 1'000'000'000;
        const Index steps = per_period / evaluations_per_step(method);
        const Real h = 2 * pi / static_cast<Real>(steps);
        std::size_t next = 0;
        for (Index period = 1; next < samples.size(); ++period) {
            const bool wanted = period == samples[next];
            Real of_place = 0, of_energy = 0;
            const auto look = [&](const State<2>& y, Real t) {
                if (!wanted) return;
                of_place =
                    std::max(of_place, (y.x - exact_kepler(kepler, e, t).x).norm());
                of_energy =
                    std::max(of_energy,
                             std::abs(kepler.energy(y) / kepler.energy(start) - 1));
            };
            if (method == Method::dormand_prince) {
                while (run.t < 2 * pi * static_cast<Real>(period)) {
                    if (advance(run, 1e9, kepler, allowed) != Outcome::reached)
                        return;
                    look(run.s, run.t);
                }
            } else {
                for (Index n = 0; n < steps; ++n) {
                    switch (method) {
                    case Method::explicit_euler:
                        s = explicit_euler(s, h, kepler);
                        break;
                    case Method::symplectic_euler:
                        s = symplectic_euler(s, h, kepler);
                        break;
                    case Method::verlet:
                        s = velocity_verlet(s, now, h, kepler);
                        break;
                    case Method::yoshida4: s = yoshida4(s, h, kepler); break;
                    default: s = rk4(s, h, kepler); break;
                    }
                    look(s, 2 * pi * static_cast<Real>(period - 1) +
                                static_cast<Real>(n + 1) * h);
                }
            }
            if (wanted) {
                std::printf("%s,%ld,%ld,%.3e,%.3e\n", name_of(method),
                            static_cast<long>(per_period),
                            static_cast<long>(period), of_place, of_energy);
                ++next;
            }
        }
    }
}

/// The largest modulus of an eigenvalue of one step on a spring, from the step itself: a
/// linear method is the matrix of what it makes of (1, 0) and of (0, 1).
void table_stability()
{
    std::puts("method,h_omega,modulus");
    const Spring spring{1};
    const auto print = [](const char* name, Real z, const State<1>& p,
                          const State<1>& q) {
        const Real trace = p.x[0] + q.u[0], det = p.x[0] * q.u[0] - q.x[0] * p.u[0];
        const Real root = trace * trace / 4 - det;
        const Real modulus =
            root < 0 ? std::sqrt(det) : std::abs(trace) / 2 + std::sqrt(root);
        std::printf("%s,%.3f,%.6f\n", name, z, modulus);
    };
    const State<1> one{Vec<1>(1), Vec<1>(0)}, other{Vec<1>(0), Vec<1>(1)};
    for (Method method : all_methods)
        for (int i = 1; i <= 32; ++i) {
            const Real z = 0.1 * i;
            print(name_of(method), z, run_fixed(method, one, z, 1, spring),
                  run_fixed(method, other, z, 1, spring));
        }
    for (int i = 1; i <= 32; ++i)
        print("implicit_euler", 0.1 * i, implicit_euler_spring(one, 0.1 * i, 1),
              implicit_euler_spring(other, 0.1 * i, 1));
}

/// Energy of a spring under the three Euler methods, h ω = 0.1.
void table_energy()
{
    std::puts("n,explicit_euler,symplectic_euler,implicit_euler");
    const Spring spring{1};
    const State<1> start{Vec<1>(1), Vec<1>(0)};
    State<1> a = start, b = start, c = start;
    const Real h = 0.1;
    for (int n = 0; n <= 400; ++n) {
        const auto ratio = [&](const State<1>& s) {
            return spring.energy(s) / spring.energy(start);
        };
        std::printf("%d,%.6f,%.6f,%.6f\n", n, ratio(a), ratio(b), ratio(c));
        a = explicit_euler(a, h, spring);
        b = symplectic_euler(b, h, spring);
        c = implicit_euler_spring(c, h, 1);
    }
}

/// A spring in its phase plane, h ω = 0.5.
void table_phase()
{
    std::puts(
        "n,explicit_x,explicit_u,symplectic_x,symplectic_u,implicit_x,implicit_u");
    const Spring spring{1};
    const State<1> start{Vec<1>(1), Vec<1>(0)};
    State<1> a = start, b = start, c = start;
    const Real h = 0.5;
    for (int n = 0; n <= 40; ++n) {
        std::printf("%d,%.5f,%.5f,%.5f,%.5f,%.5f,%.5f\n", n, a.x[0], a.u[0], b.x[0],
                    b.u[0], c.x[0], c.u[0]);
        a = explicit_euler(a, h, spring);
        b = symplectic_euler(b, h, spring);
        c = implicit_euler_spring(c, h, 1);
    }
}

/// Energy and modified energy (1.21) of a pendulum from 90 degrees under symplectic Euler.
void table_modified()
{
    std::puts("h,t,energy_error,modified_error");
    const Pendulum pendulum;
    for (Real h : {0.02, 0.01}) {
        State<1> s{Vec<1>(pi / 2), Vec<1>(0)};
        const auto modified = [&](const State<1>& y) {  // H + (h/2) u · a
            return pendulum.energy(y) + h / 2 * y.u.dot(pendulum(y.x));
        };
        const Real energy = pendulum.energy(s), start = modified(s);
        for (int n = 0; static_cast<Real>(n) * h <= 5; ++n) {
            std::printf("%.2f,%.4f,%.6f,%.6f\n", h, static_cast<Real>(n) * h,
                        pendulum.energy(s) - energy, modified(s) - start);
            s = symplectic_euler(s, h, pendulum);
        }
    }
}

/// Steps that the adaptive method chooses.
void table_steps()
{
    std::puts("problem,t,h,speed");
    const auto walk = [](const char* name, const auto& state, const auto& a, Real T,
                         Real tolerance) {
        const Tolerance allowed{tolerance, tolerance, tolerance};
        auto run = start_adaptive(state, a, allowed);
        while (run.t < T) {
            if (advance(run, 1e9, a, allowed) != Outcome::reached) return;
            std::printf("%s,%.5f,%.5f,%.5f\n", name, run.t - run.last.h / 2,
                        run.last.h, run.last.at(0.5).u.norm());
        }
    };
    walk("kepler", kepler_perihelion({}, 0.6), Kepler{}, 4 * pi, 1e-6);
    walk("projectile", ThrowProblem{}.start(), ThrowProblem{}.a, 3, 1e-6);
}

/// The fewest evaluations for a given error, with steps of one size and with steps of their
/// own: the same pair of Dormand and Prince. Within 1 %, by a search over steps and over
/// tolerances.
void table_adaptive()
{
    std::puts("problem,error,fixed,adaptive,gain");
    const auto row = [](const char* name, const auto& problem, Real error) {
        const auto start = problem.start();
        const auto exact = problem.exact();
        // From far too fine towards too coarse, and stop before the first that is not good
        // enough.
        Index fixed = 0, adaptive = 0;
        for (Real steps = 20; fixed == 0; steps = std::ceil(steps * 1.01)) {
            const auto good = [&](Index n) {
                return (run_fixed(Method::dormand_prince, start,
                                  problem.T / static_cast<Real>(n), n, problem.a)
                            .x -
                        exact)
                           .norm() <= error;
            };
            const Index n = static_cast<Index>(steps);
            if (good(n) && good(n + n / 20) && good(n + n / 10))
                fixed = 6 * n;  // not by a lucky crossing of zero
        }
        for (Real exponent = -2; adaptive == 0; exponent -= 0.02) {
            const auto at = [&](Real x) {
                return run_adaptive(start, problem.T, std::pow(10, x), problem.a);
            };
            const auto good = [&](Real x) {
                return (at(x).s.x - exact).norm() <= error;
            };
            if (good(exponent) && good(exponent - 0.2) && good(exponent - 0.4))
                adaptive = at(exponent).evaluations;
        }
        std::printf("%s,%.0e,%ld,%ld,%.2f\n", name, error, static_cast<long>(fixed),
                    static_cast<long>(adaptive),
                    static_cast<Real>(fixed) / static_cast<Real>(adaptive));
    };
    row("kepler e = 0", KeplerProblem{{}, 7, 0}, 1e-6);
    row("kepler e = 0.3", KeplerProblem{{}, 7, 0.3}, 1e-6);
    row("kepler e = 0.6", KeplerProblem{{}, 7, 0.6}, 1e-6);
    row("kepler e = 0.9", KeplerProblem{{}, 7, 0.9}, 1e-6);
    row("kepler e = 0.99", KeplerProblem{{}, 7, 0.99}, 1e-6);
    row("pendulum", PendulumProblem{}, 1e-6);
    row("projectile", ThrowProblem{}, 1e-6);
}

#ifdef RIGID_HAS_ODEINT
/// Seconds of processor time that f() takes, from enough repetitions to be seen by the
/// clock. Time in which the processor serves another program does not count.
template <class F>
Real seconds(const F& f, Index repeat)
{
    const std::clock_t start = std::clock();
    for (Index i = 0; i < repeat; ++i) benchmark::DoNotOptimize(f());
    return static_cast<Real>(std::clock() - start) / CLOCKS_PER_SEC /
           static_cast<Real>(repeat);
}

/// Times of two functions, measured in turns; the least of 31 each, because what disturbs
/// only adds.
struct Pair {
    Real ours = infinity, theirs = infinity;
};
template <class F, class G>
Pair paired(const F& ours, const G& theirs)
{
    const Index repeat = std::max<Index>(
        1, static_cast<Index>(1e-3 / std::max(1e-7, seconds(ours, 100))));
    Pair least;
    for (int i = 0; i < 31; ++i) {
        least.ours = std::min(least.ours, seconds(ours, repeat));
        least.theirs = std::min(least.theirs, seconds(theirs, repeat));
    }
    return least;
}

/// Ours against odeint's: the same steps for fixed methods, equal error for the adaptive
/// one.
void table_pairs()
{
    std::puts("problem,method,error_ours,error_odeint,ns_per_step_ours,ns_per_step_"
              "odeint,ratio");
    for_each_problem([](const std::string& name, const auto& problem) {
        using Problem = std::decay_t<decltype(problem)>;
        constexpr int N = Problem::N;
        const State<N> s = problem.start();
        const Vec<N> exact = problem.exact();
        if (name == "kepler_1_period")
            return;  // the same steps as ten periods, a tenth of them
        for (Method method : all_methods) {
            if (!can<typename Problem::A, N>(method)) continue;
            // odeint's takes no drag
            if constexpr (!PositionAcceleration<typename Problem::A, N>)
                if (method == Method::symplectic_euler) continue;
            const Index steps = 4000;
            const Real h = problem.T / static_cast<Real>(steps);
            const auto ours = [&] {
                return run_fixed(method, s, h, steps, problem.a);
            };
            const auto theirs = [&] {
                return Odeint<Problem>::run_fixed(method, s, h, steps);
            };
            const Pair pair = paired(ours, theirs);
            const Real per = 1e9 / static_cast<Real>(steps);
            std::printf("%s,%s,%.3e,%.3e,%.2f,%.2f,%.3f\n", name.c_str(),
                        name_of(method), (ours().x - exact).norm(),
                        (theirs() - exact).norm(), pair.ours * per,
                        pair.theirs * per, pair.ours / pair.theirs);
            std::fflush(stdout);
        }
        // The adaptive run: both curves of time against error, read at the same errors.
        std::vector<Vec2> ours, theirs;  // log error, log time
        for (Real exponent = -2; exponent >= -13; exponent -= 0.25) {
            const Real tolerance = std::pow(10, exponent);
            const Adaptive<N> prepared = start_at(s, tolerance, problem.a);
            const Real first = prepared.h;
            const auto our_run = [&] {
                return run_adaptive(prepared, problem.T, tolerance, problem.a);
            };
            const auto their_run = [&] {
                return Odeint<Problem>::run_adaptive(s, problem.T, tolerance,
                                                     first);
            };
            const Pair pair = paired(our_run, their_run);
            ours.emplace_back(std::log((our_run().s.x - exact).norm()),
                              std::log(pair.ours));
            theirs.emplace_back(std::log((their_run() - exact).norm()),
                                std::log(pair.theirs));
        }
        // One run's error is a matter of luck. A straight line through the logarithms of
        // the runs with an error within a factor of 30 of the target gives its cost
        // on the whole.
        const auto time_for = [](const std::vector<Vec2>& curve, Real error) {
            Real n = 0, x = 0, y = 0, xx = 0, xy = 0;
            for (const Vec2& p : curve) {
                const Real away = p[0] - std::log(error);
                if (std::abs(away) > std::log(30.)) continue;
                n += 1;
                x += away;
                y += p[1];
                xx += away * away;
                xy += away * p[1];
            }
            return std::exp((y * xx - x * xy) / (n * xx - x * x));
        };
        for (Real error : {1e-2, 1e-4, 1e-6, 1e-8}) {
            const Real a = time_for(ours, error), b = time_for(theirs, error);
            std::printf("%s,adaptive to %.0e,%.0e,%.0e,%.1f,%.1f,%.3f\n",
                        name.c_str(), error, error, error, a * 1e9, b * 1e9, a / b);
        }
    });
}
#else
void table_pairs()
{
    std::puts("Boost.odeint was not installed when this program was built");
}
#endif

int print_table(const std::string& name)
{
    const std::pair<const char*, std::function<void()>> tables[] = {
        {"work_precision", table_work_precision},
        {"long_time", [] { table_long_time(1200); }},
        {"long_time_coarse", [] { table_long_time(240); }},
        {"stability", table_stability},
        {"energy", table_energy},
        {"phase", table_phase},
        {"modified", table_modified},
        {"steps", table_steps},
        {"adaptive", table_adaptive},
        {"pairs", table_pairs},
    };
    for (const auto& [known, table] : tables)
        if (name == known) {
            table();
            return 0;
        }
    std::fprintf(stderr, "there is no table '%s'; there are:", name.c_str());
    for (const auto& [known, table] : tables) std::fprintf(stderr, " %s", known);
    std::fputc('\n', stderr);
    return 2;
}

}  // namespace
}  // namespace rigid

int main(int argc, char** argv)
{
    if (argc == 3 && std::strcmp(argv[1], "--table") == 0)
        return rigid::print_table(argv[2]);
    rigid::for_each_problem([](const std::string& name, const auto& problem) {
        rigid::register_problem(name, problem);
    });
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}
