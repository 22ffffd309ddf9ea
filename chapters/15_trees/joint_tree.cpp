// The functions of joint_tree.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/joint_tree.hpp"

namespace rigid {

void JointTree::walk(std::size_t from)
{
    for (std::size_t n = from; n < nodes.size(); ++n) {
        const int body = nodes[n].body;
        for (int p = at(begin_, body); p < at(begin_, body + 1); ++p) {
            const int g = at(met_, p);
            if (at(used_, g) || at(groups, g).a < 0) continue;
            const int other =
                at(groups, g).a == body ? at(groups, g).b : at(groups, g).a;
            enter(other, static_cast<int>(n), g);
        }
    }
}

bool JointTree::group_rows(Index count)
{
    groups.swap(before_);
    groups.clear();
    open_.assign(static_cast<std::size_t>(count), -1);
    for (auto [a, b, row] : taken_) {
        if (b < 0) std::swap(a, b);
        // rows that follow each other, or the last group of body b
        int g = at(open_, b);
        if (g < 0 || at(groups, g).a != a || at(groups, g).b != b ||
            at(groups, g).count == RowGroup::most) {
            g = static_cast<int>(groups.size());
            groups.push_back({a, b, 0, {}});
            at(open_, b) = g;
        }
        RowGroup& group = at(groups, g);
        group.rows[static_cast<std::size_t>(group.count++)] = row;
    }
    const auto same = [](const RowGroup& x, const RowGroup& y) {
        return x.a == y.a && x.b == y.b;
    };
    return !std::equal(groups.begin(), groups.end(), before_.begin(), before_.end(),
                       same);
}

}  // namespace rigid
