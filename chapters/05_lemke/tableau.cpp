// The functions of tableau.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/05_lemke/tableau.hpp"

namespace rigid {

Tableau::Tableau(const MatX& A, const VecX& q, const VecX& d,
                 const Tolerances& nothing)
    : tolerances(nothing), n(q.size()), basic(size(n)), nonbasic(size(n + 1)),
      place(size(2 * n + 1)), T_(whole_lines(n), n + 2),
      U_(T_.rows(), std::max<Index>(n, 8)), applied_(size(n + 2), 0)
{
    T_.bottomRows(T_.rows() - n).setZero();
    T_.topLeftCorner(n, n) = A;
    T_.col(n).head(n) = d;
    T_.col(n + 1).head(n) = q;
    for (Index i = 0; i < n; ++i) {
        put_row(i, n + i);
        put_column(i, i);
    }
    put_column(n, artificial());
}

//! [pivot]
void Tableau::pivot(Index p, Index c)
{
    if (pivots_.size() == size(U_.cols())) forget();
    bring_up_to_date(c);
    auto u = U_.col(static_cast<Index>(pivots_.size()));
    u = T_.col(c);
    u[p] = 0;
    const Real inverse = -1 / T_(p, c);
    // the column of the variable that leaves: it was a unit vector
    T_.col(c).setZero();
    T_(p, c) = -1;
    Index first = 0, last = n;  // only rows first … last-1 can change
    while (first < last && u[first] == 0) ++first;
    while (last > first && u[last - 1] == 0) --last;
    first -= first % line;
    pivots_.push_back({p, inverse, first, whole_lines(last - first)});
    const Index leaving = basic[size(p)];
    put_row(p, nonbasic[size(c)]);
    put_column(c, leaving);
}

void Tableau::bring_up_to_date(Index j) const
{
    for (std::size_t& k = applied_[size(j)]; k < pivots_.size(); ++k) {
        const PastPivot& past = pivots_[k];
        const Real multiplier = past.inverse * T_(past.row, j);
        if (multiplier == 0) continue;  // a multiplier of zero changes nothing
        T_.col(j).segment(past.first, past.count) +=
            multiplier *
            U_.col(static_cast<Index>(k)).segment(past.first, past.count);
        T_(past.row, j) = multiplier;
        ++column_updates;
    }
}
//! [pivot]

}  // namespace rigid
