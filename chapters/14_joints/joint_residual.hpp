/// \file joint_residual.hpp
/// What an answer leaves of the rows of a step, and where the next one starts from.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/14_joints/joint_tree.hpp"

#include <cmath>
#include <vector>

namespace rigid {

inline void biases_of(const std::vector<Row<3>>& rows, VecX& b)
{
    b.resize(static_cast<Index>(rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i)
        b[static_cast<Index>(i)] = rows[i].bias;
}

/// u ← u + M⁻¹ Jᵀ λ
inline void apply_all(const std::vector<Row<3>>& rows, const VecX& lambda, VecX& u)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        rows[i].apply(lambda[static_cast<Index>(i)], u);
}

/// The natural residual of all rows [m/s], (3.15), with the bounds that λ sets; infinite if one is not finite.
/// \param b  of each row, in place of its own bias
inline Real natural_residual(const std::vector<Row<3>>& rows, const VecX& b,
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

/// The largest |J u + γ λ + b| of the rows of joints [m/s]; infinite if one is not finite.
inline Real joint_residual(const std::vector<Row<3>>& rows, const VecX& b,
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

/// λ of joints is zero, of others within its bounds. Returns whether there are others.
inline bool clamp_start(const std::vector<Row<3>>& rows,
                        const std::vector<char>& left_out, VecX& lambda)
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
