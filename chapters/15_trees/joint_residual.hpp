/// \file joint_residual.hpp
/// What an answer leaves of the rows of a step, and where the next one starts from.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/15_trees/joint_tree.hpp"

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
Real natural_residual(const std::vector<Row<3>>& rows, const VecX& b,
                      const VecX& lambda, const VecX& u);

/// The largest |J u + γ λ + b| of the rows of joints [m/s]; infinite if one is not finite.
Real joint_residual(const std::vector<Row<3>>& rows, const VecX& b,
                    const VecX& lambda, const VecX& u);

/// λ of joints is zero, of others within its bounds. Returns whether there are others.
bool clamp_start(const std::vector<Row<3>>& rows, const std::vector<char>& left_out,
                 VecX& lambda);

}  // namespace rigid
