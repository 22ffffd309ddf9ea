/// Chapter 5: what a walk costs, beside other programs' walks and beside sweeps.
///
///     versus/…   ours, Siconos' and Bullet's Lemke in turns on the same problem: the fastest of each, its residual
///     error/…    residual against time: sweeps, and the walk
///     tie/…      how many of 24 friction problems are solved, against the tie tolerance
///     pivots/…   time per pivot against n
///
/// A residual of 1e300 stands for: no answer, or not a number.

#include "chapters/04_pgs/pgs.hpp"
#include "chapters/05_lemke/families.hpp"
#include "chapters/05_lemke/lemke.hpp"
#include "chapters/05_lemke/stewart_trinkle.hpp"

#include <benchmark/benchmark.h>

#ifdef RIGID_HAS_BULLET
#include <BulletDynamics/MLCPSolvers/btLemkeAlgorithm.h>
#endif
#ifdef RIGID_HAS_SICONOS
#include <dlfcn.h>
extern "C" {
#include <LCP_Solvers.h>
#include <LinearComplementarityProblem.h>
#include <NumericsMatrix.h>
#include <SolverOptions.h>
#include <lcp_cst.h>
}
#endif

#include <chrono>
#include <functional>
#include <map>
#include <string>

using namespace rigid;

namespace {

/// The normal rows of a box stack: two contacts for each box, gravity, and small random speeds.
Mlcp contact_column(Index n)
{
    BoxStack stack;
    stack.boxes = n / 2;
    ContactRows scene = contact_rows(stack);
    scene.rows.resize(static_cast<std::size_t>(n));
    return assemble(scene.rows, scene.u_star);
}

Mlcp friction_stack(Index n)
{
    BoxStack stack;
    stack.boxes = n / 8;
    return stewart_trinkle(stack);
}

/// A column of discs at rest, the topmost of 1000 kg.
Mlcp heavy_top(Index n)
{
    MatX A = 2 * MatX::Identity(n, n);
    for (Index i = 0; i + 1 < n; ++i) A(i, i + 1) = A(i + 1, i) = -1;
    A(0, 0) = 1;
    A(n - 1, n - 1) = 1 + 1e-3;
    VecX q = VecX::Zero(n);
    q[0] = -9.81 / 60;
    return plain_lcp(A, q);
}

Mlcp spd(Index n)
{
    Random random(7);
    return random_spd(n, random);
}

using Problems = std::map<std::string, Mlcp (*)(Index)>;
const Problems problems = {{"spd", spd},
                           {"column", contact_column},
                           {"friction", friction_stack},
                           {"heavy_top", heavy_top}};

Real told(const Mlcp& mlcp, const VecX& z)
{
    const Real residual = z.allFinite() ? natural_residual(mlcp, z) : infinity;
    return residual < 1e300 ? residual : 1e300;
}

/// A table needs the same counters in each row.
void no_peers(benchmark::State& state)
{
    for (const char* counter :
         {"lemke_us", "siconos_us", "siconos_residual", "siconos_ratio",
          "bullet_us", "bullet_residual", "bullet_ratio", "ns_per_pivot"})
        state.counters[counter] = 0;
}

using Clock = std::chrono::steady_clock;

/// The fastest run so far [µs].
struct Stopwatch {
    Real fastest = infinity;
    template <class Work>
    void time(const Work& work)
    {
        const auto start = Clock::now();
        work();
        fastest = std::min(
            fastest,
            std::chrono::duration<Real, std::micro>(Clock::now() - start).count());
    }
};

/// Each iteration runs all of them, one after the other: none has the quieter minute. Ours goes from Mlcp to
/// Solution, with all its checks; the peers from their own dense matrix, filled before, to z.
void versus(benchmark::State& state, Mlcp (*problem)(Index))
{
    const Index n = state.range(0);
    const Mlcp mlcp = problem(n);
    const MatX A(mlcp.A);
    Solution solution;
    Stopwatch ours;
    VecX siconos_z = VecX::Constant(n, infinity), bullet_z = siconos_z;
    Stopwatch siconos, bullet;
    (void)siconos;
    (void)bullet;
#ifdef RIGID_HAS_SICONOS
    MatX copy = A;
    VecX q = mlcp.q, z(n), w(n);
    LinearComplementarityProblem lcp;
    lcp.size = static_cast<int>(n);
    lcp.M = NM_create_from_data(NM_DENSE, lcp.size, lcp.size, copy.data());
    lcp.q = q.data();
    SolverOptions* const options = solver_options_create(SICONOS_LCP_LEMKE);
#endif
#ifdef RIGID_HAS_BULLET
    const int size = static_cast<int>(n);
    btMatrixXu M(size, size);
    btVectorXu b(size);
    for (int i = 0; i < size; ++i) {
        b[i] = mlcp.q[i];
        for (int j = 0; j < size; ++j) M.setElem(i, j, A(i, j));
    }
    int rounds = 0;
#endif
    for (auto _ : state) {
        for (int repeat = 0; repeat < 5; ++repeat)
            ours.time([&] { solution = lemke(mlcp); });
#ifdef RIGID_HAS_SICONOS
        siconos.time([&] {
            z.setZero();
            w.setZero();
            int info = 0;
            lcp_lexicolemke(&lcp, z.data(), w.data(), &info, options);
        });
        siconos_z = z;
#endif
#ifdef RIGID_HAS_BULLET
        if (rounds++ > 2) continue;  // it takes its time
        btLemkeAlgorithm algorithm(M, b);
        btVectorXu answer;
        bullet.time(
            [&] { answer = algorithm.solve(static_cast<unsigned>(5 * size)); });
        // its answer is w, then z
        for (int i = 0; i < size; ++i) bullet_z[i] = answer[i + size];
#endif
    }
    no_peers(state);
    state.counters["lemke_us"] = ours.fastest;
    state.counters["residual"] = told(mlcp, solution.lambda);
    state.counters["iterations"] = solution.iterations;
#ifdef RIGID_HAS_SICONOS
    state.counters["siconos_us"] = siconos.fastest;
    state.counters["siconos_residual"] = told(mlcp, siconos_z);
    state.counters["siconos_ratio"] = siconos.fastest / ours.fastest;
    lcp.M->matrix0 = nullptr;  // ours
    NM_clear(lcp.M);
    std::free(lcp.M);
    solver_options_delete(options);
    std::free(options);
#endif
#ifdef RIGID_HAS_BULLET
    state.counters["bullet_us"] = bullet.fastest;
    state.counters["bullet_residual"] = told(mlcp, bullet_z);
    state.counters["bullet_ratio"] = bullet.fastest / ours.fastest;
#endif
}

/// Residual after so many sweeps, or after the walk (0 sweeps).
void error(benchmark::State& state, Mlcp (*problem)(Index))
{
    const Mlcp mlcp = problem(state.range(0));
    PgsSettings settings;
    settings.tolerance = 1e-300;  // never met: each sweep is made
    settings.max_sweeps = static_cast<int>(state.range(1));
    Solution solution;
    for (auto _ : state)
        solution = settings.max_sweeps > 0 ? pgs(mlcp, settings) : lemke(mlcp);
    no_peers(state);
    state.counters["residual"] = told(mlcp, solution.lambda);
    state.counters["iterations"] = solution.iterations;
}

void pivots(benchmark::State& state, Mlcp (*problem)(Index))
{
    const Mlcp mlcp = problem(state.range(0));
    Solution solution;
    for (auto _ : state) solution = lemke(mlcp);
    no_peers(state);
    state.counters["residual"] = told(mlcp, solution.lambda);
    state.counters["iterations"] = solution.iterations;
    state.counters["ns_per_pivot"] = benchmark::Counter(
        solution.iterations * 1e-9, benchmark::Counter::kIsIterationInvariantRate |
                                        benchmark::Counter::kInvert);
}

/// Walks with the tie tolerance 10^-digits on stacks of 5, 10, 20, 40 boxes, jostled a little or much.
void tie(benchmark::State& state)
{
    int solved = 0;
    for (auto _ : state)
        for (const Index boxes : {5, 10, 20, 40})
            for (const Real jostle : {0.01, 1.0})
                for (std::uint64_t seed = 1; seed <= 3; ++seed) {
                    BoxStack stack;
                    stack.boxes = boxes;
                    stack.jostle = jostle;
                    stack.top_mass = 1000;
                    stack.seed = seed;
                    const Mlcp mlcp = stewart_trinkle(stack);
                    LemkeWalk walk(
                        MatX(mlcp.A), mlcp.q, VecX::Ones(mlcp.size()),
                        TieRule::lexicographic,
                        {1e-10, std::pow(10, -static_cast<Real>(state.range(0)))});
                    while (walk.place == LemkeWalk::Place::on_the_way &&
                           walk.pivots < 3000)
                        walk.step();
                    solved += walk.place == LemkeWalk::Place::solution &&
                              told(mlcp, walk.z()) < 1e-6;
                }
    no_peers(state);
    state.counters["residual"] = 0;
    state.counters["iterations"] = solved;
}

void add_all()
{
    const auto name = [](const std::string& group, const std::string& what) {
        return group + "/" + what;
    };
    for (const auto& [what, problem] : problems) {
        auto* const one = benchmark::RegisterBenchmark(name("versus", what).c_str(),
                                                       versus, problem);
        one->Unit(benchmark::kMillisecond)->Iterations(5);
        if (what == "friction") one->Arg(40)->Arg(80)->Arg(160)->Arg(320);
        else one->Arg(30)->Arg(100)->Arg(300);

        auto* const against = benchmark::RegisterBenchmark(
            name("error", what).c_str(), error, problem);
        against->Unit(benchmark::kMicrosecond)->MinTime(0.05);
        const Index n = what == "friction" ? 80 : 100;
        for (const Index sweeps :
             {0, 1, 3, 10, 30, 100, 300, 1000, 3000, 10000, 30000})
            against->Args({n, sweeps});
    }
    for (const auto& [what, problem] : problems) {
        if (what == "heavy_top") continue;
        auto* const one = benchmark::RegisterBenchmark(name("pivots", what).c_str(),
                                                       pivots, problem);
        one->Unit(benchmark::kMicrosecond)->MinTime(0.05);
        for (const Index n : {16, 32, 64, 128, 256}) one->Arg(n);
    }
    auto* const ties = benchmark::RegisterBenchmark("tie", tie);
    ties->Unit(benchmark::kMillisecond)->Iterations(1);
    for (int digits = 2; digits <= 16; ++digits) ties->Arg(digits);
}

/// One thread for all: Siconos calls OpenBLAS, which else takes all processors. (Its environment variable is
/// read when the library is loaded, before main.)
void single_thread()
{
#ifdef RIGID_HAS_SICONOS
    using SetThreads = void (*)(int);
    if (void* const found = dlsym(RTLD_DEFAULT, "openblas_set_num_threads"))
        reinterpret_cast<SetThreads>(found)(1);
#endif
}

}  // namespace

int main(int argc, char** argv)
{
    single_thread();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    add_all();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
