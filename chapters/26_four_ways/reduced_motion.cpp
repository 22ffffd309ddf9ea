// The functions of reduced_motion.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/26_four_ways/reduced_motion.hpp"

#include "chapters/12_contact_manifolds/scene_watch.hpp"
#include "chapters/15_trees/newton_settings.hpp"
#include "chapters/26_four_ways/order_four.hpp"

#include <Eigen/LU>

namespace rigid {

namespace {

constexpr Index no_joint = -2;  // besides world: hangs on nothing

/// A body without mass that a rail carries: what hangs on it has a coordinate more.
Index add_carrier(JointedScene& tree, Index rail_of, const Vec2& at,
                  const Vec2& axis)
{
    const Index carrier = add_body(tree, disc(1), Mass{1, {0, 0}, 1}, at);
    RigidJoint rail;
    rail.kind = JointKind::prismatic;
    rail.a = rail_of, rail.b = carrier;
    rail.axis = axis;
    add_joint(tree, rail);
    return carrier;
}

}  // namespace

TreeAndLoops split_loops(const JointedScene& scene)
{
    TreeAndLoops parts;
    JointedScene& tree = parts.tree;
    tree = scene;
    tree.joints.clear(), tree.placed.clear(), tree.owner.clear();
    const Index count = scene.bodies.count();
    std::vector<Index> hangs_on(static_cast<std::size_t>(count), no_joint);
    const auto on = [&](Index k) -> Index& {
        return hangs_on[static_cast<std::size_t>(k)];
    };
    const auto carries = [&](Index b, Index a) {
        while (a != no_joint && a != world && a != b) a = on(a);
        return a == b;
    };
    const auto is_loop = [](const PointJoint& row) {
        return row.kind == ConstraintKind::bilateral;
    };
    for (std::size_t i = 0; i < scene.joints.size(); ++i)  // rows of no joint
        if ((i >= scene.owner.size() || scene.owner[i] < 0) &&
            is_loop(scene.joints[i]))
            parts.loops.push_back(scene.joints[i]);
    for (const PlacedJoint& placed : scene.placed) {
        const RigidJoint& joint = placed.joint;
        const bool is_coordinate = joint.kind == JointKind::revolute ||
                                   joint.kind == JointKind::prismatic ||
                                   joint.kind == JointKind::weld;
        if (is_coordinate && scene.bodies.can_move(joint.b) &&
            on(joint.b) == no_joint && !carries(joint.b, joint.a)) {
            on(joint.b) = joint.a;
            add_joint(tree, joint);
            continue;
        }
        for (int i = 0; i < placed.count; ++i) {
            const PointJoint& row =
                scene.joints[static_cast<std::size_t>(placed.first + i)];
            if (is_loop(row)) parts.loops.push_back(row);
        }
    }
    for (Index k = 0; k < count; ++k) parts.carried.push_back(k);
    for (Index k = 0; k < count; ++k) {
        if (!scene.bodies.can_move(k) || on(k) != no_joint) continue;
        const Vec2 at = scene.bodies.position(k).head<2>();
        const Index x = add_carrier(tree, world, {at.x(), 0}, {1, 0}),
                    y = add_carrier(tree, x, at, {0, 1});
        RigidJoint centre;
        centre.a = y, centre.b = k;
        add_joint(tree, centre);
        parts.carried.insert(parts.carried.end(), {k, k});
    }
    for (Index k = count; k < tree.bodies.count(); ++k)
        tree.bodies.inverse_mass.segment<3>(3 * k).setConstant(infinity);
    return parts;
}

namespace {

const JointedScene& checked(const JointedScene& scene,
                            const CollisionFilter& filter = {})
{
    require_valid_motion(scene, filter,
                         "coordinates of joints take their forces from outside");
    require_one_friction(scene);
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Vec<3> inverse = scene.bodies.inverse_mass.segment<3>(3 * k);
        if (scene.bodies.can_move(k) && !(inverse.minCoeff() > 0))
            throw std::invalid_argument(
                "body " + std::to_string(k) + " has the inverse masses " +
                shortest(inverse.x()) + ", " + shortest(inverse.y()) + " and " +
                shortest(inverse.z()) +
                "; coordinates take bodies that move in all directions or in "
                "none");
    }
    return scene;
}

}  // namespace

ReducedMotion::ReducedMotion(const JointedScene& scene)
    : parts_(split_loops(checked(scene))), tree_(parts_.tree),
      links_(links_of(parts_.tree)), joints_given_(scene.joints)
{
    x_ = parts_.tree.bodies.x, u_ = parts_.tree.bodies.u;
    take(scene.bodies);
}

void ReducedMotion::take(const Bodies<3>& bodies)
{
    x_.head(bodies.x.size()) = bodies.x;
    u_.head(bodies.u.size()) = bodies.u;
    for (Index k = bodies.count(); 3 * k < x_.size(); ++k) {  // carriers: x, then y
        const bool second = (k - bodies.count()) % 2 == 1;
        const Vec2 at = bodies.position(carried_by(k)).head<2>();
        x_.segment<3>(3 * k) << at.x(), second ? at.y() : 0, 0;
    }
    q_ = tree_.coordinates(x_);
    c_.setZero(u_.size());
    motion_ = c_;
    // the rates nearest to the velocities that the bodies have
    dq_ = tree_.nearest(x_, parts_.tree.bodies.inverse_mass, u_, c_, motion_);
    u_ = motion_;
    written_x_ = bodies.x, written_u_ = bodies.u;
}

// (limits are those of the scene that a step is given)
bool ReducedMotion::holds_as_given(const JointedScene& scene) const
{
    return std::equal(scene.joints.begin(), scene.joints.end(),
                      joints_given_.begin(), joints_given_.end(),
                      [](const PointJoint& is, const PointJoint& was) {
                          const bool holds = was.kind == ConstraintKind::bilateral;
                          return holds ? is == was : is.kind == was.kind;
                      });
}

void ReducedMotion::follow(const JointedScene& scene)
{
    checked(scene, filter);
    if (!(restitution >= 0 && restitution <= 1))
        throw std::invalid_argument("the restitution of contacts and limits is " +
                                    shortest(restitution) +
                                    "; it must be from 0 to 1");
    const Bodies<3>& bodies = scene.bodies;
    if (bodies.x.size() != written_x_.size() || !holds_as_given(scene) ||
        bodies.inverse_mass !=
            parts_.tree.bodies.inverse_mass.head(bodies.x.size()))
        throw std::invalid_argument(
            "the scene has other bodies, masses or joints than that of which these "
            "coordinates were made; make them of it again");
    parts_.tree.gravity = scene.gravity;
    length_ = typical_length(scene);
    if (bodies.x != written_x_ || bodies.u != written_u_) take(bodies);
}

void ReducedMotion::require_fits(const VecX& v, const char* name) const
{
    if (v.size() != coordinates())
        throw std::invalid_argument(std::string(name) + " has " +
                                    std::to_string(v.size()) +
                                    " entries; the tree has " +
                                    std::to_string(coordinates()) + " coordinates");
}

VecX ReducedMotion::forward_dynamics(const VecX& q, const VecX& dq, const VecX& tau)
{
    require_fits(q, "q");
    require_fits(dq, "dq");
    if (tau.size() > 0) require_fits(tau, "tau");
    ++recursions;
    const JointedScene& scene = parts_.tree;
    tree_.place(q, x_);
    tree_.move(dq, x_, u_);
    tree_.velocity_products(x_, dq, u_, c_);
    f_.setZero(u_.size());
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if (scene.bodies.can_move(k)) f_.segment<2>(3 * k) = scene.gravity;
    // the force of a joint, on its body and against its parent; that on a carrier is
    // one on what it carries, and what pushes against one ends at the world
    for (std::size_t i = 0; i < links_.size(); ++i) {
        const Real t = tau.size() > 0 ? tau[static_cast<Index>(i)] : 0;
        if (t == 0) continue;
        const RigidJoint& joint = links_[i].joint;
        const Constraint<3> c = joint_constraint(x_, coordinate_row(joint));
        const Index b = carried_by(c.b);
        f_.segment<3>(3 * b) +=
            scene.bodies.apply_inverse_mass(b, t * c.Jb.transpose());
        if (c.a != world && carried_by(c.a) == c.a)
            f_.segment<3>(3 * c.a) +=
                scene.bodies.apply_inverse_mass(c.a, t * c.Ja.transpose());
    }
    return tree_.nearest(x_, scene.bodies.inverse_mass, f_, c_, motion_);
}

//! [inverse]
VecX ReducedMotion::inverse_dynamics(const VecX& q, const VecX& dq, const VecX& ddq)
{
    require_fits(q, "q");
    require_fits(dq, "dq");
    require_fits(ddq, "ddq");
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
    // none has a bound, and joints that are given twice repeat their rows: any answer
    // of theirs moves the tree alike
    const MatX A = mlcp_.A;
    solution_.lambda = -Eigen::FullPivLU<MatX>(A).solve(mlcp_.q);
    const Verification found =
        verify(mlcp_, solution_.lambda, {1e-9, 1e-9 * length_});
    if (!found.solved) return Status::infeasible;
    for (std::size_t i = 0; i < rows.size(); ++i)
        ddq += solution_.lambda[static_cast<Index>(i)] * answers_[i];
    return Status::solved;
}

void ReducedMotion::find_near(const JointedScene& scene, Real h)
{
    const Bodies<3>& bodies = scene.bodies;
    near_.clear();
    if (!touches) return;
    find_push_joints(scene, filter,
                     0.02 * length_ + closing_reach(scene, length_, h), near_);
    std::erase_if(near_, [&](const PushJoint& one) {  // limits that are far
        if (one.touches) return false;
        const Constraint<3> c = gap_of(one, bodies.x);
        const Real rate = bilateral(c, bodies.inverse_mass).velocity(bodies.u);
        const Real arm = is_angle(c) ? length_ : 1;
        return c.C * arm >
               0.02 * length_ +
                   2 * h * (std::abs(rate) * arm + h * scene.gravity.norm());
    });
}

Row<3> ReducedMotion::row_of(const PushJoint& push) const
{
    return unilateral(gap_of(push, x_), parts_.tree.bodies.inverse_mass);
}

void ReducedMotion::add_drag(const PushJoint& push, int normal,
                             std::vector<Row<3>>& rows,
                             std::vector<FrictionBox>& boxes) const
{
    if (!(push.surface.friction > 0)) return;
    const Constraint<3> c = drag_of(push, gap_of(push, x_), normal, x_, u_).c;
    boxes.push_back(
        {static_cast<Index>(rows.size()), normal, push.surface.friction});
    rows.push_back(bilateral(c, parts_.tree.bodies.inverse_mass, -c.speed));
}

Real ReducedMotion::open(const VecX& q, const VecX& dq)
{
    place(q, dq);
    Real least = infinity;
    for (const PushJoint& push : near_)
        if (row_of(push).velocity(u_) < 0)
            least = std::min(least, gap_of(push, x_).C);
    return least;
}

bool ReducedMotion::rests(Real h) const
{
    return std::any_of(near_.begin(), near_.end(), [&](const PushJoint& push) {
        const Real C = gap_of(push, x_).C, closed = settings.gap * length_;
        return C <= closed && C + h * row_of(push).velocity(u_) <= closed;
    });
}

Status ReducedMotion::solve(const std::vector<Row<3>>& rows,
                            const std::vector<FrictionBox>& boxes)
{
    for (std::size_t i = 0; i < rows.size(); ++i)
        mlcp_.q[static_cast<Index>(i)] = rows[i].velocity(u_);
    solution_.lambda.setZero(mlcp_.q.size());
    find_(mlcp_, boxes, 1e-9 * length_, solution_);
    return solution_.status;
}

Status ReducedMotion::fly(Real h, VecX& q, VecX& dq)
{
    return order_four(h, q, dq, [&](const VecX& at, const VecX& v, VecX& a) {
        return accelerations(at, v, a);
    });
}

Real ReducedMotion::fly_until_closed(Real h, Real width, Status& status)
{
    VecX q = q_, dq = dq_;
    if ((status = fly(h, q, dq)) != Status::solved) return h;
    Moment moment(h, open(q_, dq_), open(q, dq));
    if (moment.here < 0)
        for (Real at; (at = moment.next(width)) > 0;) {
            VecX q_at = q_, dq_at = dq_;
            if ((status = fly(at, q_at, dq_at)) != Status::solved) return h;
            if (moment.take(at, open(q_at, dq_at))) q = q_at, dq = dq_at;
        }
    q_ = q, dq_ = dq;
    return moment.past;
}

Index ReducedMotion::bouncing() const
{
    return std::count_if(near_.begin(), near_.end(), [&](const PushJoint& push) {
        return restitution_of(push) > 0;
    });
}

Real ReducedMotion::safe_part(const JointedScene& scene, Real h) const
{
    Real safe = h;
    const Bodies<3>& bodies = scene.bodies;
    for (const PushJoint& push : near_) {
        if (!push.touches || push.gap.a == world)
            continue;  // a wall has no far side
        Real thinnest = infinity, speed = 0;
        for (const Index k : {push.gap.a, push.gap.b}) {
            const Vec2 at = bodies.position(k).head<2>();
            const PlacedShape shape(scene.shapes[static_cast<std::size_t>(k)],
                                    bodies.position(k));
            thinnest = std::min(thinnest, inner_radius(shape.view(), at));
            Real reach = 0;  // of what turns
            for (const Vec2& vertex : shape.vertices)
                reach = std::max(reach, (vertex - at).norm());
            if (bodies.can_move(k)) speed += scene.gravity.norm() * h;
            speed += bodies.velocity(k).head<2>().norm() +
                     std::abs(bodies.u[3 * k + 2]) * reach;
        }
        if (!(thinnest > 0)) return 0;
        const Real free = std::max(Real{0}, gap_of(push, x_).C) + thinnest / 2;
        if (free < speed * safe) safe = free / speed;
    }
    return safe;
}

bool ReducedMotion::bounce(const JointedScene& scene)
{
    Real e = 0;
    std::vector<Row<3>> rows;
    std::vector<FrictionBox> boxes;
    for (const PointJoint& joint : parts_.loops)
        rows.push_back(
            bilateral(joint_constraint(x_, joint), scene.bodies.inverse_mass));
    for (const PushJoint& push : near_) {
        if (gap_of(push, x_).C > settings.gap * length_) continue;
        const auto normal = static_cast<int>(rows.size());
        rows.push_back(row_of(push));
        if (rows.back().velocity(u_) < -settings.rest_speed * length_)
            e = std::max(e, restitution_of(push));
        add_drag(push, normal, rows, boxes);
    }
    if (!(e > 0)) return false;
    couple(rows);
    if (solve(rows, boxes) != Status::solved) return false;
    ++bounces;
    for (std::size_t i = 0; i < rows.size(); ++i)
        dq_ += (1 + e) * solution_.lambda[static_cast<Index>(i)] * answers_[i];
    return true;
}

Status ReducedMotion::push(const JointedScene& scene, Real h, Real whole,
                           bool bounces_too)
{
    // q̇* of the forces, then the rows of velocities: loops, limits, contacts
    const VecX ddq = forward_dynamics(q_, dq_, {});
    dq_ += h * ddq;
    std::vector<Row<3>> rows;
    std::vector<FrictionBox> boxes;
    std::vector<std::pair<int, Real>> bouncing;  // rows, their b without e
    for (const PointJoint& joint : parts_.loops) {
        const Constraint<3> c = joint_constraint(x_, joint);
        rows.push_back(bilateral(c, scene.bodies.inverse_mass, c.C / whole));
    }
    for (const PushJoint& push : near_) {
        const Constraint<3> c = gap_of(push, x_);
        const Real C = c.C, e = restitution_of(push);
        Row<3> row = row_of(push);
        const Real v = row.velocity(u_);
        // closed within the step, and faster than what gravity gives in it
        const bool hits = C + h * v < 0 && v < -2 * h * scene.gravity.norm();
        // what it starts with comes out slowly: the velocity stays
        const Real fastest = repair_speed * (is_angle(c) ? 1 : length_);
        row.bias = C > 0 ? C / h : std::max(C / whole, -fastest);
        const auto normal = static_cast<int>(rows.size());
        if (hits && e > 0 && bounces_too) {
            bouncing.push_back({normal, row.bias});
            row.bias = e * v;
        }
        rows.push_back(row);
        add_drag(push, normal, rows, boxes);
    }
    couple(rows);
    tree_.move(dq_, x_, u_);
    Status status = solve(rows, boxes);
    if (status != Status::solved && !bouncing.empty()) {
        // no room for them, as between two walls that both are hit: all stop
        for (const auto& [row, stops] : bouncing)
            rows[static_cast<std::size_t>(row)].bias = stops;
        status = solve(rows, boxes);
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        dq_ += solution_.lambda[static_cast<Index>(i)] * answers_[i];
    q_ += h * dq_;
    return status;
}

void ReducedMotion::write(JointedScene& scene)
{
    place(q_, dq_);
    scene.bodies.x = x_.head(scene.bodies.x.size());
    scene.bodies.u = u_.head(scene.bodies.u.size());
    written_x_ = scene.bodies.x, written_u_ = scene.bodies.u;
}

//! [advance]
Status ReducedMotion::advance(JointedScene& scene, Real h)
{
    require_step(h);
    require_valid(settings);
    follow(scene);
    Real left = h;
    for (int events = 0; left > 0; ++events) {
        find_near(scene, left);
        Status status = Status::solved;
        Real part = left;
        if (near_.empty()) {
            status = fly(left, q_, dq_);
        } else {
            place(q_, dq_);
            const Real safe = safe_part(scene, left);
            const Index bounce_here = bouncing();
            const bool in_parts = bounce_here > 0 && safe > 0 &&
                                  events < settings.most_events,
                       each = in_parts && bounce_here == std::ssize(near_);
            if (each && bounce(scene)) {
                part = 0;
            } else if (each && !rests(left)) {
                part = fly_until_closed(safe, 1e-13 * h, status);
            } else {  // of order one
                if (in_parts) part = safe;
                status = push(scene, part, h, events < settings.most_events);
            }
        }
        if (!q_.allFinite() || !dq_.allFinite()) return Status::iteration_limit;
        write(scene);
        if (status != Status::solved) return status;
        left -= part;
    }
    return Status::solved;
}
//! [advance]

}  // namespace rigid
