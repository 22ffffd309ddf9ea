// The functions of first_guess.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/first_guess.hpp"

namespace rigid {

void visit_rows(const GuessedProblem& problem, VecX& lambda)
{
    const Mlcp& mlcp = *problem.mlcp;
    for (Index i = 0; i < mlcp.size(); ++i) {
        Real w = problem.q[i], a = 0;
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            w += entry.value() * lambda[entry.col()];
            if (entry.col() == i) a = entry.value();
        }
        if (problem.shifted) {
            w += problem.shift[i] * lambda[i];
            a += problem.shift[i];
        }
        if (a > 0)
            lambda[i] = std::clamp(lambda[i] - w / a, mlcp.lo[i], mlcp.hi[i]);
    }
}

void cases_of(const Mlcp& mlcp, const VecX& lambda, std::vector<BoundState>& cases)
{
    for (Index i = 0; i < mlcp.size(); ++i)
        cases[static_cast<std::size_t>(i)] =
            lambda[i] <= mlcp.lo[i]   ? BoundState::at_lo
            : lambda[i] >= mlcp.hi[i] ? BoundState::at_hi
                                      : BoundState::between;
}

//! [begin]
void begin(const GuessedProblem& problem, const std::vector<BoundState>& previous,
           bool cheap, Guess& guess)
{
    const Mlcp& mlcp = *problem.mlcp;
    const auto n = static_cast<std::size_t>(mlcp.size());
    const bool known = previous.size() == n;
    guess.cases.resize(n);
    guess.wrong.clear();
    guess.w = problem.q;
    guess.step.resize(mlcp.size());
    // if no guess can be solved, this is what is left: it must be a number
    guess.lambda.setZero(mlcp.size());
    clamp_into_bounds(mlcp, guess.lambda);
    if (!known && !cheap) {
        visit_rows(problem, guess.lambda);
        visit_rows(problem, guess.lambda);
        cases_of(mlcp, guess.lambda, guess.cases);
    }
    for (std::size_t k = 0; k < n; ++k) {
        const auto i = static_cast<Index>(k);
        const BoundState wish = known   ? previous[k]
                                : cheap ? BoundState::between
                                        : guess.cases[k];
        const bool possible =
            (wish != BoundState::at_lo || mlcp.lo[i] > -infinity) &&
            (wish != BoundState::at_hi || mlcp.hi[i] < infinity);
        guess.cases[k] = mlcp.lo[i] == mlcp.hi[i] ? BoundState::at_lo
                         : possible               ? wish
                                                  : BoundState::between;
    }
}
//! [begin]

}  // namespace rigid
