#include "chapters/30_elastic_bodies/elastic_contact.hpp"

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

void ElasticContacts::add_contact(const ElasticScene& scene, CompliantRow<2> row,
                                  const Vec2& normal, Real gap, Real h)
{
    const Index a = row.rigid.a, b = row.rigid.b;
    const auto along = [&](const Vec2& n) {
        row.along = n;
        if (a != world)
            set_body(scene, a, -block_of(scene, a, row.point, n), true, row.rigid);
        if (b != world)
            set_body(scene, b, block_of(scene, b, row.point, n), false, row.rigid);
    };
    along(normal);
    row.gap = gap;
    row.rigid.bias = bias_of(row, scene.elastic, h);
    if (row.is_stuck(scene.elastic, scene.bodies.u)) return;
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
        CompliantRow<2> row;
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
                CompliantRow<2> row;
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
                CompliantRow<2> row;
                row.rigid.a = a, row.rigid.b = b, row.point = m.points[i].point;
                add_contact(scene, row, m.normal, m.points[i].gap, h);
            }
        }
    }
    const std::size_t before = rows.size();
    // A node belongs to two edges; a push that is there already is not added again.
    const auto is_new = [&](const CompliantRow<2>& row) {
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
                CompliantRow<2> row;
                row.rigid.a = a, row.rigid.b = world;
                // on the edge itself: halfway into an overlap another node is near
                row.point = m.points[i].point +
                            (m.points[i].gap / 2 + scene.skin) * m.normal;
                const Real s = std::clamp<Real>(
                    along.dot(row.point - p) / (length * length), 0, 1);
                const bool at_first = s<1e-3, at_second = s> 1 - 1e-3;
                row.count = at_first || at_second ? 1 : 2;
                row.node = {at_second ? second : first, second};
                row.share[0] = row.count == 1 ? 1 : 1 - s,
                row.share[1] = row.count == 1 ? 0 : s;
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
            CompliantRow<2> row;
            row.rigid.b = world, row.count = 1, row.node = {first, first};
            row.share[0] = 1, row.point = soft.at(first) - scene.skin * wall.normal;
            add_contact(scene, row, wall.normal, gap, h);
        }
}
//! [find]

//! [rows]
/// (30.19) and chapter 13: λ of all rows at the velocities v and u.
void ElasticContacts::solve_rows(const VecX& v, const VecX& u, bool same)
{
    const auto m = static_cast<Index>(rows.size());
    mlcp_.q.resize(m), mlcp_.lo.resize(m), mlcp_.hi.resize(m);
    boxes_.clear();
    for (Index i = 0; i < m; ++i) {
        const CompliantRow<2>& row = rows[static_cast<std::size_t>(i)];
        mlcp_.q[i] = row.velocity(v, u);
        mlcp_.lo[i] = row.rigid.lo, mlcp_.hi[i] = row.rigid.hi;
        if (row.rigid.bounded_by >= 0)
            boxes_.push_back({i, row.rigid.bounded_by, row.rigid.friction});
    }
    if (!same) {
        mlcp_.A.resize(m, m);
        for (Index i = 0; i < m; ++i) {
            mlcp_.A.startVec(i);
            for (Index j = 0; j < m; ++j)
                if (const Real a = entry(static_cast<std::size_t>(i),
                                         static_cast<std::size_t>(j));
                    a != 0 || i == j)
                    mlcp_.A.insertBack(i, j) = a;
        }
        mlcp_.A.finalize();
    }
    friction_active_sets(mlcp_, boxes_,
                         {.tolerance = 1e-11, .enough = 1e-10, .late = 1e-6},
                         memory_, solution);
}
//! [rows]

//! [step]
void ElasticContacts::step(ElasticScene& scene, Real h)
{
    rigid::require_valid(StepSettings{.h = h}, scene.gravity, 0);
    require_bodies(scene);
    require_valid(scene.friction, scene.skin, margin);
    ElasticBody<2>& soft = scene.elastic;
    rigid::require_valid(soft, solver.settings);
    if (outline_of_ != soft.model.mesh().elements) {
        outline_of_ = soft.model.mesh().elements;
        outline_ = outline(soft.model.mesh());
    }
    find_rows(scene, h);
    Bodies<3>& bodies = scene.bodies;
    for (Index k = 0; k < bodies.count(); ++k) {  // u*
        if (!bodies.can_move(k)) continue;
        bodies.velocity(k).head<2>() += h * scene.gravity;
        bodies.velocity(k) += h * bodies.apply_inverse_mass(k, bodies.force(k));
    }
    iterate(soft, bodies, h, [this](const VecX& v, const VecX& u, bool same) {
        solve_rows(v, u, same);
    });
    for (Index k = 0; k < bodies.count(); ++k)
        bodies.integrate(k, bodies.velocity(k), h);
}
//! [step]

}  // namespace rigid
