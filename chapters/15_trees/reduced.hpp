/// \file reduced.hpp
/// The second way to the same answer: no rows at all, but coordinates that can't break a joint.
///
///     u_i = X_i u_p + s_i q̇_i            a body moves with its parent, and by its own joint
///     up      A_i = M_i + Σ X_cᵀ (A_c − A_c s sᵀ A_c / sᵀ A_c s) X_c        the articulated inertia
///     down    q̇ = sᵀ (p − A X u_p) / sᵀ A s
///
/// (15.26) to (15.28), Featherstone's algorithm in the plane, O(n). Takes trees from the world whose joints are revolute,
/// prismatic, or weld; no loops, no floating bodies, no contacts. \cite featherstone2008
#pragma once

#include "chapters/15_trees/reduced_links.hpp"

namespace rigid {

class ReducedTree {
public:
    /// Throws as links_of() does.
    explicit ReducedTree(const JointedScene& scene) : links_(links_of(scene)) {}

    std::size_t size() const { return links_.size(); }

    /// q of the bodies as they are.
    VecX coordinates(const VecX& x) const;

    //! [place]
    /// Positions of the bodies whose coordinates are q: no joint can be off.
    void place(const VecX& q, VecX& x) const
    {
        for (std::size_t i = 0; i < size(); ++i) {
            const RigidJoint& joint = links_[i].joint;
            const Real along = q[static_cast<Index>(i)];
            const Index b = joint.b;
            const Real before = joint.a == world ? 0 : x[3 * joint.a + 2];
            Vec2 p = point_of(x, joint.a, joint.at_a);
            x[3 * b + 2] = before + joint.angle;
            if (joint.kind == JointKind::revolute) x[3 * b + 2] += along;
            if (joint.kind == JointKind::prismatic) p += along * axis(joint, x);
            x.segment<2>(3 * b).setZero();
            x.segment<2>(3 * b) = p - point_of(x, b, joint.at_b);
        }
    }

    /// Velocities of the bodies whose coordinates change at the rates dq, (15.26).
    void move(const VecX& dq, const VecX& x, VecX& u)
    {
        find_motions(x);
        for (std::size_t i = 0; i < size(); ++i)
            u.segment<3>(3 * links_[i].body) =
                carried(i, x, u) + links_[i].s * dq[static_cast<Index>(i)];
    }
    //! [place]

    //! [recursion]
    /// The rates y of the coordinates for which the motion of the bodies is nearest
    /// to a wanted one, in the sense of M: with velocities u* that is a step's
    /// answer, with f/m and the velocity products c it is the accelerations.
    /// \param wanted  of all bodies
    /// \param c       what the motion has besides X and s; zero for velocities
    /// \param motion  of all bodies: the answer
    VecX nearest(const VecX& x, const VecX& inverse_mass, const VecX& wanted,
                 const VecX& c, VecX& motion)
    {
        find_motions(x);
        for (Link& link : links_) {
            const Vec<3> m = inverse_mass.segment<3>(3 * link.body).cwiseInverse();
            link.A = m.asDiagonal();
            link.p = m.cwiseProduct(wanted.segment<3>(3 * link.body));
        }
        for (std::size_t i = size(); i-- > 0;) {  // (15.28)
            Link& link = links_[i];
            link.p -= link.A * c.segment<3>(3 * link.body);
            link.As = link.A * link.s;
            const Real inertia = link.s.dot(link.As);
            link.per_inertia = inertia > 0 ? 1 / inertia : 0;
            if (link.parent < 0) continue;
            Link& parent = links_[static_cast<std::size_t>(link.parent)];
            const Mat3 X = shift(i, x);
            parent.A +=
                X.transpose() *
                (link.A - link.per_inertia * link.As * link.As.transpose()) * X;
            parent.p += X.transpose() *
                        (link.p - link.per_inertia * link.s.dot(link.p) * link.As);
        }
        VecX y(static_cast<Index>(size()));
        for (std::size_t i = 0; i < size(); ++i) {  // (15.27)
            Link& link = links_[i];
            const Vec<3> with_parent = carried(i, x, motion);
            y[static_cast<Index>(i)] =
                link.per_inertia * (link.s.dot(link.p) - link.As.dot(with_parent));
            motion.segment<3>(3 * link.body) = with_parent +
                                               c.segment<3>(3 * link.body) +
                                               link.s * y[static_cast<Index>(i)];
        }
        return y;
    }
    //! [recursion]

    /// (15.29): the part of the accelerations that velocities alone make.
    void velocity_products(const VecX& x, const VecX& dq, const VecX& u, VecX& c);

private:
    using Link = ReducedLink;
    using Mat3 = Link::Mat3;

    static Vec2 axis(const RigidJoint& joint, const VecX& x)
    {
        if (joint.a == world) return joint.axis;
        return point_of(x, joint.a, joint.axis) - x.segment<2>(3 * joint.a);
    }
    Index parent_body(std::size_t i) const
    {
        const int parent = links_[i].parent;
        return parent < 0 ? world : links_[static_cast<std::size_t>(parent)].body;
    }

    /// s of each link: how its body moves when its own coordinate does.
    void find_motions(const VecX& x);

    /// X: the motion of the parent, at this body's centroid.
    Mat3 shift(std::size_t i, const VecX& x) const;
    Vec<3> carried(std::size_t i, const VecX& x, const VecX& u) const
    {
        if (links_[i].parent < 0) return Vec<3>::Zero();
        return shift(i, x) * u.segment<3>(3 * parent_body(i));
    }

    std::vector<Link> links_;
};

}  // namespace rigid
