/// \file assemblies.hpp
/// Which bodies joints hold together: the parts that a tree of joints falls into.
///
///     an impulse on a body moves its assembly and, by joints alone, nothing else
///
/// So the answer to one impulse costs as much as its assembly is long, however many others there are.
#pragma once

#include "chapters/15_trees/joint_tree.hpp"
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

    void find(const JointTree& tree);

private:
    std::vector<int> lowest_, next_;
};

}  // namespace rigid
