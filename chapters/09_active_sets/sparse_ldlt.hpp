/// \file sparse_ldlt.hpp
/// The active rows of a sparse A as L D Lᵀ, in the pattern of the whole A.
///
///     l_kj = (a_kj − Σ l_ki d_i l_ji) / d_j,   d_k = a_kk − Σ l_kj² d_j       over active rows alone
///
/// (9.9). A row that is not active is stepped over: it has neither entries nor a pivot. In a column or a chain
/// a row has one entry, so a guess costs O(n). \cite davis2006, ch. 4
#pragma once

#include "chapters/09_active_sets/elimination.hpp"
#include "chapters/09_active_sets/guess.hpp"

namespace rigid {

class SparseLdlt {
    template <class List>
    static auto& at(List& list, int i)
    {
        return list[static_cast<std::size_t>(i)];
    }

public:
    Elimination elimination;

    void look(const Mlcp& mlcp)
    {
        elimination.look(mlcp.A);
        const Index n = mlcp.size();
        row_.resize(static_cast<std::size_t>(elimination.entries()));
        value_.resize(row_.size());
        filled_.resize(static_cast<std::size_t>(n));
        pivot_.resize(n);
        y_.setZero(n);
        factored_.clear();
    }

    //! [factor]
    /// Factors the rows that are `between`. Returns false at a pivot that is nothing: that row depends on
    /// others.
    bool factor(const GuessedProblem& problem, const std::vector<RowCase>& cases, ActiveSetWork& work)
    {
        if (factored_ == cases) return true;
        factored_.clear();
        ++work.factorisations;
        const Elimination& e = elimination;
        const auto n = static_cast<int>(cases.size());
        const Real* const A = problem.mlcp->A.valuePtr();
        const bool shifted = problem.shift.size() > 0;
        work.entries = 0;
        active_.clear();
        for (int k = 0; k < n; ++k) {
            const int i = at(e.order, k);
            at(filled_, k) = at(e.column_begin, k);
            pivot_[k] = 0;  // zero = not active
            if (at(cases, i) != RowCase::between) continue;
            for (int p = at(e.lower_begin, k); p < at(e.lower_begin, k + 1); ++p)
                y_[at(e.lower_column, p)] = A[at(e.lower_value, p)];
            const int place = at(e.diagonal_value, k);
            Real d = (place < 0 ? 0 : A[place]) + (shifted ? problem.shift[i] : 0);
            const Real nothing = shifted ? 0.01 * problem.shift[i] : rank_tolerance * problem.diagonal[i];
            for (int p = at(e.row_begin, k); p < at(e.row_begin, k + 1); ++p) {  // (9.9)
                const int j = at(e.row_columns, p);
                const Real y = y_[j];
                y_[j] = 0;
                if (y == 0 || pivot_[j] == 0) continue;
                const int begin = at(e.column_begin, j), end = at(filled_, j);
                for (int r = begin; r < end; ++r) y_[at(row_, r)] -= at(value_, r) * y;
                const Real l = y / pivot_[j];
                d -= l * y;
                at(row_, end) = k;
                at(value_, end) = l;
                at(filled_, j) = end + 1;
                ++work.entries;
            }
            if (!(d > nothing)) return false;
            pivot_[k] = d;
            active_.push_back(k);
        }
        factored_ = cases;
        return true;
    }
    //! [factor]

    /// Solves for the active rows: their entries of x are the right side, then the answer.
    void solve(VecX& x) const
    {
        const Elimination& e = elimination;
        for (const int k : active_) y_[k] = x[at(e.order, k)];
        for (const int j : active_) {
            const Real y = y_[j];
            for (int r = at(e.column_begin, j); r < at(filled_, j); ++r) y_[at(row_, r)] -= at(value_, r) * y;
        }
        for (auto place = active_.rbegin(); place != active_.rend(); ++place) {
            const int j = *place;
            Real y = y_[j] / pivot_[j];
            for (int r = at(e.column_begin, j); r < at(filled_, j); ++r) y -= at(value_, r) * y_[at(row_, r)];
            y_[j] = y;
        }
        for (const int k : active_) {
            x[at(e.order, k)] = y_[k];
            y_[k] = 0;
        }
    }

    void multiply(const Mlcp& mlcp, const VecX& x, VecX& product) const
    {
        const int* const outer = mlcp.A.outerIndexPtr();
        const int* const inner = mlcp.A.innerIndexPtr();
        const Real* const A = mlcp.A.valuePtr();
        product.resize(x.size());
        for (Index i = 0; i < x.size(); ++i) {
            Real sum = 0;
            for (int p = outer[i]; p < outer[i + 1]; ++p) sum += A[p] * x[inner[p]];
            product[i] = sum;
        }
    }

    void forget() { factored_.clear(); }

private:
    static constexpr Real rank_tolerance = 1e-11;  ///< share of A_ii that a pivot must keep

    std::vector<int> row_, filled_, active_;  ///< of the entries of L, column by column
    std::vector<Real> value_;
    VecX pivot_;
    mutable VecX y_;                ///< all zero between calls
    std::vector<RowCase> factored_;  ///< the cases that the factor is of
};

}  // namespace rigid
