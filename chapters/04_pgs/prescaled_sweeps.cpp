// The functions of prescaled_sweeps.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/04_pgs/prescaled_sweeps.hpp"

namespace rigid {

void prepare(const Mlcp& mlcp, Real omega, std::span<const int> order,
             SweepRows& sweep)
{
    if (!(omega > 0 && omega < 2))
        throw std::invalid_argument("the relaxation omega is " + shortest(omega) +
                                    "; it must lie between 0 and 2");
    const auto n = static_cast<std::size_t>(mlcp.size());
    if (!order.empty() && order.size() != n)
        throw std::invalid_argument("the order names " +
                                    std::to_string(order.size()) +
                                    " rows; the problem has " + std::to_string(n));
    sweep.row_at.resize(n);
    sweep.place_of.assign(n, -1);
    for (std::size_t k = 0; k < n; ++k) {
        const int i = order.empty() ? static_cast<int>(k) : order[k];
        if (i < 0 || static_cast<std::size_t>(i) >= n ||
            sweep.place_of[static_cast<std::size_t>(i)] >= 0)
            throw std::invalid_argument(
                "the order names row " + std::to_string(i) +
                " twice or out of range; it must name each row once");
        sweep.row_at[k] = i;
        sweep.place_of[static_cast<std::size_t>(i)] = static_cast<int>(k);
    }

    sweep.rows.resize(n);
    sweep.start.resize(n + 1);
    sweep.column.resize(static_cast<std::size_t>(mlcp.A.nonZeros()));
    sweep.coefficient.resize(static_cast<std::size_t>(mlcp.A.nonZeros()));
    sweep.lambda.resize(mlcp.size());
    sweep.next.resize(mlcp.size());
    std::size_t filled = 0;
    sweep.start[0] = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const Index i = sweep.row_at[k];
        const std::size_t first = filled;
        Real diagonal = 0, before = 0, after = 0;
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            const int place = sweep.place_of[static_cast<std::size_t>(entry.col())];
            const int distance = place - static_cast<int>(k);
            if (distance == 0) diagonal = entry.value();
            else if (distance == -1) before = entry.value();
            else if (distance == 1) after = entry.value();
            else
                sweep.column[filled] = place,
                sweep.coefficient[filled++] = entry.value();
        }
        sweep.start[k + 1] = static_cast<int>(filled);
        // as in the natural residual
        const Real scale = diagonal > 0 ? diagonal : 1;
        const Real factor = -omega / scale;
        for (std::size_t e = first; e < filled; ++e) sweep.coefficient[e] *= factor;
        SweepRow& row = sweep.rows[k];
        row.keep = diagonal > 0 ? 1 - omega : 1 - omega * diagonal;
        row.constant = factor * mlcp.q[i];
        row.before = factor * before;
        row.after = factor * after;
        row.lo = mlcp.lo[i];
        row.hi = mlcp.hi[i];
        row.scale = scale / omega;
        if (is_empty(sweep, k)) {  // w = q for every λ: a bound is the answer
            if (mlcp.q[i] > 0 && std::isfinite(row.lo)) row.hi = row.lo;
            if (mlcp.q[i] < 0 && std::isfinite(row.hi)) row.lo = row.hi;
            if (row.lo < row.hi) row.constant = 0;
        }
    }
}

//! [forward]
Real sweep_forward(SweepRows& sweep)
{
    const std::size_t n = sweep.rows.size();
    Real* const lambda = sweep.lambda.data();
    Real largest = 0, before = 0;
    for (std::size_t k = 0; k < n; ++k) {
        const Real value =
            visit(sweep, k, lambda, before, k + 1 < n ? lambda[k + 1] : 0);
        largest =
            std::max(largest, sweep.rows[k].scale * std::abs(value - lambda[k]));
        before = lambda[k] = value;
    }
    return largest;
}
//! [forward]

Real sweep_backward(SweepRows& sweep)
{
    Real* const lambda = sweep.lambda.data();
    Real largest = 0, after = 0;
    for (std::size_t k = sweep.rows.size(); k-- > 0;) {
        const Real value =
            visit(sweep, k, lambda, k > 0 ? lambda[k - 1] : 0, after);
        largest =
            std::max(largest, sweep.rows[k].scale * std::abs(value - lambda[k]));
        after = lambda[k] = value;
    }
    return largest;
}

//! [jacobi]
Real sweep_jacobi(SweepRows& sweep)
{
    Real largest = 0;
    for (std::size_t k = 0; k < sweep.rows.size(); ++k) {
        const auto i = static_cast<Index>(k);
        sweep.next[i] = visit(sweep, k, sweep.lambda.data());
        largest = std::max(largest, sweep.rows[k].scale *
                                        std::abs(sweep.next[i] - sweep.lambda[i]));
    }
    sweep.lambda.swap(sweep.next);
    return largest;
}
//! [jacobi]

}  // namespace rigid
