// Chapter 3, run time and counted work against error.
//
//   assembly/sparse/N    A = J M⁻¹ Jᵀ for a chain of N links, pair by pair
//   assembly/dense/N     the same as a product of full matrices
//   enumerate/contacts/N a column of N discs at rest: 2^N sets, all of them tried
//   enumerate/boxed/N    the same rows between two bounds: 3^N sets
//   enumerate/guess/N    the column of N once more, with the right first guess
//   direct/N             a hanging chain of N links: one sparse Cholesky decomposition
//   schur/N              a zigzag chain of N links that touches the floor at four places
//   step/ten_discs       one step of the ten discs in the middle of a run
//
// error: for assembly the largest difference from the dense product over the largest entry of A; for solvers
// the natural residual over the largest |q|. work: multiplications for assembly, sets for enumeration.
#include "chapters/03_mlcp_formulation/exact.hpp"
#include "chapters/03_mlcp_formulation/step.hpp"
#include "common/scenes.hpp"

#include <benchmark/benchmark.h>
#include <string>
#include <vector>

namespace {

using namespace rigid;

constexpr Real h = 1.0 / 60;

void report(benchmark::State& state, Real n, Real work, Real error,
            const Solution* solution = nullptr)
{
    state.counters["n"] = n;
    state.counters["work"] = work;
    state.counters["error"] = error;
    state.counters["solved"] =
        solution == nullptr || solution->status == Status::solved;
}

/// Velocities after one step of gravity.
VecX fallen(const Bodies<2>& bodies)
{
    VecX u = VecX::Zero(bodies.u.size());
    for (Index k = 0; k < bodies.count(); ++k)
        if (bodies.can_move(k)) u[2 * k + 1] = -9.81 * h;
    return u;
}

std::vector<Row<2>> rows_of(const DiscScene& scene)
{
    std::vector<Contact> contacts;
    find_contacts(scene, 0.01, contacts);
    std::vector<Row<2>> rows;
    disc_rows(scene, h, contacts, rows);
    return rows;
}

/// A chain of N links on N + 1 free discs.
DiscScene free_chain(Index links)
{
    DiscScene scene = hanging_chain(links);
    scene.bodies.inverse_mass.setOnes();
    return scene;
}

struct DenseParts {
    MatX J;
    VecX inverse_mass;
    MatX A;
};

DenseParts dense_parts(const DiscScene& scene, const std::vector<Row<2>>& rows)
{
    DenseParts parts;
    parts.inverse_mass = scene.bodies.inverse_mass;
    parts.J = MatX::Zero(static_cast<Index>(rows.size()), scene.bodies.x.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i].a != world)
            parts.J.block<1, 2>(static_cast<Index>(i), 2 * rows[i].a) = rows[i].Ja;
        parts.J.block<1, 2>(static_cast<Index>(i), 2 * rows[i].b) = rows[i].Jb;
    }
    return parts;
}

void assembly_sparse(benchmark::State& state)
{
    const DiscScene scene = free_chain(state.range(0));
    const auto rows = rows_of(scene);
    const VecX u_star = fallen(scene.bodies);
    AssemblyScratch scratch;
    Mlcp mlcp;
    for ([[maybe_unused]] auto _ : state) {
        assemble(rows, u_star, scratch, mlcp);
        benchmark::DoNotOptimize(mlcp.A.valuePtr());
        benchmark::ClobberMemory();
    }
    const DenseParts parts = dense_parts(scene, rows);
    const MatX A = parts.J * parts.inverse_mass.asDiagonal() * parts.J.transpose();
    const Real error =
        (MatX(mlcp.A) - A).cwiseAbs().maxCoeff() / A.cwiseAbs().maxCoeff();
    // A pair of neighbours shares one body: a block of 1×2 times one of 2×1. A row meets itself at two.
    report(state, static_cast<Real>(rows.size()),
           2.0 * static_cast<Real>(scratch.pairs) +
               2.0 * static_cast<Real>(rows.size()),
           error);
}

void assembly_dense(benchmark::State& state)
{
    const DiscScene scene = free_chain(state.range(0));
    const auto rows = rows_of(scene);
    DenseParts parts = dense_parts(scene, rows);
    for ([[maybe_unused]] auto _ : state) {
        parts.A.noalias() =
            parts.J * parts.inverse_mass.asDiagonal() * parts.J.transpose();
        benchmark::DoNotOptimize(parts.A.data());
        benchmark::ClobberMemory();
    }
    const auto m = static_cast<Real>(parts.J.rows()),
               n = static_cast<Real>(parts.J.cols());
    report(state, m, m * m * n + m * n, 0);
}

Mlcp column_problem(Index N)
{
    const DiscScene scene = column(N);
    return assemble(rows_of(scene), fallen(scene.bodies));
}

void enumerate_contacts(benchmark::State& state)
{
    const Mlcp mlcp = column_problem(state.range(0));
    Solution solution;
    for ([[maybe_unused]] auto _ : state) solution = enumerate(mlcp);
    report(state, static_cast<Real>(mlcp.size()), solution.iterations,
           solution.residual / mlcp.q.cwiseAbs().maxCoeff(), &solution);
}

void enumerate_boxed(benchmark::State& state)
{
    Mlcp mlcp = column_problem(state.range(0));
    mlcp.hi.setConstant(0.6 * static_cast<Real>(mlcp.size()) * 9.81 *
                        h);  // the lowest ones can't carry it all
    Solution solution;
    for ([[maybe_unused]] auto _ : state) solution = enumerate(mlcp);
    report(state, static_cast<Real>(mlcp.size()), solution.iterations,
           solution.residual / mlcp.q.cwiseAbs().maxCoeff(), &solution);
}

void enumerate_guess(benchmark::State& state)
{
    const Mlcp mlcp = column_problem(state.range(0));
    EnumerationSettings settings;
    settings.stop_at_first = true;
    settings.first.assign(static_cast<std::size_t>(mlcp.size()),
                          BoundState::between);
    Solution solution;
    for ([[maybe_unused]] auto _ : state) solution = enumerate(mlcp, settings);
    report(state, static_cast<Real>(mlcp.size()), solution.iterations,
           solution.residual / mlcp.q.cwiseAbs().maxCoeff(), &solution);
}

void direct_chain(benchmark::State& state)
{
    const DiscScene scene = hanging_chain(state.range(0));
    const Mlcp mlcp = assemble(rows_of(scene), fallen(scene.bodies));
    Solution solution;
    for ([[maybe_unused]] auto _ : state) solution = direct(mlcp);
    report(state, static_cast<Real>(mlcp.size()),
           static_cast<Real>(mlcp.A.nonZeros()),
           solution.residual / mlcp.q.cwiseAbs().maxCoeff(), &solution);
}

void schur_chain(benchmark::State& state)
{
    // It lies in a zigzag, and its discs at four of the lower corners touch the floor.
    const Index N = state.range(0);
    DiscScene scene = free_chain(N);
    for (Index k = 0; k <= N; ++k)
        scene.bodies.position(k) =
            Vec2(0.1 * static_cast<Real>(k), k % 2 == 0 ? 0.1 : 0.15);
    for (Link& link : scene.links) link.length = std::hypot(0.1, 0.05);
    scene.walls = {{{0, 1}, 0}};
    scene.radius.setConstant(0.05);
    for (Index place = 0; place < 4; ++place)
        scene.radius[2 * (place * N / 6)] = 0.1;
    scene.linked = PairSet::all();
    const Mlcp mlcp = assemble(rows_of(scene), fallen(scene.bodies));
    Solution solution;
    for ([[maybe_unused]] auto _ : state) solution = schur(mlcp);
    report(state, static_cast<Real>(mlcp.size()), solution.iterations,
           solution.residual / mlcp.q.cwiseAbs().maxCoeff(), &solution);
}

void step_ten_discs(benchmark::State& state)
{
    const auto solve = [](const Mlcp& mlcp, Solution& solution) {
        EnumerationSettings settings;
        settings.stop_at_first = true;
        for (Index i = 0; solution.lambda.size() == mlcp.size() && i < mlcp.size();
             ++i)  // as in the last step
            settings.first.push_back(solution.lambda[i] > 0 ? BoundState::between
                                                            : BoundState::at_lo);
        solution = schur(mlcp, settings);
    };
    DiscScene start = ten_discs();
    StepData<2> now;
    StepSettings settings{.h = 1.0 / 480};
    settings.stiffness = 1;
    auto method = by_matrix(solve);
    for (int n = 0; n < 400; ++n) step(start, settings, method, now);
    DiscScene scene = start;
    for ([[maybe_unused]] auto _ : state) {
        scene.bodies = start.bodies;
        step(scene, settings, method, now);
        benchmark::DoNotOptimize(scene.bodies.x.data());
    }
    report(state, static_cast<Real>(method.solver.mlcp.size()),
           now.solution.iterations,
           now.solution.residual / method.solver.mlcp.q.cwiseAbs().maxCoeff(),
           &now.solution);
}

BENCHMARK(assembly_sparse)
    ->Name("assembly/sparse")
    ->Arg(10)
    ->Arg(30)
    ->Arg(100)
    ->Arg(300)
    ->Arg(1000)
    ->Arg(3000);
BENCHMARK(assembly_dense)
    ->Name("assembly/dense")
    ->Arg(10)
    ->Arg(30)
    ->Arg(100)
    ->Arg(300)
    ->Arg(1000);
BENCHMARK(enumerate_contacts)->Name("enumerate/contacts")->DenseRange(2, 16, 2);
BENCHMARK(enumerate_boxed)->Name("enumerate/boxed")->DenseRange(2, 10, 1);
BENCHMARK(enumerate_guess)->Name("enumerate/guess")->DenseRange(2, 32, 5);
BENCHMARK(direct_chain)
    ->Name("direct")
    ->Arg(10)
    ->Arg(30)
    ->Arg(100)
    ->Arg(300)
    ->Arg(1000)
    ->Arg(3000)
    ->Arg(10000);
BENCHMARK(schur_chain)
    ->Name("schur")
    ->Arg(10)
    ->Arg(30)
    ->Arg(100)
    ->Arg(300)
    ->Arg(1000)
    ->Arg(3000);
BENCHMARK(step_ten_discs)->Name("step/ten_discs");

}  // namespace

BENCHMARK_MAIN();
