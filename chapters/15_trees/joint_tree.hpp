/// \file joint_tree.hpp
/// Which rows hold which two bodies together, and a tree of these pairs in which no body comes before its parent.
///
///     world ─ joint ─ body ─ joint ─ body …        every body but a root hangs on one joint; what is left closes loops
///
/// (15.3): bodies are nodes, joints edges; what cannot move is the world. Found breadth first, from the world, in the
/// order of the rows: O(n), and only when the pairs have changed.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "common/bodies.hpp"

#include <array>
#include <vector>

namespace rigid {

/// Rows between the same two bodies, solved together.
struct RowGroup {
    /// at most so many; a pair with more of them has several groups
    static constexpr int most = 4;
    int a = -1, b = -1;  ///< bodies; −1 = one that cannot move, and a only
    int count = 0;
    std::array<int, most> rows{};
};

/// A body in the tree, in an order in which parents come first.
struct TreeNode {
    int body = 0;
    int parent = -1;  ///< its number in the order; −1 = the world, or nothing
    int group = -1;   ///< the rows to the parent; −1 = a root that floats
};

class JointTree {
    template <class List>
    static auto& at(List& list, int i)
    {
        return list[static_cast<std::size_t>(i)];
    }

public:
    std::vector<RowGroup> groups;
    std::vector<TreeNode> nodes;
    std::vector<int> node_of;  ///< of each body; −1 = it has no group
    std::vector<int> loops;    ///< groups that close loops
    bool found_anew = false;   ///< by the last find()

    /// Whether a row is one that the tree takes: it pushes and pulls as far as it has to.
    template <int Dof>
    static bool takes(const Row<Dof>& row)
    {
        return row.lo == -infinity && row.hi == infinity && row.bounded_by < 0;
    }

    //! [find]
    /// \param left_out  1: a row that the tree is not to take; empty = none
    template <int Dof>
    void find(const std::vector<Row<Dof>>& rows, const VecX& inverse_mass,
              const std::vector<char>& left_out)
    {
        const Index count = inverse_mass.size() / Dof;
        found_anew = !are_those_of_before(rows, inverse_mass, left_out) &&
                     collect(rows, inverse_mass, left_out);
        if (!found_anew) return;
        // the groups of each body
        begin_.assign(static_cast<std::size_t>(count) + 1, 0);
        for (const RowGroup& group : groups)
            for (const int k : {group.a, group.b})
                if (k >= 0) ++at(begin_, k + 1);
        for (std::size_t k = 1; k < begin_.size(); ++k) begin_[k] += begin_[k - 1];
        met_.assign(static_cast<std::size_t>(begin_.back()), 0);
        next_ = begin_;
        for (std::size_t g = 0; g < groups.size(); ++g)
            for (const int k : {groups[g].a, groups[g].b})
                if (k >= 0) at(met_, at(next_, k)++) = static_cast<int>(g);

        nodes.clear();
        loops.clear();
        node_of.assign(static_cast<std::size_t>(count), -1);
        used_.assign(groups.size(), 0);
        for (std::size_t g = 0; g < groups.size(); ++g)  // what hangs on the world
            if (groups[g].a < 0) enter(groups[g].b, -1, static_cast<int>(g));
        walk(0);
        // what floats: the first body of each is a root
        for (const RowGroup& group : groups) {
            const std::size_t from = nodes.size();
            if (at(node_of, group.b) < 0) enter(group.b, -1, -1);
            walk(from);
        }
        for (std::size_t g = 0; g < groups.size(); ++g)
            if (!used_[g]) loops.push_back(static_cast<int>(g));
    }
    //! [find]

private:
    void enter(int body, int parent, int group)
    {
        if (at(node_of, body) >= 0) return;
        at(node_of, body) = static_cast<int>(nodes.size());
        nodes.push_back({body, parent, group});
        if (group >= 0) at(used_, group) = 1;
    }

    /// Breadth first from the nodes behind `from` on.
    void walk(std::size_t from);

    /// Row by row the same bodies, and those that cannot move the same ones?
    template <int Dof>
    bool are_those_of_before(const std::vector<Row<Dof>>& rows,
                             const VecX& inverse_mass,
                             const std::vector<char>& left_out) const
    {
        const auto count = static_cast<std::size_t>(bodies_);
        if (inverse_mass.size() != Dof * bodies_) return false;
        for (std::size_t k = 0; k < count; ++k)
            if (moves_[k] != can_move<Dof>(inverse_mass, k)) return false;
        std::size_t n = 0;
        for (std::size_t i = 0; i < rows.size(); ++i) {
            const Row<Dof>& row = rows[i];
            if (!takes(row) || (!left_out.empty() && left_out[i])) continue;
            if (n == seen_.size() || seen_[n].a != row.a || seen_[n].b != row.b ||
                seen_[n].row != i)
                return false;
            ++n;
        }
        return n == seen_.size();
    }
    template <int Dof>
    static char can_move(const VecX& inverse_mass, std::size_t k)
    {
        return inverse_mass.template segment<Dof>(static_cast<Index>(Dof * k))
                   .maxCoeff() > 0;
    }

    /// Lists the rows that the tree takes. Returns false if its pairs of bodies are those of last time.
    template <int Dof>
    bool collect(const std::vector<Row<Dof>>& rows, const VecX& inverse_mass,
                 const std::vector<char>& left_out)
    {
        const Index count = inverse_mass.size() / Dof;
        moves_.resize(static_cast<std::size_t>(count));
        for (std::size_t k = 0; k < moves_.size(); ++k)
            moves_[k] = can_move<Dof>(inverse_mass, k);
        const auto body = [this](Index k) {
            return k != world && moves_[static_cast<std::size_t>(k)]
                       ? static_cast<int>(k)
                       : -1;
        };
        const bool resized = bodies_ != count;
        bodies_ = count;
        bool known = !resized;
        std::size_t n = 0;
        seen_.clear();
        for (std::size_t i = 0; i < rows.size(); ++i) {
            if (!takes(rows[i]) || (!left_out.empty() && left_out[i])) continue;
            seen_.push_back({rows[i].a, rows[i].b, i});
            const TakenRow taken{body(rows[i].a), body(rows[i].b),
                                 static_cast<int>(i)};
            // nothing that could move
            if (taken.a < 0 && taken.b < 0) continue;
            if (n == taken_.size()) taken_.emplace_back();
            known = known && taken_[n] == taken;
            taken_[n++] = taken;
        }
        known = known && n == taken_.size();
        taken_.resize(n);
        return (!known && group_rows(count)) || resized;
    }

    /// Sorts them into groups. Returns false if these are between the same bodies as last time.
    bool group_rows(Index count);

    struct TakenRow {
        int a, b, row;
        bool operator==(const TakenRow& other) const = default;
    };
    struct SeenRow {
        Index a, b;
        std::size_t row;
    };
    std::vector<TakenRow> taken_;  ///< of them, those that move anything
    std::vector<SeenRow> seen_;    ///< all that the tree takes
    std::vector<char> moves_;
    std::vector<RowGroup> before_;
    std::vector<int> begin_, next_, met_, open_;
    std::vector<char> used_;
    Index bodies_ = -1;
};

}  // namespace rigid
