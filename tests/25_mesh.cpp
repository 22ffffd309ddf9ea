/// Chapter 25: a ground of triangles.

#include "tests/no_allocation.hpp"

#include "chapters/25_world_in_space/mesh_scenes.hpp"
#include "chapters/25_world_in_space/space_sleep.hpp"

#include "tests/catch.hpp"
#include "tests/sentence.hpp"
#include "tests/solids.hpp"

#include <set>

using namespace rigid;

namespace {

using Ground = std::shared_ptr<const TriangleMesh>;

Hull solid_on_mesh(Random& random, int kind)
{
    if (kind == 0) return solid_ball(random.uniform(0.1, 0.5));
    if (kind == 1) return solid_capsule(0.8, random.uniform(0.05, 0.3));
    if (kind == 2) return solid_box(Vec3(0.5, 0.5, 0.5) + any_vector(random, 0.4));
    std::vector<Vec3> cloud;
    for (int i = 0; i < 10; ++i) cloud.push_back(any_vector(random, 0.5));
    return solid_hull(cloud);
}

/// A floor of 50 × 12 cells of half a metre.
Ground floor_of_triangles() { return flat_mesh(50, 12, 0.5); }

/// What slides or rolls for four seconds over some twenty edges: the scene on a plane.
SpaceScene what_slides(int kind, Real mu)
{
    SpaceScene scene;
    const Real low = kind == 0 ? 0.5 : kind == 1 ? 0.2 : 0.1;
    const Hull hull = kind == 0   ? solid_ball(0.5)
                      : kind == 1 ? solid_capsule(1, 0.2)
                                  : solid_box({1, 0.2, 1});
    add_body(scene, {hull}, 1000.0, {-9.93, low, 0.03});
    scene.bodies.u.head<3>() = Vec3(3, 0, kind == 1 ? 0.5 : 0.3);
    scene.length = 1;
    add_floor(scene, mu);
    return scene;
}

/// How far the way over a mesh is from that over the plane, at most [m].
Real strayed(SpaceScene scene, const Ground& mesh, Real mu, bool as_one, TouchingCones method, int steps)
{
    SpaceScene other = scene;
    add_ground(other, mesh, mu);
    TouchingCones plane = method;
    method.contacts.ground.as_one = as_one;
    StepData<6> now, there;
    Real farthest = 0;
    for (int i = 0; i < steps; ++i) {
        step(scene, {.h = sixtieth}, plane, now);
        step(other, {.h = sixtieth}, method, there);
        farthest = std::max(farthest, (scene.bodies.x - other.bodies.x).cwiseAbs().maxCoeff());
    }
    return farthest;
}

TouchingCones many_sweeps()
{
    TouchingCones method;
    method.solver.sweeps = {2000, 1e-14};
    return method;
}

Ground bumpy(Random& random, int cells, Real cell, Real high)
{
    return height_field(cells, cells, cell, [&](Real, Real) { return random.uniform(0, high); });
}

/// All points where a solid touches a mesh.
struct OnMesh {
    MeshMemory memory;
    ClipRoom room;
    SolidTouch touch;

    const OnMesh& look(const TriangleMesh& mesh, const PlacedSolid& solid, Real margin, Real slack)
    {
        const int names = TouchNames(memory.form, *solid.form).count();
        collide(mesh, solid, names, {margin, slack}, room, touch, memory);
        return *this;
    }
    Real deepest() const
    {
        Real gap = infinity;
        for (std::size_t m = 0; m < memory.count; ++m)
            for (const TouchPoint& p : memory.manifolds[m].points) gap = std::min(gap, p.gap);
        return gap;
    }
};

Ground one_triangle(const std::vector<Vec3>& corners) { return triangle_mesh(corners, {{0, 1, 2}}); }

Ground mirrored(const TriangleMesh& mesh)
{
    std::vector<Vec3> vertices = mesh.vertices;
    std::vector<TriangleMesh::Triangle> triangles = mesh.triangles;
    for (Vec3& p : vertices) p.z() = -p.z();
    for (TriangleMesh::Triangle& t : triangles) std::swap(t[1], t[2]);
    return triangle_mesh(vertices, triangles);
}

Hull mirrored(Hull hull)
{
    for (Vec3& p : hull.vertices) p.z() = -p.z();
    for (std::vector<int>& face : hull.faces) std::reverse(face.begin(), face.end());
    return hull;
}

/// From p to the nearest point of a triangle, by a search over it: no code of the book.
Real distance_by_force(const TriangleMesh& mesh, int t, const Vec3& p)
{
    Real nearest = infinity;
    const int parts = 24;
    Vec3 centre(1.0 / 3, 1.0 / 3, 1.0 / 3);
    Real size = 1;
    // a triangle of weights around the best so far, smaller by a third each time
    for (int round = 0; round < 40; ++round, size *= 0.7) {
        Vec3 best = centre;
        for (int i = 0; i <= parts; ++i)
            for (int k = 0; k <= parts - i; ++k) {
                Vec3 w(i * 1.0 / parts, k * 1.0 / parts, 0);
                w.z() = 1 - w.x() - w.y();
                w = centre + size * (w - Vec3(1.0 / 3, 1.0 / 3, 1.0 / 3));
                w = w.cwiseMax(0);
                w /= w.sum();
                const Vec3 at =
                    w.x() * mesh.corner(t, 0) + w.y() * mesh.corner(t, 1) + w.z() * mesh.corner(t, 2);
                if ((at - p).norm() < nearest) nearest = (at - p).norm(), best = w;
            }
        centre = best;
    }
    return nearest;
}

}  // namespace

TEST_CASE("what slides and rolls over a floor of triangles goes as on a plane", "[idea]")
{
    const Ground mesh = floor_of_triangles();
    for (const Real mu : {0.0, 0.5})
        for (int kind = 0; kind < 3; ++kind) {
            INFO("kind " << kind << ", mu " << mu);
            // the sum of what rounding leaves in 240 steps
            CHECK(strayed(what_slides(kind, mu), mesh, mu, true, many_sweeps(), 240) < 1e-11);
        }
}

TEST_CASE("triangles that answer each for itself stop what slides over them", "[house]")
{
    const Ground mesh = floor_of_triangles();
    for (const Real mu : {0.0, 0.5})
        for (int kind = 0; kind < 3; ++kind) {
            INFO("kind " << kind << ", mu " << mu);
            CHECK(strayed(what_slides(kind, mu), mesh, mu, false, many_sweeps(), 240) > 0.1);
        }
}

TEST_CASE("the nearest point of a mesh is among its contacts and all of them are nearest around them",
          "[idea]")
{
    Random random(5);
    OnMesh on;
    int over_edges = 0, over_corners = 0;
    for (int round = 0; round < 100; ++round) {
        const Ground mesh = bumpy(random, 4, 0.5, 0.6);
        Vec3 middle = Vec3(0, 0.6, 0) + 0.3 * any_vector(random, 1);
        if (round % 2 == 0) {  // over the highest of the inner vertices
            Vec3 top(0, -1, 0);
            for (const Vec3& p : mesh->vertices)
                if (p.cwiseAbs().maxCoeff() < 0.9 && p.y() > top.y()) top = p;
            middle = top + Vec3(0, 0.15, 0) + any_vector(random, 0.1);
        }
        const SolidForm form = form_of(solid_ball(0.05));
        PlacedSolid ball;
        ball.place(form, middle, Mat3::Identity());
        Real nearest = infinity;
        int owner = 0;
        for (int t = 0; t < mesh->count(); ++t)
            if (const Real d = distance_by_force(*mesh, t, middle); d < nearest) nearest = d, owner = t;
        if (behind(*mesh, owner, ball)) continue;  // it is under the ground
        on.look(*mesh, ball, 2, 0);
        // the search by force ends at 1e-6 of a cell
        CHECK(std::abs(on.deepest() - (nearest - 0.05)) < 1e-6);
        for (std::size_t m = 0; m < on.memory.count; ++m)
            for (const TouchPoint& p : on.memory.manifolds[m].points) {
                // no point of the mesh that is near this one is nearer to the ball, unless it is on a face
                // that this point is not on: there the mesh rises
                const Real far = (p.on_a - middle).norm();
                int at = 0;
                for (int t = 0; t < mesh->count(); ++t) {
                    if (distance_by_force(*mesh, t, p.on_a) > 1e-5) continue;
                    ++at;
                    for (int k = 0; k < 3; ++k) {
                        const Vec3 way = mesh->corner(t, k) - p.on_a;
                        if (way.norm() > 1e-3) CHECK((p.on_a + 1e-4 * way - middle).norm() > far - 1e-9);
                    }
                }
                over_edges += at == 2 ? 1 : 0;
                over_corners += at > 2 ? 1 : 0;
            }
    }
    CHECK(over_edges > 10);  // it was tried
    CHECK(over_corners > 3);
}

TEST_CASE("a ridge pushes between the normals of its faces and a valley along both", "[idea]")
{
    // two faces that meet along z, at 45° each
    const auto roof = [](Real high) {
        return triangle_mesh(
            {{0, 0, -2}, {0, 0, 2}, {2, -high, -2}, {2, -high, 2}, {-2, -high, -2}, {-2, -high, 2}},
            {{0, 1, 2}, {2, 1, 3}, {4, 5, 0}, {0, 5, 1}});
    };
    const SolidForm form = form_of(solid_ball(0.5));
    PlacedSolid ball;
    OnMesh on;
    for (const Real angle : {-0.7, -0.3, 0.0, 0.5}) {
        const Vec3 u(rigid::sin(angle), rigid::cos(angle), 0);
        ball.place(form, 0.499 * u, Mat3::Identity());
        on.look(*roof(2), ball, 0.01, 1e-4);
        REQUIRE(on.memory.count == 1);
        CHECK((on.memory.manifolds[0].normal - u).norm() < 1e-12);
        CHECK(on.memory.manifolds[0].points.size() == 1);  // two triangles, one point
        CHECK(std::abs(on.deepest() + 0.001) < 1e-12);
    }
    ball.place(form, {0, 0.5 * std::sqrt(2.0), 0}, Mat3::Identity());
    on.look(*roof(-2), ball, 0.01, 1e-4);
    REQUIRE(on.memory.count == 2);
    const Real c = std::sqrt(0.5);
    CHECK((on.memory.manifolds[0].normal - Vec3(-c, c, 0)).norm() < 1e-12);
    CHECK((on.memory.manifolds[1].normal - Vec3(c, c, 0)).norm() < 1e-12);
}

TEST_CASE("a triangle answers for itself or with its face or leaves it to a neighbour", "[idea]")
{
    // a pyramid whose top is at the origin, of four faces; they fall by 45°, or rise
    const auto pyramid = [](Real top) {
        return triangle_mesh({{0, 0, 0}, {1, -top, 1}, {1, -top, -1}, {-1, -top, -1}, {-1, -top, 1}},
                             {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 1}});
    };
    const Ground peak = pyramid(1), pit = pyramid(-1), flat = pyramid(0);
    const Vec3 n = peak->normal(0), up(0, 1, 0);
    REQUIRE((n - Vec3(1, 1, 0).normalized()).norm() < 1e-15);
    // its own normal, and what comes from behind
    CHECK(answer_of(*peak, 0, n) == Answer::of_its_face);
    CHECK(answer_of(*peak, 0, -n) == Answer::of_a_neighbour);
    // at the peak: whatever leans less than the faces
    CHECK(answer_of(*peak, 0, up) == Answer::stays);
    CHECK(answer_of(*peak, 0, Vec3(0.3, 1, 0.2).normalized()) == Answer::stays);
    // the edge between the faces 0 and 1 goes along (1, -1, -1): between their normals, and beyond them
    const Vec3 g = peak->normal(1);
    CHECK(answer_of(*peak, 0, (2 * n + g).normalized()) == Answer::stays);
    CHECK(answer_of(*peak, 0, (2 * g - n).normalized()) == Answer::of_a_neighbour);
    // an edge where the mesh ends pushes any way that the triangle alone allows
    CHECK(answer_of(*peak, 0, Vec3(1, -0.2, 0).normalized()) == Answer::stays);
    // flat: nothing but the normal, at an edge and at a corner
    CHECK(answer_of(*flat, 0, Vec3(-0.2, 1, 0).normalized()) == Answer::of_its_face);
    CHECK(answer_of(*flat, 0, Vec3(-0.2, 1, -0.4).normalized()) == Answer::of_its_face);
    CHECK(answer_of(*flat, 0, up) == Answer::of_its_face);
    // a valley: what is between the normals is answered by the face
    const Vec3 a = pit->normal(0), b = pit->normal(1);
    CHECK(answer_of(*pit, 0, (2 * a + b).normalized()) == Answer::of_its_face);
}

TEST_CASE(
    "a normal stays if the point of the whole mesh that is nearest to a point along it is where it began",
    "[idea]")
{
    Random random(2525);
    int stayed = 0, forbidden = 0;
    for (int round = 0; round < 60; ++round) {
        const Ground bumps = bumpy(random, 4, 0.5, 0.4);
        // one of the nine inner vertices, raised
        const int v = 6 + 5 * (round % 3) + round / 3 % 3;
        std::vector<Vec3> vertices = bumps->vertices;
        vertices[static_cast<std::size_t>(v)].y() += random.uniform(0, 0.6);
        const Ground mesh = triangle_mesh(vertices, bumps->triangles);
        const Vec3 p = mesh->vertex(v), m = (Vec3(0, 1, 0) + any_vector(random, 0.6)).normalized();
        const Vec3 out = p + 0.01 * m;
        Real nearest = infinity;
        for (int t = 0; t < mesh->count(); ++t) nearest = std::min(nearest, distance_by_force(*mesh, t, out));
        const Real short_of = 0.01 - nearest;
        if (short_of > 1e-8 && short_of < 1e-5) continue;  // as good as on the border
        for (int k = mesh->first[static_cast<std::size_t>(v)];
             k < mesh->first[static_cast<std::size_t>(v) + 1]; ++k) {
            const int t = mesh->at[static_cast<std::size_t>(k)];
            // of the triangle alone it is the corner v that lies farthest along m, by something
            bool is_top = true;
            for (const int i : mesh->triangle(t))
                is_top = is_top && (i == v || m.dot(mesh->vertex(i) - p) < -1e-3);
            if (!is_top || mesh->normal(t).dot(m) <= 0) continue;
            CHECK((answer_of(*mesh, t, m) == Answer::stays) == (short_of <= 1e-8));
            short_of <= 1e-8 ? ++stayed : ++forbidden;
        }
    }
    CHECK(stayed > 20);
    CHECK(forbidden > 20);
}

TEST_CASE("a box that leans over the edge of a step is not thrown up by the side of the step", "[idea]")
{
    // the side of the step faces x, its top is the ground; ten strips of both, of a metre
    std::vector<Vec3> vertices;
    std::vector<TriangleMesh::Triangle> triangles;
    for (int i = 0; i <= 10; ++i)
        for (const Vec3& p : {Vec3(-5, 0, i - 5), Vec3(0, 0, i - 5), Vec3(0, -5, i - 5)})
            vertices.push_back(p);
    for (int i = 0; i < 10; ++i)
        for (const int k : {3 * i, 3 * i + 1})
            triangles.push_back({k, k + 3, k + 1}), triangles.push_back({k + 1, k + 3, k + 4});
    const Ground mesh = triangle_mesh(vertices, triangles);
    Random random(9);
    const SolidForm form = form_of(solid_box({1, 1, 1}));
    PlacedSolid box;
    OnMesh on;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 lean = any_vector(random, 0.02);
        const Mat3 R = rotation_matrix(lean);
        Vec3 at = any_vector(random, 0.45);
        // its lowest corner over the top is 1 mm below it
        Real low = infinity;
        for (const Vec3& p : form.hull.vertices) {
            const Vec3 q = R * p;
            if (at.x() + q.x() < 0) low = std::min(low, q.y());
        }
        at.y() = -low - 0.001;
        box.place(form, at, R);
        on.look(*mesh, box, 0.02, 2e-4);
        // the plane of its lowest face sinks by its lean over its width
        CHECK(on.deepest() > -0.001 - 1.5 * lean.norm());
    }
}

TEST_CASE("a box that is deeper in a floor than it reaches over an edge has the corners of a plane", "[idea]")
{
    const Ground mesh = floor_of_triangles();
    Random random(10);
    const SolidForm form = form_of(solid_box({1, 1, 1}));
    PlacedSolid box;
    OnMesh on;
    SolidTouch touch;
    for (int i = 0; i < 1000; ++i) {
        // up to 5 cm deep, and 0 to 5 cm over the next triangles
        const Real cells_x = std::round(random.uniform(-20, 20)), cells_z = std::round(random.uniform(-3, 3));
        const Vec3 more = Vec3(0.025, 0.025, 0.025) + any_vector(random, 0.025);
        const Vec3 at = Vec3(0.5 * cells_x, 0.5, 0.5 * cells_z) + Vec3(more.x(), -more.y(), more.z());
        box.place(form, at, rotation_matrix({0, 0.5 * pi * std::round(random.uniform(0, 4)), 0}));
        on.look(*mesh, box, 0.02, 2e-4);
        REQUIRE(on.memory.count == 1);
        touch.normal = on.memory.manifolds[0].normal;
        CHECK(touch.normal == Vec3(0, 1, 0));
        keep_four(on.memory.manifolds[0].points, 2e-4, touch);
        REQUIRE(touch.count == 4);
        for (int k = 0; k < 4; ++k) {
            const Vec3 way = touch.points[static_cast<std::size_t>(k)].on_b - at;
            CHECK((way.cwiseAbs() - Vec3(0.5, 0.5, 0.5)).norm() < 1e-12);
        }
    }
}

TEST_CASE("ten thousand hulls on a triangle have unit normals that turn and are mirrored with them",
          "[house]")
{
    Random random(11);
    // what differs by less may be cut in another order in a mirror
    const Real same = 1e-9;
    OnMesh on, there, beyond_glass;
    int touched = 0;
    for (int i = 0; i < 10000; ++i) {
        const Hull hull = solid_on_mesh(random, i % 4);
        const SolidForm form = form_of(hull), other = form_of(mirrored(hull));
        const std::vector<Vec3> corners = {any_vector(random, 1), any_vector(random, 1),
                                           any_vector(random, 1)};
        if (cross(corners[1] - corners[0], corners[2] - corners[0]).norm() < 0.01) continue;
        const Ground mesh = one_triangle(corners);
        const Vec3 at = any_vector(random, 0.5), theta = any_vector(random, 1.7);
        const Mat3 R = rotation_matrix(theta);
        PlacedSolid solid;
        solid.place(form, at, R);
        on.look(*mesh, solid, 0.02, same);

        // all of it turned and moved
        const Mat3 Q = rotation_matrix(any_vector(random, 1.7));
        const Vec3 shift = any_vector(random, 3);
        std::vector<Vec3> turned = corners;
        for (Vec3& p : turned) p = Q * p + shift;
        solid.place(form, Q * at + shift, Q * R);
        there.look(*one_triangle(turned), solid, 0.02, same);

        // and in a mirror
        const Vec3 at_mirrored(at.x(), at.y(), -at.z());
        Mat3 S = Mat3::Identity();
        S(2, 2) = -1;
        solid.place(other, at_mirrored, S * R * S);
        beyond_glass.look(*mirrored(*mesh), solid, 0.02, same);

        REQUIRE(on.memory.count == there.memory.count);
        REQUIRE(on.memory.count == beyond_glass.memory.count);
        if (on.memory.count == 0) continue;
        ++touched;
        const Vec3& n = on.memory.manifolds[0].normal;
        CHECK(std::abs(n.norm() - 1) < 1e-12);
        CHECK(n.dot(mesh->normal(0)) > -1e-5);  // a triangle pushes to its front
        // GJK ends at 1e-15 of the squared distance; what is cut near a side keeps that
        CHECK((there.memory.manifolds[0].normal - Q * n).norm() < 1e-6);
        CHECK((beyond_glass.memory.manifolds[0].normal - S * n).norm() < 1e-6);
        CHECK(std::abs(there.deepest() - on.deepest()) < 1e-6);
        CHECK(std::abs(beyond_glass.deepest() - on.deepest()) < 1e-6);
        for (const TouchPoint& p : on.memory.manifolds[0].points) {
            CHECK((p.on_a.allFinite() && p.on_b.allFinite()));
            CHECK(std::abs(n.dot(p.on_b - p.on_a) - hull.radius - p.gap) < 1e-9);
        }
    }
    CHECK(touched > 1000);
}

TEST_CASE("a stack of ten boxes stands on triangles as on a plane", "[house]")
{
    TouchingCones method = exact_cones();
    // boxes of a metre on triangles of 0.37: the residual of the exact answers, 300 times
    CHECK(strayed(box_stack(10, 0.05, 0.5), flat_mesh(10, 10, 0.37), 0.5, true, method, 300) < 1e-9);
    SpaceScene scene = box_stack(10, 0.05, 0.5);
    add_ground(scene, flat_mesh(10, 10, 0.37), 0.5);
    method = {};
    method.solver.sweeps = {500, 1e-6};
    StepData<6> now;
    for (int i = 0; i < 600; ++i) step(scene, {.h = sixtieth}, method, now);
    for (Index k = 0; k < 10; ++k) {
        const Vec3 at = centre_of(scene.bodies.x, k);
        // ten contacts, each closed to a thousandth and as much again of what sweeps leave
        CHECK((at - Vec3(0, static_cast<Real>(k) + 0.5, 0)).norm() < 0.02);
    }
}

TEST_CASE("a hundred solids poured into a bowl of triangles stay above it", "[house]")
{
    SpaceScene scene = heap_on(bowl(40, 0.25, 2), 100, 0.5, 1);
    TouchingCones method;
    method.solver.sweeps = {50, 1e-6};
    StepData<6> now;
    Real deepest = 0;
    for (int i = 0; i < 600; ++i) {
        step(scene, {.h = 1.0 / 120}, method, now);
        if (i < 300) continue;  // they have fallen
        for (const Constraint<6>& c : now.constraints)
            if (c.kind == ConstraintKind::unilateral) deepest = std::max(deepest, -c.C);
    }
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Vec3 at = centre_of(scene.bodies.x, k);
        CHECK(at.y() >
              (at.x() * at.x() + at.z() * at.z()) / 4 + 0.1);  // the thinnest is 0.12 from its middle
    }
    CHECK(deepest < 0.003);  // bodies of half a metre; 1 mm is the slop
}

TEST_CASE("a ball in a trough of flat strips loses half the energy where strips are half as wide", "[idea]")
{
    // strips along z of a cylinder of 4 m: each inner edge turns the way of a ball by an angle φ, and takes
    // sin² φ of its energy; as many edges as 1/φ
    const auto lost = [](int strips) {
        std::vector<Vec3> vertices;
        std::vector<TriangleMesh::Triangle> triangles;
        for (int i = 0; i <= strips; ++i)
            for (const Real z : {-1.0, 1.0}) {
                const Real angle = 2.0 * i / strips - 1;
                vertices.push_back({4 * rigid::sin(angle), 4 * (1 - rigid::cos(angle)), z});
            }
        for (int i = 0; i < strips; ++i) {
            triangles.push_back({2 * i, 2 * i + 1, 2 * i + 2});
            triangles.push_back({2 * i + 2, 2 * i + 1, 2 * i + 3});
        }
        SpaceScene scene;
        add_body(scene, {solid_ball(0.5)}, 1.0,
                 3.5 * Vec3(rigid::sin(-0.6), -rigid::cos(-0.6), 0) + Vec3(0, 4, 0));
        add_ground(scene, triangle_mesh(vertices, triangles), 0);
        TouchingCones method = many_sweeps();
        StepData<6> now;
        // above the bottom, where its centre is half a metre high
        const auto above = [&scene] { return energy(scene) - 9.81 / scene.bodies.inverse_mass[0] * 0.5; };
        const Real before = above();
        for (int i = 0; i < 2500; ++i) step(scene, {.h = 0.0005}, method, now);
        CHECK(scene.bodies.x[0] > 0.5);  // it has been through the bottom
        return (before - above()) / before;
    };
    // the order of a sum of 1/φ terms φ² is one
    const Real coarse = lost(24), middle = lost(48), fine = lost(96);
    CHECK(std::abs(std::log2(coarse / middle) - 1) < 0.15);
    CHECK(std::abs(std::log2(middle / fine) - 1) < 0.15);
}

TEST_CASE("a ball on a slope of triangles rolls five sevenths of its weight", "[house]")
{
    SpaceScene scene = what_slides(0, 0.5);
    scene.bodies.u.setZero();
    add_ground(scene, floor_of_triangles(), 0.5);
    const Real slope = 0.2;
    scene.gravity = 9.81 * Vec3(rigid::sin(slope), -rigid::cos(slope), 0);
    TouchingCones method = many_sweeps();
    StepData<6> now;
    for (int i = 0; i < 120; ++i) step(scene, {.h = sixtieth}, method, now);
    // Symplectic Euler from rest: v = a t to rounding, but for the first step, in which the ball lands on the slop
    CHECK(std::abs(scene.bodies.u[0] - 5.0 / 7 * 9.81 * rigid::sin(slope) * 2) < 1e-9);
}

TEST_CASE("only triangles that are near are looked at however many there are", "[house]")
{
    const auto looked = [](int cells) {
        SpaceScene scene;
        add_body(scene, {solid_ball(0.3)}, 1000.0, {0.1, 0.3, 0.1});
        add_body(scene, {solid_box({1, 0.2, 1})}, 1000.0, {3.1, 0.1, 0.1});
        add_ground(scene, flat_mesh(cells, cells, 0.5), 0.5);
        TouchingCones method;
        StepData<6> now;
        step(scene, {.h = sixtieth}, method, now);
        return std::pair(method.contacts.ground.triangles, method.contacts.ground.boxes);
    };
    const auto [few, boxes] = looked(16);
    const auto [many, more_boxes] = looked(128);
    CHECK(few == many);  // of 512 and of 32,768
    CHECK(few == 2 * 4 + 2 * 9);
    CHECK(more_boxes < 4 * boxes);
}

TEST_CASE("the names of points on a mesh are all different and stay while a body rests", "[house]")
{
    SpaceScene scene = heap_on(bowl(20, 0.5, 3), 20, 0.5, 3);
    scene.meshes.push_back(flat_mesh(8, 8, 1));
    scene.mesh_friction.push_back(0.5);
    TouchingCones method;
    StepData<6> now;
    std::set<std::tuple<Index, Index, Index>> before;
    int kept = 0, all = 0;
    for (int i = 0; i < 600; ++i) {
        step(scene, {.h = sixtieth}, method, now);
        std::set<std::tuple<Index, Index, Index>> names;
        for (const SpaceContact& c : now.contacts) names.emplace(c.a, c.b, c.feature);
        REQUIRE(names.size() == now.contacts.size());
        if (i > 500)
            for (const auto& name : names) ++all, kept += static_cast<int>(before.count(name));
        before = names;
    }
    CHECK(all > 1000);
    CHECK(kept > 0.99 * all);
}

TEST_CASE("triangles that share no vertices are one surface where their corners lie in one place", "[house]")
{
    const Ground mesh = floor_of_triangles();
    std::vector<Vec3> vertices;
    std::vector<TriangleMesh::Triangle> triangles;
    for (int t = 0; t < mesh->count(); ++t) {
        for (int k = 0; k < 3; ++k) vertices.push_back(mesh->corner(t, k));
        triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
    }
    const Ground soup = triangle_mesh(vertices, triangles);
    CHECK(soup->beyond == mesh->beyond);
    for (int kind = 0; kind < 3; ++kind) {
        SpaceScene scene = what_slides(kind, 0.5), other = scene;
        add_ground(scene, mesh, 0.5), add_ground(other, soup, 0.5);
        TouchingCones method, method_other;
        StepData<6> now, there;
        for (int i = 0; i < 120; ++i) {
            step(scene, {.h = sixtieth}, method, now);
            step(other, {.h = sixtieth}, method_other, there);
        }
        CHECK(same_bits(scene.bodies.x, other.bodies.x));
    }
}

TEST_CASE("a triangle has one side", "[idea]")
{
    SpaceScene scene;
    scene.gravity = {0, 9.81, 0};  // from below
    add_body(scene, {solid_ball(0.2)}, 1000.0, {0.1, -1, 0.1});
    add_body(scene, {solid_box({0.5, 0.5, 0.5})}, 1000.0, {2.1, -1, 0.1});
    add_ground(scene, floor_of_triangles(), 0.5);
    TouchingCones method;
    StepData<6> now;
    for (int i = 0; i < 60; ++i) {
        step(scene, {.h = sixtieth}, method, now);
        // until its middle is through: then it is before the ground, and falls on it no more
        if (scene.bodies.x[1] < 0) CHECK(now.contacts.empty());
    }
    CHECK(scene.bodies.x[1] > 1);
    CHECK(scene.bodies.x[7] > 1);
}

TEST_CASE("solids on triangles fall asleep and another ground wakes them", "[house]")
{
    const Ground mesh = bowl(20, 0.5, 3);
    SpaceScene scene = heap_on(mesh, 12, 0.5, 3);
    SleepingCones method;
    StepData<6> now;
    for (int i = 0; i < 1200; ++i) step(scene, {.h = sixtieth}, method, now);
    for (Index k = 0; k < scene.bodies.count(); ++k) REQUIRE(method.contacts.set.is_asleep(k));
    const VecX x = scene.bodies.x;
    step(scene, {.h = sixtieth}, method, now);
    CHECK(same_bits(scene.bodies.x, x));
    scene.meshes = {bowl(20, 0.5, 3)};  // the same form, but another: it may be compared by its pointer alone
    step(scene, {.h = sixtieth}, method, now);
    CHECK(method.contacts.set.is_awake(0));
    for (int i = 0; i < 600; ++i) step(scene, {.h = sixtieth}, method, now);
    REQUIRE(method.contacts.set.is_asleep(0));
    scene.mesh_friction = {0.4};
    step(scene, {.h = sixtieth}, method, now);
    CHECK(method.contacts.set.is_awake(0));
}

TEST_CASE("what is fast stops on triangles and slides over them", "[house]")
{
    for (int kind = 0; kind < 3; ++kind) {
        INFO("kind " << kind);
        SpaceScene scene = what_slides(kind, 0);
        add_ground(scene, floor_of_triangles(), 0);
        SpaceScene slides = scene, without = scene;
        TouchingCones stops = many_sweeps(), goes_on = stops;
        stops.contacts.fast.stop = true;
        StepData<6> now;
        // down, 3 m in a step
        scene.bodies.x.head<3>() = Vec3(0.1, 1.7, 0.1);
        scene.bodies.u.head<3>() = Vec3(5, -200, 3);
        SpaceScene through = scene;
        step(through, {.h = sixtieth}, goes_on, now);
        CHECK(through.bodies.x[1] < -1);
        step(scene, {.h = sixtieth}, stops, now);
        CHECK(stops.contacts.fast.impacts == 1);
        CHECK(scene.bodies.x[1] > 0);
        for (int i = 0; i < 30; ++i) step(scene, {.h = sixtieth}, stops, now);
        CHECK(scene.bodies.x[1] > 0);
        // along: it is fast, but nothing is in its way
        slides.bodies.u.head<3>() = without.bodies.u.head<3>() = Vec3(60, 0, 0);
        stops = goes_on = many_sweeps();
        stops.contacts.fast.stop = true;
        for (int i = 0; i < 15; ++i) {
            step(slides, {.h = sixtieth}, stops, now);
            CHECK(stops.contacts.fast.bodies.size() == 1);
            CHECK(stops.contacts.fast.impacts == 0);
            step(without, {.h = sixtieth}, goes_on, now);
        }
        CHECK(same_bits(slides.bodies.x, without.bodies.x));
        CHECK(slides.bodies.x[0] > 4);
    }
}

TEST_CASE("solids look ahead to triangles", "[house]")
{
    const auto deepest_of = [](Real ahead) {
        SpaceScene scene;
        scene.length = 1;
        add_body(scene, {solid_box({0.5, 0.5, 0.5})}, 1000.0, {0.1, 0.28, 0.1});
        add_ground(scene, flat_mesh(8, 8, 0.4), 0.5);
        scene.bodies.u[1] = -5;
        TouchingCones method;
        method.contacts.ahead = ahead;
        StepData<6> now;
        Real deepest = 0;
        for (int n = 0; n < 20; ++n) {
            step(scene, {.h = sixtieth}, method, now);
            deepest = std::max(deepest, 0.25 - scene.bodies.x[1]);
        }
        return deepest;
    };
    CHECK(deepest_of(0) > 0.02);
    CHECK(deepest_of(1) < 2e-8);  // what sweeps leave, 1e-6 m/s, times a step
}

TEST_CASE("a mesh that is none is refused with a sentence", "[house]")
{
    const std::vector<Vec3> square = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {1, 0, 1}};
    const auto of = [&](std::vector<Vec3> vertices, std::vector<TriangleMesh::Triangle> triangles) {
        return sentence_of([&] { triangle_mesh(std::move(vertices), std::move(triangles)); });
    };
    CHECK(of(square, {{0, 1, 2}, {2, 1, 3}}) == "accepted");
    CHECK(of(square, {}) == "a mesh has no triangles; it needs one or more");
    CHECK(of(square, {{0, 1, 2}, {2, 1, 4}}) == "triangle 1 of a mesh has the vertex 4 among 4");
    CHECK(of(square, {{0, 1, -1}}) == "triangle 0 of a mesh has the vertex -1 among 4");
    std::vector<Vec3> bad = square;
    bad[2].y() = std::numeric_limits<Real>::quiet_NaN();
    CHECK(of(bad, {{0, 1, 3}}) == "vertex 2 of a mesh is at (1, nan, 0) m; it must be finite");
    CHECK(
        of(square, {{0, 1, 1}}) ==
        "triangle 0 of a mesh has the area 0 m² at a longest side of 1 m; it must not be a line or a point");
    CHECK(of({{0, 0, 0}, {1, 0, 0}, {2, 1e-11, 0}}, {{0, 1, 2}})
              .find("triangle 0 of a mesh has the area 5e-12") == 0);
    CHECK(of({{0, 0, 0}, {1e200, 0, 0}, {0, 0, 1e200}}, {{0, 1, 2}}).find("has the area inf m²") !=
          std::string::npos);
    // turned over, and three at an edge
    CHECK(of(square, {{0, 1, 2}, {1, 2, 3}}) == "triangles 0 and 1 of a mesh both go from vertex 1 to vertex "
                                                "2; an edge belongs to two at most, and they "
                                                "run along it in opposite directions");
    std::vector<Vec3> fan = square;
    fan.push_back({1, 1, 1});
    CHECK(of(fan, {{0, 1, 2}, {2, 1, 3}, {2, 1, 4}}).find("triangles 1 and 2 of a mesh both go") == 0);

    SpaceScene scene = box_stack(1, 0, 0.5);
    TouchingCones method;
    StepData<6> now;
    const auto taken = [&](const SpaceScene& s) {
        SpaceScene copy = s;
        return sentence_of([&] { step(copy, {}, method, now); });
    };
    scene.meshes.push_back(nullptr);
    CHECK(taken(scene) == "mesh 0 of the scene is none; make it by triangle_mesh()");
    scene.meshes = {std::make_shared<TriangleMesh>()};  // without triangles
    CHECK(taken(scene) == "mesh 0 of the scene is none; make it by triangle_mesh()");
    scene.meshes = {flat_mesh(4, 4, 1)};
    CHECK(taken(scene) == "accepted");  // no list: no friction
    scene.mesh_friction = {0.5, 0.5};
    CHECK(taken(scene) ==
          "the scene has 2 friction coefficients for 1 meshes; each needs its own, or none has one");
    scene.mesh_friction = {-1};
    CHECK(taken(scene) ==
          "number 0 of the meshes has the friction coefficient -1; it must be zero or positive and finite");
    scene.mesh_friction = {0.5};
    scene.ellipsoids.push_back({});
    CHECK(taken(scene) == "the scene has 1 ellipsoids and 1 meshes; an ellipsoid touches walls alone");
    // 20,000 triangles times the names of a box and a triangle: 3 + 8 corners, 3·12 crossings and one
    MeshMemory memory;
    const Ground large = flat_mesh(100, 100, 0.1);
    Index first = std::numeric_limits<std::int32_t>::min() + 900000;
    const SolidForm box = form_of(solid_box({1, 1, 1}));
    CHECK(sentence_of([&] { take_names(*large, box, memory, first); }) ==
          "a mesh of 20000 triangles and a hull of 12 edges could touch in more points than there are names, "
          "2^31");
}

TEST_CASE("a steady step on triangles asks for no memory and has the same bits again", "[house]")
{
    const auto run = [](SpaceScene& scene, TouchingCones& method, StepData<6>& now, int steps) {
        for (int i = 0; i < steps; ++i) step(scene, {.h = sixtieth}, method, now);
    };
    SpaceScene scene = heap_on(bowl(20, 0.5, 3), 12, 0.5, 3), other = scene;
    TouchingCones method, again;
    StepData<6> now, there;
    run(scene, method, now, 400);
    {
        const NoAllocation guard;
        step(scene, {.h = sixtieth}, method, now);
        CHECK(NoAllocation::violations() == 0);
    }
    run(other, again, there, 401);
    CHECK(same_bits(scene.bodies.x, other.bodies.x));
}
