// The functions of assemblies.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/assemblies.hpp"

namespace rigid {

//! [find]
void Assemblies::find(const JointTree& tree)
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
        at(nodes, at(next_, at(of, tree.nodes[n].body))++) = static_cast<int>(n);
}
//! [find]

}  // namespace rigid
