// The functions of friction_cases.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/friction_cases.hpp"

namespace rigid {

void find_wrong(FrictionProblem& problem, Real left, FrictionGuess& guess)
{
    Mlcp& mlcp = *problem.mlcp;
    bound_by(problem.boxes, guess.lambda, mlcp);
    const Real rounding = std::max(10 * left, rounding_of(problem, guess));
    guess.wrong.clear();
    for (Index i = 0; i < mlcp.size(); ++i) {
        const Real residual =
            natural_residual_row(problem.scale.diagonal[i], guess.lambda[i],
                                 guess.w[i], mlcp.lo[i], mlcp.hi[i]);
        if (!(residual <= allowed(problem, rounding, i))) guess.wrong.push_back(i);
    }
}

//! [first_cases]
void first_cases(FrictionProblem& problem, FrictionGuess& guess)
{
    Mlcp& mlcp = *problem.mlcp;
    bound_by(problem.boxes, guess.lambda, mlcp);
    const Real rounding = rounding_of(problem, guess);
    for (Index i = 0; i < mlcp.size(); ++i) {
        BoundState& here = guess.cases[static_cast<std::size_t>(i)];
        const Real a = problem.scale.diagonal[i], w = guess.w[i],
                   above = a * (guess.lambda[i] - mlcp.lo[i]),
                   below = a * (mlcp.hi[i] - guess.lambda[i]),
                   least = 100 * allowed(problem, rounding, i);
        const bool fits = here == BoundState::between ? std::abs(w) <= least
                          : here == BoundState::at_lo
                              ? above <= least && w >= -least
                              : below <= least && w <= least;
        if (!guess.of_last_answer || !fits) here = pointed_at(problem, guess, i);
    }
    guess.of_last_answer = false;
}
//! [first_cases]

//! [flip]
void flip(const FrictionProblem& problem, FrictionGuess& guess)
{
    for (const Index i : guess.wrong)
        if (guess.box_of[static_cast<std::size_t>(i)] < 0)
            guess.cases[static_cast<std::size_t>(i)] =
                pointed_at(problem, guess, i);
    for (std::size_t k = 0; k < problem.boxes.size(); ++k) {
        const FrictionBox& box = problem.boxes[k];
        const auto normal = static_cast<std::size_t>(box.normal);
        const bool opens =
            guess.active[normal] && guess.cases[normal] != BoundState::between;
        if (opens ||
            std::binary_search(guess.wrong.begin(), guess.wrong.end(), box.row))
            guess.cases[static_cast<std::size_t>(box.row)] =
                pointed_at(problem, guess, box.row);
    }
}
//! [flip]

}  // namespace rigid
