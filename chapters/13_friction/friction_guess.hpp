/// \file friction_guess.hpp
/// One guess of the exact friction solver: which rows are active, which slide, the λ that follows, and which rows it shows to be wrong.
///
///     ordinary row  at lo, between, at hi          friction row  slides back (λ_f = −μ λ_n), sticks (w_f = 0), slides on (λ_f = μ λ_n)
///                                                  … and while its normal is open λ_f = 0, whatever its case
///
/// The case of a row is where its natural map points, λ_i − w_i / A_ii (13.9); a row is wrong when its natural residual is
/// not zero. So the rule that corrects a guess is the rule that finds the first one, from any λ: last step's, for example.
#pragma once

#include "chapters/09_active_sets/friction_lu.hpp"
#include "chapters/13_friction/coulomb_residual.hpp"

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
    /// ε of a proximal step (13.25); 0: the problem itself
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
void begin_guesses(FrictionProblem& problem, FrictionGuess& guess, bool same_rows);

/// w = A λ + q, and in a proximal step + ε D (λ − base). A is symmetric, so it is read by columns: one whose λ is zero costs
/// nothing, and most are open or out of reach.
void velocities(const FrictionProblem& problem, FrictionGuess& guess);

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
void arrange(const FrictionProblem& problem, FrictionGuess& guess);

/// λ of the rows that are no unknowns.
void impose(const FrictionProblem& problem, FrictionGuess& guess);

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
Real rounding_of(const FrictionProblem& problem, const FrictionGuess& guess);

/// (13.10): steps with the factor of B + ε D until the active rows have no velocity left that
/// rounding does not explain. Where rows depend on each other, the λ that they start
/// from chooses among the many answers.
/// \return what is left, in the units of the rows
Real solve_guess(const FrictionProblem& problem, FrictionLu& factor,
                 FrictionGuess& guess);

}  // namespace rigid
