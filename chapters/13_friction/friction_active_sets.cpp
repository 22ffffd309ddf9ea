// The functions of friction_active_sets.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/friction_active_sets.hpp"

namespace rigid {

//! [proximal]
bool proximal_friction(FrictionMemory& memory, const FrictionSettings& settings,
                       Solution& solution)
{
    FrictionProblem& problem = memory.problem;
    const Acceptance acceptance{settings.tolerance, settings.enough};
    Real share = 0.1, last = infinity, least = infinity;
    memory.proximal_base = solution.lambda;
    bool settled = false;
    int idle = 0;
    const auto is_stuck = [&] {
        return settings.idle_steps > 0 && idle >= settings.idle_steps;
    };
    for (int step = 0; step < settings.proximal_steps && !settled && !is_stuck() &&
                       !is_spent(memory, settings);
         ++step, ++idle) {
        ++memory.work.proximal_steps;
        set_share(problem, share);
        memory.factor.forget();
        memory.guess.lambda = memory.proximal_base;
        if (!correct_friction(memory, settings)) {
            share = std::min(Real{100}, 8 * share);
            continue;
        }
        memory.candidate = memory.guess.lambda;
        Solution here;
        settled = accept_coulomb(*problem.mlcp, problem.boxes, acceptance,
                                 memory.candidate, here);
        if (settled || here.residual < solution.residual) solution = here;
        memory.proximal_base = memory.candidate;
        if (here.residual < 0.99 * least) least = here.residual, idle = -1;
        // too slow: a smaller term is gone sooner
        if (!(here.residual < 0.5 * last)) share = std::max(1e-9, 0.5 * share);
        last = here.residual;
    }
    set_share(problem, 0);
    memory.factor.forget();
    return settled;
}
//! [proximal]

bool last_resorts(FrictionMemory& memory, const FrictionSettings& settings,
                  Solution& solution)
{
    Mlcp& mlcp = *memory.problem.mlcp;
    const std::span<const FrictionBox> boxes = memory.problem.boxes;
    const Acceptance acceptance{settings.tolerance, settings.enough};
    const auto take = [&](const Solution& found) {
        memory.candidate = found.lambda;
        if (accept_coulomb(mlcp, boxes, acceptance, memory.candidate, solution))
            return true;
        memory.guess.lambda = memory.candidate;  // nearly right: guess from there
        return guess_friction(memory, settings, solution);
    };
    const auto affords = [&](Index up_to, std::int64_t price) {
        if (mlcp.size() > up_to || is_spent(memory, settings, price)) return false;
        memory.work.entries += price;
        return true;
    };
    const std::int64_t cube = mlcp.size() * mlcp.size() * mlcp.size();
    if (affords(settings.most_rows_of_rounds, cube / 8)) {
        ++memory.work.rounds;
        ActiveSetSettings of_rounds;
        of_rounds.tolerance = settings.tolerance;
        of_rounds.enough = settings.enough;
        Solution found;
        bound_by(boxes, VecX::Zero(mlcp.size()), mlcp);
        active_sets(mlcp, boxes, of_rounds, memory.rounds, found);
        if (take(found)) return true;
    }
    if (affords(settings.most_rows_of_walks, cube)) {
        ++memory.work.walks;
        LemkeSettings of_walks;  // one that ends has up to four pivots a row
        of_walks.pivot_limit =
            20 * static_cast<int>(mlcp.size() + 2 * std::ssize(boxes));
        if (take(stewart_trinkle_by_lemke(mlcp, boxes, of_walks))) return true;
    }
    return false;
}

//! [retreat]
void retreat(FrictionMemory& memory, const FrictionSettings& settings,
             Solution& solution)
{
    FrictionProblem& problem = memory.problem;
    FrictionGuess& guess = memory.guess;
    const auto accept = [&] {
        return accept_coulomb(*problem.mlcp, problem.boxes,
                              {settings.tolerance, settings.enough},
                              memory.candidate, solution);
    };
    problem.scale.enough = 0.5 * settings.enough;
    memory.candidate = solution.lambda;  // the best may be enough now
    if (settings.late > 0 && accept()) return;
    for (int time = 0, sweeps = 10; time < settings.retreats; ++time, sweeps *= 3) {
        if (is_spent(memory, settings)) return;
        guess.lambda = solution.lambda;  // the best so far
        sweep_friction(problem, sweeps, guess.box_of, guess.lambda);
        memory.work.sweeps += sweeps;
        guess.looked += sweeps;
        memory.candidate = guess.lambda;
        if (accept() || guess_friction(memory, settings, solution) ||
            proximal_friction(memory, settings, solution))
            return;
    }
    last_resorts(memory, settings, solution);
}
//! [retreat]

}  // namespace rigid
