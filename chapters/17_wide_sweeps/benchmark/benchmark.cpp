/// Chapter 17: what a visit costs, and what this machine allows.
///
///     visits/WAY/BASE     one thread, a pyramid of 4 BASE² rows: ns a row visit, best of many
///         given           chapter 6, rows as they come
///         rows            chapter 6, its colours of single rows
///         bundles         this chapter's order, one number at a time
///         doubles, floats lanes, as many as a register has
///     threads/WAY/N       the largest of them on N threads: ns a row visit, and times one thread's speed
///     prepare/WHAT        ns a row, once in a step
///     machine/bandwidth/K machine/flops/WAY   what the roofline is made of [GB/s, Gflop/s]
///
/// counters: ns, flops a visit, bytes a visit, gflops

#include "chapters/17_wide_sweeps/brick_rows.hpp"
#include "chapters/17_wide_sweeps/wide_solver.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <string>
#include <vector>

using namespace rigid;

namespace {

Real seconds()
{
    return std::chrono::duration<Real>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// The least time of one call in a quarter of a second or eight calls, whichever is longer [s].
template <class Work>
Real best_of(const Work& work)
{
    Real best = infinity;
    const Real begin = seconds();
    for (int n = 0; n < 8 || (seconds() - begin < 0.25 && n < 100000); ++n) {
        const Real before = seconds();
        work();
        best = std::min(best, seconds() - before);
    }
    return best;
}

/// Of a visit: w 12 and b 1, λ 2, clamp 2, Δλ 1, u 12, the test 4; half of the rows have friction, 4. In lanes W, 6.
constexpr Real flops = 36, flops_in_lanes = 42;
/// 11 numbers read and one written; μ in every second row, and six inverse masses for each four.
template <class T>
constexpr Real bytes = 14 * sizeof(T);

/// A table has the same columns in each line.
void no_counters(benchmark::State& state)
{
    for (const char* name :
         {"ns", "flops", "bytes", "gflops", "lanes", "times", "gbytes"})
        state.counters[name] = 0;
}

void report(benchmark::State& state, Real ns, Real bytes_a_visit,
            Real flops_a_visit)
{
    state.counters["ns"] = ns;
    state.counters["flops"] = flops_a_visit;
    state.counters["bytes"] = bytes_a_visit;
    state.counters["gflops"] = flops_a_visit / ns;
}

void chapter_6(benchmark::State& state, Order kind)
{
    const BrickRows all = brick_rows(static_cast<int>(state.range(0)));
    Colouring colouring;
    Random random(1);
    std::vector<int> order;
    order_rows(all.rows, all.bodies, kind, random, colouring, order);
    ImpulseMemory<3> memory;
    Solution solution;
    begin_sweeps(all.rows, std::span<const int>(order), Real{0}, memory, all.u,
                 solution);
    Real best = 0;
    for (auto _ : state) best = best_of([&] { sweep(memory, Real{0}); });
    report(state, best * 1e9 / static_cast<Real>(all.rows.size()),
           sizeof(SolverRow<3>) + sizeof(Feedback), flops);
}

template <class T, int L>
struct Wide {
    BrickRows all;
    Bundles bundles;
    WideRows<3, T, L> rows;

    explicit Wide(int base) : all(brick_rows(base))
    {
        bundle_rows(all.rows, all.bodies, bundles);
        colour_bundles(all.rows, all.bodies, bundles);
        arrange(all.rows, all.bodies, bundles, rows);
        put_masses(all.inverse_mass, rows);
        load();
    }
    void load()
    {
        const VecX zero = VecX::Zero(static_cast<Index>(all.rows.size()));
        fill<3, T, L>({all.rows}, bundles, zero, all.u, rows);
    }
    Real ns(int threads)
    {
        return best_of([&] { wide_sweep(rows, T{0}, threads); }) * 1e9 /
               static_cast<Real>(all.rows.size());
    }
};

template <class T, int L>
void wide(benchmark::State& state)
{
    Wide<T, L> problem(static_cast<int>(state.range(0)));
    Real ns = 0;
    for (auto _ : state) ns = problem.ns(1);
    report(state, ns, bytes<T>, flops_in_lanes);
    state.counters["lanes"] = L;
}

template <class T, int L>
void by_threads(benchmark::State& state)
{
    Wide<T, L> problem(120);
    Real ns = 0, one = 0;
    for (auto _ : state) {
        one = problem.ns(1);
        ns = problem.ns(static_cast<int>(state.range(0)));
    }
    report(state, ns, bytes<T>, flops_in_lanes);
    state.counters["times"] = one / ns;
}

void prepare(benchmark::State& state, const std::string& what)
{
    Wide<Real, full_lanes<Real>> problem(40);
    ImpulseMemory<3> memory;
    Solution solution;
    Colouring colouring;
    Random random(1);
    std::vector<int> order;
    const auto m = static_cast<Real>(problem.all.rows.size());
    Real best = 0;
    for (auto _ : state)
        best = best_of([&] {
            const auto& all = problem.all;
            if (what == "chapter_6")
                order_rows(all.rows, all.bodies, Order::coloured, random, colouring,
                           order);
            if (what == "chapter_6" || what == "as_they_come")
                begin_sweeps(all.rows, std::span<const int>(order), Real{0}, memory,
                             all.u, solution);
            if (what == "bundle")
                bundle_rows(all.rows, all.bodies, problem.bundles);
            if (what == "colour")
                colour_bundles(all.rows, all.bodies, problem.bundles);
            if (what == "arrange")
                arrange(all.rows, all.bodies, problem.bundles, problem.rows);
            if (what == "masses") put_masses(all.inverse_mass, problem.rows);
            if (what == "fill") problem.load();
        });
    state.counters["ns"] = best * 1e9 / m;
}

/// Reads an array from front to back.
void bandwidth(benchmark::State& state)
{
    constexpr int L = full_lanes<Real>;
    using V = Lanes<Real, L>;
    const auto kilobytes = static_cast<std::size_t>(state.range(0));
    std::vector<V> numbers(kilobytes * 1024 / sizeof(V));
    V sum[8] = {};
    Real best = 0;
    for (auto _ : state)
        best = best_of([&] {
                   const auto rounds = std::max<std::size_t>(1, 1024 / kilobytes);
                   for (std::size_t n = 0; n < rounds; ++n)
                       for (std::size_t i = 0; i + 8 <= numbers.size(); i += 8)
                           for (std::size_t k = 0; k < 8; ++k)
                               sum[k] = sum[k] + numbers[i + k];
                   benchmark::DoNotOptimize(sum);
               }) /
               static_cast<Real>(std::max<std::size_t>(1, 1024 / kilobytes));
    state.counters["gbytes"] = static_cast<Real>(kilobytes) * 1024 / best * 1e-9;
}

/// Products and sums that do not wait for each other.
template <class T, int L>
void arithmetic(benchmark::State& state)
{
    using V = Lanes<T, L>;
    constexpr int chains = 12, rounds = 20000;
    V x[chains] = {}, a{}, b{};
    for (int l = 0; l < L; ++l) set_lane(a, l, 0.999), set_lane(b, l, 0.001);
    Real best = 0;
    for (auto _ : state)
        best = best_of([&] {
            benchmark::DoNotOptimize(a);
            benchmark::DoNotOptimize(b);
            for (int n = 0; n < rounds; ++n)
                for (int k = 0; k < chains; ++k) {
                    const V product = x[k] * a;
                    x[k] = product + b;
                }
            benchmark::DoNotOptimize(x);
        });
    state.counters["gflops"] = 2.0 * L * chains * rounds / best * 1e-9;
}

void once(benchmark::internal::Benchmark* one) { one->Iterations(1); }

const bool registered = [] {
    const auto named = [](const std::string& name, const auto& work) {
        return benchmark::RegisterBenchmark(name.c_str(),
                                            [work](benchmark::State& state) {
                                                no_counters(state);
                                                work(state);
                                            });
    };
    constexpr int D = full_lanes<Real>, F = full_lanes<float>;
    const auto given = [](auto& s) { chapter_6(s, Order::given); };
    const auto rows = [](auto& s) { chapter_6(s, Order::coloured); };
    for (const int base : {10, 40, 120}) {
        named("visits/given", given)->Arg(base)->Apply(once);
        named("visits/rows", rows)->Arg(base)->Apply(once);
        named("visits/bundles", wide<Real, 1>)->Arg(base)->Apply(once);
        named("visits/doubles", wide<Real, D>)->Arg(base)->Apply(once);
        named("visits/floats", wide<float, F>)->Arg(base)->Apply(once);
    }
    for (const int threads : {1, 2}) {
        named("threads/doubles", by_threads<Real, D>)->Arg(threads)->Apply(once);
        named("threads/floats", by_threads<float, F>)->Arg(threads)->Apply(once);
    }
    for (const char* what : {"as_they_come", "chapter_6", "bundle", "colour",
                             "arrange", "masses", "fill"})
        named(std::string("prepare/") + what, [what](auto& s) {
            prepare(s, what);
        })->Apply(once);
    for (const int kilobytes : {16, 512, 8192, 131072})
        named("machine/bandwidth", bandwidth)->Arg(kilobytes)->Apply(once);
    named("machine/flops/one", arithmetic<Real, 1>)->Apply(once);
    named("machine/flops/doubles", arithmetic<Real, D>)->Apply(once);
    named("machine/flops/floats", arithmetic<float, F>)->Apply(once);
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
