/// Chapter 9: exact answers, beside other programs' and beside sweeps.
///
///     versus/…     active sets and the peers in turns on the same problem: the fastest of each, its residual
///     warm/…       the same problem again from the previous set, and with a q that has moved a little
///     growth/…     assembly and solve against n, and slope/…  the exponent fitted to them
///     error/…      residual against time: sweeps, Lemke, one index at a time, active sets
///
/// Times are the fastest of several repetitions [µs]. A residual of 1e300 stands for: no answer, or not a
/// number; a time of 0 for: did not run (not installed, or not for this kind of problem).

#include "chapters/04_pgs/pgs.hpp"
#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/09_active_sets/benchmark/peers.hpp"
#include "chapters/09_active_sets/benchmark/problems.hpp"
#include "chapters/09_active_sets/dantzig.hpp"

#include <benchmark/benchmark.h>

#include <Eigen/Cholesky>
#include <functional>
#include <map>
#include <string>
#include <vector>

using namespace rigid;

namespace {

// ---- the problems ---------------------------------------------------------------------------------------

Index boxes_of(Index n) { return n / 2; }
Index levels_of(Index n)
{
    return static_cast<Index>(std::lround(std::sqrt(static_cast<Real>(n) / 2)));
}

RowProblem<3> toppling_rows(Index n)
{
    return pile_problem(box_column(boxes_of(n)), at_rest);
}
RowProblem<3> upright_rows(Index n)
{
    return pile_problem(box_column(boxes_of(n), {.upright = true}), at_rest);
}
RowProblem<3> hit_upright_rows(Index n)
{
    return pile_problem(box_column(boxes_of(n), {.upright = true}), in_impact);
}
RowProblem<3> column_rows(Index n)
{
    return pile_problem(box_column(boxes_of(n)), nudged);
}
RowProblem<3> hit_column_rows(Index n)
{
    return pile_problem(box_column(boxes_of(n)), in_impact);
}
RowProblem<3> heavy_rows(Index n)
{
    return pile_problem(
        box_column(boxes_of(n), {.top_mass = 1000, .alternate = true}), in_impact);
}
RowProblem<3> pyramid_rows(Index n)
{
    return pile_problem(box_pyramid(levels_of(n)), at_rest);
}
RowProblem<3> hit_pyramid_rows(Index n)
{
    return pile_problem(box_pyramid(levels_of(n)), in_impact);
}
RowProblem<3> friction_rows(Index n)
{
    return pile_problem(box_column(n / 4), nudged, 0.5);
}
RowProblem<2> chain_rows(Index n) { return chain_on_hills((n + 1) / 2); }

template <auto rows>
Mlcp from_rows(Index n)
{
    return rows(n).mlcp();
}

Mlcp spd(Index n)
{
    Random random(7);
    return random_spd(n, random);
}

struct Problem {
    Mlcp (*make)(Index n);
    /// ODE needs its cfm, and Bullet, which has none, gives no number
    bool singular = false;
};
const std::map<std::string, Problem> problems = {
    {"spd", {spd}},
    {"column", {from_rows<column_rows>}},
    {"column_hit", {from_rows<hit_column_rows>}},
    {"column_1_to_1000", {from_rows<heavy_rows>}},
    {"chain", {from_rows<chain_rows>}},
    {"pyramid", {from_rows<pyramid_rows>, true}},
    {"pyramid_hit", {from_rows<hit_pyramid_rows>, true}},
    {"friction", {from_rows<friction_rows>, true}}};

// ---- what is said ---------------------------------------------------------------------------------------

Real told(const Mlcp& mlcp, const VecX& z)
{
    const Real residual = z.allFinite() ? natural_residual(mlcp, z) : infinity;
    return residual < 1e300 ? residual : 1e300;
}

/// A table needs the same counters in each row.
void no_counters(benchmark::State& state)
{
    for (const char* counter : {"n",
                                "us",
                                "residual",
                                "solved",
                                "factorisations",
                                "updates",
                                "flips",
                                "single_flips",
                                "outer_steps",
                                "entries",
                                "ode_us",
                                "ode_residual",
                                "ode_ratio",
                                "polished_us",
                                "polished_residual",
                                "polished_ratio",
                                "siconos_us",
                                "siconos_residual",
                                "siconos_ratio",
                                "bullet_us",
                                "bullet_residual",
                                "bullet_ratio",
                                "warm_us",
                                "warm_ratio",
                                "warm_factorisations",
                                "moved_us",
                                "moved_ratio",
                                "assembly_us",
                                "slope",
                                "guess_slope",
                                "assembly_slope"})
        state.counters[counter] = 0;
}

void tell(benchmark::State& state, const Mlcp& mlcp, const Solution& solution,
          const ActiveSetMemory& memory)
{
    state.counters["n"] = static_cast<Real>(mlcp.size());
    state.counters["residual"] = told(mlcp, solution.lambda);
    state.counters["solved"] = solution.status == Status::solved;
    state.counters["factorisations"] = memory.work.factorisations;
    state.counters["updates"] = memory.work.updates;
    state.counters["flips"] = memory.work.flips;
    state.counters["guesses"] = memory.work.guesses;
    state.counters["outer_steps"] = memory.work.outer_steps;
    state.counters["entries"] = static_cast<Real>(memory.work.entries);
}

/// So many calls of work in a row that the clock does not count, and the time of one [µs].
template <class Work>
Real time_of_one(int calls, const Work& work)
{
    return microseconds([&] {
               for (int k = 0; k < calls; ++k) work();
           }) /
           calls;
}
int calls_for(Index n) { return n <= 32 ? 20 : 1; }

struct ColdSolve {
    ActiveSetSettings settings;
    Solution solution;
    ActiveSetMemory memory;
    Fastest fastest;

    /// From Mlcp to Solution, with all its checks and nothing remembered: allocations, the order of elimination and
    /// the pattern of the factor are part of the time.
    void run(const Mlcp& mlcp)
    {
        fastest.add(time_of_one(calls_for(mlcp.size()), [&] {
            memory = {};
            active_sets(mlcp, settings, memory, solution);
        }));
    }
};

// ---- versus ---------------------------------------------------------------------------------------------

/// What ODE's λ needs to be exact in spite of the cfm: on the rows that it left between their bounds, steps
/// λ_F ← λ_F − (A_FF + cfm)⁻¹ w_F until w_F is zero. Returns the time of that.
Real polish(const peers::FreeFirst& problem, Real cfm, VecX& x)
{
    return microseconds([&] {
        std::vector<Index> F;
        for (Index i = 0; i < x.size(); ++i)
            if (x[i] > problem.lo[i] && x[i] < problem.hi[i]) F.push_back(i);
        MatX AF = problem.A(F, F);
        AF.diagonal().array() += cfm;
        const Eigen::LLT<Eigen::Ref<MatX>> cholesky(AF);
        for (int k = 0; k < 3; ++k) {
            const VecX w = problem.A * x + problem.q;
            const VecX step = cholesky.solve(w(F));
            x(F) -= step;
        }
    });
}

/// One peer: the fastest run, and its last answer.
struct Contestant {
    Fastest fastest;
    VecX lambda;
    bool ran = false;
    int runs = 0;
    Real spent = 0;

    /// Twelve runs, but no more than about a second.
    bool has_time() const { return runs == 0 || (runs < 12 && spent < 1e6); }
    void add(const peers::Answer& answer)
    {
        ++runs;
        spent += answer.us;
        ran = answer.ran;
        lambda = answer.lambda;
        if (ran) fastest.add(answer.us);
    }
    void tell(benchmark::State& state, const std::string& name, const Mlcp& mlcp,
              Real ours) const
    {
        if (!ran) return;
        state.counters[name + "_us"] = fastest.us;
        state.counters[name + "_residual"] = told(mlcp, lambda);
        state.counters[name + "_ratio"] = fastest.us / ours;
    }
};

/// Each iteration runs all of them, one after the other: none has the quieter minute.
void versus(benchmark::State& state, const Problem& problem)
{
    const Mlcp mlcp = problem.make(state.range(0));
    const peers::FreeFirst dense(mlcp);
    const Real cfm = problem.singular ? 1e-8 : 0;
    ColdSolve ours;
    Contestant ode, polished, siconos, bullet;
    for (auto _ : state) {
        for (int repeat = 0; repeat < 5; ++repeat) ours.run(mlcp);
        if (ode.has_time()) {
            peers::Answer answer = peers::ode(dense, cfm);
            ode.add(answer);
            if (problem.singular && answer.ran) {
                VecX x = answer.lambda(dense.order);
                answer.us += polish(dense, cfm, x);
                answer.lambda = dense.back(x);
                polished.add(answer);
            }
        }
        // On a singular A it fails from n = 512 on; n = 968 takes it twelve seconds, more is left out.
        const bool within_reason = !problem.singular || mlcp.size() <= 1000;
        if (within_reason && siconos.has_time()) siconos.add(peers::siconos(dense));
        if (bullet.has_time()) bullet.add(peers::bullet(dense));
    }
    no_counters(state);
    tell(state, mlcp, ours.solution, ours.memory);
    state.counters["us"] = ours.fastest.us;
    ode.tell(state, "ode", mlcp, ours.fastest.us);
    polished.tell(state, "polished", mlcp, ours.fastest.us);
    siconos.tell(state, "siconos", mlcp, ours.fastest.us);
    bullet.tell(state, "bullet", mlcp, ours.fastest.us);
}

// ---- warm starts ----------------------------------------------------------------------------------------

/// The previous set: the same problem again, and one whose q has moved by up to a hundredth of its largest entry.
void warm(benchmark::State& state, const Problem& problem)
{
    const Mlcp mlcp = problem.make(state.range(0));
    Mlcp moved = mlcp;
    Random random(3);
    for (Real& entry : moved.q)
        entry += 0.01 * mlcp.q.cwiseAbs().maxCoeff() * random.uniform(-1, 1);
    const int calls = calls_for(mlcp.size());
    ColdSolve cold, cold_moved;
    ActiveSetMemory memory;
    Solution solution;
    active_sets(mlcp, {}, memory, solution);
    const ActiveSetMemory yesterday = memory;
    Fastest again, after_move;
    for (auto _ : state) {
        cold.run(mlcp);
        active_sets(mlcp, {}, memory, solution);
        again.add(
            time_of_one(calls, [&] { active_sets(mlcp, {}, memory, solution); }));
        const int factorisations = memory.work.factorisations;
        cold_moved.run(moved);
        memory = yesterday;
        after_move.add(
            time_of_one(1, [&] { active_sets(moved, {}, memory, solution); }));
        memory = yesterday;
        memory.work.factorisations = factorisations;
    }
    no_counters(state);
    tell(state, mlcp, cold.solution, cold.memory);
    state.counters["us"] = cold.fastest.us;
    state.counters["warm_us"] = again.us;
    state.counters["warm_ratio"] = cold.fastest.us / again.us;
    state.counters["warm_factorisations"] = memory.work.factorisations;
    state.counters["moved_us"] = after_move.us;
    state.counters["moved_ratio"] = cold_moved.fastest.us / after_move.us;
}

// ---- growth ---------------------------------------------------------------------------------------------

struct Point {
    Real n, solve, guess, assembly;
};
std::map<std::string, std::vector<Point>> points;

/// From rows to A and q, and from these to λ; both with memory that is kept from step to step.
template <auto rows>
void growth(benchmark::State& state, const std::string& name)
{
    const auto problem = rows(state.range(0));
    AssemblyScratch scratch;
    Mlcp mlcp;
    ColdSolve cold;
    // Less than what rounding makes of positions of a metre, 4 ε m / (1/60 s). From
    // 12,800 rows on a column that topples has speeds in it that are below ε times
    // the largest.
    cold.settings.enough = 1e-13;
    Fastest assembly;
    for (auto _ : state) {
        assembly.add(microseconds(
            [&] { assemble(problem.rows, problem.u_star, scratch, mlcp); }));
        cold.run(mlcp);
    }
    no_counters(state);
    tell(state, mlcp, cold.solution, cold.memory);
    state.counters["us"] = cold.fastest.us;
    state.counters["assembly_us"] = assembly.us;
    points[name].push_back({static_cast<Real>(mlcp.size()), cold.fastest.us,
                            cold.fastest.us / std::max(1, cold.memory.work.guesses),
                            assembly.us});
}

/// The exponent p of time ~ n^p: a straight line through log time against log n, from n = 800 on: a column of 50
/// boxes is another problem than one of 500, which needs ten times the guesses, and more boxes need no more.
Real fitted_slope(const std::vector<Point>& list, Real Point::*time)
{
    Real x = 0, y = 0, xx = 0, xy = 0, count = 0;
    for (const Point& point : list) {
        if (point.n < 799) continue;
        ++count;
        const Real a = std::log(point.n), b = std::log(point.*time);
        x += a, y += b, xx += a * a, xy += a * b;
    }
    return (count * xy - x * y) / (count * xx - x * x);
}

void slope(benchmark::State& state, const std::string& name)
{
    for (auto _ : state) benchmark::DoNotOptimize(points[name].data());
    no_counters(state);
    state.counters["slope"] = fitted_slope(points[name], &Point::solve);
    state.counters["guess_slope"] = fitted_slope(points[name], &Point::guess);
    state.counters["assembly_slope"] = fitted_slope(points[name], &Point::assembly);
}

// ---- error against time ---------------------------------------------------------------------------------

using Solve = std::function<Solution(const Mlcp&)>;

void error(benchmark::State& state, const Problem& problem, const Solve& solve)
{
    const Mlcp mlcp = problem.make(state.range(0));
    Solution solution;
    Fastest fastest;
    Real spent = 0;
    for (auto _ : state) {
        if (spent > 3e6) continue;
        const Real us = microseconds([&] { solution = solve(mlcp); });
        spent += us;
        fastest.add(us);
    }
    no_counters(state);
    state.counters["n"] = static_cast<Real>(mlcp.size());
    state.counters["us"] = fastest.us;
    state.counters["residual"] = told(mlcp, solution.lambda);
    state.counters["solved"] = solution.status == Status::solved;
}

Solve sweeping(int sweeps)
{
    return [sweeps](const Mlcp& mlcp) {
        PgsSettings settings;
        settings.tolerance = 1e-300;  // never met: each sweep is made
        settings.max_sweeps = sweeps;
        return pgs(mlcp, settings);
    };
}

void add_all()
{
    const auto of = [](const char* name) { return problems.at(name); };
    const auto add = [](const std::string& name, auto function, auto... arguments) {
        auto* const one =
            benchmark::RegisterBenchmark(name.c_str(), function, arguments...);
        return one->Unit(benchmark::kMillisecond);
    };
    const std::vector<std::pair<const char*, std::vector<Index>>> table = {
        {"spd", {10, 300, 1000}},
        {"column", {10, 300, 1000}},
        {"column_hit", {10, 300, 1000}},
        {"chain", {99, 999}},
        {"column_1_to_1000", {300}},
        {"pyramid", {32, 128, 512, 968, 2048}},
        {"friction", {600}},
        {"pyramid_hit", {32, 128, 512, 968, 2048}}};
    for (const auto& [name, sizes] : table)
        for (const Index n : sizes) {
            add("versus/" + std::string(name), versus, of(name))
                ->Arg(n)
                ->Iterations(n <= 32 ? 200 : 10);
            add("warm/" + std::string(name), warm, of(name))
                ->Arg(n)
                ->Iterations(n <= 32 ? 200 : 20);
        }
    for (const Index n : {100, 200, 400, 800, 1600, 3200, 6400, 12800, 25600}) {
        add("growth/column_upright", growth<upright_rows>, "column_upright")
            ->Arg(n)
            ->Iterations(20);
        add("growth/column_upright_hit", growth<hit_upright_rows>,
            "column_upright_hit")
            ->Arg(n)
            ->Iterations(20);
        add("growth/column_topples", growth<toppling_rows>, "column_topples")
            ->Arg(n)
            ->Iterations(5);
        add("growth/column", growth<column_rows>, "column")->Arg(n)->Iterations(20);
        add("growth/column_hit", growth<hit_column_rows>, "column_hit")
            ->Arg(n)
            ->Iterations(20);
        add("growth/chain", growth<chain_rows>, "chain")
            ->Arg(n - 1)
            ->Iterations(20);
    }
    for (const Index n : {32, 128, 288, 512, 968, 2048})
        add("growth/pyramid_hit", growth<hit_pyramid_rows>, "pyramid_hit")
            ->Arg(n)
            ->Iterations(10);
    for (const char* name :
         {"column_upright", "column_upright_hit", "column_topples", "column",
          "column_hit", "chain", "pyramid_hit"})
        add("slope/" + std::string(name), slope, name)->Iterations(1);
    for (const auto& [name, n] :
         {std::pair("spd", 300), std::pair("column_hit", 300),
          std::pair("chain", 999), std::pair("pyramid_hit", 512)}) {
        const auto contest = [&, here = std::string(name), size = n](
                                 const std::string& who, const Solve& solve) {
            add("error/" + here + "/" + who, error, of(here.c_str()), solve)
                ->Arg(size)
                ->Iterations(10);
        };
        contest("active_sets", [](const Mlcp& mlcp) { return active_sets(mlcp); });
        contest("dantzig", [](const Mlcp& mlcp) { return dantzig(mlcp); });
        contest("lemke", [](const Mlcp& mlcp) { return lemke(mlcp); });
        for (const int sweeps : {1, 3, 10, 30, 100, 300, 1000, 3000, 10000, 30000})
            contest("pgs_" + std::to_string(sweeps), sweeping(sweeps));
    }
}

}  // namespace

int main(int argc, char** argv)
{
    peers::single_thread();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    add_all();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
