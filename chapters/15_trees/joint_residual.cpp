// The functions of joint_residual.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/joint_residual.hpp"

namespace rigid {

Real natural_residual(const std::vector<Row<3>>& rows, const VecX& b,
                      const VecX& lambda, const VecX& u)
{
    Real residual = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row<3>& row = rows[i];
        const auto k = static_cast<Index>(i);
        const Real w = row.velocity(u) - row.bias + b[k] + row.softness * lambda[k];
        const auto [lo, hi] = bounds_of(row, lambda);
        const Real r = natural_residual_row(row.diagonal(), lambda[k], w, lo, hi);
        if (!(r <= residual)) residual = std::isfinite(r) ? r : infinity;
    }
    return residual;
}

Real joint_residual(const std::vector<Row<3>>& rows, const VecX& b,
                    const VecX& lambda, const VecX& u)
{
    Real residual = 0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!JointTree::takes(rows[i])) continue;
        const auto k = static_cast<Index>(i);
        const Real w = std::abs(rows[i].velocity(u) - rows[i].bias + b[k] +
                                rows[i].softness * lambda[k]);
        if (!(w <= residual)) residual = std::isfinite(w) ? w : infinity;
    }
    return residual;
}

bool clamp_start(const std::vector<Row<3>>& rows, const std::vector<char>& left_out,
                 VecX& lambda)
{
    bool any = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Real& start = lambda[static_cast<Index>(i)];
        const bool out = !left_out.empty() && left_out[i];
        if (JointTree::takes(rows[i]) || out || !std::isfinite(start)) start = 0;
        if (JointTree::takes(rows[i]) || out) continue;
        any = true;
        const auto [lo, hi] = bounds_of(rows[i], lambda);
        start = std::clamp(start, lo, hi);
    }
    return any;
}

}  // namespace rigid
