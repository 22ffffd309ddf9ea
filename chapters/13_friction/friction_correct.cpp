// The functions of friction_correct.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/friction_correct.hpp"

namespace rigid {

void require_valid(const FrictionSettings& settings)
{
    if (!(settings.tolerance > 0) || !(settings.enough >= 0) ||
        !std::isfinite(settings.enough) || !(settings.late >= 0) ||
        !std::isfinite(settings.late) || settings.most_entries < 0 ||
        settings.pair_entries < 0 || settings.patience < 0 ||
        settings.retreats < 0 || settings.proximal_steps < 0 ||
        settings.idle_steps < 0)
        throw std::invalid_argument(
            "tolerance " + shortest(settings.tolerance) + ", enough " +
            shortest(settings.enough) + ", late " + shortest(settings.late) +
            ", entries " + std::to_string(settings.most_entries) +
            ", of a pair of rows " + std::to_string(settings.pair_entries) +
            ", patience " + std::to_string(settings.patience) + ", retreats " +
            std::to_string(settings.retreats) + ", proximal steps " +
            std::to_string(settings.proximal_steps) + ", idle ones " +
            std::to_string(settings.idle_steps) +
            ": the tolerance must be positive, the others not negative");
    require_share(settings.tolerance);
}

void require_pushing(const Mlcp& mlcp, std::span<const FrictionBox> boxes)
{
    for (const FrictionBox& box : boxes)
        if (!(mlcp.lo[box.normal] >= 0))
            throw std::invalid_argument(
                "row " + std::to_string(box.normal) + ", which bounds row " +
                std::to_string(box.row) +
                ", has lo = " + shortest(mlcp.lo[box.normal]) +
                "; a row that bounds friction only pushes (lo at least 0)");
}

std::pair<Real, Real> present_bounds(const FrictionProblem& problem,
                                     const std::vector<int>& box_of, Index i,
                                     const VecX& lambda)
{
    const int k = box_of[static_cast<std::size_t>(i)];
    if (k < 0) return {problem.mlcp->lo[i], problem.mlcp->hi[i]};
    const FrictionBox& box = problem.boxes[static_cast<std::size_t>(k)];
    const Real most = box.mu * std::max(Real{0}, lambda[box.normal]);
    return {-most, most};
}

//! [sweep]
void sweep_friction(const FrictionProblem& problem, int sweeps,
                    const std::vector<int>& box_of, VecX& lambda)
{
    const Mlcp& mlcp = *problem.mlcp;
    for (; sweeps > 0; --sweeps)
        for (Index i = 0; i < mlcp.size(); ++i) {
            Real w = mlcp.q[i], a = 0;
            for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
                w += entry.value() * lambda[entry.col()];
                if (entry.col() == i) a = entry.value();
            }
            const auto [lo, hi] = present_bounds(problem, box_of, i, lambda);
            if (a > 0) lambda[i] = std::clamp(lambda[i] - w / a, lo, hi);
        }
}
//! [sweep]

//! [sweep_changes]
int sweep_changes(const FrictionProblem& problem, int sweeps, Real small,
                  FrictionGuess& guess)
{
    const Mlcp& mlcp = *problem.mlcp;
    guess.step = mlcp.A.diagonal();
    guess.w.resize(mlcp.size());
    velocities(problem, guess);
    int made = 0;
    for (bool changed = true; made < sweeps && changed; ++made) {
        changed = false;
        for (Index i = 0; i < mlcp.size(); ++i) {
            const Real a = guess.step[i];
            if (!(a > 0)) continue;
            const auto [lo, hi] =
                present_bounds(problem, guess.box_of, i, guess.lambda);
            const Real here = guess.lambda[i],
                       next = std::clamp(here - guess.w[i] / a, lo, hi);
            if (next == here) continue;
            changed = changed || std::abs(next - here) * a > small;
            guess.lambda[i] = next;
            for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
                guess.w[entry.col()] += entry.value() * (next - here);
        }
    }
    return made;
}
//! [sweep_changes]

//! [guesses]
bool correct_friction(FrictionMemory& memory, const FrictionSettings& settings)
{
    FrictionProblem& problem = memory.problem;
    FrictionGuess& guess = memory.guess;
    guess.base = guess.lambda;
    velocities(problem, guess);
    first_cases(problem, guess);
    std::size_t fewest = guess.cases.size() + 1;
    for (int chances = settings.patience; chances >= 0;) {
        if (is_spent(memory, settings)) return false;
        ++memory.work.guesses;
        // a guess that was wrong leaves nothing behind but its cases
        guess.lambda = guess.base;
        arrange(problem, guess);
        memory.factor.factor(guess.active, guess.tie, problem.scale.shift);
        const Real left = solve_guess(problem, memory.factor, guess);
        if (!guess.lambda.allFinite()) return false;
        find_wrong(problem, left, guess);
        if (guess.wrong.empty()) return true;
        if (guess.wrong.size() < fewest) {
            fewest = guess.wrong.size();
            chances = settings.patience;
        } else --chances;
        memory.work.flips += static_cast<int>(guess.wrong.size());
        flip(problem, guess);
    }
    return false;
}

bool guess_friction(FrictionMemory& memory, const FrictionSettings& settings,
                    Solution& solution)
{
    if (!correct_friction(memory, settings)) return false;
    memory.candidate = memory.guess.lambda;
    return accept_coulomb(*memory.problem.mlcp, memory.problem.boxes,
                          {settings.tolerance, settings.enough}, memory.candidate,
                          solution);
}
//! [guesses]

}  // namespace rigid
