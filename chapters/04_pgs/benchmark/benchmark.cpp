/// Chapter 4: what a sweep costs, what it gains, and the same work done by Bullet.
///
///     sweep/…       one sweep of a contact column: ns per row
///     ten_sweeps/…  a whole solve of ten sweeps, ours and Bullet's, in turns
///     error/…       error against row visits and time, for every method on four problems

#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/04_pgs/conjugate_gradients.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/04_pgs/rates.hpp"
#include "common/program/scripted_pointer.hpp"

#include <benchmark/benchmark.h>

#ifdef RIGID_HAS_BULLET
#include "chapters/04_pgs/benchmark/peers_bullet.hpp"
#endif

#include <chrono>
#include <functional>

using namespace rigid;

namespace {

/// The rows of a column of N discs, assembled as a step does it.
Mlcp contact_column(Index N)
{
    DiscScene scene = column(N);
    std::vector<Contact> contacts;
    std::vector<Row<2>> rows;
    // The floor's row first, then upwards: bottom-up.
    find_contacts(scene, 1e-6, contacts);
    std::rotate(contacts.begin(), contacts.end() - 1, contacts.end());
    disc_rows(scene, 1.0 / 60, contacts, rows);
    VecX u_star = VecX::Zero(2 * N);
    for (Index k = 0; k < N; ++k) u_star[2 * k + 1] = -9.81 / 60;
    return assemble(rows, u_star);
}

/// The ten discs in the middle of things: after 2000 steps under the seeded pointer.
Mlcp ten_discs_problem()
{
    DiscScene scene = ten_discs();
    const ScriptedPointer pointer(1, {{0, 0}, {0.8, 0.57}});
    StepSettings settings{.h = 1.0 / 480};
    settings.stiffness = 1;
    settings.damping = 1;
    StepData<2> now;
    PgsSettings sweeps;
    sweeps.tolerance = 1e-6;
    Mlcp busiest;
    auto method = by_matrix([&](const Mlcp& mlcp) { return pgs(mlcp, sweeps); });
    for (int k = 0; k < 3000; ++k) {
        const Vec2 tilt = pointer.at(k * settings.h).cwiseQuotient(scene.half_size);
        scene.gravity = 9.81 * tilt / std::max(Real{1}, tilt.norm());
        step(scene, settings, method, now);
        const Mlcp& mlcp = method.solver.mlcp;
        Index pushing = 0, most = 0;
        for (Index i = 0; i < mlcp.size(); ++i)
            pushing += now.solution.lambda[i] > 1e-6;
        if (mlcp.size() > busiest.size() && mlcp.size() <= 22 && pushing > most)
            busiest = mlcp, most = pushing;
    }
    return busiest;
}

/// A table in CSV has the same counters in every line; 0 where one has no meaning.
void declare_counters(benchmark::State& state)
{
    for (const char* name :
         {"ns_per_row", "ours_us", "bullet_us", "bullet_over_ours", "difference",
          "sweeps", "row_visits", "residual", "error", "velocity_error"})
        state.counters[name] = 0;
}

// ---- the cost of a sweep ------------------------------------------------------------------------------

void one_sweep(benchmark::State& state, Real (*sweep)(SweepRows&))
{
    declare_counters(state);
    const auto N = static_cast<Index>(state.range(0));
    const Mlcp mlcp = contact_column(N);
    SweepRows rows;
    prepare(mlcp, 1, {}, rows);
    rows.lambda.setZero();
    for (auto _ : state) benchmark::DoNotOptimize(sweep(rows));
    state.counters["ns_per_row"] =
        benchmark::Counter(static_cast<double>(N) * 1e-9,
                           benchmark::Counter::kIsIterationInvariantRate |
                               benchmark::Counter::kInvert);
}

void preparation(benchmark::State& state)
{
    declare_counters(state);
    const auto N = static_cast<Index>(state.range(0));
    const Mlcp mlcp = contact_column(N);
    SweepRows rows;
    for (auto _ : state) prepare(mlcp, 1, {}, rows);
    state.counters["ns_per_row"] =
        benchmark::Counter(static_cast<double>(N) * 1e-9,
                           benchmark::Counter::kIsIterationInvariantRate |
                               benchmark::Counter::kInvert);
}

void residual(benchmark::State& state)
{
    declare_counters(state);
    const auto N = static_cast<Index>(state.range(0));
    const Mlcp mlcp = contact_column(N);
    const VecX lambda = VecX::Ones(N);
    for (auto _ : state) benchmark::DoNotOptimize(natural_residual(mlcp, lambda));
    state.counters["ns_per_row"] =
        benchmark::Counter(static_cast<double>(N) * 1e-9,
                           benchmark::Counter::kIsIterationInvariantRate |
                               benchmark::Counter::kInvert);
}

// ---- ten sweeps, and the peer ---------------------------------------------------------------------------

PgsSettings ten_sweeps_settings()
{
    PgsSettings settings;
    settings.tolerance = 0;
    settings.max_sweeps = 10;
    return settings;
}

/// Both in turns in one loop, so that neither has the quieter minute. Ours: from Mlcp to Solution with its
/// checks, preparation and final residual. Bullet's: from its own dense matrix, filled before, to x.
void ten_sweeps(benchmark::State& state)
{
    declare_counters(state);
    const auto N = static_cast<Index>(state.range(0));
    const Mlcp mlcp = contact_column(N);
    const PgsSettings settings = ten_sweeps_settings();
    PgsMemory memory;
    Solution solution;
    using clock = std::chrono::steady_clock;
    std::vector<double> ours, theirs;
#ifdef RIGID_HAS_BULLET
    BulletProblem peer(mlcp);
#endif
    for (auto _ : state) {
        const auto a = clock::now();
        cold_start(mlcp, solution.lambda);
        pgs(mlcp, settings, memory, solution);
        const auto b = clock::now();
        ours.push_back(std::chrono::duration<double>(b - a).count());
#ifdef RIGID_HAS_BULLET
        const auto c = clock::now();
        peer.solve(10);
        theirs.push_back(std::chrono::duration<double>(clock::now() - c).count());
#endif
    }
    const auto median = [](std::vector<double>& times) {
        if (times.empty()) return 0.0;
        std::nth_element(times.begin(),
                         times.begin() +
                             static_cast<std::ptrdiff_t>(times.size() / 2),
                         times.end());
        return times[times.size() / 2];
    };
    const double our_time = median(ours), their_time = median(theirs);
    state.counters["ours_us"] = 1e6 * our_time;
    state.counters["ns_per_row"] = 1e9 * our_time / static_cast<double>(10 * N);
    state.counters["bullet_us"] = 1e6 * their_time;
    state.counters["bullet_over_ours"] = their_time / our_time;
#ifdef RIGID_HAS_BULLET
    Real difference = 0;
    for (Index i = 0; i < N; ++i)
        difference = std::max(
            difference, std::abs(peer.x[static_cast<int>(i)] - solution.lambda[i]));
    state.counters["difference"] = difference;
#endif
}

// ---- error against work -----------------------------------------------------------------------------------

struct Case {
    std::string name;
    Mlcp mlcp;
    VecX exact;
    /// the best one, or for the ten discs one that was found to be good
    Real omega = 1;
};

std::vector<Case> cases()
{
    const Real impulse = 9.81 / 60;
    std::vector<Case> list;
    list.push_back({"column", line_problem(20, 1, impulse),
                    line_answer(20, 1, impulse), best_omega(line_rate(20, 1))});
    list.push_back({"chain", line_problem(40, 100, impulse),
                    line_answer(40, 100, impulse), best_omega(line_rate(40, 100))});
    list.push_back({"mass_ratio", line_problem(2, 1000, impulse),
                    line_answer(2, 1000, impulse), best_omega(line_rate(2, 1000))});
    for (Index i = 0; i < 40; ++i) list[1].mlcp.lo[i] = -infinity;  // links
    const Mlcp discs = ten_discs_problem();
    list.push_back({"ten_discs", discs, schur(discs).lambda, 1.5});
    return list;
}

/// One point of the diagram: so many sweeps of a method.
void one_error(benchmark::State& state, const Case& one, const std::string& method,
               int sweeps)
{
    declare_counters(state);
    PgsSettings settings;
    settings.tolerance = 0;
    settings.max_sweeps = sweeps;
    if (method == "sor") settings.omega = one.omega;
    if (method == "jacobi")
        settings.omega = std::min(1.0, 0.95 * safe_jacobi_omega(one.mlcp)),
        settings.sweeps = Sweeps::jacobi;
    if (method == "symmetric") settings.sweeps = Sweeps::symmetric;
    Mlcp free_rows = one.mlcp;
    free_rows.lo.setConstant(-infinity);
    PgsMemory memory;
    CgMemory cg;
    Solution solution;
    for (auto _ : state) {
        cold_start(one.mlcp, solution.lambda);
        if (method == "cg") conjugate_gradients(free_rows, 0, sweeps, cg, solution);
        else pgs(one.mlcp, settings, memory, solution);
        benchmark::DoNotOptimize(solution.residual);
    }
    const VecX w = one.mlcp.A * (solution.lambda - one.exact);
    state.counters["sweeps"] = sweeps;
    state.counters["row_visits"] = static_cast<double>(sweeps * one.mlcp.size());
    state.counters["residual"] = natural_residual(one.mlcp, solution.lambda);
    state.counters["error"] =
        (solution.lambda - one.exact).lpNorm<Eigen::Infinity>() /
        one.exact.lpNorm<Eigen::Infinity>();
    state.counters["velocity_error"] = w.lpNorm<Eigen::Infinity>();
}

void register_errors()
{
    static const std::vector<Case> all = cases();
    for (const Case& one : all)
        for (const std::string method :
             {"jacobi", "gauss_seidel", "symmetric", "sor", "cg"}) {
            // it cannot clamp
            if (method == "cg" && one.name == "ten_discs") continue;
            for (int sweeps = 1; sweeps <= 16384;
                 sweeps = sweeps < 4 ? sweeps + 1 : sweeps + sweeps / 3) {
                if (method == "cg" && sweeps > 2 * one.mlcp.size()) break;
                const std::string name = "error/" + one.name + "/" + method + "/" +
                                         std::to_string(sweeps);
                benchmark::RegisterBenchmark(
                    name.c_str(),
                    [&one, method, sweeps](benchmark::State& state) {
                        one_error(state, one, method, sweeps);
                    })
                    ->MinTime(0.002);
            }
        }
}

}  // namespace

int main(int argc, char** argv)
{
    using OneSweep = Real (*)(SweepRows&);  // of the prescaled rows
    const OneSweep forward = sweep_forward, backward = sweep_backward,
                   jacobi = sweep_jacobi;
    for (const Index N : {300, 1000}) {
        benchmark::RegisterBenchmark("sweep/gauss_seidel", one_sweep, forward)
            ->Arg(N);
        benchmark::RegisterBenchmark("sweep/symmetric_backward", one_sweep,
                                     backward)
            ->Arg(N);
        benchmark::RegisterBenchmark("sweep/jacobi", one_sweep, jacobi)->Arg(N);
        benchmark::RegisterBenchmark("sweep/preparation", preparation)->Arg(N);
        benchmark::RegisterBenchmark("sweep/residual", residual)->Arg(N);
        benchmark::RegisterBenchmark("ten_sweeps", ten_sweeps)->Arg(N);
    }
    register_errors();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
