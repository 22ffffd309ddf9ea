/// \file joint_factor.hpp
/// All rows that push and pull, solved together: a tree, and a border for the rows that close its loops.
///
///     [ T   Bᵀ ] [ tree's λ ]         T is solved in O(n). A column of the border is the answer of the tree to one unit of
///     [ B   C  ] [ μ        ]         impulse in a row that closes a loop; the border itself is k × k
///
/// (15.8): k rows that close loops cost k solves of the tree, and k³. \cite baraff1996
#pragma once

#include "chapters/15_trees/assemblies.hpp"
#include "chapters/15_trees/pivoted_ldlt.hpp"
#include "chapters/15_trees/tree_factor.hpp"

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

    void factor(const std::vector<Row<3>>& rows, const VecX& inverse_mass,
                const std::vector<char>& left_out = {});

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

    /// Whether a row is a sum of others: it got no impulse.
    bool is_dependent() const
    {
        return tree.dependent > 0 ||
               (!loop_rows.empty() &&
                inverse_.rank < static_cast<Index>(loop_rows.size()));
    }

    /// Where the velocities of a node are.
    Index place(int node) const
    {
        return 3 * static_cast<Index>(
                       tree.tree.nodes[static_cast<std::size_t>(node)].body);
    }

    /// What the joints leave of velocities that are zero but on one assembly: b = 0.
    void hold(const std::vector<Row<3>>& rows, int assembly, VecX& u);

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
