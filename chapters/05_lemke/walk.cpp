// The functions of walk.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/05_lemke/walk.hpp"

namespace rigid {

Index LemkeWalk::most_negative_row() const
{
    const VecX need = -tableau.values().cwiseQuotient(tableau.column(tableau.n));
    const Real enough =
        need.maxCoeff() - tableau.tolerances.tie * need.cwiseAbs().maxCoeff();
    Index best = 0;
    while (need[best] < enough) ++best;
    for (Index i = best + 1; i < tableau.n && ties != TieRule::first_row; ++i)
        if (need[i] >= enough) best = i;
    return best;
}

//! [ray]
VecX LemkeWalk::ray() const
{
    const VecX direction = tableau.column(tableau.column_of(entering));
    VecX y = VecX::Zero(tableau.n);
    for (Index i = 0; i < tableau.n; ++i)
        if (tableau.is_basic(i))
            y[i] = std::max(Real{0}, direction[tableau.row_of(i)]);
    if (entering < tableau.n) y[entering] = 1;
    return y;
}
//! [ray]

//! [refine]
VecX solve_between(const Mlcp& mlcp, VecX lambda, const std::vector<Index>& between)
{
    const auto k = static_cast<Index>(between.size());
    if (k == 0) return lambda;
    std::vector<Index> place(static_cast<std::size_t>(mlcp.size()), -1);
    for (Index r = 0; r < k; ++r)
        place[static_cast<std::size_t>(between[static_cast<std::size_t>(r)])] = r;
    MatX block = MatX::Zero(k, k);
    for (Index r = 0; r < k; ++r)
        for (SparseMatrix::InnerIterator entry(
                 mlcp.A, between[static_cast<std::size_t>(r)]);
             entry; ++entry)
            if (const Index c = place[static_cast<std::size_t>(entry.col())];
                c >= 0)
                block(r, c) = entry.value();
    VecX unit(k);
    for (Index r = 0; r < k; ++r) {
        const Index i = between[static_cast<std::size_t>(r)];
        unit[r] = row_unit(mlcp, i, mlcp.A.coeff(i, i));
    }
    const Eigen::PartialPivLU<MatX> factors(unit.cwiseInverse().asDiagonal() *
                                            block *
                                            unit.cwiseInverse().asDiagonal());
    for (int round = 0; round < 3; ++round) {  // once, and twice what is left of w
        const VecX w = mlcp.A * lambda + mlcp.q;
        const VecX step = factors.solve(VecX(w(between).cwiseQuotient(unit)));
        for (Index r = 0; r < k; ++r)
            lambda[between[static_cast<std::size_t>(r)]] -= step[r] / unit[r];
    }
    return lambda.cwiseMax(mlcp.lo).cwiseMin(mlcp.hi);
}
//! [refine]

}  // namespace rigid
