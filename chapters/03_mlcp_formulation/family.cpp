// The functions of family.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/03_mlcp_formulation/family.hpp"

namespace rigid {

DenseMlcp::DenseMlcp(const Mlcp& mlcp)
    : A(mlcp.A), q(mlcp.q), lo(mlcp.lo), hi(mlcp.hi)
{
    scale.resize(mlcp.size());
    for (Index i = 0; i < mlcp.size(); ++i)
        scale[i] =
            std::ldexp(1, -static_cast<int>(std::round(log2(unit_of(mlcp, i)))));
    A = scale.asDiagonal() * A * scale.asDiagonal();
    q.array() *= scale.array();
    lo.array() /= scale.array();
    hi.array() /= scale.array();
}

Real DenseMlcp::unit_of(const Mlcp& mlcp, Index i) const
{
    const Real moves = A.col(i).cwiseAbs().maxCoeff();
    if (!(moves > 0) || A.row(i).cwiseAbs().maxCoeff() > 0)
        return row_unit(mlcp, i, A(i, i));
    Real unit = 0;
    for (Index j = 0; j < A.rows(); ++j)
        if (const Real across = std::abs(A(j, j)); across > 0)
            unit = std::max(unit, std::abs(A(j, i)) / std::sqrt(across));
    return unit > 0 ? unit : std::sqrt(moves);
}

VecX nonnegative_least_squares(const MatX& E, const VecX& f)
{
    const Index n = E.cols();
    VecX v = VecX::Zero(n);
    std::vector<Index> free;
    const Real small = 1e-13 * (f.norm() + 1e-300) *
                       (E.cols() ? E.colwise().norm().maxCoeff() : 1);
    for (Index round = 0; round < 5 * n; ++round) {
        VecX wish = E.transpose() * (f - E * v);
        for (const Index j : free) wish[j] = 0;
        Index grows = 0;
        if (n == 0 || !(wish.maxCoeff(&grows) > small)) break;
        free.push_back(grows);
        while (!free.empty()) {
            MatX columns(E.rows(), static_cast<Index>(free.size()));
            for (std::size_t k = 0; k < free.size(); ++k)
                columns.col(static_cast<Index>(k)) = E.col(free[k]);
            const VecX wanted = columns.colPivHouseholderQr().solve(f);
            Real reach = 1;  // how far towards it all stay ≥ 0
            for (std::size_t k = 0; k < free.size(); ++k) {
                const Real to = wanted[static_cast<Index>(k)], from = v[free[k]];
                if (to <= 0)
                    reach =
                        std::min(reach, from > 0 ? from / (from - to) : Real{0});
            }
            for (std::size_t k = 0; k < free.size(); ++k)
                v[free[k]] += reach * (wanted[static_cast<Index>(k)] - v[free[k]]);
            if (reach >= 1) break;
            std::erase_if(free, [&](Index j) {
                if (v[j] > 1e-14 * v.maxCoeff()) return false;
                v[j] = 0;
                return true;
            });
        }
    }
    return v;
}

Family::Family(const DenseMlcp& problem, const std::vector<BoundState>& set)
    : problem_(problem), n_(problem.q.size()), base_(VecX::Zero(n_)),
      from_(MatX::Zero(n_, 0))
{
    // λ = base + from · v, a column for each nonnegative unknown.
    std::vector<std::pair<Index, Real>> columns;
    for (Index i = 0; i < n_; ++i) {
        const BoundState here = set[static_cast<std::size_t>(i)];
        const bool low = std::isfinite(problem.lo[i]),
                   high = std::isfinite(problem.hi[i]);
        if (here == BoundState::at_lo || (here == BoundState::between && low))
            base_[i] = problem.lo[i];
        else if (here == BoundState::at_hi || high) base_[i] = problem.hi[i];
        if (here != BoundState::between) continue;
        if (low || !high) columns.emplace_back(i, 1);
        if (!low) columns.emplace_back(i, -1);
    }
    from_ = MatX::Zero(n_, static_cast<Index>(columns.size()));
    for (std::size_t k = 0; k < columns.size(); ++k)
        from_(columns[k].first, static_cast<Index>(k)) = columns[k].second;

    // One equation for each row (w = 0, or w = ± a slack ≥ 0), and one for each second bound.
    MatX slacks = MatX::Zero(n_, n_), upper = MatX::Zero(0, 0);
    std::vector<Index> used, boxed;
    for (Index i = 0; i < n_; ++i) {
        const BoundState here = set[static_cast<std::size_t>(i)];
        // a pinned row may have any w
        if (!(problem.lo[i] < problem.hi[i])) continue;
        used.push_back(i);
        if (here == BoundState::at_lo) slacks(i, i) = -1;
        if (here == BoundState::at_hi) slacks(i, i) = 1;
        if (here == BoundState::between && std::isfinite(problem.lo[i]) &&
            std::isfinite(problem.hi[i]))
            boxed.push_back(i);
    }
    const Index rows = static_cast<Index>(used.size() + boxed.size()),
                lambdas = from_.cols();
    E_ = MatX::Zero(rows, lambdas + n_ + static_cast<Index>(boxed.size()));
    f_ = VecX::Zero(rows);
    const MatX A_from = problem.A * from_;
    const VecX w_base = problem.A * base_ + problem.q;
    numbers_ =
        (problem.A.cwiseAbs() * base_.cwiseAbs() + problem.q.cwiseAbs()).maxCoeff();
    Index line = 0;
    for (const Index i : used) {
        E_.row(line).head(lambdas) = A_from.row(i);
        E_.row(line).segment(lambdas, n_) = slacks.row(i);
        f_[line++] = -w_base[i];
    }
    // λ − lo + slack = hi − lo
    for (std::size_t k = 0; k < boxed.size(); ++k, ++line) {
        E_.row(line).head(lambdas) = from_.row(boxed[k]);
        E_(line, lambdas + n_ + static_cast<Index>(k)) = 1;
        f_[line] = problem.hi[boxed[k]] - problem.lo[boxed[k]];
    }
}

std::optional<VecX> Family::member_with(const Eigen::RowVectorXd& line,
                                        Real value) const
{
    MatX E = MatX::Zero(E_.rows() + 1, E_.cols());
    VecX f(f_.size() + 1);
    E.topRows(E_.rows()) = E_;
    E.row(E_.rows()).head(line.size()) = line;
    f << f_, value;
    return solve(E, f);
}

std::optional<VecX> Family::solve(const MatX& E, const VecX& f) const
{
    const VecX v = nonnegative_least_squares(E, f);
    const VecX left = f - E * v;
    if (left.norm() <= 1e-9 * f.norm() + 1e-14 * numbers_)
        return base_ + from_ * v.head(from_.cols());
    // The second without what rounding of f has left along the columns in use.
    unsure_ = unsure_ ||
              !(proves(E, f, v, left) || proves(E, f, v, left - along(E, v, left)));
    return std::nullopt;
}

}  // namespace rigid
