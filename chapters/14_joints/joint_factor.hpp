/// \file joint_factor.hpp
/// All rows that push and pull, solved together: a tree, and a border for the rows that close its loops.
///
///     [ T   Bᵀ ] [ tree's λ ]         T is solved in O(n). A column of the border is the answer of the tree to one unit of
///     [ B   C  ] [ μ        ]         impulse in a row that closes a loop; the border itself is k × k
///
/// (14.14): k rows that close loops cost k solves of the tree, and k³. \cite baraff1996
#pragma once

#include "chapters/14_joints/assemblies.hpp"
#include "chapters/14_joints/pivoted_ldlt.hpp"
#include "chapters/14_joints/tree_factor.hpp"

namespace rigid {

/// J u of a row [m/s], without its b.
inline Real speed_along(const Row<3>& row, const VecX& u)
{
    Real speed = row.Jb.dot(u.segment<3>(3 * row.b));
    if (row.a != world) speed += row.Ja.dot(u.segment<3>(3 * row.a));
    return speed;
}

class JointFactor {
public:
    TreeFactor tree;
    Assemblies assemblies;
    std::vector<int> loop_rows;
    std::int64_t border_entries = 0;  ///< that were factored
    /// part of J M⁻¹ Jᵀ that a loop must leave of a row, or the row gets no impulse
    Real rank_tolerance = 1e-11;

    //! [factor]
    void factor(const std::vector<Row<3>>& rows, const VecX& inverse_mass,
                const std::vector<char>& left_out = {})
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
            for (Index i = 0; i < k; ++i)
                border_(i, j) = speed_along(row(rows, i), u_);
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

    //! [solve]
    /// λ and u with J u + γ λ + b = 0 in each of the rows, u = u* + M⁻¹ Jᵀ λ.
    template <class Bias>
    void solve(const std::vector<Row<3>>& rows, const Bias& b, VecX& u,
               VecX& lambda)
    {
        if (loop_rows.empty()) return tree.solve(b, u, lambda);
        u_ = u;
        tree.solve(b, u_, lambda);
        const auto k = static_cast<Index>(loop_rows.size());
        mu_.resize(k);
        for (Index i = 0; i < k; ++i)
            mu_[i] = -scale_[i] * (speed_along(row(rows, i), u_) +
                                   b[loop_rows[static_cast<std::size_t>(i)]]);
        inverse_.solve(mu_);
        for (Index i = 0; i < k; ++i) {
            mu_[i] *= scale_[i];
            lambda[loop_rows[static_cast<std::size_t>(i)]] = mu_[i];
            row(rows, i).apply(mu_[i], u);
        }
        tree.solve(b, u, lambda);
    }
    //! [solve]

    /// Where the velocities of a node are.
    Index place(int node) const
    {
        return 3 * static_cast<Index>(
                       tree.tree.nodes[static_cast<std::size_t>(node)].body);
    }

    //! [hold]
    /// What the joints leave of velocities that are zero but on one assembly: b = 0.
    void hold(const std::vector<Row<3>>& rows, int assembly, VecX& u)
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

private:
    struct Zero {
        Real operator[](Index) const { return 0; }
    };
    const Row<3>& row(const std::vector<Row<3>>& rows, Index i) const
    {
        return rows[static_cast<std::size_t>(
            loop_rows[static_cast<std::size_t>(i)])];
    }

    MatX border_;
    VecX scale_, mu_, u_, lambda_;
    VecX held_;  ///< zero between calls
    PivotedLdlt inverse_;
};

}  // namespace rigid
