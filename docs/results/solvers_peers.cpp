// Other programs' exact solvers on the task "find the impulses of a step".
#include "docs/results/one_step.hpp"

#include "chapters/09_active_sets/benchmark/peers.hpp"
#ifdef RIGID_HAS_BULLET
#include "chapters/04_pgs/benchmark/peers_bullet.hpp"
#endif

#include <chrono>
#include <cstdarg>
#ifdef RIGID_HAS_ODE
extern "C" void dSetMessageHandler(void (*handler)(int number, const char* format, va_list arguments));
#endif

namespace rigid::results {
namespace {

/// What it says of itself is not asked: its answer is held to the residual of this book (3.15).
std::string_view verdict(const peers::FreeFirst& problem, const VecX& lambda)
{
    if (!lambda.allFinite()) return "no answer";
    const VecX mine = lambda(problem.order), w = problem.A * mine + problem.q;
    Real residual = 0;
    for (Index i = 0; i < mine.size(); ++i)
        residual = std::max(
            residual, natural_residual_row(problem.A(i, i), mine[i], w[i], problem.lo[i], problem.hi[i]));
    return residual <= 1e-8 * problem.q.cwiseAbs().maxCoeff() ? "solved" : "wrong answer";
}

/// A peer: from the rows by way of A and its own dense matrix to λ, as for all. What it allocates is left
/// out of its time.
template <class Solve>
void add_peer(Registry& registry, const SharedScene& scene, const std::string& method, const Solve& solve)
{
    add_solver(
        registry, scene, "peer", method, "unit=none", false,
        [=] {
            return [=, assembled = Assembler()](const OneStep& step, std::size_t, Solved& out) mutable {
                const auto start = std::chrono::steady_clock::now();
                const peers::FreeFirst problem(assembled(step));
                const std::chrono::duration<Real> to_matrix = std::chrono::steady_clock::now() - start;
                const peers::Answer answer = solve(problem);
                out.lambda = answer.lambda;
                out.seconds = to_matrix.count() + answer.us * 1e-6;
                out.status = verdict(problem, answer.lambda);
            };
        },
        true);
}

#ifdef RIGID_HAS_BULLET
/// Bullet's sweeps, from its dense matrix: each visit costs n multiplications, whatever is zero.
void add_bullet_sweeps(Registry& registry, const SharedScene& scene, int sweeps)
{
    const std::string parameters = "sweeps=" + std::to_string(sweeps) + " unit=row_visit";
    add_solver(registry, scene, "peer", "bullet_gauss_seidel", parameters, false, [=] {
        return [=, assembled = Assembler()](const OneStep& step, std::size_t, Solved& out) mutable {
            BulletProblem problem(assembled(step));
            problem.solve(sweeps);
            const auto n = static_cast<Index>(step.rows.size());
            out.lambda.resize(n);
            for (Index i = 0; i < n; ++i) out.lambda[i] = problem.x[static_cast<int>(i)];
            out.work = n * sweeps;
            out.sweeps = sweeps;
            out.status = to_string(Status::iteration_limit);
        };
    });
}
#endif

}  // namespace

void add_exact_peers([[maybe_unused]] Registry& registry, [[maybe_unused]] const SharedScene& scene)
{
    peers::single_thread();
#ifdef RIGID_HAS_ODE
    // Where it is lost it says so in a line for each pivot; the table tells it in a word.
    dSetMessageHandler([](int, const char*, va_list) {});
#endif
#ifdef RIGID_HAS_ODE
    add_peer(registry, scene, "ode_dantzig",
             [](const peers::FreeFirst& problem) { return peers::ode(problem); });
#endif
#ifdef RIGID_HAS_BULLET
    for (int sweeps = 1; sweeps <= 4096 && sweeps * scene->rows() * scene->rows() < 40'000'000; sweeps *= 4)
        if (sweeps <= scene->most_sweeps) add_bullet_sweeps(registry, scene, sweeps);
    add_peer(registry, scene, "bullet_dantzig",
             [](const peers::FreeFirst& problem) { return peers::bullet(problem); });
#endif
#ifdef RIGID_HAS_SICONOS
    // A problem without a single bound is not of its kind: its elimination of the free rows leaves an empty one.
    if (!scene->bilateral)
        add_peer(registry, scene, "siconos_lemke",
                 [](const peers::FreeFirst& problem) { return peers::siconos(problem); });
#endif
}

}  // namespace rigid::results
