// The functions of reduced.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/15_trees/reduced.hpp"

namespace rigid {

VecX ReducedTree::coordinates(const VecX& x) const
{
    VecX q = VecX::Zero(static_cast<Index>(size()));
    for (std::size_t i = 0; i < size(); ++i)
        if (links_[i].joint.kind != JointKind::weld)
            q[static_cast<Index>(i)] = coordinate(x, links_[i].joint);
    return q;
}

//! [products]
void ReducedTree::velocity_products(const VecX& x, const VecX& dq, const VecX& u,
                                    VecX& c)
{
    find_motions(x);
    c.setZero(u.size());
    for (std::size_t i = 0; i < size(); ++i) {
        const Link& link = links_[i];
        const Index b = link.body, a = parent_body(i);
        const Real rate = dq[static_cast<Index>(i)],
                   turns = a == world ? 0 : u[3 * a + 2];
        Vec2 relative = u.segment<2>(3 * b);
        if (a != world) relative -= u.segment<2>(3 * a);
        Vec2 sum = turns * perpendicular(relative);
        const Vec2 s = link.s.head<2>();
        sum += rate * perpendicular(s) *
               (link.joint.kind == JointKind::revolute ? u[3 * b + 2] : turns);
        c.segment<2>(3 * b) = sum;
    }
}
//! [products]

void ReducedTree::find_motions(const VecX& x)
{
    for (Link& link : links_) {
        link.s.setZero();
        if (link.joint.kind == JointKind::prismatic)
            link.s.head<2>() = axis(link.joint, x);
        if (link.joint.kind != JointKind::revolute) continue;
        const Vec2 arm =
            x.segment<2>(3 * link.body) - point_of(x, link.body, link.joint.at_b);
        link.s << perpendicular(arm), 1;
    }
}

ReducedTree::Mat3 ReducedTree::shift(std::size_t i, const VecX& x) const
{
    const Vec2 d =
        x.segment<2>(3 * links_[i].body) - x.segment<2>(3 * parent_body(i));
    Mat3 X = Mat3::Identity();
    X.block<2, 1>(0, 2) = perpendicular(d);
    return X;
}

}  // namespace rigid
