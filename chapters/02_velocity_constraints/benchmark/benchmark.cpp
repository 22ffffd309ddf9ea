// Chapter 2, run time against error.
//
//   pendulum/METHOD/STEPS   one second of the pendulum from 90 degrees (reference A4): a row, the stiffest
//   spring
//                           that is stable at this step (h ω = 1), and chapter 1's way, the angle as
//                           coordinate
//   links/METHOD/N          all rows of a hanging chain of N links met to 1e-9 of their first error
//   rounds/N=32/ROUNDS      the error that is left after so many rounds of row by row
//
// error: rad (to the exact angle), or the largest |w| over the first one. A method that does not reach its
// error is kept, with what it got.
#include "chapters/01_euler_integration/exact.hpp"
#include "chapters/01_euler_integration/integrators.hpp"
#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/02_velocity_constraints/solve_rows.hpp"
#include "common/scenes.hpp"

#include <benchmark/benchmark.h>
#include <cmath>
#include <string>
#include <vector>

namespace {

using namespace rigid;

// t = 1 s, from 90 degrees, L = 1 m
constexpr Real exact_angle = -1.405027311524799;

Real angle_error(const VecX& x)
{
    const Real difference = std::atan2(x[0], -x[1]) - exact_angle;
    return std::abs(std::remainder(difference, 2 * pi));
}

/// Every case has the same counters, as a table needs them.
void report(benchmark::State& state, Real error, Real stretch, Real rounds,
            Real work)
{
    state.counters["error"] = error;
    state.counters["stretch"] = stretch;
    state.counters["rounds"] = rounds;
    state.counters["work"] = work;
}

void pendulum_by_row(benchmark::State& state, bool repay)
{
    const auto steps = state.range(0);
    const Real h = 1 / static_cast<Real>(steps);
    Bodies<2> bodies(1);
    for ([[maybe_unused]] auto _ : state) {
        bodies.x << 1, 0;
        bodies.u.setZero();
        for (long k = 0; k < steps; ++k) {
            bodies.u[1] -= h * 9.81;
            const Constraint<2> rod = anchor_constraint(bodies.x, 0, {0, 0}, 1);
            const Row<2> row =
                bilateral(rod, bodies.inverse_mass, repay ? rod.C / h : 0);
            row.apply(solve_row(row, bodies.u).lambda, bodies.u);
            bodies.x += h * bodies.u;
        }
        benchmark::DoNotOptimize(bodies.x.data());
    }
    report(state, angle_error(bodies.x), std::abs(bodies.x.norm() - 1), 1,
           static_cast<Real>(steps));
}

void pendulum_by_spring(benchmark::State& state)
{
    const auto steps = state.range(0);
    const Real h = 1 / static_cast<Real>(steps);
    const Real stiffness = 1 / (h * h);  // h ω = 1
    Bodies<2> bodies(1);
    for ([[maybe_unused]] auto _ : state) {
        bodies.x << 1, 0;
        bodies.u.setZero();
        for (long k = 0; k < steps; ++k) {
            const Constraint<2> rod = anchor_constraint(bodies.x, 0, {0, 0}, 1);
            bodies.u -= h * stiffness * rod.C * rod.Jb.transpose();
            bodies.u[1] -= h * 9.81;
            bodies.x += h * bodies.u;
        }
        benchmark::DoNotOptimize(bodies.x.data());
    }
    report(state, angle_error(bodies.x), std::abs(bodies.x.norm() - 1), 1,
           static_cast<Real>(steps));
}

void pendulum_by_angle(benchmark::State& state)
{
    const auto steps = state.range(0);
    const Real h = 1 / static_cast<Real>(steps);
    const Pendulum pendulum;
    State<1> s;
    for ([[maybe_unused]] auto _ : state) {
        s = {Vec<1>(pi / 2), Vec<1>(0)};
        for (long k = 0; k < steps; ++k) s = symplectic_euler(s, h, pendulum);
        benchmark::DoNotOptimize(s);
    }
    report(state, std::abs(s.x[0] - exact_angle), 0, 1, static_cast<Real>(steps));
}

/// The rows of a chain that hangs straight down, and the velocities after one step of gravity.
struct Links {
    std::vector<Row<2>> rows;
    VecX u;

    explicit Links(Index count)
    {
        const DiscScene scene = hanging_chain(count);
        for (const Link& link : scene.links)
            rows.push_back(bilateral(distance_constraint(scene.bodies.x, link),
                                     scene.bodies.inverse_mass));
        u = scene.bodies.u;
        for (Index k = 1; k <= count; ++k) u[2 * k + 1] = -9.81 / 60;
    }
    Real worst(const VecX& v) const
    {
        Real largest = 0;
        for (const Row<2>& row : rows)
            largest = std::max(largest, std::abs(row.velocity(v)));
        return largest;
    }
    void round(VecX& v) const
    {
        for (const Row<2>& row : rows) row.apply(solve_row(row, v).lambda, v);
    }
};

void links_in_one_shot(benchmark::State& state)
{
    const Links links(state.range(0));
    RowsSolver<2> solver;
    VecX u;
    for ([[maybe_unused]] auto _ : state) {
        u = links.u;
        apply(links.rows, solver.solve(links.rows, u).lambda, u);
        benchmark::DoNotOptimize(u.data());
    }
    const auto n = static_cast<Real>(state.range(0));
    report(state, links.worst(u) / links.worst(links.u), 0, 1,
           n * n * n / 6);  // multiplications of the factorisation
}

void links_row_by_row(benchmark::State& state)
{
    const Links links(state.range(0));
    const Real wanted = 1e-9 * links.worst(links.u);
    VecX u;
    long rounds = 0;
    for ([[maybe_unused]] auto _ : state) {
        u = links.u;
        rounds = 0;
        while (links.worst(u) > wanted && rounds < 1000000) {
            // looking costs as much as half a round
            for (int k = 0; k < 16; ++k) links.round(u);
            rounds += 16;
        }
        benchmark::DoNotOptimize(u.data());
    }
    const Real visits = static_cast<Real>(rounds * state.range(0));
    // 12 multiplications a visit: w, λ and two velocities
    report(state, links.worst(u) / links.worst(links.u), 0,
           static_cast<Real>(rounds), 12 * visits);
}

void rounds_of_32_links(benchmark::State& state)
{
    const Links links(32);
    VecX u;
    for ([[maybe_unused]] auto _ : state) {
        u = links.u;
        for (long k = 0; k < state.range(0); ++k) links.round(u);
        benchmark::DoNotOptimize(u.data());
    }
    report(state, links.worst(u) / links.worst(links.u), 0,
           static_cast<Real>(state.range(0)),
           static_cast<Real>(state.range(0)) * 32 * 12);
}

}  // namespace

BENCHMARK_CAPTURE(pendulum_by_row, row, false)
    ->Name("pendulum/row")
    ->RangeMultiplier(2)
    ->Range(64, 1 << 16);
BENCHMARK_CAPTURE(pendulum_by_row, repaid, true)
    ->Name("pendulum/repaid")
    ->RangeMultiplier(2)
    ->Range(64, 1 << 16);
BENCHMARK(pendulum_by_spring)
    ->Name("pendulum/spring")
    ->RangeMultiplier(2)
    ->Range(64, 1 << 16);
BENCHMARK(pendulum_by_angle)
    ->Name("pendulum/angle")
    ->RangeMultiplier(2)
    ->Range(64, 1 << 16);
BENCHMARK(links_in_one_shot)
    ->Name("links/one-shot")
    ->RangeMultiplier(2)
    ->Range(2, 512)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(links_row_by_row)
    ->Name("links/row-by-row")
    ->RangeMultiplier(2)
    ->Range(2, 128)
    ->Unit(benchmark::kMicrosecond);
BENCHMARK(rounds_of_32_links)
    ->Name("rounds/N=32")
    ->RangeMultiplier(4)
    ->Range(1, 1 << 16)
    ->Unit(benchmark::kMicrosecond);

BENCHMARK_MAIN();
