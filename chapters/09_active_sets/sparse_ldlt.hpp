/// \file sparse_ldlt.hpp
/// The active rows of a sparse A as L D Lᵀ, in the pattern of the whole A.
///
///     l_kj = (a_kj − Σ l_ki d_i l_ji) / d_j,   d_k = a_kk − Σ l_kj² d_j       over active rows alone
///
/// (9.8). A row that is not active is stepped over: it has neither entries nor a pivot. In a column or a chain
/// a row has one entry, so a guess costs O(n). \cite davis2006, ch. 4
#pragma once

#include "chapters/09_active_sets/block_principal_pivoting.hpp"
#include "chapters/09_active_sets/elimination.hpp"

namespace rigid {

class SparseLdlt {
    template <class List>
    static auto& at(List& list, int i)
    {
        return list[static_cast<std::size_t>(i)];
    }

public:
    Elimination elimination;

    void analyse_pattern(const Mlcp& mlcp);

    /// Factors the rows that are `between`. Returns false at a pivot that is
    /// nothing: that row depends on others.
    bool factor(const GuessedProblem& problem, const std::vector<BoundState>& cases,
                ActiveSetWork& work);

    /// Solves for the active rows: their entries of x are the right side, then the answer.
    void solve(VecX& x) const;

    void multiply(const Mlcp& mlcp, const VecX& x, VecX& product) const;

    void forget() { factored_.clear(); }

    /// With a proximal term: would the rows have done without it? True if each pivot is far above the term.
    bool is_independent(const GuessedProblem& problem) const
    {
        for (const int k : active_)
            if (!(pivot_[k] > 100 * problem.shift[at(elimination.order, k)]))
                return false;
        return !factored_.empty();
    }

private:
    /// share of A_ii that a pivot must keep
    static constexpr Real rank_tolerance = 1e-11;

    /// of the entries of L, column by column; not filled with zeros: a large part may never be used
    Eigen::VectorXi row_;
    VecX value_;
    std::vector<int> filled_, active_;
    VecX pivot_;
    mutable VecX y_;                    ///< all zero between calls
    std::vector<BoundState> factored_;  ///< the cases that the factor is of
};

}  // namespace rigid
