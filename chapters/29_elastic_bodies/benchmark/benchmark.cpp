/// Chapter 29: what a step of an elastic body costs, and what its error is.
///
///     SCENE/LAW/RULE/SOLVE/STEPS   time of a step [µs]; error of the tip after half a second [shares of its way]
///     net/METHOD/SWEEPS            a net of springs that is also a sheet: one second, error beside the converged step
///     tets/LAW/SOLVE               10,080 tetrahedra, a step of 1/60 s: time [ms], residual, linear systems
///     memory/…                     bytes an element, of the model and of the solver
///
/// light, heavy: a strip of 1 m × 0.1 m that falls by 1 % and by 40 % of its length. The reference is the neo-Hookean law on
/// the same mesh by midpoint with 1/3840 s: what is left is the error of the step and of the law.

#include "chapters/16_soft_constraints/xpbd.hpp"
#include "chapters/29_elastic_bodies/elastic_scenes.hpp"
#include "chapters/29_elastic_bodies/vibration.hpp"

#ifdef RIGID_CHOLMOD
#include <Eigen/CholmodSupport>
#endif
#include <Eigen/SparseCholesky>
#include <benchmark/benchmark.h>

#include <chrono>
#include <map>
#include <memory>
#include <string>

using namespace rigid;

namespace {

using Clock = std::chrono::steady_clock;
Real since(Clock::time_point start)
{
    return std::chrono::duration<Real>(Clock::now() - start).count();
}

/// The CSV wants each counter of each line.
void clear(benchmark::State& state)
{
    for (const char* name :
         {"us", "ms", "ms_whole", "solve_ms", "error", "residual", "systems",
          "inner", "bytes_model", "bytes_solver", "nodes", "blocks"})
        state.counters[name] = 0;
}

// ------------------------------------------------------------------------------------------- strips

ElasticBody<2> strip(StrainLaw law, Real weight)
{
    const ElasticMesh<2> mesh =
        quadratic(rectangle_mesh({0, -0.05}, {1, 0.1}, 20, 2));
    ElasticBody<2> body(mesh, {.young = 1e6, .poisson = 0.3, .law = law});
    for (int i = 0; i < mesh.nodes(); ++i)
        if (mesh.at(i).x() < 1e-9) body.hold(i);
    body.gravity = {0, -weight};
    return body;
}

Vec2 tip_of(const ElasticBody<2>& body)
{
    for (int i = 0; i < body.model.nodes(); ++i)
        if ((body.model.mesh().at(i) - Vec2(1, 0)).norm() < 1e-9) return body.at(i);
    return {0, 0};
}

constexpr Real seconds = 0.5;
Real weight_of(const std::string& scene) { return scene == "light" ? 0.05 : 4; }

Vec2 reference(const std::string& scene)
{
    static std::map<std::string, Vec2> known;
    if (const auto found = known.find(scene); found != known.end())
        return found->second;
    ElasticBody<2> body = strip(StrainLaw::neo_hookean, weight_of(scene));
    ElasticSolver<2> solver;
    solver.settings.rule = TimeRule::implicit_midpoint;
    const int steps = 1920;
    for (int n = 0; n < steps; ++n) solver.step(body, seconds / steps);
    return known[scene] = tip_of(body);
}

void falls(benchmark::State& state, const std::string& scene, StrainLaw law,
           const std::string& rule, LinearSolve solve)
{
    const auto steps = static_cast<int>(state.range(0));
    Real best = infinity, error = 0, systems = 0, inner = 0;
    for (auto _ : state)
        for (int repeat = 0; repeat < 3; ++repeat) {
            ElasticBody<2> body = strip(law, weight_of(scene));
            ElasticSolver<2> solver;
            solver.settings.solve = solve;
            solver.settings.tolerance = 1e-7;
            solver.settings.rule = rule == "midpoint" ? TimeRule::implicit_midpoint
                                                      : TimeRule::implicit_euler;
            std::unique_ptr<ModalBody<2>> modal;
            if (rule == "modal") modal = std::make_unique<ModalBody<2>>(body, 20);
            systems = inner = 0;
            const auto start = Clock::now();
            for (int n = 0; n < steps; ++n) {
                if (modal) modal->step(body, seconds / steps);
                else solver.step(body, seconds / steps);
                systems += solver.report.iterations,
                    inner += solver.report.linear_iterations;
            }
            best = std::min(best, since(start));
            const Vec2 end = reference(scene);
            error = (tip_of(body) - end).norm() / (end - Vec2(1, 0)).norm();
        }
    clear(state);
    state.counters["us"] = 1e6 * best / steps;
    state.counters["ms_whole"] = 1e3 * best;
    state.counters["error"] = error;
    state.counters["systems"] = systems / steps;
    state.counters["inner"] = inner / steps;
}

// ------------------------------------------------------------------------------------ a net that is a sheet

struct LatticeScene {
    static constexpr int dof = 2;
    Bodies<2> bodies{0};
    std::vector<std::array<int, 2>> edges;
    std::vector<Real> stiffness, length;
};

Constraint<2> constraint_at(const LatticeScene& scene, const StepData<2>&,
                            std::size_t i, const VecX& x)
{
    Constraint<2> c;
    const auto [a, b] = scene.edges[i];
    const Vec2 ab = x.segment<2>(2 * b) - x.segment<2>(2 * a);
    c.a = a, c.b = b, c.C = ab.norm() - scene.length[i];
    c.Jb = ab.normalized().transpose(), c.Ja = -c.Jb;
    return c;
}

ElasticBody<2> lattice()
{
    ElasticBody<2> body(lattice_mesh(1.0 / 32, 33, 5), {.young = 1e6,
                                                        .poisson = 1.0 / 3,
                                                        .law = StrainLaw::linear,
                                                        .plane_stress = true});
    body.model.lump();
    for (int i = 0; i < body.model.nodes(); ++i)
        if (body.at(i).x() < 0.02) body.hold(i);
    body.gravity = {0, -0.2};
    return body;
}

/// Sag of the far lower corner after a second of 60 steps, by XPBD.
Real net_sag(int sweeps, Real& us)
{
    const ElasticBody<2> body = lattice();
    const ElasticMesh<2>& mesh = body.model.mesh();
    LatticeScene scene;
    scene.bodies = Bodies<2>(mesh.nodes());
    scene.bodies.x = mesh.rest;
    for (int i = 0; i < mesh.nodes(); ++i)
        for (int c = 0; c < 2; ++c)
            scene.bodies.inverse_mass[2 * i + c] =
                body.fixed[static_cast<std::size_t>(2 * i)]
                    ? 0
                    : 1 / body.model.mass_at(i);
    std::map<std::array<int, 2>, Real> edges;
    for (int e = 0; e < mesh.count(); ++e)
        for (const auto& [i, j] : edges_of_element<2>()) {
            const int a = mesh.node(e, i), b = mesh.node(e, j);
            edges[{std::min(a, b), std::max(a, b)}] += std::sqrt(3.0) / 4 * 1e6;
        }
    Xpbd xpbd;
    xpbd.sweeps = sweeps;
    xpbd.velocity_pass = false;
    FreeVelocities none;
    StepData<2> now;
    const Real h = 1.0 / 60;
    for (int k = 0; k < mesh.nodes(); ++k) now.active.push_back(k);
    for (const auto& [edge, k] : edges) {
        scene.edges.push_back(edge), scene.stiffness.push_back(k);
        scene.length.push_back((mesh.at(edge[1]) - mesh.at(edge[0])).norm());
    }
    const auto start = Clock::now();
    for (int n = 0; n < 60; ++n) {
        for (int i = 0; i < mesh.nodes(); ++i)
            if (scene.bodies.can_move(i)) scene.bodies.u[2 * i + 1] -= 0.2 * h;
        now.rows.clear();
        now.constraints.resize(scene.edges.size());
        for (std::size_t i = 0; i < scene.edges.size(); ++i) {
            const Constraint<2> c = constraint_at(scene, now, i, scene.bodies.x);
            Row<2> row = bilateral(c, scene.bodies.inverse_mass, c.C / h);
            row.softness = 1 / (h * h * scene.stiffness[i]);
            now.rows.push_back(row);
        }
        xpbd.move(scene, {.h = h}, none, now);
    }
    us = 1e6 * since(start) / 60;
    return mesh.rest[2 * 32 + 1] - scene.bodies.x[2 * 32 + 1];
}

Real sheet_sag(StrainLaw law, LinearSolve solve, Real tolerance, Real& us)
{
    ElasticBody<2> linear = lattice();
    ElasticBody<2> body(
        linear.model.mesh(),
        {.young = 1e6, .poisson = 1.0 / 3, .law = law, .plane_stress = true});
    body.model.lump();
    body.fixed = linear.fixed, body.gravity = linear.gravity;
    ElasticSolver<2> solver;
    solver.settings.solve = solve;
    solver.settings.tolerance = tolerance;
    const auto start = Clock::now();
    for (int n = 0; n < 60; ++n) solver.step(body, 1.0 / 60);
    us = 1e6 * since(start) / 60;
    return body.model.mesh().rest[2 * 32 + 1] - body.x[2 * 32 + 1];
}

// ---------------------------------------------------------------------------------------- tetrahedra

ElasticBody<3> many_tetrahedra(StrainLaw law)
{
    ElasticBody<3> body(block_mesh({0, 0, 0}, {2.1, 1, 0.8}, 21, 10, 8),
                        {.young = 2e5, .poisson = 0.3, .law = law});
    for (int i = 0; i < body.model.nodes(); ++i)
        if (body.at(i)[0] < 1e-9) body.hold(i);
    body.gravity = {0, -9.81, 0};
    return body;
}

void tetrahedra(benchmark::State& state, StrainLaw law, LinearSolve solve, int most)
{
    Real best = infinity, residual = 0, systems = 0, inner = 0;
    std::size_t bytes = 0, model = 0;
    int nodes = 0, count = 0;
    std::int64_t blocks = 0;
    for (auto _ : state) {
        ElasticBody<3> body = many_tetrahedra(law);
        ElasticSolver<3> solver;
        solver.settings.solve = solve;
        solver.settings.most = most;
        solver.settings.tolerance = 1e-6;
        solver.settings.linear_tolerance = 1e-2;
        for (int n = 0; n < 20; ++n) {
            const auto start = Clock::now();
            solver.step(body, 1.0 / 60);
            if (n < 5) continue;  // it has begun to move
            best = std::min(best, since(start));
            residual = std::max(residual, solver.report.residual);
            systems += solver.report.iterations / 15.0,
                inner += solver.report.linear_iterations / 15.0;
        }
        bytes = solver.bytes(), model = body.model.bytes(),
        nodes = body.model.nodes(), count = body.model.mesh().count();
        blocks = solver.factor.blocks();
    }
    clear(state);
    state.counters["ms"] = 1e3 * best;
    state.counters["residual"] = residual;
    state.counters["systems"] = systems;
    state.counters["inner"] = inner;
    state.counters["bytes_model"] = static_cast<Real>(model) / count;
    state.counters["bytes_solver"] = static_cast<Real>(bytes) / count;
    state.counters["nodes"] = nodes;
    state.counters["blocks"] = static_cast<Real>(blocks);
}

/// The factor of one and the same matrix by this book, by Eigen and by CHOLMOD.
template <class Factor, class Solve>
void time_factor(benchmark::State& state, const Factor& factor, const Solve& solve)
{
    Real first = infinity, second = infinity;
    for (auto _ : state)
        for (int n = 0; n < 3; ++n) {
            auto start = Clock::now();
            factor();
            first = std::min(first, since(start));
            start = Clock::now();
            solve();
            second = std::min(second, since(start));
        }
    clear(state);
    state.counters["ms"] = 1e3 * first;
    state.counters["solve_ms"] = 1e3 * second;
}

struct Matrices {
    ElasticBody<3> body = many_tetrahedra(StrainLaw::linear);
    BlockMatrix<3> H;
    Eigen::SparseMatrix<Real> sparse;
    VecX b;

    Matrices()
    {
        H.reset(body.model.pattern());
        body.model.add_stiffness(body.x, 1.0 / 3600, true, H);
        body.model.add_mass(1, H);
        fix<3>(body.fixed, H);
        std::vector<Eigen::Triplet<Real>> entries;
        const BlockPattern& p = body.model.pattern();
        for (int j = 0; j < p.size(); ++j)
            for (int s = p.start[static_cast<std::size_t>(j)];
                 s < p.start[static_cast<std::size_t>(j) + 1]; ++s)
                for (int r = 0; r < 3; ++r)
                    for (int c = 0; c < 3; ++c) {
                        const int i = p.row[static_cast<std::size_t>(s)];
                        if (i != j || r >= c)
                            entries.emplace_back(3 * i + r, 3 * j + c,
                                                 H.block(s)[3 * r + c]);
                    }
        sparse.resize(body.x.size(), body.x.size());
        sparse.setFromTriplets(entries.begin(), entries.end());
        b = VecX::Ones(body.x.size());
    }
};

template <class Solver>
void eigen_factor(benchmark::State& state)
{
    Matrices m;
    Solver solver;
    solver.analyzePattern(m.sparse);
    VecX x;
    time_factor(
        state, [&] { solver.factorize(m.sparse); }, [&] { x = solver.solve(m.b); });
}

void own_factor(benchmark::State& state)
{
    Matrices m;
    BlockLdlt<3> solver;
    solver.analyse(m.body.model.pattern());
    VecX x;
    time_factor(
        state, [&] { solver.factor(m.H); }, [&] { x = m.b, solver.solve(x); });
    state.counters["blocks"] = static_cast<Real>(solver.blocks());
}

const bool registered = [] {
    const std::pair<const char*, StrainLaw> laws[] = {
        {"linear", StrainLaw::linear},
        {"corotational", StrainLaw::corotational},
        {"neo_hookean", StrainLaw::neo_hookean}};
    const std::pair<const char*, LinearSolve> solves[] = {
        {"direct", LinearSolve::direct}, {"cg", LinearSolve::conjugate_gradients}};
    for (const std::string scene : {"light", "heavy"}) {
        for (const auto& [law_name, law] : laws)
            for (const std::string rule : {"euler", "midpoint"})
                for (const auto& [solve_name, solve] : solves) {
                    auto* const one = benchmark::RegisterBenchmark(
                        (scene + "/" + law_name + "/" + rule + "/" + solve_name)
                            .c_str(),
                        [scene, law = law, rule,
                         solve = solve](benchmark::State& state) {
                            falls(state, scene, law, rule, solve);
                        });
                    for (const int steps : {15, 30, 60, 120, 240}) one->Arg(steps);
                    one->Iterations(1);
                }
        auto* const modal =
            benchmark::RegisterBenchmark((scene + "/linear/modal/exact").c_str(),
                                         [scene](benchmark::State& state) {
                                             falls(state, scene, StrainLaw::linear,
                                                   "modal", LinearSolve::direct);
                                         });
        for (const int steps : {15, 30, 60}) modal->Arg(steps);
        modal->Iterations(1);
    }
    auto* const net =
        benchmark::RegisterBenchmark("net/xpbd", [](benchmark::State& state) {
            Real us = 0, none = 0, sag = 0;
            const Real truth =
                sheet_sag(StrainLaw::linear, LinearSolve::direct, 1e-12, none);
            for (auto _ : state)
                sag = net_sag(static_cast<int>(state.range(0)), us);
            clear(state);
            state.counters["us"] = us;
            state.counters["error"] = std::abs(sag / truth - 1);
        });
    for (const int sweeps : {10, 100, 1000, 10000}) net->Arg(sweeps);
    net->Iterations(1);
    for (const auto& [law_name, law] : laws)
        for (const auto& [solve_name, solve] : solves)
            benchmark::RegisterBenchmark(
                (std::string("net/") + law_name + "/" + solve_name).c_str(),
                [law = law, solve = solve](benchmark::State& state) {
                    Real us = 0, none = 0, sag = 0;
                    const Real truth = sheet_sag(StrainLaw::linear,
                                                 LinearSolve::direct, 1e-12, none);
                    for (auto _ : state) sag = sheet_sag(law, solve, 1e-7, us);
                    state.counters["us"] = us,
                    state.counters["error"] = std::abs(sag / truth - 1);
                })
                ->Iterations(1);
    for (const auto& [law_name, law] : laws)
        for (const auto& [solve_name, solve] : solves)
            for (const int most : {1, 20})
                benchmark::RegisterBenchmark(
                    (std::string("tets/") + law_name + "/" + solve_name +
                     (most == 1 ? "/one" : "/all"))
                        .c_str(),
                    [law = law, solve = solve, most](benchmark::State& state) {
                        tetrahedra(state, law, solve, most);
                    })
                    ->Iterations(1);
    benchmark::RegisterBenchmark("factor/book", own_factor)->Iterations(1);
    benchmark::RegisterBenchmark(
        "factor/eigen",
        eigen_factor<Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>>>)
        ->Iterations(1);
#ifdef RIGID_CHOLMOD
    benchmark::RegisterBenchmark(
        "factor/cholmod",
        eigen_factor<Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<Real>>>)
        ->Iterations(1);
#endif
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
