// The functions of acceleration_level.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/26_four_ways/acceleration_level.hpp"

#include "chapters/05_lemke/lemke.hpp"
#include "chapters/09_active_sets/dantzig.hpp"
#include "chapters/13_friction/coulomb_residual.hpp"
#include "chapters/26_four_ways/order_four.hpp"

#include <Eigen/LU>

namespace rigid {

void require_valid(const AccelerationSettings& settings)
{
    require_valid(static_cast<const EventSettings&>(settings));
    require_not_negative(
        {{"the speed at which a contact sticks", settings.stick_speed},
         {"the rate of stabilisation", settings.rate}});
}

void AccelerationLevel::require_valid(const JointedScene& scene) const
{
    rigid::require_valid(settings);
    require_valid_motion(scene, filter,
                         "at the level of accelerations joints push and pull, or "
                         "only push");
}

void AccelerationLevel::close(const JointedScene& scene, Real reach)
{
    length_ = typical_length(scene);
    find_push_joints(scene, filter, reach, near_);
    closed_.clear();
    bodies_closed_ = scene.bodies.count();
    const VecX &x = scene.bodies.x, &u = scene.bodies.u;
    for (std::size_t i = 0; i < near_.size(); ++i) {
        const Constraint<3> c = gap_of(near_[i], x);
        const Row<3> row = bilateral(c, scene.bodies.inverse_mass);
        if (!(row.inverse_effective_mass() > 0)) continue;
        if (c.C > settings.gap * length_ ||
            std::abs(row.velocity(u)) > settings.stick_speed * length_)
            continue;
        int slides = 0;
        if (near_[i].surface.friction > 0) {
            const Drag drag = drag_of(near_[i], c, 0, x, u);
            const Real v =
                bilateral(drag.c, scene.bodies.inverse_mass).velocity(u) -
                drag.c.speed;
            if (std::abs(v) > settings.stick_speed * length_)
                slides = v > 0 ? 1 : -1;
        }
        closed_.push_back({i, slides});
    }
}

//! [accelerations]
Status AccelerationLevel::accelerations(const JointedScene& scene, const VecX& x,
                                        const VecX& u, VecX& a)
{
    const Index n = scene.bodies.x.size();
    if (x.size() != n || u.size() != n)
        throw std::invalid_argument("x and u have " + std::to_string(x.size()) +
                                    " and " + std::to_string(u.size()) +
                                    " entries; the bodies have " +
                                    std::to_string(n));
    if (!closed_.empty() && scene.bodies.count() != bodies_closed_)
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.bodies.count()) +
            " bodies; its closed contacts were found among " +
            std::to_string(bodies_closed_) + ": call close()");
    ++work.evaluations;
    free_accelerations(scene, a);
    const VecX& inverse_mass = scene.bodies.inverse_mass;
    rows_.clear();
    drags_.clear();
    boxes_.clear();
    slip_.clear();
    const auto add = [&](const Constraint<3>& c, Real k, Real C, Real lo) {
        rows_.push_back(make_row(c, inverse_mass, k, lo, infinity));
        Row<3>& row = rows_.back();
        row.bias = 0;
        const Real rate = row.velocity(u);
        row.bias = k + settings.rate * (2 * rate + settings.rate * C);
        drags_.push_back(Row<3>{});
        slip_.push_back(0);
    };
    for (const PointJoint& joint : scene.joints)
        if (joint.kind == ConstraintKind::bilateral) {
            const Constraint<3> c = joint_constraint(x, joint);
            add(c, velocity_product(joint, x, u), c.C, -infinity);
        }
    bool symmetric = true;
    for (const Closed& one : closed_) {
        const PushJoint& push = near_[one.joint];
        const Constraint<3> c = gap_of(push, x);
        const auto normal = static_cast<int>(rows_.size());
        add(c, velocity_product(push.gap, x, u), c.C, 0);
        if (!(push.surface.friction > 0)) continue;
        const Drag drag = drag_of(push, c, normal, x, u);
        if (one.slides != 0) {  // f_t = −μ f sign(v_t), with the normal's own f
            drags_.back() = bilateral(drag.c, inverse_mass);
            slip_.back() = one.slides * push.surface.while_sliding();
            symmetric = false;
        } else {
            add(drag.c, drag.k, 0, -infinity);
            boxes_.push_back({static_cast<Index>(rows_.size()) - 1, normal,
                              push.surface.friction});
            symmetric = false;
        }
    }
    solution_ = {};
    solution_.status = Status::solved;
    if (rows_.empty()) return Status::solved;
    // joints alone, none of which has a bound: one factor
    if (closed_.empty() && rows_.size() == scene.joints.size() &&
        settings.rate == 0) {
        joints_.find(scene, x, u, a);
        return Status::solved;
    }

    // W = M⁻¹ Jᵀ of each row, with the drag of what slides; A = J W, q = J a + k
    const auto m = static_cast<Index>(rows_.size());
    MatX W(a.size(), m), A(m, m);
    VecX column(a.size());
    for (Index j = 0; j < m; ++j) {
        column.setZero();
        rows_[static_cast<std::size_t>(j)].apply(1, column);
        if (const Real mu = slip_[static_cast<std::size_t>(j)]; mu != 0)
            drags_[static_cast<std::size_t>(j)].apply(-mu, column);
        W.col(j) = column;
        for (Index i = 0; i < m; ++i) {
            const Row<3>& row = rows_[static_cast<std::size_t>(i)];
            A(i, j) = row.velocity(column) - row.bias;
        }
    }
    mlcp_.q.resize(m);
    mlcp_.lo.resize(m);
    mlcp_.hi.resize(m);
    for (Index i = 0; i < m; ++i) {
        const Row<3>& row = rows_[static_cast<std::size_t>(i)];
        mlcp_.q[i] = row.velocity(a);
        mlcp_.lo[i] = row.lo, mlcp_.hi[i] = row.hi;
    }
    // two discs with one centre have no normal, and so no force
    if (!A.allFinite() || !mlcp_.q.allFinite()) return Status::infeasible;
    if (symmetric) A = ((A + A.transpose()) / 2).eval();  // to the bit
    mlcp_.A = A.sparseView();
    if (symmetric) {
        solution_ = dantzig(mlcp_);
    } else if (!as_before(A)) {
        solution_.lambda.setZero(m);
        if (boxes_.empty()) {
            solution_ = lemke(mlcp_);
        } else {  // guesses first: two corners that stick repeat each other's row
            find_(mlcp_, boxes_, 1e-9 * length_, solution_);
            if (solution_.status != Status::solved)
                walk_(mlcp_, boxes_, 1e-9 * length_, solution_);
        }
        guess_ = solution_.lambda;
    }
    work.pivots += solution_.iterations;
    if (solution_.status != Status::solved) return solution_.status;
    for (Index j = 0; j < m; ++j)
        for (Index i = 0; i < a.size(); ++i) a[i] += W(i, j) * solution_.lambda[j];
    return Status::solved;
}
//! [accelerations]

//! [as_before]
/// What pushed, stuck and gave way a moment ago does so now: one factor, and a look.
bool AccelerationLevel::as_before(const MatX& A)
{
    const Index m = A.rows();
    solution_.status = Status::iteration_limit;
    solution_.residual = infinity;
    if (guess_.size() != m) return false;
    MatX columns = A;  // a row at its bound rides on that of its normal
    VecX lambda = guess_, at_bound = VecX::Zero(m);
    std::vector<char> is_bound(static_cast<std::size_t>(m), 0);
    for (const FrictionBox& box : boxes_) {
        const Real most = box.mu * lambda[box.normal];
        if (std::abs(lambda[box.row]) < most * (1 - 1e-12)) continue;
        is_bound[static_cast<std::size_t>(box.row)] = 1;
        if (most > 0) at_bound[box.row] = lambda[box.row] > 0 ? box.mu : -box.mu;
        lambda[box.row] = at_bound[box.row] * lambda[box.normal];
        columns.col(box.normal) += at_bound[box.row] * A.col(box.row);
    }
    std::vector<Index> free;
    for (Index i = 0; i < m; ++i)
        if (is_bound[static_cast<std::size_t>(i)] == 0 &&
            (mlcp_.lo[i] < 0 || lambda[i] > 0))
            free.push_back(i);
    // the change alone: where rows repeat each other it keeps to what they shared
    const auto n = static_cast<Index>(free.size());
    MatX block(n, n);
    VecX right(n);
    for (Index i = 0; i < n; ++i) {
        const Index row = free[static_cast<std::size_t>(i)];
        right[i] = -mlcp_.q[row];
        for (Index j = 0; j < m; ++j) right[i] -= A(row, j) * lambda[j];
        for (Index j = 0; j < n; ++j)
            block(i, j) = columns(row, free[static_cast<std::size_t>(j)]);
    }
    const VecX change = Eigen::FullPivLU<MatX>(block).solve(right);
    for (Index i = 0; i < n; ++i)
        lambda[free[static_cast<std::size_t>(i)]] += change[i];
    for (const FrictionBox& box : boxes_)
        if (is_bound[static_cast<std::size_t>(box.row)] != 0)
            lambda[box.row] = at_bound[box.row] * lambda[box.normal];
    if (!accept_coulomb(mlcp_, boxes_, {1e-9, 1e-9 * length_}, lambda, solution_))
        return false;
    guess_ = solution_.lambda;
    return true;
}
//! [as_before]

bool AccelerationLevel::impact(JointedScene& scene)
{
    Bodies<3>& bodies = scene.bodies;
    bool hits = false;
    Real e = 0;
    std::vector<Row<3>> rows;
    for (const PointJoint& joint : scene.joints)
        if (joint.kind == ConstraintKind::bilateral)
            rows.push_back(
                bilateral(joint_constraint(bodies.x, joint), bodies.inverse_mass));
    for (const PushJoint& push : near_) {
        const Constraint<3> c = gap_of(push, bodies.x);
        if (c.C > settings.gap * length_) continue;
        const auto normal = static_cast<int>(rows.size());
        rows.push_back(unilateral(c, bodies.inverse_mass));
        const Real approach = -rows.back().velocity(bodies.u);
        if (!(rows.back().inverse_effective_mass() > 0)) {
            rows.pop_back();
            continue;
        }
        // what comes slowly stops; it would sink in at its speed forever
        hits = hits || approach > 1e-9 * length_;
        if (approach > settings.rest_speed * length_)
            e = std::max(e, push.surface.restitution);
        if (!(push.surface.friction > 0)) continue;
        const Constraint<3> along = drag_of(push, c, normal, bodies.x, bodies.u).c;
        Row<3> drag = bilateral(along, bodies.inverse_mass, -along.speed);
        drag.bounded_by = normal;
        drag.friction = push.surface.friction;
        rows.push_back(drag);
    }
    if (!hits) return false;
    ++work.impacts;
    rigid::impact(rows, e, ImpactLaw::common, find_, bodies.u);
    return true;
}

Status AccelerationLevel::move(const JointedScene& scene, Real h, VecX& x, VecX& u)
{
    return order_four(h, x, u, [&](const VecX& where, const VecX& how, VecX& a) {
        return accelerations(scene, where, how, a);
    });
}

Real AccelerationLevel::open(const JointedScene& scene, const VecX& x,
                             const VecX& u) const
{
    Real least = infinity;
    std::size_t next = 0;
    for (std::size_t i = 0; i < near_.size(); ++i) {
        const Constraint<3> c = gap_of(near_[i], x);
        const bool is_closed = next < closed_.size() && closed_[next].joint == i;
        if (!is_closed) {
            const Row<3> row = bilateral(c, scene.bodies.inverse_mass);
            if (row.velocity(u) < 0) least = std::min(least, c.C);
            continue;
        }
        const int slides = closed_[next++].slides;
        if (slides == 0) continue;
        const Drag drag = drag_of(near_[i], c, 0, x, u);
        const Real v =
            bilateral(drag.c, scene.bodies.inverse_mass).velocity(u) - drag.c.speed;
        least = std::min(least, slides * v);
    }
    return least;
}

Status AccelerationLevel::advance(JointedScene& scene, Real h)
{
    require_step(h);
    require_valid(scene);
    Bodies<3>& bodies = scene.bodies;
    Real left = h;
    for (int events = 0; left > 0; ++events) {
        if (events >= settings.most_events) return Status::iteration_limit;
        const Real length = typical_length(scene),
                   reach = closing_reach(scene, length, left);
        close(scene, 0.05 * length + reach);
        if (impact(scene))  // it may have made something faster
            close(scene, 0.05 * length +
                             std::max(reach, closing_reach(scene, length, left)));
        VecX x = bodies.x, u = bodies.u;
        Status status = move(scene, left, x, u);
        if (status != Status::solved) return status;
        Real part = left;
        if (const Real here = open(scene, x, u); here < 0) {
            ++work.events;
            Moment moment(left, open(scene, bodies.x, bodies.u), here);
            for (Real at; (at = moment.next(1e-13 * h)) > 0;) {
                VecX x_at = bodies.x, u_at = bodies.u;
                status = move(scene, at, x_at, u_at);
                if (status != Status::solved) return status;
                if (moment.take(at, open(scene, x_at, u_at))) x = x_at, u = u_at;
            }
            part = moment.past;
        }
        if (!x.allFinite() || !u.allFinite()) return Status::iteration_limit;
        bodies.x = x, bodies.u = u;
        left -= part;
    }
    return Status::solved;
}

}  // namespace rigid
