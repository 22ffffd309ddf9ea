/// \file tree_factor.hpp
/// The rows of a tree of joints solved together, from the leaves to the root and back: block LDLᵀ in O(n).
///
///     up      K = J G Jᵀ + Γ,   S_parent += J_pᵀ K⁻¹ J_p,   G = (M + S)⁻¹
///     down    λ = −K⁻¹ (J_p u_p + J û + b),                 u = û + G Jᵀ λ
///
/// (15.4) to (15.7). G is the inverse mass of a body with all that hangs below it, K what one unit of λ does to the
/// joint. Every matrix that is inverted is symmetric and positive. A body that carries c times its mass loses ε c² all the
/// same, on a pin ε c, (15.23). \cite baraff1996 \cite featherstone2008
#pragma once

#include "chapters/15_trees/joint_block.hpp"

#include <cstdint>
#include <type_traits>

namespace rigid {

/// What counts of its work.
struct TreeWork {
    std::int64_t orders = 0;         ///< trees that were found
    std::int64_t factored_rows = 0;  ///< rows of joints that were factored
    std::int64_t solved_rows = 0;    ///< rows of joints that were solved
};

class TreeFactor {
public:
    JointTree tree;
    TreeWork work;
    int dependent = 0;  ///< rows that say nothing new, of the last factor()
    /// how many times its own mass a body carries at most, of the last factor(); of c
    /// times on a pin 32 √c counts
    Real carried = 0;

    /// Finds the tree of the rows, where it has changed, and factors it.
    /// \param left_out  1: a row that is not to be looked at; empty = none
    void factor(const std::vector<Row<3>>& rows, const VecX& inverse_mass,
                const std::vector<char>& left_out = {});

    //! [solve]
    /// λ and u with J u + γ λ + b = 0 in each row of the tree, u = u* + M⁻¹ Jᵀ λ.
    /// \param b       one number a row of the step; only those of the tree are read
    /// \param u       u* before, u after
    /// \param lambda  of the tree's rows; others are left as they are
    template <class Bias>
    void solve(const Bias& b, VecX& u, VecX& lambda)
    {
        solve_some(All{blocks_.size()}, b, u, lambda);
    }
    //! [solve]

    //! [solve_some]
    /// The same for a part of the tree that no joint joins to the rest of it.
    /// \param nodes  ascending: parents first
    template <class Nodes, class Bias>
    void solve_some(const Nodes& nodes, const Bias& b, VecX& u, VecX& lambda)
    {
        const std::size_t count = nodes.size();
        for (std::size_t i = 0; i < count; ++i) {
            const auto n = static_cast<std::size_t>(nodes[i]);
            blocks_[n].pull.setZero();
            blocks_[n].star = u.segment<3>(place(n));
        }
        for (std::size_t i = count; i-- > 0;) {  // up
            const auto n = static_cast<std::size_t>(nodes[i]);
            JointBlock& block = blocks_[n];
            if (block.is_pin) {
                block.up_pin(b, group_of(n), u, parent_of(n));
                continue;
            }
            block.u = block.star - block.G * block.pull;  // û
            with_count(block.count, [&](auto d) {
                block.template up<d>(b, group_of(n), u, parent_of(n));
            });
        }
        for (std::size_t i = 0; i < count; ++i) {  // and down
            const auto n = static_cast<std::size_t>(nodes[i]);
            JointBlock& block = blocks_[n];
            if (block.is_pin) block.down_pin(group_of(n), parent_of(n), lambda);
            else
                with_count(block.count, [&](auto d) {
                    block.template down<d>(group_of(n), parent_of(n), lambda);
                });
            u.segment<3>(place(n)) = block.u;
            work.solved_rows += block.count;
        }
    }
    //! [solve_some]

private:
    struct All {
        std::size_t count;
        std::size_t size() const { return count; }
        std::size_t operator[](std::size_t i) const { return i; }
    };

    /// Calls what(d) with the number of rows as a constant.
    template <class What>
    static void with_count(int count, const What& what)
    {
        static_assert(RowGroup::most == 4);
        switch (count) {
        case 1:
            return what(std::integral_constant<int, 1>());
        case 2:
            return what(std::integral_constant<int, 2>());
        case 3:
            return what(std::integral_constant<int, 3>());
        case 4:
            return what(std::integral_constant<int, 4>());
        default:
            return;
        }
    }

    Index place(std::size_t n) const
    {
        return 3 * static_cast<Index>(tree.nodes[n].body);
    }
    const RowGroup& group_of(std::size_t n) const
    {
        return tree.groups[static_cast<std::size_t>(tree.nodes[n].group)];
    }
    JointBlock* parent_of(std::size_t n)
    {
        const int parent = tree.nodes[n].parent;
        return parent < 0 ? nullptr : &blocks_[static_cast<std::size_t>(parent)];
    }

    std::vector<JointBlock> blocks_;
};

}  // namespace rigid
