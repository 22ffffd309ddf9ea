// The functions of sparse_ldlt.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/sparse_ldlt.hpp"

namespace rigid {

void SparseLdlt::analyse_pattern(const Mlcp& mlcp)
{
    elimination.analyse_pattern(mlcp.A);
    const Index n = mlcp.size();
    row_.resize(elimination.entries());
    value_.resize(row_.size());
    filled_.resize(static_cast<std::size_t>(n));
    pivot_.resize(n);
    y_.setZero(n);
    factored_.clear();
}

//! [factor]
bool SparseLdlt::factor(const GuessedProblem& problem,
                        const std::vector<BoundState>& cases, ActiveSetWork& work)
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

void SparseLdlt::solve(VecX& x) const
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

void SparseLdlt::multiply(const Mlcp& mlcp, const VecX& x, VecX& product) const
{
    const int* const outer = mlcp.A.outerIndexPtr();
    const int* const inner = mlcp.A.innerIndexPtr();
    const Real* const A = mlcp.A.valuePtr();
    const Real* const known = x.data();
    product.resize(x.size());
    for (Index i = 0; i < x.size(); ++i) {
        Real sum = 0;
        for (int p = outer[i]; p < outer[i + 1]; ++p) sum += A[p] * known[inner[p]];
        product[i] = sum;
    }
}

}  // namespace rigid
