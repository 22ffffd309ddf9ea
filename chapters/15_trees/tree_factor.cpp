// The functions of tree_factor.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/tree_factor.hpp"

namespace rigid {

//! [factor]
void TreeFactor::factor(const std::vector<Row<3>>& rows, const VecX& inverse_mass,
                        const std::vector<char>& left_out)
{
    tree.find(rows, inverse_mass, left_out);
    work.orders += tree.found_anew;
    blocks_.resize(tree.nodes.size());
    dependent = 0;
    carried = 0;
    Real by_pins = 0;
    for (JointBlock& block : blocks_) block.S.setZero();
    for (std::size_t n = blocks_.size(); n-- > 0;) {  // leaves first
        const TreeNode& node = tree.nodes[n];
        const Vec<3> w = inverse_mass.segment<3>(place(n));
        JointBlock& block = blocks_[n];
        const Real c = block.S.diagonal().cwiseProduct(w).maxCoeff();
        block.count = 0;
        block.is_pin = false;
        if (node.group >= 0) block.load(rows, group_of(n), node, w);
        if (block.is_pin) {
            by_pins = std::max(by_pins, c);
            dependent += block.factor_pin(w, parent_of(n));
        } else {
            carried = std::max(carried, c);
            block.find_mobility(w);
            with_count(block.count, [&](auto d) {
                dependent += block.template factor<d>(w, parent_of(n));
            });
        }
        work.factored_rows += block.count;
    }
    // where others lose ε c², a pin loses ten times ε c: refined from 10⁵ on
    carried = std::max(carried, 32 * std::sqrt(by_pins));
}
//! [factor]

}  // namespace rigid
