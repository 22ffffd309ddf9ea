// The functions of reduced_motion.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/26_four_ways/reduced_motion.hpp"

namespace rigid {

TreeAndLoops split_loops(const JointedScene& scene)
{
    TreeAndLoops parts;
    parts.tree = scene;
    parts.tree.joints.clear(), parts.tree.placed.clear(), parts.tree.owner.clear();
    std::vector<char> hangs(static_cast<std::size_t>(scene.bodies.count()), 0);
    for (const PlacedJoint& placed : scene.placed) {
        const RigidJoint& joint = placed.joint;
        char& done = hangs[static_cast<std::size_t>(joint.b)];
        if (!done) {
            done = 1;
            add_joint(parts.tree, joint);
            continue;
        }
        for (int i = 0; i < placed.count; ++i)
            parts.loops.push_back(
                scene.joints[static_cast<std::size_t>(placed.first + i)]);
    }
    return parts;
}

ReducedMotion::ReducedMotion(const JointedScene& scene)
    : parts_(split_loops(scene)), tree_(parts_.tree), links_(links_of(parts_.tree))
{
    for (const PointJoint& joint : scene.joints)
        if (!has_error(joint.kind))
            throw std::invalid_argument(
                "a joint has a motor or a spring; coordinates of joints take their "
                "forces from outside");
    q_ = tree_.coordinates(scene.bodies.x);
    x_ = scene.bodies.x, u_ = scene.bodies.u;
    c_.setZero(u_.size());
    motion_ = c_;
    // the rates nearest to the velocities that the bodies have
    dq_ = tree_.nearest(x_, scene.bodies.inverse_mass, u_, c_, motion_);
    u_ = motion_;
}

VecX ReducedMotion::forward_dynamics(const VecX& q, const VecX& dq, const VecX& tau)
{
    ++recursions;
    const JointedScene& scene = parts_.tree;
    tree_.place(q, x_);
    tree_.move(dq, x_, u_);
    tree_.velocity_products(x_, dq, u_, c_);
    f_.setZero(u_.size());
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if (scene.bodies.can_move(k)) f_.segment<2>(3 * k) = scene.gravity;
    // the force of a joint, on its body and against its parent
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const Real t = tau.size() > 0 ? tau[static_cast<Index>(i)] : 0;
        if (t == 0) continue;
        const RigidJoint& joint = links_[i].joint;
        Constraint<3> c = joint_constraint(x_, coordinate_row(joint));
        f_.segment<3>(3 * c.b) +=
            scene.bodies.apply_inverse_mass(c.b, t * c.Jb.transpose());
        if (c.a != world)
            f_.segment<3>(3 * c.a) +=
                scene.bodies.apply_inverse_mass(c.a, t * c.Ja.transpose());
    }
    return tree_.nearest(x_, scene.bodies.inverse_mass, f_, c_, motion_);
}

//! [inverse]
VecX ReducedMotion::inverse_dynamics(const VecX& q, const VecX& dq, const VecX& ddq)
{
    ++recursions;
    const Bodies<3>& bodies = parts_.tree.bodies;
    tree_.place(q, x_);
    tree_.move(dq, x_, u_);
    tree_.velocity_products(x_, dq, u_, c_);
    VecX a, force = VecX::Zero(u_.size());
    // down: a = X a_p + s q̈ + c.  The first two are velocities with q̈ for q̇
    a = u_;
    tree_.move(ddq, x_, a);
    VecX tau(ddq.size());
    VecX bend = c_;
    for (std::size_t i = 0; i < links_.size(); ++i) {  // c of the parents moves on
        const ReducedLink& link = links_[i];
        if (link.parent < 0) continue;
        const Index b = link.body,
                    p = links_[static_cast<std::size_t>(link.parent)].body;
        const Vec2 d = x_.segment<2>(3 * b) - x_.segment<2>(3 * p);
        bend.segment<2>(3 * b) += bend.segment<2>(3 * p);
        bend.segment<2>(3 * b) += bend[3 * p + 2] * perpendicular(d);
        bend[3 * b + 2] += bend[3 * p + 2];
    }
    a += bend;
    // up: what each joint passes on is the sum of what is beyond it
    for (std::size_t i = links_.size(); i-- > 0;) {
        const ReducedLink& link = links_[i];
        const Index b = link.body;
        Vec<3> pull = a.segment<3>(3 * b);
        pull.head<2>() -= parts_.tree.gravity;
        force.segment<3>(3 * b) +=
            pull.cwiseQuotient(bodies.inverse_mass.segment<3>(3 * b));
        const Constraint<3> c = joint_constraint(x_, coordinate_row(link.joint));
        const Vec2 F = force.segment<2>(3 * b);
        const Vec2 arm = point_of(x_, b, link.joint.at_b) - x_.segment<2>(3 * b);
        // at the point of the joint
        const Real moment = force[3 * b + 2] - cross2(arm, F);
        tau[static_cast<Index>(i)] = link.joint.kind == JointKind::revolute ? moment
                                     : link.joint.kind == JointKind::prismatic
                                         ? F.dot(Vec2(c.Jb.head<2>().transpose()))
                                         : 0;
        if (link.parent < 0) continue;
        const Index p = links_[static_cast<std::size_t>(link.parent)].body;
        const Vec2 d = x_.segment<2>(3 * b) - x_.segment<2>(3 * p);
        force.segment<2>(3 * p) += F;
        force[3 * p + 2] += force[3 * b + 2] + cross2(d, F);
    }
    return tau;
}
//! [inverse]

//! [couple]
void ReducedMotion::couple(std::vector<Row<3>>& rows)
{
    const Bodies<3>& bodies = parts_.tree.bodies;
    const auto m = static_cast<Index>(rows.size());
    answers_.resize(rows.size());
    MatX A(m, m);
    const VecX none = VecX::Zero(u_.size());
    for (Index j = 0; j < m; ++j) {
        ++recursions;
        VecX push = none;
        rows[static_cast<std::size_t>(j)].apply(1, push);  // M⁻¹ Jᵀ
        answers_[static_cast<std::size_t>(j)] =
            tree_.nearest(x_, bodies.inverse_mass, push, none, motion_);
        for (Index i = 0; i < m; ++i) {
            const Row<3>& row = rows[static_cast<std::size_t>(i)];
            A(i, j) = row.velocity(motion_) - row.bias;
        }
    }
    A = ((A + A.transpose()) / 2).eval();
    mlcp_.A = A.sparseView();
    mlcp_.q.resize(m);
    mlcp_.lo.resize(m);
    mlcp_.hi.resize(m);
    for (Index i = 0; i < m; ++i) {
        mlcp_.lo[i] = rows[static_cast<std::size_t>(i)].lo;
        mlcp_.hi[i] = rows[static_cast<std::size_t>(i)].hi;
    }
}
//! [couple]

Status ReducedMotion::accelerations(const VecX& q, const VecX& dq, VecX& ddq)
{
    ddq = forward_dynamics(q, dq, {});
    if (parts_.loops.empty()) return Status::solved;
    const VecX a = motion_;
    std::vector<Row<3>> rows;
    for (const PointJoint& joint : parts_.loops)
        rows.push_back(bilateral(joint_constraint(x_, joint),
                                 parts_.tree.bodies.inverse_mass,
                                 velocity_product(joint, x_, u_)));
    couple(rows);
    for (std::size_t i = 0; i < rows.size(); ++i)
        mlcp_.q[static_cast<Index>(i)] = rows[i].velocity(a);
    solution_.lambda.setZero(mlcp_.q.size());
    find_(mlcp_, std::span<const FrictionBox>{}, 0, solution_);
    if (solution_.status != Status::solved) return solution_.status;
    for (std::size_t i = 0; i < rows.size(); ++i)
        ddq += solution_.lambda[static_cast<Index>(i)] * answers_[i];
    return Status::solved;
}

Status ReducedMotion::advance(JointedScene& scene, Real h)
{
    require_step(h);
    Bodies<3>& bodies = scene.bodies;
    const Real length = typical_length(scene);
    Status status = Status::solved;
    Real fastest = scene.gravity.norm() * h;
    for (Index k = 0; k < bodies.count(); ++k)
        fastest = std::max(fastest, bodies.velocity(k).head<2>().norm() +
                                        std::abs(bodies.u[3 * k + 2]) * length);
    if (touches)
        find_push_joints(scene, filter, 0.02 * length + 2 * h * fastest, near_);
    const bool pushed = touches && !near_.empty();
    if (!pushed) {  // the tree and its loops alone: order four
        VecX k1, k2, k3, k4;
        const VecX q = q_, v = dq_;
        if ((status = accelerations(q, v, k1)) != Status::solved) return status;
        const VecX v2 = v + h / 2 * k1, v3_q = q + h / 2 * v;
        if ((status = accelerations(v3_q, v2, k2)) != Status::solved) return status;
        const VecX v3 = v + h / 2 * k2, q3 = q + h / 2 * v2;
        if ((status = accelerations(q3, v3, k3)) != Status::solved) return status;
        const VecX v4 = v + h * k3, q4 = q + h * v3;
        if ((status = accelerations(q4, v4, k4)) != Status::solved) return status;
        q_ = q + h / 6 * (v + 2 * v2 + 2 * v3 + v4);
        dq_ = v + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    } else {
        // q̇* of the forces, then the rows of velocities: loops, limits, contacts
        const VecX before = dq_;
        const VecX ddq = forward_dynamics(q_, dq_, {});
        dq_ += h * ddq;
        std::vector<Row<3>> rows;
        std::vector<FrictionBox> boxes;
        for (const PointJoint& joint : parts_.loops) {
            const Constraint<3> c = joint_constraint(x_, joint);
            rows.push_back(bilateral(c, bodies.inverse_mass, c.C / h));
        }
        for (const PushJoint& push : near_) {
            const Constraint<3> c = gap_of(push, x_);
            Row<3> row = unilateral(c, bodies.inverse_mass);
            const Real v = row.velocity(u_),
                       e = std::max(restitution, push.surface.restitution);
            // closed within the step, and faster than what gravity gives in it
            const bool hits = c.C + h * v < 0 && v < -2 * h * scene.gravity.norm();
            row.bias = hits && e > 0 ? e * v : c.C / h;
            const auto normal = static_cast<int>(rows.size());
            rows.push_back(row);
            if (!(push.surface.friction > 0)) continue;
            Row<3> drag =
                bilateral(drag_of(push, c, normal, x_, u_).c, bodies.inverse_mass);
            boxes.push_back(
                {static_cast<Index>(rows.size()), normal, push.surface.friction});
            rows.push_back(drag);
        }
        couple(rows);
        tree_.move(dq_, x_, u_);
        for (std::size_t i = 0; i < rows.size(); ++i)
            mlcp_.q[static_cast<Index>(i)] = rows[i].velocity(u_);
        solution_.lambda.setZero(mlcp_.q.size());
        find_(mlcp_, boxes, 1e-9 * length, solution_);
        status = solution_.status;
        for (std::size_t i = 0; i < rows.size(); ++i)
            dq_ += solution_.lambda[static_cast<Index>(i)] * answers_[i];
        q_ += h * dq_;
    }
    tree_.place(q_, bodies.x);
    tree_.move(dq_, bodies.x, bodies.u);
    return status;
}

}  // namespace rigid
