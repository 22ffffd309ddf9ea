/// \file bounded_rows.hpp
/// Rows with bounds above joints that are solved at once: the joints are eliminated, and what is left is a small Coulomb
/// problem, solved exactly.
///
///     w = A λ + q,   A = J_B M_J⁻¹ J_Bᵀ + Γ_B,   q = J_B û + b,   M_J⁻¹ = M⁻¹ − M⁻¹Jᵀ (J M⁻¹Jᵀ + Γ)⁻¹ J M⁻¹
///
/// (15.10). J_B are the rows with bounds, M_J⁻¹ is the inverse mass of the bodies as their joints hold them, û what the
/// joints alone make of u*. A column of A is one impulse and one solve of the tree; what is at a bound, chapter 13 finds.
#pragma once

#include "chapters/15_trees/bounded_problem.hpp"

#include <deque>

namespace rigid {

class BoundedRows {
public:
    BoundedIslands islands;
    int columns = 0;           ///< of A, computed in the last eliminate()
    int unsolved = 0;          ///< islands without an answer, of the last solve()
    int guesses = 0;           ///< of all islands, in the last solve()
    int swept = 0;             ///< islands that were too large for guesses
    int sweeps_made = 0;       ///< over the one that needed most of them
    std::int64_t entries = 0;  ///< that guesses looked at

    /// A of an island.
    const SparseMatrix& matrix(int island) const
    {
        return problems_[at(island)].mlcp.A;
    }

    /// The next guesses begin from λ alone: cases and factors of earlier solves are
    /// nothing to them.
    void forget()
    {
        for (std::size_t k = 0; k < used_; ++k) problems_[k].find.memory.forget();
        used_ = 0;
    }

    /// A of each island.
    /// \param known  the same of these joints, perhaps of more rows: what it has is not
    ///               computed again; nullptr = nothing
    void eliminate(JointFactor& joints, const std::vector<Row<3>>& rows,
                   const std::vector<char>& left_out, Index bodies,
                   const BoundedRows* known = nullptr);

    /// λ of the rows with bounds.
    /// \param u       û, what the joints alone make of u* [m/s]
    /// \param b       of all rows
    /// \param lambda  in: where the guesses begin; out: the answer, where there is
    ///                one, else the best that was found
    /// \param most    rows that an island may have to be guessed
    /// \param sweeps  over those of a larger one
    /// \param enough  a residual below this is none [m/s]
    void solve(const std::vector<Row<3>>& rows, const VecX& u, const VecX& b,
               const FrictionSettings& settings, int most, int sweeps, Real enough,
               VecX& lambda);

private:
    template <class Number>
    static std::size_t at(Number i)
    {
        return static_cast<std::size_t>(i);
    }

    void eliminate(int k, JointFactor& joints, const std::vector<Row<3>>& rows,
                   Mlcp& mlcp);
    bool has(const std::vector<int>& some) const;
    void take_part(const BoundedRows& known, int k, Mlcp& mlcp) const;

    void clear(int place, const JointFactor& joints);

    std::deque<BoundedProblem> problems_;  ///< grows without copying their memory
    std::size_t used_ =
        0;  ///< of these, since forget(): what sleeps has had others
    std::vector<int> next_;
    VecX u_;  ///< zero between calls

    /// part of J M⁻¹ Jᵀ that joints must leave of a row, or it is held
    static constexpr Real rank_tolerance = 1e-11;
};

}  // namespace rigid
