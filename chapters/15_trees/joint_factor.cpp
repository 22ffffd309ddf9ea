// The functions of joint_factor.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/joint_factor.hpp"

namespace rigid {

//! [factor]
void JointFactor::factor(const std::vector<Row<3>>& rows, const VecX& inverse_mass,
                         const std::vector<char>& left_out)
{
    tree.factor(rows, inverse_mass, left_out);
    if (tree.tree.found_anew) assemblies.find(tree.tree);
    lambda_.resize(static_cast<Index>(rows.size()));
    loop_rows.clear();
    for (const int g : tree.tree.loops) {
        const RowGroup& group = tree.tree.groups[static_cast<std::size_t>(g)];
        for (int i = 0; i < group.count; ++i)
            loop_rows.push_back(group.rows[static_cast<std::size_t>(i)]);
    }
    const auto k = static_cast<Index>(loop_rows.size());
    border_entries += k * k * k / 6;
    if (k == 0) return;
    border_.resize(k, k);
    scale_.resize(k);
    for (Index j = 0; j < k; ++j) {
        const Row<3>& column = row(rows, j);
        u_.setZero(inverse_mass.size());
        column.apply(1, u_);
        tree.solve(Zero(), u_, lambda_);
        for (Index i = 0; i < k; ++i) border_(i, j) = speed_along(row(rows, i), u_);
        border_(j, j) += column.softness;
        const Real whole = column.diagonal();
        scale_[j] = whole > 0 ? 1 / std::sqrt(whole) : 1;
    }
    for (Index j = 0; j < k; ++j)
        for (Index i = 0; i < k; ++i) border_(i, j) *= scale_[i] * scale_[j];
    // a loop that says nothing new gets no impulse
    inverse_.factor(border_, rank_tolerance);
}
//! [factor]

//! [hold]
void JointFactor::hold(const std::vector<Row<3>>& rows, int assembly, VecX& u)
{
    const std::span<const int> nodes = assemblies.nodes_of(assembly);
    const auto k = static_cast<Index>(loop_rows.size());
    if (k > 0) {
        if (held_.size() != u.size()) held_.setZero(u.size());
        for (const int n : nodes)
            held_.segment<3>(place(n)) = u.segment<3>(place(n));
        tree.solve_some(nodes, Zero(), held_, lambda_);
        mu_.resize(k);
        for (Index i = 0; i < k; ++i)
            mu_[i] = -scale_[i] * speed_along(row(rows, i), held_);
        inverse_.solve(mu_);
        for (Index i = 0; i < k; ++i)
            if (mu_[i] != 0) row(rows, i).apply(scale_[i] * mu_[i], u);
        for (const int n : nodes) held_.segment<3>(place(n)).setZero();
    }
    tree.solve_some(nodes, Zero(), u, lambda_);
}
//! [hold]

}  // namespace rigid
