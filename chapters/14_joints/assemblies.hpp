/// \file assemblies.hpp
/// Which bodies joints hold together: the parts that a tree of joints falls into.
///
///     an impulse on a body moves its assembly and, by joints alone, nothing else
///
/// So the answer to one impulse costs as much as its assembly is long, however many others there are.
#pragma once

#include "chapters/14_joints/joint_tree.hpp"
#include "common/union_find.hpp"

#include <numeric>
#include <span>

namespace rigid {

struct Assemblies {
    std::vector<int> of;     ///< K: of each body; −1 = no joint holds it
    std::vector<int> nodes;  ///< of the tree, assembly after assembly, ascending
    std::vector<int> first;  ///< count() + 1: where those of each begin

    int count() const
    {
        return first.empty() ? 0 : static_cast<int>(first.size()) - 1;
    }
    std::span<const int> nodes_of(int i) const
    {
        const int begin = first[static_cast<std::size_t>(i)],
                  end = first[static_cast<std::size_t>(i) + 1];
        return {nodes.data() + begin, static_cast<std::size_t>(end - begin)};
    }

    //! [find]
    void find(const JointTree& tree)
    {
        const auto at = [](auto& list, int i) -> auto&
        {
            return list[static_cast<std::size_t>(i)];
        };
        lowest_.resize(tree.node_of.size());
        std::iota(lowest_.begin(), lowest_.end(), 0);
        for (const RowGroup& group : tree.groups)
            if (group.a >= 0) unite(lowest_, group.a, group.b);
        of.assign(tree.node_of.size(), -1);
        first.assign(1, 0);
        for (const TreeNode& node : tree.nodes) {  // number and count
            int& number = at(of, lowest_of(lowest_, node.body));
            if (number < 0) {
                number = count();
                first.push_back(0);
            }
            at(of, node.body) = number;
            ++at(first, number + 1);
        }
        for (std::size_t i = 1; i < first.size(); ++i) first[i] += first[i - 1];
        next_.assign(first.begin(), first.end());
        nodes.resize(tree.nodes.size());
        for (std::size_t n = 0; n < nodes.size(); ++n)
            at(nodes, at(next_, at(of, tree.nodes[n].body))++) =
                static_cast<int>(n);
    }
    //! [find]

private:
    std::vector<int> lowest_, next_;
};

}  // namespace rigid
