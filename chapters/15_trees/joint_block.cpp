// The functions of joint_block.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/joint_block.hpp"

namespace rigid {

void JointBlock::load(const std::vector<Row<3>>& rows, const RowGroup& group,
                      const TreeNode& node, const Vec<3>& inverse_mass)
{
    const Index body = node.body;
    const auto row_of = [&](int i) -> const Row<3>& {
        return rows[static_cast<std::size_t>(number(group, i))];
    };
    is_pin = group.count == 2 && inverse_mass.minCoeff() > 0 &&
             load_pin(row_of(0), row_of(1), node);
    if (is_pin) {
        count = 2;
        return;
    }
    for (count = 0; count < group.count; ++count) {
        const Row<3>& row = row_of(count);
        const bool is_b = row.b == body;
        J.row(count) = is_b ? row.Jb : row.Ja;
        Jp.row(count) = is_b ? row.Ja : row.Jb;
        softness[count] = row.softness;
        others[static_cast<std::size_t>(count)] = node.parent >= 0 ? world
                                                  : is_b           ? row.a
                                                                   : row.b;
    }
}

}  // namespace rigid
