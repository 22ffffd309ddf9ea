#include "chapters/29_elastic_bodies/elastic_contact.hpp"

#include "chapters/11_rotation/point_constraints.hpp"
#include "chapters/11_rotation/rigid_constraints.hpp"
#include "chapters/12_contact_manifolds/wall_manifold.hpp"

namespace rigid {

namespace {

/// J of a push along n at p on rigid body k.
RowVec<3> block_of(const RigidScene& scene, Index k, const Vec2& p, const Vec2& n)
{
    return point_row(p - scene.bodies.x.segment<2>(3 * k), n);
}

void set_body(const RigidScene& scene, Index k, const RowVec<3>& J, bool is_a,
              Row<3>& row)
{
    (is_a ? row.a : row.b) = k;
    (is_a ? row.Ja : row.Jb) = J;
    (is_a ? row.Wa : row.Wb) =
        scene.bodies.inverse_mass.segment<3>(3 * k).cwiseProduct(J.transpose());
}

bool are_joined(const RigidScene& scene, Index a, Index b)
{
    for (const PointJoint& joint : scene.joints)
        if (!joint.collides &&
            ((joint.a == a && joint.b == b) || (joint.a == b && joint.b == a)))
            return true;
    return false;
}

}  // namespace

Real CompliantRow::velocity(const VecX& v, const VecX& u) const
{
    Real w = rigid.bias;
    for (int i = 0; i < count; ++i) {
        const auto k = static_cast<std::size_t>(i);
        w += push[k].x() * v[2 * node[k]] + push[k].y() * v[2 * node[k] + 1];
    }
    if (rigid.a != world) w += rigid.Ja.dot(u.segment<3>(3 * rigid.a));
    if (rigid.b != world) w += rigid.Jb.dot(u.segment<3>(3 * rigid.b));
    return w;
}

void ElasticContacts::add_contact(const ElasticScene& scene, CompliantRow row,
                                  const Vec2& normal, Real gap, Real h)
{
    const Index a = row.rigid.a, b = row.rigid.b;
    std::array<Real, 2> share{};
    for (std::size_t i = 0; i < 2; ++i)
        share[i] = row.push[i].x();  // weights of the nodes
    const auto along = [&](const Vec2& n) {
        for (std::size_t i = 0; i < 2; ++i) row.push[i] = share[i] * n;
        if (a != world)
            set_body(scene, a, -block_of(scene, a, row.point, n), true, row.rigid);
        if (b != world)
            set_body(scene, b, block_of(scene, b, row.point, n), false, row.rigid);
    };
    along(normal);
    row.gap = gap;
    row.rigid.bias = (gap > 0 ? gap : repaid * gap) / h;
    rows.push_back(row);
    along(perpendicular(normal));
    row.rigid.bias = 0;
    row.rigid.bounded_by = static_cast<int>(rows.size()) - 1;
    row.rigid.friction = scene.friction;
    rows.push_back(row);
}

//! [find]
void ElasticContacts::find_rows(const ElasticScene& scene, Real h)
{
    const ElasticBody<2>& soft = scene.elastic;
    const auto K = scene.bodies.count();
    rows.clear();
    for (const PointJoint& joint : scene.joints) {
        const Constraint<3> c = joint_constraint(scene.bodies.x, joint);
        CompliantRow row;
        row.rigid = row_of(c, scene.bodies.inverse_mass,
                           has_error(c.kind) ? c.C / h : own_bias(c, h), h);
        rows.push_back(row);
    }
    placed_.move(scene);
    for (Index b = 0; b < K; ++b) {  // rigid bodies, walls and each other
        if (!scene.bodies.can_move(b)) continue;
        for (const HalfSpace& wall : scene.walls) {
            const Manifold m = collide(wall, placed_.of(b), margin);
            for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
                CompliantRow row;
                row.rigid.b = b, row.point = m.points[i].point;
                add_contact(scene, row, m.normal, m.points[i].gap, h);
            }
        }
        for (Index a = 0; a < K; ++a) {
            if (a == b || (scene.bodies.can_move(a) && a > b) ||
                are_joined(scene, a, b))
                continue;
            const Manifold m =
                collide(placed_.of(a), placed_.of(b), {.margin = margin});
            for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
                CompliantRow row;
                row.rigid.a = a, row.rigid.b = b, row.point = m.points[i].point;
                add_contact(scene, row, m.normal, m.points[i].gap, h);
            }
        }
    }
    const std::size_t before = rows.size();
    // A node belongs to two edges; a push that is there already is not added again.
    const auto is_new = [&](const CompliantRow& row) {
        for (std::size_t i = before; i < rows.size(); i += 2)
            if (rows[i].count == 1 && rows[i].rigid.a == row.rigid.a &&
                rows[i].node[0] == row.node[0])
                return false;
        return true;
    };
    for (const auto& [first, second] : outline_) {  // the outline and rigid shapes
        const Vec2 p = soft.at(first), q = soft.at(second), along = q - p;
        const Real length = along.norm();
        if (!(length > 0)) continue;
        const Vec2 out = -perpendicular(along) / length;
        const std::array<Vec2, 2> ends{p, q}, normals{out, -out};
        const Placed edge{ends, normals, scene.skin};
        const Box box = grown(box_of(edge), margin);
        for (Index a = 0; a < K; ++a) {
            const Box& other = placed_.boxes[static_cast<std::size_t>(a)];
            if ((box.low.array() > other.high.array()).any() ||
                (other.low.array() > box.high.array()).any())
                continue;
            const Manifold m = collide(placed_.of(a), edge, {.margin = margin});
            if (m.normal.dot(out) > 0.2)
                continue;  // from within: another edge has it
            for (std::size_t i = 0; i < static_cast<std::size_t>(m.count); ++i) {
                CompliantRow row;
                row.rigid.a = a, row.rigid.b = world, row.point = m.points[i].point;
                const Real s = std::clamp<Real>(
                    along.dot(row.point - p) / (length * length), 0, 1);
                const bool at_first = s<1e-3, at_second = s> 1 - 1e-3;
                row.count = at_first || at_second ? 1 : 2;
                row.node = {at_second ? second : first, second};
                row.push[0].x() = row.count == 1 ? 1 : 1 - s,
                row.push[1].x() = row.count == 1 ? 0 : s;
                if (row.count == 2 || is_new(row))
                    add_contact(scene, row, m.normal, m.points[i].gap, h);
            }
        }
    }
    for (std::size_t w = 0; w < scene.walls.size(); ++w)  // and walls: node by node
        for (const auto& [first, second] : outline_) {
            const HalfSpace& wall = scene.walls[w];
            const Real gap =
                wall.normal.dot(soft.at(first)) - wall.offset - scene.skin;
            if (!(gap < margin)) continue;
            CompliantRow row;
            row.rigid.b = world, row.count = 1, row.node = {first, first};
            row.push[0].x() = 1,
            row.point = soft.at(first) - scene.skin * wall.normal;
            add_contact(scene, row, wall.normal, gap, h);
        }
}
//! [find]

//! [rows]
/// (29.22) and chapter 13: λ of all rows at the velocities v and u.
void ElasticContacts::solve_rows(const ElasticScene& scene, const VecX& v,
                                 const VecX& u)
{
    const auto m = static_cast<Index>(rows.size());
    answer_.resize(std::max(answer_.size(), rows.size()));
    for (std::size_t i = 0; i < rows.size(); ++i) {  // H⁻¹ Jᵀ
        answer_[i].setZero(v.size());
        if (rows[i].count == 0) continue;
        for (std::size_t k = 0; k < static_cast<std::size_t>(rows[i].count); ++k)
            for (int c = 0; c < 2; ++c)
                if (const int at = 2 * rows[i].node[k] + c;
                    !scene.elastic.fixed[static_cast<std::size_t>(at)])
                    answer_[i][at] += rows[i].push[k][c];
        solver.factor.solve(answer_[i]);
    }
    mlcp_.A.resize(m, m);
    mlcp_.q.resize(m), mlcp_.lo.resize(m), mlcp_.hi.resize(m);
    boxes_.clear();
    for (Index i = 0; i < m; ++i) {
        const CompliantRow& row = rows[static_cast<std::size_t>(i)];
        mlcp_.q[i] = row.velocity(v, u);
        mlcp_.lo[i] = row.rigid.lo, mlcp_.hi[i] = row.rigid.hi;
        if (row.rigid.bounded_by >= 0)
            boxes_.push_back({i, row.rigid.bounded_by, row.rigid.friction});
        mlcp_.A.startVec(i);
        for (Index j = 0; j < m; ++j) {
            // the lower half is what counts for both, so that A is symmetric to the bit
            const CompliantRow &one =
                                   rows[static_cast<std::size_t>(std::max(i, j))],
                               &other =
                                   rows[static_cast<std::size_t>(std::min(i, j))];
            const VecX& answer = answer_[static_cast<std::size_t>(std::min(i, j))];
            Real a = i == j ? row.rigid.softness : 0;
            if (other.count > 0)
                for (std::size_t k = 0; k < static_cast<std::size_t>(one.count);
                     ++k)
                    a += one.push[k].x() * answer[2 * one.node[k]] +
                         one.push[k].y() * answer[2 * one.node[k] + 1];
            for (const auto& [body, J] : {std::pair{one.rigid.a, &one.rigid.Ja},
                                          std::pair{one.rigid.b, &one.rigid.Jb}}) {
                if (body == world) continue;
                if (body == other.rigid.a) a += J->dot(other.rigid.Wa);
                if (body == other.rigid.b) a += J->dot(other.rigid.Wb);
            }
            if (a != 0 || i == j) mlcp_.A.insertBack(i, j) = a;
        }
    }
    mlcp_.A.finalize();
    friction_active_sets(mlcp_, boxes_,
                         {.tolerance = 1e-11, .enough = 1e-10, .late = 1e-6},
                         memory_, solution);
}
//! [rows]

//! [step]
void ElasticContacts::step(ElasticScene& scene, Real h)
{
    require_step(h);
    require_bodies(scene);
    for (const auto& [value, name] :
         {std::pair{scene.friction, "friction"}, {scene.skin, "skin"}})
        if (!(value >= 0 && value < infinity))
            throw std::invalid_argument(
                "the " + std::string(name) + " of an elastic scene is " +
                shortest(value) + "; it must be zero or positive");
    ElasticBody<2>& soft = scene.elastic;
    require_valid(soft, solver.settings);
    if (outline_of_ != soft.model.mesh().elements) {
        outline_of_ = soft.model.mesh().elements;
        outline_ = outline(soft.model.mesh());
    }
    find_rows(scene, h);
    Bodies<3>& bodies = scene.bodies;
    for (Index k = 0; k < bodies.count(); ++k)  // u*
        if (bodies.can_move(k))
            bodies.velocity(k).head<2>() +=
                h * scene.gravity +
                h * bodies.inverse_mass[3 * k] * bodies.force(k).head<2>();
    x0_ = soft.x;
    solver.begin(soft, h);
    report = {};
    solution.lambda.setZero(static_cast<Index>(rows.size()));
    for (report.iterations = 1; report.iterations <= most; ++report.iterations) {
        solver.look(soft);
        if (!solver.prepare(soft)) {
            report.status = Status::singular;
            break;
        }
        change_ = solver.r;
        solver.factor.solve(change_);
        soft.x += change_;
        v_ = (soft.x - x0_) / h;
        for (Index i = 0; i < v_.size(); ++i)
            if (soft.fixed[static_cast<std::size_t>(i)]) v_[i] = soft.v[i];
        solve_rows(scene, v_, bodies.u);
        for (std::size_t i = 0; i < rows.size(); ++i)
            if (rows[i].count > 0)
                soft.x += (h * solution.lambda[static_cast<Index>(i)]) * answer_[i];
        // (29.21) at the new place: is it an answer?
        solver.look(soft);
        left_ = solver.r;
        for (std::size_t i = 0; i < rows.size(); ++i)
            for (std::size_t k = 0; k < static_cast<std::size_t>(rows[i].count);
                 ++k)
                for (int c = 0; c < 2; ++c)
                    if (const int at = 2 * rows[i].node[k] + c;
                        !soft.fixed[static_cast<std::size_t>(at)])
                        left_[at] += h * solution.lambda[static_cast<Index>(i)] *
                                     rows[i].push[k][c];
        report.residual = solver.residual_of(soft, left_);
        if (report.residual <= tolerance) {
            report.status = rows.empty() ? Status::solved : solution.status;
            break;
        }
    }
    for (Index i = 0; i < soft.x.size(); ++i)
        if (!soft.fixed[static_cast<std::size_t>(i)])
            soft.v[i] = (soft.x[i] - x0_[i]) / h;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Row<3>& row = rows[i].rigid;
        const Real lambda = solution.lambda[static_cast<Index>(i)];
        if (row.a != world) bodies.u.segment<3>(3 * row.a) += row.Wa * lambda;
        if (row.b != world) bodies.u.segment<3>(3 * row.b) += row.Wb * lambda;
    }
    for (Index k = 0; k < bodies.count(); ++k)
        bodies.integrate(k, bodies.velocity(k), h);
}
//! [step]

}  // namespace rigid
