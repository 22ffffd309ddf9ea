/// \file friction_guess.hpp
/// One guess of the exact friction solver: which rows are active, which slide, the λ that follows, and which rows it shows to be wrong.
///
///     ordinary row  at lo, between, at hi          friction row  slides back (λ_f = −μ λ_n), sticks (w_f = 0), slides on (λ_f = μ λ_n)
///                                                  … and while its normal is open λ_f = 0, whatever its case
///
/// The case of a row is where its natural map points, λ_i − w_i / A_ii (13.9); a row is wrong when its natural residual is
/// not zero. So the rule that corrects a guess is the rule that finds the first one, from any λ: last step's, for example.
#pragma once

#include "chapters/13_friction/coulomb_residual.hpp"
#include "chapters/13_friction/friction_lu.hpp"

namespace rigid {

struct FrictionGuess {
    std::int64_t looked = 0;  ///< times at all of A, in this solve
    std::vector<BoundState> cases;
    std::vector<char> active;  ///< 1: λ is an unknown of the linear system
    VecX tie;                  ///< s μ of each box whose row slides, else 0
    VecX base;                 ///< the λ that each guess starts from
    VecX lambda, w, step;
    std::vector<int> box_of;  ///< of each row: the number of its box, −1 = ordinary
    std::vector<Index> wrong;
    /// the cases are those of an answer for these very rows
    bool of_last_answer = false;
};

/// The problem that the guesses see.
struct FrictionProblem {
    Mlcp* mlcp = nullptr;  ///< bounds of friction rows are those of the present λ
    std::span<const FrictionBox> boxes;
    GuessedProblem scale;  ///< diagonal, units and tolerances (chapter 9)
    /// ε of a proximal step (13.11); 0: the problem itself
    Real share = 0;
};

/// Share of the diagonal that makes each factor possible.
inline constexpr Real factor_share = 1e-8;

/// The problem itself, or a proximal step with this ε.
inline void set_share(FrictionProblem& problem, Real share)
{
    problem.share = share;
    problem.scale.shift = std::max(share, factor_share) * problem.scale.diagonal;
}

/// \param same_rows  the cases are still about these rows
inline void begin_guesses(FrictionProblem& problem, FrictionGuess& guess,
                          bool same_rows)
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

/// w = A λ + q, and in a proximal step + ε D (λ − base). A is symmetric, so it is read by columns: one whose λ is zero costs
/// nothing, and most are open or out of reach.
inline void velocities(const FrictionProblem& problem, FrictionGuess& guess)
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

//! [natural_map]
/// (13.9): the case that a row should have, by its λ and w; of a friction row also
/// by what the λ of its normal will be.
inline BoundState pointed_at(const FrictionProblem& problem,
                             const FrictionGuess& guess, Index i)
{
    const Mlcp& mlcp = *problem.mlcp;
    const auto points = [&](Index row) {
        return guess.lambda[row] - guess.w[row] / problem.scale.diagonal[row];
    };
    Real lo = mlcp.lo[i], hi = mlcp.hi[i];
    const int k = guess.box_of[static_cast<std::size_t>(i)];
    if (k >= 0) {
        const FrictionBox& box = problem.boxes[static_cast<std::size_t>(k)];
        hi = box.mu * std::max(Real{0}, points(box.normal));
        lo = -hi;
    }
    const Real there = points(i);
    return there <= lo   ? BoundState::at_lo
           : there >= hi ? BoundState::at_hi
                         : BoundState::between;
}
//! [natural_map]

/// Which rows are unknowns, and which follow another: by the cases.
inline void arrange(const FrictionProblem& problem, FrictionGuess& guess)
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

/// λ of the rows that are no unknowns.
inline void impose(const FrictionProblem& problem, FrictionGuess& guess)
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

/// The residual of a row up to which it is right: what rounding and the tolerance explain [m/s].
/// \param rounding  in the units of the rows
inline Real allowed(const FrictionProblem& problem, Real rounding, Index i)
{
    const GuessedProblem& scale = problem.scale;
    return std::max({rounding * scale.unit[i],
                     std::min(scale.tolerance * scale.unit[i], scale.ceiling),
                     scale.enough});
}

/// What rounding does to w of a λ, in the units of the rows.
inline Real rounding_of(const FrictionProblem& problem, const FrictionGuess& guess)
{
    Real largest = 0;
    for (Index i = 0; i < guess.lambda.size(); ++i)
        largest =
            std::max(largest, std::abs(guess.lambda[i]) * problem.scale.unit[i]);
    return 8 * std::numeric_limits<Real>::epsilon() * largest;
}

//! [solve]
/// (13.10): steps with the factor of B + ε D until the active rows have no velocity left that
/// rounding does not explain. Where rows depend on each other, the λ that they start
/// from chooses among the many answers.
/// \return what is left, in the units of the rows
inline Real solve_guess(const FrictionProblem& problem, FrictionLu& factor,
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
