/// Chapter 6: what a visit costs in each order of the rows, and a whole solve beside chapter 4's with the matrix.
///
///     visit/…   one sweep of a scene at rest in the four orders and by blocks, in turns: ns per row, the best of many
///     size/…    ten sweeps from rows to λ, with and without the matrix, up to 100,000 rows: time and memory
///     error/…   residual against row visits and time

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/06_sequential_impulse/block.hpp"
#include "chapters/06_sequential_impulse/impulse_method.hpp"

#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <initializer_list>
#include <string>

using namespace rigid;

namespace {

constexpr Real h = 1.0 / 60;

/// The rows of a scene at rest, its contacts given by hand: find_contacts() tries each pair, which is too slow for
/// 40,000 discs.
struct Problem {
    VecX inverse_mass, u_star;
    std::vector<Row<2>> rows;

    explicit Problem(Index bodies)
        : inverse_mass(VecX::Ones(2 * bodies)), u_star(VecX::Zero(2 * bodies))
    {
        for (Index k = 0; k < bodies; ++k) u_star[2 * k + 1] = -9.81 * h;
    }
    void contact(Index a, Index b, const Vec2& normal)
    {
        rows.push_back(
            unilateral(contact_constraint({a, b, normal, 0}), inverse_mass));
    }
    Index bodies() const { return u_star.size() / 2; }
};

/// As triangle(base), with its contacts in the order of find_contacts().
Problem triangle_of(Index m)
{
    Index base = 2;
    // contacts of discs, floor, two walls
    while (3 * base * (base + 1) / 2 - 2 * base + 2 < m) ++base;
    Problem problem(base * (base + 1) / 2);
    const Vec2 right(1, 0), up_right(0.5, std::sqrt(0.75)),
        up_left(-0.5, std::sqrt(0.75)), up(0, 1);
    Index first = 0;
    for (Index row = 0; row < base; ++row) {
        const Index length = base - row, above = first + length;
        for (Index i = 0; i < length; ++i) {
            if (i + 1 < length) problem.contact(first + i, first + i + 1, right);
            if (i > 0) problem.contact(first + i, above + i - 1, up_left);
            if (i + 1 < length) problem.contact(first + i, above + i, up_right);
        }
        first = above;
    }
    for (Index i = 0; i < base; ++i) problem.contact(world, i, up);
    problem.contact(world, 0, right);
    problem.contact(world, base - 1, -right);
    return problem;
}

Problem column_of(Index m)
{
    Problem problem(m);
    for (Index k = 0; k + 1 < m; ++k) problem.contact(k, k + 1, {0, 1});
    problem.contact(world, 0, {0, 1});
    return problem;
}

/// A column between two walls: two of three rows are against the world.
Problem walls_of(Index m)
{
    Problem problem = column_of(m / 3);
    for (Index k = 0; k < m / 3; ++k) {
        problem.contact(world, k, {1, 0});
        problem.contact(world, k, {-1, 0});
    }
    return problem;
}

/// Links of a chain; the first disc hangs from the world.
Problem chain_of(Index m)
{
    Problem problem(m);
    problem.rows.push_back(bilateral(contact_constraint({world, 0, {0, -1}, 0}),
                                     problem.inverse_mass));
    for (Index k = 0; k + 1 < m; ++k)
        problem.rows.push_back(bilateral(contact_constraint({k, k + 1, {0, -1}, 0}),
                                         problem.inverse_mass));
    return problem;
}

/// One disc with m others around it: every row meets every other, and A is full.
Problem hub_of(Index m)
{
    Problem problem(m + 1);
    for (Index k = 1; k <= m; ++k) {
        const Real angle = 2 * pi * static_cast<Real>(k) / static_cast<Real>(m);
        problem.contact(0, k, {std::cos(angle), std::sin(angle)});
    }
    // else they all fall alike, and there is nothing to do
    problem.u_star.head<2>() = Vec2(1, 0.3);
    return problem;
}

struct Named {
    const char* name;
    Problem (*make)(Index);
};
constexpr Named scenes[] = {{"column", column_of},
                            {"chain", chain_of},
                            {"triangle", triangle_of},
                            {"walls", walls_of}};

/// "error/column/given/8"
std::string name_of(std::initializer_list<std::string> words)
{
    std::string name;
    for (const std::string& word : words) {
        if (!name.empty()) name += '/';
        name += word;
    }
    return name;
}

double seconds()
{
    return std::chrono::duration<double>(
               std::chrono::steady_clock::now().time_since_epoch())
        .count();
}

/// A table in CSV has the same counters in every line; 0 where one has no meaning.
void declare_counters(benchmark::State& state)
{
    for (const char* name : {"rows",
                             "given_ns",
                             "alternating_ns",
                             "shuffled_ns",
                             "coloured_ns",
                             "blocks_ns",
                             "world_in_memory_ns",
                             "prepare_ns",
                             "colour_ns",
                             "residual_ns",
                             "colours",
                             "ours_us",
                             "pgs_us",
                             "ours_sweeps_us",
                             "pgs_sweeps_us",
                             "ours_bytes",
                             "pgs_bytes",
                             "row_visits",
                             "residual",
                             "time_us"})
        state.counters[name] = 0;
}

constexpr Order orders[] = {Order::given, Order::alternating, Order::shuffled,
                            Order::coloured};

/// All orders in turns in one loop, so that none has the quieter minute; the shortest time of each.
void visits(benchmark::State& state, Problem (*make)(Index))
{
    declare_counters(state);
    const Problem problem = make(state.range(0));
    const double m = static_cast<double>(problem.rows.size());
    Random random(1);
    Colouring colouring;
    std::array<std::vector<int>, 6> order;
    std::array<ImpulseMemory<2>, 6> memory;
    Solution solution;
    for (std::size_t i = 0; i < 6; ++i) {
        if (i < 4)
            order_rows(problem.rows, problem.bodies(), orders[i], random, colouring,
                       order[i]);
        if (i == 5) order[i] = order[3];
        begin_sweeps(problem.rows, order[i], 0, memory[i], problem.u_star,
                     solution);
    }
    std::vector<Block> blocks;
    pair_rows(memory[4].rows, blocks);
    // What the rows against the world would cost if the world had a velocity in memory.
    memory[5].u.conservativeResize(problem.u_star.size() + 2);
    memory[5].u.tail<2>().setZero();
    for (SolverRow<2>& row : memory[5].rows)
        if (row.a == row.b) row.a = static_cast<int>(problem.u_star.size());

    std::array<double, 9> best;
    best.fill(1e9);
    const auto timed = [&](std::size_t what, const auto& act) {
        const double begin = seconds();
        act();
        best[what] = std::min(best[what], (seconds() - begin) / m * 1e9);
    };
    for (auto _ : state) {
        for (std::size_t i = 0; i < 6; ++i)
            timed(i, [&] {
                for (int backwards = 0; backwards < 2; ++backwards) {
                    if (i == 4)
                        for (const Block& block : blocks) {
                            SolverRow<2>& first =
                                memory[4]
                                    .rows[static_cast<std::size_t>(block.first)];
                            if (block.second < 0) visit(first, memory[4].u);
                            else
                                visit_block(first,
                                            memory[4].rows[static_cast<std::size_t>(
                                                block.second)],
                                            block.coupling, 0, memory[4].u);
                        }
                    else
                        benchmark::DoNotOptimize(sweep(
                            memory[i], 0,
                            orders[i % 4] == Order::alternating && backwards));
                }
            });
        timed(6, [&] {
            prepare(problem.rows, order[3], VecX::Zero(static_cast<Index>(m)),
                    memory[3].rows);
        });
        timed(7, [&] {
            colour_rows(problem.rows, problem.bodies(), colouring, order[3]);
        });
        timed(8, [&] { benchmark::DoNotOptimize(natural_residual(memory[3])); });
    }
    const char* names[] = {"given_ns",    "alternating_ns", "shuffled_ns",
                           "coloured_ns", "blocks_ns",      "world_in_memory_ns",
                           "prepare_ns",  "colour_ns",      "residual_ns"};
    for (std::size_t i = 0; i < best.size(); ++i)
        state.counters[names[i]] = i < 6 ? best[i] / 2 : best[i];
    int colours = 0;
    while (colours < Colouring::most &&
           colouring.start[static_cast<std::size_t>(colours)] < static_cast<int>(m))
        ++colours;
    state.counters["colours"] = colours;
    state.counters["rows"] = m;
}

/// Ten sweeps from the rows to λ: with the order, the copies and no matrix, and chapter 4 with the matrix.
void whole_solve(benchmark::State& state, Problem (*make)(Index))
{
    declare_counters(state);
    const Problem problem = make(state.range(0));
    const double m = static_cast<double>(problem.rows.size());
    Random random(1);
    Colouring colouring;
    std::vector<int> order;
    ImpulseMemory<2> memory;
    Solution ours, theirs;
    VecX u;
    AssemblyScratch scratch;
    Mlcp mlcp;
    PgsMemory pgs_memory;
    PgsSettings settings;
    settings.tolerance = 0;
    settings.max_sweeps = 10;
    double best[4] = {1e9, 1e9, 1e9, 1e9};
    const auto note = [&best](int what, double begin) {
        best[what] = std::min(best[what], seconds() - begin);
    };
    for (auto _ : state) {
        u = problem.u_star;
        double begin = seconds();
        order_rows(problem.rows, problem.bodies(), Order::coloured, random,
                   colouring, order);
        ours.lambda.setZero(static_cast<Index>(m));
        sequential_impulse<2>(problem.rows, order, {.max_sweeps = 10}, memory, u,
                              ours);
        note(0, begin);
        begin = seconds();
        for (int k = 0; k < 10; ++k) benchmark::DoNotOptimize(sweep(memory, 0));
        note(2, begin);

        begin = seconds();
        assemble(problem.rows, problem.u_star, scratch, mlcp);
        cold_start(mlcp, theirs.lambda);
        pgs(mlcp, settings, pgs_memory, theirs);
        note(1, begin);
        begin = seconds();
        for (int k = 0; k < 10; ++k)
            benchmark::DoNotOptimize(sweep_forward(pgs_memory.rows));
        note(3, begin);
    }
    state.counters["rows"] = m;
    state.counters["ours_us"] = best[0] * 1e6;
    state.counters["pgs_us"] = best[1] * 1e6;
    state.counters["ours_sweeps_us"] = best[2] * 1e6;
    state.counters["pgs_sweeps_us"] = best[3] * 1e6;
    // What lies in memory while the sweeps run, besides the rows that both begin with.
    state.counters["ours_bytes"] = m * (sizeof(SolverRow<2>) + sizeof(int)) +
                                   16.0 * static_cast<double>(problem.bodies());
    const double entries = static_cast<double>(mlcp.A.nonZeros());
    // A by rows, q, lo, hi
    state.counters["pgs_bytes"] = entries * 12 + m * (4 + 3 * 8) +
                                  m * (sizeof(SweepRow) + 3 * sizeof(int) + 8) +
                                  entries * 12;
}

/// One point of the diagram: so many sweeps.
void one_error(benchmark::State& state, const Problem& problem,
               const std::string& method, int sweeps)
{
    declare_counters(state);
    Random random(1);
    Colouring colouring;
    std::vector<int> order;
    std::vector<Block> blocks;
    ImpulseMemory<2> memory;
    Solution solution;
    AssemblyScratch scratch;
    Mlcp mlcp;
    PgsMemory pgs_memory;
    PgsSettings settings;
    settings.tolerance = 0;
    settings.max_sweeps = sweeps;
    Order kind = Order::given;
    for (const Order one : orders)
        if (method == to_string(one)) kind = one;
    const ImpulseSettings impulses{sweeps, 0, kind == Order::alternating};
    double best = 1e9;
    for (auto _ : state) {
        const double begin = seconds();
        VecX u = problem.u_star;
        solution.lambda.setZero(static_cast<Index>(problem.rows.size()));
        if (method == "pgs") {
            assemble(problem.rows, problem.u_star, scratch, mlcp);
            cold_start(mlcp, solution.lambda);
            pgs(mlcp, settings, pgs_memory, solution);
        } else {
            order_rows(problem.rows, problem.bodies(), kind, random, colouring,
                       order);
            if (method == "blocks")
                block_impulse<2>(problem.rows, order, impulses, memory, blocks, u,
                                 solution);
            else
                sequential_impulse<2>(problem.rows, order, impulses, memory, u,
                                      solution);
        }
        best = std::min(best, seconds() - begin);
    }
    state.counters["row_visits"] =
        static_cast<double>(problem.rows.size()) * sweeps;
    state.counters["residual"] =
        method == "pgs" ? solution.residual : natural_residual(memory);
    state.counters["time_us"] = best * 1e6;
}

}  // namespace

int main(int argc, char** argv)
{
    for (const Named& scene : scenes)
        for (const Index m : {300, 1000, 3000, 10000})
            benchmark::RegisterBenchmark(name_of({"visit", scene.name}).c_str(),
                                         visits, scene.make)
                ->Arg(m)
                ->MinTime(0.2);
    for (const Named& scene : {scenes[0], scenes[2]})
        for (const Index m : {100, 300, 1000, 3000, 10000, 30000, 100000})
            benchmark::RegisterBenchmark(name_of({"size", scene.name}).c_str(),
                                         whole_solve, scene.make)
                ->Arg(m)
                ->MinTime(0.2);
    for (const Index m : {100, 300, 1000, 3000})
        benchmark::RegisterBenchmark("size/hub", whole_solve, hub_of)
            ->Arg(m)
            ->MinTime(0.2);

    static const Problem triangle = triangle_of(600), column = column_of(50);
    for (const auto& [name, problem] :
         {std::pair{"triangle", &triangle}, {"column", &column}})
        for (const std::string method :
             {"given", "alternating", "shuffled", "coloured", "blocks", "pgs"})
            for (int sweeps = 1; sweeps <= 4096; sweeps *= 2)
                benchmark::RegisterBenchmark(
                    name_of({"error", name, method, std::to_string(sweeps)})
                        .c_str(),
                    [problem = problem, method, sweeps](benchmark::State& state) {
                        one_error(state, *problem, method, sweeps);
                    })
                    ->MinTime(0.005);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
