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

    void analyse_pattern(const Mlcp& mlcp)
    {
        elimination.analyse_pattern(mlcp.A);
        const Index n = mlcp.size();
        row_.resize(static_cast<std::size_t>(elimination.entries()));
        value_.resize(row_.size());
        filled_.resize(static_cast<std::size_t>(n));
        pivot_.resize(n);
        y_.setZero(n);
        factored_.clear();
    }

    //! [factor]
    /// Factors the rows that are `between`. Returns false at a pivot that is
    /// nothing: that row depends on others.
    bool factor(const GuessedProblem& problem, const std::vector<BoundState>& cases,
                ActiveSetWork& work)
    {
        if (factored_ == cases) return true;
        factored_.clear();
        ++work.factorisations;
        const Elimination& e = elimination;
        const auto n = static_cast<int>(cases.size());
        const Real* const A = problem.mlcp->A.valuePtr();
        const bool shifted = problem.shifted;
        const int* const begin = e.column_begin.data();
        int* const end = filled_.data();
        int* const row = row_.data();
        Real* const value = value_.data();
        Real* const y = y_.data();
        Real* const pivot = pivot_.data();
        active_.clear();
        for (int k = 0; k < n; ++k) {
            const int i = at(e.order, k);
            end[k] = begin[k];
            pivot[k] = 0;  // zero = not active
            if (at(cases, i) != BoundState::between) continue;
            for (int p = at(e.lower_begin, k); p < at(e.lower_begin, k + 1); ++p)
                y[at(e.lower_column, p)] = A[at(e.lower_value, p)];
            const int place = at(e.diagonal_value, k);
            Real d = (place < 0 ? 0 : A[place]) + (shifted ? problem.shift[i] : 0);
            const Real nothing = shifted ? 0.01 * problem.shift[i]
                                         : rank_tolerance * problem.diagonal[i];
            // (9.8)
            for (int p = at(e.row_begin, k); p < at(e.row_begin, k + 1); ++p) {
                const int j = at(e.row_columns, p);
                const Real y_j = y[j];
                y[j] = 0;
                if (y_j == 0 || pivot[j] == 0) continue;
                const int last = end[j];
                for (int r = begin[j]; r < last; ++r) y[row[r]] -= value[r] * y_j;
                const Real l = y_j / pivot[j];
                d -= l * y_j;
                row[last] = k;
                value[last] = l;
                end[j] = last + 1;
            }
            if (!(d > nothing)) return false;
            pivot[k] = d;
            active_.push_back(k);
        }
        work.entries = 0;
        for (const int j : active_) work.entries += end[j] - begin[j];
        factored_ = cases;
        return true;
    }
    //! [factor]

    /// Solves for the active rows: their entries of x are the right side, then the answer.
    void solve(VecX& x) const
    {
        const Elimination& e = elimination;
        const int* const begin = e.column_begin.data();
        const int* const end = filled_.data();
        const int* const row = row_.data();
        const Real* const value = value_.data();
        Real* const y = y_.data();
        for (const int k : active_) y[k] = x[at(e.order, k)];
        for (const int j : active_)
            for (int r = begin[j]; r < end[j]; ++r) y[row[r]] -= value[r] * y[j];
        for (auto place = active_.rbegin(); place != active_.rend(); ++place) {
            const int j = *place;
            Real sum = y[j] / pivot_[j];
            for (int r = begin[j]; r < end[j]; ++r) sum -= value[r] * y[row[r]];
            y[j] = sum;
        }
        for (const int k : active_) {
            x[at(e.order, k)] = y[k];
            y[k] = 0;
        }
    }

    void multiply(const Mlcp& mlcp, const VecX& x, VecX& product) const
    {
        const int* const outer = mlcp.A.outerIndexPtr();
        const int* const inner = mlcp.A.innerIndexPtr();
        const Real* const A = mlcp.A.valuePtr();
        const Real* const known = x.data();
        product.resize(x.size());
        for (Index i = 0; i < x.size(); ++i) {
            Real sum = 0;
            for (int p = outer[i]; p < outer[i + 1]; ++p)
                sum += A[p] * known[inner[p]];
            product[i] = sum;
        }
    }

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

    /// of the entries of L, column by column
    std::vector<int> row_, filled_, active_;
    std::vector<Real> value_;
    VecX pivot_;
    mutable VecX y_;                    ///< all zero between calls
    std::vector<BoundState> factored_;  ///< the cases that the factor is of
};

}  // namespace rigid
