// Other programs' exact solvers on the task "find the impulses of a step".
#include "docs/results/one_step.hpp"

#include "chapters/09_active_sets/peers.hpp"

namespace rigid::results {
namespace {

/// A peer: from its own dense matrix, filled before, to λ; timed by itself.
template <class Solve>
void add_peer(Registry& registry, const SharedScene& scene, const std::string& method, const Solve& solve)
{
    const auto problems = std::make_shared<std::vector<peers::FreeFirst>>();
    add_solver(
        registry, scene, "peer", method, "unit=none", false,
        [=] {
            problems->clear();
            for (const OneStep& step : scene->steps) problems->emplace_back(assemble(step.rows, step.u_star));
            return [=](const OneStep&, std::size_t k, Solved& out) {
                const peers::Answer answer = solve((*problems)[k]);
                out.lambda = answer.lambda;
                out.seconds = answer.us * 1e-6;
                out.status = answer.lambda.allFinite() ? Status::solved : Status::singular;
            };
        },
        true);
}

}  // namespace

void add_exact_peers([[maybe_unused]] Registry& registry, [[maybe_unused]] const SharedScene& scene)
{
#ifdef RIGID_HAS_ODE
    add_peer(registry, scene, "ode_dantzig",
             [](const peers::FreeFirst& problem) { return peers::ode(problem); });
#endif
#ifdef RIGID_HAS_BULLET
    add_peer(registry, scene, "bullet_dantzig",
             [](const peers::FreeFirst& problem) { return peers::bullet(problem); });
#endif
#ifdef RIGID_HAS_SICONOS
    add_peer(registry, scene, "siconos_lemke",
             [](const peers::FreeFirst& problem) { return peers::siconos(problem); });
#endif
}

}  // namespace rigid::results
