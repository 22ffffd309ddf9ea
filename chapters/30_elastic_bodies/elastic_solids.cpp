// The functions of elastic_solids.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/30_elastic_bodies/elastic_solids.hpp"

#include <numeric>

namespace rigid {

//! [contact]
void ElasticSolids::add_contact(const ElasticSpace& scene, CompliantRow<3> row,
                                Index k, const Vec3& normal, Real h)
{
    const auto along = [&](const Vec3& n) {
        row.along = n;
        if (k == world) return;
        // at the point of the core, as the elastic body is: no moment is lost
        row.rigid.Ja = -point_row(rotation_of(scene.bodies.x, k),
                                  row.point - centre_of(scene.bodies.x, k), n);
        row.rigid.Wa = scene.bodies.inverse_mass.segment<6>(6 * k).cwiseProduct(
            row.rigid.Ja.transpose());
    };
    row.rigid.a = k, row.rigid.b = world;
    along(normal);
    row.rigid.bias = bias_of(row, scene.elastic, h);
    if (row.is_stuck(scene.elastic, scene.bodies.u)) return;
    rows.push_back(row);
    if (!(scene.soft_friction > 0)) return;
    row.rigid.bias = 0;
    row.rigid.bounded_by = static_cast<int>(rows.size()) - 1;
    row.rigid.friction = scene.soft_friction;
    const Vec3 first = across(normal);
    for (const Vec3& t : {first, cross(normal, first)}) {
        along(t);
        rows.push_back(row);
    }
}
//! [contact]

bool ElasticSolids::is_near(const ElasticSpace& scene, Index k, const Vec3& centre,
                            Real radius) const
{
    const Real reach =
        touching.reach[static_cast<std::size_t>(k)] + radius + scene.skin + margin;
    return (centre - centre_of(scene.bodies.x, k)).squaredNorm() <= reach * reach;
}

/// The points of touch_ as contacts: of a node, or of a triangle those that are no node.
void ElasticSolids::take_touch(const ElasticSpace& scene, Index k, int at,
                               bool is_node, Real h)
{
    for (int i = 0; i < touch_.count; ++i) {
        const TouchPoint& p = touch_.points[static_cast<std::size_t>(i)];
        if (!(p.gap < margin)) continue;
        CompliantRow<3> row;
        row.point = p.on_b, row.gap = p.gap;
        if (is_node) {
            row.count = 1, row.node[0] = at, row.share[0] = 1;
            add_contact(scene, row, k, touch_.normal, h);
            continue;
        }
        const std::array<int, 3>& corners =
            triangles_[static_cast<std::size_t>(at)];
        const Vec3 o = scene.elastic.at(corners[0]),
                   e = scene.elastic.at(corners[1]) - o,
                   f = scene.elastic.at(corners[2]) - o, d = p.on_b - o;
        const Vec3 n = cross(e, f);
        const Real size = n.squaredNorm();
        if (!(size > 0) || touch_.normal.dot(n) > 0.2 * std::sqrt(size))
            continue;  // from within: another triangle has it
        const Real s = std::clamp<Real>(cross(d, f).dot(n) / size, 0, 1),
                   t = std::clamp<Real>(cross(e, d).dot(n) / size, 0, 1 - s);
        if (std::max({1 - s - t, s, t}) > 1 - 1e-3) continue;  // a node has it
        bool is_there = false;  // what lies on an edge lies on two triangles
        const Real same = 1e-3 * std::sqrt(size);
        for (std::size_t r = first_of_triangles_; r < rows.size(); ++r)
            is_there =
                is_there || (rows[r].rigid.a == k &&
                             (rows[r].point - p.on_b).squaredNorm() <= same * same);
        if (is_there) continue;
        row.count = 3, row.node = corners, row.share = {1 - s - t, s, t};
        add_contact(scene, row, k, touch_.normal, h);
    }
}

//! [nodes]
void ElasticSolids::touch_nodes(const ElasticSpace& scene, Real h)
{
    const TouchSettings how{margin, 0.01 * margin};
    const auto K = scene.bodies.count();
    ball_.hull.vertices.assign(1, Vec3(0, 0, 0));
    ball_.hull.radius = ball_.reach = scene.skin;
    for (const int i : nodes_) {
        const Vec3 p = scene.elastic.at(i);
        node_.place(ball_, p, Mat3::Identity());
        for (const SolidWall& wall : scene.walls) {
            collide(wall, node_, how, room_, touch_);
            take_touch(scene, world, i, true, h);
        }
        for (Index k = 0; k < K; ++k) {
            if (!is_near(scene, k, p, 0)) continue;
            for (const PlacedSolid& solid :
                 touching.solids[static_cast<std::size_t>(k)]) {
                collide(solid, node_, how, room_, touch_);
                take_touch(scene, k, i, true, h);
            }
        }
        for (const auto& mesh : scene.meshes) {
            collide(*mesh, node_, TouchNames(ground_.form, ball_).count(), how,
                    room_, touch_, ground_);
            for (std::size_t m = 0; m < ground_.count; ++m) {
                touch_.normal = ground_.manifolds[m].normal;
                keep_four(ground_.manifolds[m].points, how.slack, touch_);
                take_touch(scene, world, i, true, h);
            }
        }
    }
}
//! [nodes]

void ElasticSolids::touch_triangles(const ElasticSpace& scene, Real h)
{
    first_of_triangles_ = rows.size();
    const TouchSettings how{margin, 0.01 * margin};
    const auto K = scene.bodies.count();
    flat_.form.hull.radius = scene.skin;
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
        std::array<Vec3, 3> p;
        for (std::size_t c = 0; c < 3; ++c)
            p[c] = scene.elastic.at(triangles_[t][c]);
        const Vec3 centre = (p[0] + p[1] + p[2]) / 3;
        Real radius = 0;
        for (const Vec3& q : p) radius = std::max(radius, (q - centre).norm());
        bool some = !scene.meshes.empty();
        for (Index k = 0; k < K && !some; ++k)
            some = is_near(scene, k, centre, radius);
        const Vec3 n = cross(p[1] - p[0], p[2] - p[0]);
        if (!some || !(n.squaredNorm() > 0)) continue;
        flat_.form.normals[0] = n.normalized();
        for (std::size_t c = 0; c < 3; ++c) {
            flat_.form.hull.vertices[c] = p[c];
            const Vec3 way = p[(c + 1) % 3] - p[c];
            flat_.form.directions[c] = way.normalized();
            flat_.form.reach = std::max(c == 0 ? 0 : flat_.form.reach, way.norm());
        }
        flat_.placed.place(flat_.form, {0, 0, 0}, Mat3::Identity());
        for (Index k = 0; k < K; ++k) {
            if (!is_near(scene, k, centre, radius)) continue;
            for (const PlacedSolid& solid :
                 touching.solids[static_cast<std::size_t>(k)]) {
                collide(solid, flat_.placed, how, room_, touch_);
                take_touch(scene, k, static_cast<int>(t), false, h);
            }
        }
        for (const auto& mesh : scene.meshes) {
            collide(*mesh, flat_.placed,
                    TouchNames(ground_.form, flat_.form).count(), how, room_,
                    touch_, ground_);
            for (std::size_t m = 0; m < ground_.count; ++m) {
                touch_.normal = ground_.manifolds[m].normal;
                keep_four(ground_.manifolds[m].points, how.slack, touch_);
                take_touch(scene, world, static_cast<int>(t), false, h);
            }
        }
    }
}

void ElasticSolids::find_rigid_rows(const ElasticSpace& scene, Real h)
{
    moving_.resize(static_cast<std::size_t>(scene.bodies.count()));
    std::iota(moving_.begin(), moving_.end(), 0);
    now_.length = typical_length(scene);
    touching.begin_with(scene, margin, h, moving_, now_);
    evaluate_constraints(scene, now_);
    for (const Constraint<6>& c : now_.constraints) {
        const bool pushes = c.kind == ConstraintKind::unilateral;
        const Real bias = !has_error(c.kind) ? own_bias(c, h)
                          : pushes           ? bias_of(c.C, h)
                                             : c.C / h;
        rows.emplace_back();
        rows.back().rigid = row_of(c, scene.bodies.inverse_mass, bias, h);
        rows.back().gap = c.C;
    }
}

void ElasticSolids::find_rows(const ElasticSpace& scene, Real h)
{
    rows.clear();
    find_rigid_rows(scene, h);
    touch_nodes(scene, h);
    touch_triangles(scene, h);
}

//! [rows]
/// (30.19) and chapter 24: λ of all rows at the velocities v and u.
void ElasticSolids::solve_rows(const VecX& v, const VecX& u, bool same)
{
    const std::size_t m = rows.size();
    if (!same) {
        cones.begin(m);
        for (std::size_t i = 0; i < m; ++i) {
            const Row<6>& row = rows[i].rigid;
            cones.rows[i].lo = row.lo, cones.rows[i].hi = row.hi;
            if (row.bounded_by >= 0) {
                cones.feedback[i].friction = row.friction;
                cones.feedback[i].bounding = row.bounded_by - static_cast<int>(i);
            }
            for (std::size_t j = 0; j <= i; ++j)
                cones.A[i * m + j] = cones.A[j * m + i] = entry(i, j);
        }
    }
    for (std::size_t i = 0; i < m; ++i) {
        cones.q[static_cast<Index>(i)] = rows[i].velocity(v, u);
        cones.rows[i].lambda = solution.lambda[static_cast<Index>(i)];
    }
    cones.solve(enough, same, solution);
}
//! [rows]

//! [step]
void ElasticSolids::step(ElasticSpace& scene, Real h)
{
    rigid::require_valid(StepSettings{.h = h}, scene.gravity, 0);
    require_bodies(scene);
    require_valid(scene.soft_friction, scene.skin, margin);
    ElasticBody<3>& soft = scene.elastic;
    rigid::require_valid(soft, solver.settings);
    if (triangles_of_ != soft.model.mesh().elements) {
        triangles_of_ = soft.model.mesh().elements;
        triangles_ = surface_triangles(soft.model.mesh());
        nodes_ = surface_nodes(soft.model.mesh());
    }
    find_rows(scene, h);
    Bodies<6>& bodies = scene.bodies;
    for (Index k = 0; k < bodies.count(); ++k) {  // u*
        if (!(bodies.inverse_mass[6 * k] > 0)) continue;
        bodies.velocity(k).head<3>() += h * scene.gravity;
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
