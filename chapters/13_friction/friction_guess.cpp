// The functions of friction_guess.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/friction_guess.hpp"

namespace rigid {

void begin_guesses(FrictionProblem& problem, FrictionGuess& guess, bool same_rows)
{
    const auto n = static_cast<std::size_t>(problem.mlcp->size());
    guess.of_last_answer = same_rows && guess.cases.size() == n;
    if (!guess.of_last_answer) guess.cases.assign(n, BoundState::at_lo);
    guess.active.assign(n, 0);
    guess.box_of.assign(n, -1);
    for (std::size_t k = 0; k < problem.boxes.size(); ++k)
        guess.box_of[static_cast<std::size_t>(problem.boxes[k].row)] =
            static_cast<int>(k);
    guess.tie.setZero(static_cast<Index>(problem.boxes.size()));
}

void velocities(const FrictionProblem& problem, FrictionGuess& guess)
{
    const Mlcp& mlcp = *problem.mlcp;
    ++guess.looked;
    guess.w = mlcp.q;
    for (Index j = 0; j < mlcp.size(); ++j) {
        const Real here = guess.lambda[j];
        if (here == 0) continue;
        for (SparseMatrix::InnerIterator a(mlcp.A, j); a; ++a)
            guess.w[a.col()] += a.value() * here;
    }
    if (problem.share > 0)
        guess.w.array() +=
            problem.scale.shift.array() * (guess.lambda - guess.base).array();
}

void arrange(const FrictionProblem& problem, FrictionGuess& guess)
{
    const auto n = guess.cases.size();
    const auto moves = [&](std::size_t i) {
        return problem.mlcp->A.coeff(static_cast<Index>(i), static_cast<Index>(i)) >
               0;
    };
    for (std::size_t i = 0; i < n; ++i)
        guess.active[i] = guess.box_of[i] < 0 &&
                          guess.cases[i] == BoundState::between && moves(i);
    for (std::size_t k = 0; k < problem.boxes.size(); ++k) {
        const FrictionBox& box = problem.boxes[k];
        const auto i = static_cast<std::size_t>(box.row);
        const bool pressed = guess.active[static_cast<std::size_t>(box.normal)];
        const BoundState here = guess.cases[i];
        guess.active[i] =
            pressed && here == BoundState::between && box.mu > 0 && moves(i);
        guess.tie[static_cast<Index>(k)] = !pressed || here == BoundState::between
                                               ? 0
                                           : here == BoundState::at_lo ? -box.mu
                                                                       : box.mu;
    }
}

void impose(const FrictionProblem& problem, FrictionGuess& guess)
{
    const Mlcp& mlcp = *problem.mlcp;
    for (Index i = 0; i < mlcp.size(); ++i) {
        const auto row = static_cast<std::size_t>(i);
        if (guess.active[row] || guess.box_of[row] >= 0) continue;
        const Real bound =
            guess.cases[row] == BoundState::at_hi ? mlcp.hi[i] : mlcp.lo[i];
        guess.lambda[i] = std::isfinite(bound) ? bound : 0;
    }
    for (std::size_t k = 0; k < problem.boxes.size(); ++k) {
        const FrictionBox& box = problem.boxes[k];
        if (guess.active[static_cast<std::size_t>(box.row)]) continue;
        const Real fixed = guess.lambda[box.normal];
        const auto normal = static_cast<std::size_t>(box.normal);
        // a normal that is at a bound of its own still bounds its friction
        const Real sign =
            guess.cases[static_cast<std::size_t>(box.row)] == BoundState::at_lo ? -1
                                                                                : 1;
        guess.lambda[box.row] = guess.active[normal]
                                    ? guess.tie[static_cast<Index>(k)] * fixed
                                    : sign * box.mu * std::max(Real{0}, fixed);
    }
}

Real rounding_of(const FrictionProblem& problem, const FrictionGuess& guess)
{
    Real largest = 0;
    for (Index i = 0; i < guess.lambda.size(); ++i)
        largest =
            std::max(largest, std::abs(guess.lambda[i]) * problem.scale.unit[i]);
    return 8 * std::numeric_limits<Real>::epsilon() * largest;
}

//! [solve]
Real solve_guess(const FrictionProblem& problem, FrictionLu& factor,
                 FrictionGuess& guess)
{
    const Mlcp& mlcp = *problem.mlcp;
    impose(problem, guess);
    velocities(problem, guess);
    Real last = infinity;
    for (int round = 0; round < 12; ++round) {
        Real left = 0, largest = 0;
        bool right = true;
        for (Index i = 0; i < mlcp.size(); ++i) {
            const Real unit = problem.scale.unit[i];
            largest = std::max({largest, std::abs(guess.lambda[i]) * unit,
                                std::abs(mlcp.q[i]) / unit});
            const bool active = guess.active[static_cast<std::size_t>(i)];
            guess.step[i] = active ? -guess.w[i] : 0;
            if (!active) continue;
            left = std::max(left, std::abs(guess.w[i]) / unit);
            right = right && std::abs(guess.w[i]) <= allowed(problem, 0, i);
        }
        if (left <= 4 * std::numeric_limits<Real>::epsilon() * largest) return left;
        const bool old = factor.is_old();
        if (!(left < (old ? 0.1 : 0.9) * last)) {
            if (!old || right) return left;
            // the factor of the step before does not do: begin again
            factor.factor(guess.active, guess.tie, problem.scale.shift, true);
            guess.lambda = guess.base;
            impose(problem, guess);
            velocities(problem, guess);
            last = infinity;
            continue;
        }
        last = left;
        factor.solve(guess.step);
        guess.lambda += guess.step;
        impose(problem, guess);
        velocities(problem, guess);
    }
    return last;
}
//! [solve]

}  // namespace rigid
