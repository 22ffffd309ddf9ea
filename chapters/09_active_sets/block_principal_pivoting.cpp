// The functions of block_principal_pivoting.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/block_principal_pivoting.hpp"

namespace rigid {

void set_up(const Mlcp& mlcp, const Acceptance& acceptance, GuessedProblem& problem)
{
    const Index n = mlcp.size();
    problem.mlcp = &mlcp;
    problem.acceptance = acceptance;
    problem.shifted = false;
    problem.q = mlcp.q;
    problem.diagonal.resize(n);
    problem.unit.resize(n);
    Real largest = 0;
    for (Index i = 0; i < n; ++i) {
        const Real a = mlcp.A.coeff(i, i);
        problem.diagonal[i] = a > 0 ? a : 1;
        problem.unit[i] = std::sqrt(problem.diagonal[i]);
        largest = std::max(largest, std::abs(mlcp.q[i]) / problem.unit[i]);
    }
    problem.tolerance = 0.01 * acceptance.tolerance * largest;
    problem.ceiling =
        n > 0 ? 0.01 * acceptance.tolerance * mlcp.q.lpNorm<Eigen::Infinity>() : 0;
    problem.enough = 0.5 * acceptance.enough;
}

Real active_residual(const GuessedProblem& problem, const Guess& guess)
{
    Real largest = 0;
    for (Index i = 0; i < guess.w.size(); ++i)
        if (guess.cases[static_cast<std::size_t>(i)] == BoundState::between &&
            !(std::abs(guess.w[i]) <= largest * problem.unit[i]))
            largest = std::abs(guess.w[i]) / problem.unit[i];
    return largest;
}

void find_wrong(const GuessedProblem& problem, Real hidden, Guess& guess)
{
    const Index n = guess.w.size();
    const Real largest =
        n > 0 ? guess.lambda.cwiseProduct(problem.unit).lpNorm<Eigen::Infinity>()
              : 0;
    const Real rounding =
        std::max(10 * hidden, 4 * std::numeric_limits<Real>::epsilon() * largest);
    guess.wrong.clear();
    for (Index i = 0; i < n; ++i) {
        const BoundState now = guess.cases[static_cast<std::size_t>(i)];
        const Real unit = problem.unit[i];
        const Real tolerance = std::max(
            {rounding * unit, std::min(problem.tolerance * unit, problem.ceiling),
             problem.enough});
        if (corrected(problem, i, now, guess.lambda[i], guess.w[i], tolerance) !=
            now)
            guess.wrong.push_back(i);
    }
}

}  // namespace rigid
