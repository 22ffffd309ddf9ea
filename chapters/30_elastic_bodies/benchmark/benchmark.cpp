/// Chapter 30: what a step of an elastic body costs, and what its error is.
///
///     SCENE/LAW/RULE/SOLVE/STEPS   time of a step [µs]; error of the tip after half a second [shares of its way]
///     net/METHOD/SWEEPS            a net of springs that is also a sheet: one second, error beside the converged step
///     beam/METHOD/STEPS            a cantilever of 480 tetrahedra that falls for half a second, beside Bullet's
///     sag/METHOD/STEPS             the same at rest: damped until it stands, or at once
///     tets/LAW/SOLVE               10,080 tetrahedra, a step of 1/60 s: time [ms], residual, error, linear systems, bytes
///     vibrations/COUNT             the same block by the linear law and so many vibrations: time to find them and of a step [ms]
///     soft/SCENE                   a step of tetrahedra with contacts, and its rows
///     factor/PROGRAM               one matrix factored and solved: time [ms], numbers in the factor, residual
///     ccx/ORDER                    rest and vibrations of a cantilever by CalculiX: time, largest difference from the book's
///
/// light, heavy: a strip of 1 m × 0.1 m that falls by 1 % and by 40 % of its length. The reference is the neo-Hookean law on
/// the same mesh by midpoint with 1/3840 s: what is left is the error of the step and of the law.

#include "chapters/30_elastic_bodies/benchmark/springs.hpp"
#include "chapters/30_elastic_bodies/elastic_scenes.hpp"
#include "chapters/30_elastic_bodies/elastic_space_scenes.hpp"
#include "chapters/30_elastic_bodies/vibration.hpp"
#include "tests/peers/bullet_deformable.hpp"
#include "tests/peers/calculix.hpp"

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
          "inner", "factors", "bytes_model", "bytes_solver", "nodes", "blocks",
          "rows", "fill", "tones"})
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

constexpr int tetrahedra_steps = 20;  ///< a third of a second

/// Where the nodes are at the end, each step to 1e-9.
const VecX& settled_tetrahedra(StrainLaw law)
{
    static std::map<StrainLaw, VecX> known;
    if (const auto found = known.find(law); found != known.end())
        return found->second;
    ElasticBody<3> body = many_tetrahedra(law);
    ElasticSolver<3> solver;
    solver.settings.stale = 0.5;
    for (int n = 0; n < tetrahedra_steps; ++n) solver.step(body, 1.0 / 60);
    return known[law] = body.x;
}

/// The largest way between two places of a node, over the largest that one has gone.
Real off_by(const ElasticBody<3>& body, const VecX& wanted)
{
    Real off = 0, way = 0;
    for (Index i = 0; i < wanted.size(); i += 3) {
        off = std::max(off, (body.x - wanted).segment<3>(i).norm());
        way = std::max(way, (wanted - body.model.mesh().rest).segment<3>(i).norm());
    }
    return off / way;
}

void tetrahedra(benchmark::State& state, StrainLaw law, LinearSolve solve, int most,
                Real stale)
{
    Real best = infinity, residual = 0, systems = 0, inner = 0, factors = 0,
         sum = 0, error = 0;
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
        solver.settings.stale = stale;
        for (int n = 0; n < tetrahedra_steps; ++n) {
            const auto start = Clock::now();
            solver.step(body, 1.0 / 60);
            if (n < 5) continue;  // it has begun to move
            best = std::min(best, since(start));
            residual = std::max(residual, solver.report.residual);
            systems += solver.report.iterations / 15.0,
                inner += solver.report.linear_iterations / 15.0;
            factors += solver.report.factorisations / 15.0;
            sum += since(start) / 15;
        }
        error = off_by(body, settled_tetrahedra(law));
        bytes = solver.bytes(), model = body.model.bytes(),
        nodes = body.model.nodes(), count = body.model.mesh().count();
        blocks = solver.factor.blocks();
    }
    clear(state);
    state.counters["ms"] = 1e3 * best;
    state.counters["ms_whole"] = 1e3 * sum;
    state.counters["factors"] = factors;
    state.counters["residual"] = residual;
    state.counters["error"] = error;
    state.counters["systems"] = systems;
    state.counters["inner"] = inner;
    state.counters["bytes_model"] = static_cast<Real>(model) / count;
    state.counters["bytes_solver"] = static_cast<Real>(bytes) / count;
    state.counters["nodes"] = nodes;
    state.counters["blocks"] = static_cast<Real>(blocks);
}

/// The block by its slowest vibrations: how long it takes to find them and to step them, and how far off the linear law
/// they are at the end, which midpoint has to 1e-4 with these steps.
void few_vibrations(benchmark::State& state)
{
    ElasticBody<3> wanted = many_tetrahedra(StrainLaw::linear);
    ElasticSolver<3> solver;
    solver.settings.rule = TimeRule::implicit_midpoint;
    for (int n = 0; n < 16 * tetrahedra_steps; ++n) solver.step(wanted, 1.0 / 960);
    Real first = 0, best = infinity, error = 0;
    int rounds = 0;
    for (auto _ : state) {
        ElasticBody<3> body = many_tetrahedra(StrainLaw::linear);
        auto start = Clock::now();
        ModalBody<3> modal(body, static_cast<int>(state.range(0)));
        first = since(start);
        rounds = modal.vibration.iterations;
        for (int n = 0; n < tetrahedra_steps; ++n) {
            start = Clock::now();
            modal.step(body, 1.0 / 60);
            best = std::min(best, since(start));
        }
        error = off_by(body, wanted.x);
    }
    clear(state);
    state.counters["ms"] = 1e3 * best;
    state.counters["ms_whole"] = 1e3 * first;
    state.counters["error"] = error;
    state.counters["inner"] = rounds;
}

// ------------------------------------------------------------------------------- a beam beside Bullet's

ElasticBody<3> beam(StrainLaw law)
{
    ElasticBody<3> body(block_mesh({0, 0, 0}, {1, 0.1, 0.1}, 20, 2, 2),
                        {.young = 1e6, .poisson = 0.3, .law = law});
    body.model.lump();  // as Bullet has it
    for (int i = 0; i < body.model.nodes(); ++i)
        if (body.at(i).x() < 1e-9) body.hold(i);
    body.gravity = {0, -0.05, 0};  // so light that all laws agree
    return body;
}

int end_of(const ElasticBody<3>& body)
{
    for (int i = 0; i < body.model.nodes(); ++i)
        if ((body.model.mesh().at(i) - Vec3(1, 0, 0)).norm() < 1e-9) return i;
    return 0;
}

/// The tip after half a second, or at rest.
Vec3 beam_reference(bool at_rest)
{
    static std::map<bool, Vec3> known;
    if (const auto found = known.find(at_rest); found != known.end())
        return found->second;
    ElasticBody<3> body = beam(StrainLaw::corotational);
    ElasticSolver<3> solver;
    solver.settings.tolerance = 1e-12;
    solver.settings.rule = TimeRule::implicit_midpoint;
    if (at_rest) solver.rest(body);
    else
        for (int n = 0; n < 960; ++n) solver.step(body, seconds / 960);
    return known[at_rest] = body.at(end_of(body));
}

constexpr Real beam_damping = 0.02;  ///< β [s] of what has to come to rest

void note_beam(benchmark::State& state, const Vec3& tip, bool at_rest, int steps,
               Real time)
{
    const Vec3 truth = beam_reference(at_rest);
    clear(state);
    state.counters["us"] = 1e6 * time / std::max(1, steps);
    state.counters["ms_whole"] = 1e3 * time;
    state.counters["error"] = (tip - truth).norm() / (truth - Vec3(1, 0, 0)).norm();
}

void beam_falls(benchmark::State& state, StrainLaw law, TimeRule rule,
                LinearSolve solve, bool at_rest)
{
    const auto steps = static_cast<int>(state.range(0));
    const Real h = at_rest ? 1.0 / 60 : seconds / std::max(1, steps);
    Real best = infinity;
    Vec3 tip(0, 0, 0);
    for (auto _ : state)
        for (int repeat = 0; repeat < 3; ++repeat) {
            ElasticBody<3> body = beam(law);
            if (at_rest) body.stiffness_damping = beam_damping;
            ElasticSolver<3> solver;
            solver.settings.rule = rule, solver.settings.solve = solve;
            solver.settings.tolerance = 1e-7, solver.settings.stale = 0.3;
            const auto start = Clock::now();
            if (steps == 0) solver.rest(body);
            for (int n = 0; n < steps; ++n) solver.step(body, h);
            best = std::min(best, since(start));
            tip = body.at(end_of(body));
        }
    note_beam(state, tip, at_rest, steps, best);
}

#ifdef RIGID_HAS_BULLET
void bullet_falls(benchmark::State& state, StrainLaw law, int newton, bool at_rest)
{
    const auto steps = static_cast<int>(state.range(0));
    const Real h = at_rest ? 1.0 / 60 : seconds / steps;
    Real best = infinity;
    Vec3 tip(0, 0, 0);
    for (auto _ : state)
        for (int repeat = 0; repeat < 3; ++repeat) {
            const ElasticBody<3> body = beam(law);
            BulletDeformable bullet(body, newton, at_rest ? beam_damping : 0);
            const auto start = Clock::now();
            for (int n = 0; n < steps; ++n) bullet.step(h);
            best = std::min(best, since(start));
            tip = bullet.at(end_of(body));
        }
    note_beam(state, tip, at_rest, steps, best);
}
#endif

// ------------------------------------------------------------------------------- contacts in space

template <class Make, class Move>
void soft_step(benchmark::State& state, const Make& make, const Move& move,
               int from, int to, Real stale)
{
    Real sum = 0, rows = 0, systems = 0, factors = 0, residual = 0;
    int tetrahedra = 0;
    for (auto _ : state) {
        ElasticSpace scene = make();
        tetrahedra = scene.elastic.model.mesh().count();
        ElasticSolids contacts;
        contacts.solver.settings.stale = stale;
        for (int n = 0; n < to; ++n) {
            move(scene, n / 60.0);
            const auto start = Clock::now();
            contacts.step(scene, 1.0 / 60);
            if (n < from) continue;
            sum += since(start) / (to - from);
            rows += static_cast<Real>(contacts.rows.size()) / (to - from);
            systems += Real{1} * contacts.report.iterations / (to - from);
            factors += Real{1} * contacts.report.factorisations / (to - from);
            residual = std::max(residual, contacts.report.residual);
        }
    }
    clear(state);
    state.counters["ms"] = 1e3 * sum;
    state.counters["rows"] = rows;
    state.counters["systems"] = systems;
    state.counters["factors"] = factors;
    state.counters["residual"] = residual;
    state.counters["nodes"] = tetrahedra;
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

/// The factor of one and the same matrix by this book, by Eigen and by CHOLMOD.
/// \param solve  returns what it made of b
template <class Factor, class Solve>
void time_factor(benchmark::State& state, const Matrices& m, const Factor& factor,
                 const Solve& solve)
{
    Real first = infinity, second = infinity;
    VecX x;
    for (auto _ : state)
        for (int n = 0; n < 3; ++n) {
            auto start = Clock::now();
            factor();
            first = std::min(first, since(start));
            start = Clock::now();
            x = solve();
            second = std::min(second, since(start));
        }
    clear(state);
    const VecX left = m.sparse.selfadjointView<Eigen::Lower>() * x - m.b;
    state.counters["ms"] = 1e3 * first;
    state.counters["solve_ms"] = 1e3 * second;
    state.counters["residual"] = left.norm() / m.b.norm();
}

#ifdef RIGID_CHOLMOD
Real fill_of(Eigen::CholmodSupernodalLLT<Eigen::SparseMatrix<Real>>& solver)
{
    return solver.cholmod().lnz;
}
#endif
Real fill_of(Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>>& solver)
{
    return static_cast<Real>(solver.matrixL().nestedExpression().nonZeros());
}

template <class Solver>
void eigen_factor(benchmark::State& state)
{
    Matrices m;
    Solver solver;
    solver.analyzePattern(m.sparse);
    time_factor(
        state, m, [&] { solver.factorize(m.sparse); },
        [&] { return VecX(solver.solve(m.b)); });
    state.counters["fill"] = fill_of(solver);
}

void own_factor(benchmark::State& state)
{
    Matrices m;
    BlockLdlt<3> solver;
    solver.analyse(m.body.model.pattern());
    time_factor(
        state, m, [&] { solver.factor(m.H); },
        [&] {
            VecX x = m.b;
            solver.solve(x);
            return x;
        });
    state.counters["blocks"] = static_cast<Real>(solver.blocks());
    state.counters["fill"] = 9 * static_cast<Real>(solver.blocks());
}

#ifdef RIGID_CALCULIX
/// Linear or quadratic tetrahedra: rest, and its six slowest vibrations.
void beside_calculix(benchmark::State& state, int order)
{
    const ElasticBody<3> light = beam(StrainLaw::linear);
    const ElasticMesh<3>& mesh = light.model.mesh();
    ElasticBody<3> body(order == 1 ? mesh : quadratic(mesh),
                        {.young = 1e6, .poisson = 0.3, .law = StrainLaw::linear});
    for (int i = 0; i < body.model.nodes(); ++i)
        if (body.at(i).x() < 1e-9) body.hold(i);
    body.gravity = light.gravity;
    Real off = 0, whole = 0, tones = 0, own = infinity;
    CalculixAnswer other;
    for (auto _ : state) {
        other = by_calculix(body, 6);
        ElasticBody<3> at_rest = body;
        ElasticSolver<3> solver;
        const auto start = Clock::now();
        solver.rest(at_rest);
        const Vibration<3> swings = vibrations_of(body, 6);
        own = since(start);
        const VecX moved = at_rest.x - body.x;
        off = (moved - other.moved).cwiseAbs().maxCoeff();
        whole = moved.cwiseAbs().maxCoeff();
        for (Index k = 0; k < 6; ++k)
            tones =
                std::max(tones, std::abs(other.omega[static_cast<std::size_t>(k)] /
                                             swings.omega[k] -
                                         1));
    }
    clear(state);
    state.counters["ms"] = 1e3 * own;
    state.counters["ms_whole"] = 1e3 * other.seconds;
    state.counters["error"] = off / whole;
    state.counters["tones"] = tones;
    state.counters["nodes"] = body.model.nodes();
}
#endif

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
    const auto add_net = [](const char* name, ClothMethod method,
                            std::initializer_list<int> counts) {
        auto* const one =
            benchmark::RegisterBenchmark(name, [method](benchmark::State& state) {
                Real us = 0, none = 0, sag = 0;
                const Real truth = sheet_sag(StrainLaw::corotational,
                                             LinearSolve::direct, 1e-12, 0, none);
                for (auto _ : state)
                    sag = net_sag(method, static_cast<int>(state.range(0)), us);
                clear(state);
                state.counters["us"] = us;
                state.counters["error"] = std::abs(sag / truth - 1);
            });
        for (const int count : counts) one->Arg(count);
        one->Iterations(1);
    };
    add_net("net/xpbd", ClothMethod::xpbd, {10, 30, 100, 300, 1000, 3000, 10000});
    add_net("net/vbd", ClothMethod::particles,
            {10, 30, 100, 300, 1000, 3000, 10000});
    add_net("net/projective", ClothMethod::projective, {1, 3, 10, 30, 100});
    add_net("net/springs_newton", ClothMethod::newton, {1});
    for (const auto& [law_name, law] : laws)
        for (const auto& [solve_name, solve] : solves)
            for (const Real tolerance : {1e-3, 1e-5, 1e-7})
                benchmark::RegisterBenchmark(
                    (std::string("net/") + law_name + "/" + solve_name + "/" +
                     (tolerance > 1e-4   ? "3"
                      : tolerance > 1e-6 ? "5"
                                         : "7"))
                        .c_str(),
                    [law = law, solve = solve, tolerance](benchmark::State& state) {
                        Real us = 0, none = 0, sag = 0;
                        const Real truth =
                            sheet_sag(StrainLaw::corotational, LinearSolve::direct,
                                      1e-12, 0, none);
                        for (auto _ : state)
                            sag = sheet_sag(law, solve, tolerance, 0.3, us);
                        clear(state);
                        state.counters["us"] = us,
                        state.counters["error"] = std::abs(sag / truth - 1);
                    })
                    ->Iterations(1);
    for (const bool at_rest : {false, true}) {
        const std::string kind = at_rest ? "sag/" : "beam/";
        const auto arguments = [at_rest](auto* one, bool is_book) {
            if (at_rest && is_book) one->Arg(0);
            for (const int steps : {30, 60, 120, 240})
                one->Arg(at_rest ? 4 * steps : steps);
            one->Iterations(1);
        };
        for (const auto& [law_name, law] : laws)
            for (const TimeRule rule :
                 {TimeRule::implicit_euler, TimeRule::implicit_midpoint})
                for (const auto& [solve_name, solve] : solves) {
                    if (at_rest && rule == TimeRule::implicit_midpoint) continue;
                    arguments(
                        benchmark::RegisterBenchmark(
                            (kind + law_name +
                             (rule == TimeRule::implicit_euler ? "/euler/"
                                                               : "/midpoint/") +
                             solve_name)
                                .c_str(),
                            [law = law, rule, solve = solve,
                             at_rest](benchmark::State& state) {
                                beam_falls(state, law, rule, solve, at_rest);
                            }),
                        true);
                }
#ifdef RIGID_HAS_BULLET
        for (const StrainLaw law :
             {StrainLaw::corotational, StrainLaw::neo_hookean})
            for (const int newton : {1, 10})
                arguments(benchmark::RegisterBenchmark(
                              (kind + "bullet/" + std::string(to_string(law)) +
                               "/" + std::to_string(newton))
                                  .c_str(),
                              [law, newton, at_rest](benchmark::State& state) {
                                  bullet_falls(state, law, newton, at_rest);
                              }),
                          false);
#endif
    }
    for (const Real stale : {0.0, 0.3}) {
        const std::string kept = stale > 0 ? "/kept" : "/new";
        const auto stands = [](ElasticSpace&, Real) {};
        benchmark::RegisterBenchmark(
            ("soft/ball" + kept).c_str(),
            [=](benchmark::State& state) {
                soft_step(
                    state,
                    [] {
                        return soft_ball_scene(StrainLaw::corotational, 3e4, 0.2);
                    },
                    stands, 10, 50, stale);
            })
            ->Iterations(1);
        benchmark::RegisterBenchmark(
            ("soft/jelly" + kept).c_str(),
            [=](benchmark::State& state) {
                soft_step(
                    state,
                    [] { return space_jelly_scene(StrainLaw::neo_hookean, 2e4); },
                    stands, 10, 50, stale);
            })
            ->Iterations(1);
        benchmark::RegisterBenchmark(
            ("soft/mattress" + kept).c_str(),
            [=](benchmark::State& state) {
                soft_step(
                    state,
                    [] { return mattress_scene(StrainLaw::corotational, 4e4, 12); },
                    stands, 60, 120, stale);
            })
            ->Iterations(1);
        benchmark::RegisterBenchmark(
            ("soft/fingers" + kept).c_str(),
            [=](benchmark::State& state) {
                soft_step(
                    state,
                    [] {
                        return soft_fingers_scene(StrainLaw::corotational, 5e4, 8);
                    },
                    move_fingers, 40, 84, stale);
            })
            ->Iterations(1);
    }
    for (const auto& [law_name, law] : laws)
        for (const auto& [solve_name, solve] : solves)
            for (const std::string how :
                 {"one", "all", "kept", "kept_one", "kept_two"}) {
                const bool keeps = how.starts_with("kept");
                if (keeps &&
                    (solve != LinearSolve::direct || law == StrainLaw::linear))
                    continue;
                benchmark::RegisterBenchmark(
                    (std::string("tets/") + law_name + "/" + solve_name + "/" + how)
                        .c_str(),
                    [law = law, solve = solve,
                     most = how.ends_with("one")   ? 1
                            : how.ends_with("two") ? 2
                                                   : 20,
                     stale = keeps ? 0.5 : 0.0](benchmark::State& state) {
                        tetrahedra(state, law, solve, most, stale);
                    })
                    ->Iterations(1);
            }
    benchmark::RegisterBenchmark("vibrations", few_vibrations)
        ->Arg(5)
        ->Arg(20)
        ->Arg(80)
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
#ifdef RIGID_CALCULIX
    for (const int order : {1, 2})
        benchmark::RegisterBenchmark(
            ("ccx/" + std::to_string(order)).c_str(),
            [order](benchmark::State& state) { beside_calculix(state, order); })
            ->Iterations(1);
#endif
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
