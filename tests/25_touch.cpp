/// Chapter 25: where solids touch.

#include "chapters/25_space/convex_hull.hpp"
#include "chapters/25_space/solid_touch.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/sentence.hpp"
#include "tests/solids.hpp"

using namespace rigid;

namespace {

Hull any_hull(Random& random, int points)
{
    std::vector<Vec3> cloud;
    for (int i = 0; i < points; ++i) cloud.push_back(any_vector(random, 1));
    return solid_hull(cloud);
}

PlacedSolid placed(const SolidForm& form, const Vec3& at, const Vec3& theta = {0, 0, 0})
{
    PlacedSolid solid;
    solid.place(form, at, rotation_matrix(theta));
    return solid;
}

SolidTouch touch_of(const PlacedSolid& a, const PlacedSolid& b, Real margin = infinity, Real slack = 0)
{
    ClipRoom room;
    SolidTouch touch;
    collide(a, b, {margin, slack}, room, touch);
    return touch;
}

Real least_gap(const SolidTouch& touch)
{
    Real least = infinity;
    for (int i = 0; i < touch.count; ++i)
        least = std::min(least, touch.points[static_cast<std::size_t>(i)].gap);
    return least;
}

// ---- the distance of two hulls by all pairs of their parts: nothing is shared with the headers --------------------

Real to_segment(const Vec3& p, const Vec3& a, const Vec3& b)
{
    const Real t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), Real{0}, Real{1});
    return (p - a - t * (b - a)).norm();
}

Real to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c)
{
    Real least = std::min({to_segment(p, a, b), to_segment(p, b, c), to_segment(p, c, a)});
    const Vec3 n = cross(b - a, c - a);
    const bool above =
        cross(b - a, p - a).dot(n) > 0 && cross(c - b, p - b).dot(n) > 0 && cross(a - c, p - c).dot(n) > 0;
    if (above) least = std::min(least, std::abs(n.dot(p - a)) / n.norm());
    return least;
}

Real of_segments(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
{
    Real least =
        std::min({to_segment(a, c, d), to_segment(b, c, d), to_segment(c, a, b), to_segment(d, a, b)});
    const Vec3 n = cross(b - a, d - c);
    if (n.squaredNorm() < 1e-20) return least;
    // where they cross as seen along n
    const Real s = cross(c - a, d - c).dot(n) / n.squaredNorm(),
               t = cross(c - a, b - a).dot(n) / n.squaredNorm();
    if (s > 0 && s < 1 && t > 0 && t < 1) least = std::min(least, std::abs(n.dot(c - a)) / n.norm());
    return least;
}

Real distance_by_parts(const PlacedSolid& a, const PlacedSolid& b)
{
    Real least = infinity;
    const auto corners_to_faces = [&least](const PlacedSolid& p, const PlacedSolid& q) {
        for (const Vec3& corner : p.vertices)
            for (const std::vector<int>& face : q.form->hull.faces)
                for (std::size_t i = 1; i + 1 < face.size(); ++i)
                    least = std::min(least, to_triangle(corner, q.corner(face[0]), q.corner(face[i]),
                                                        q.corner(face[i + 1])));
    };
    corners_to_faces(a, b);
    corners_to_faces(b, a);
    for (const SolidEdge& e : a.form->edges)
        for (const SolidEdge& f : b.form->edges)
            least = std::min(least,
                             of_segments(a.corner(e.from), a.corner(e.to), b.corner(f.from), b.corner(f.to)));
    return least;
}

/// How deep the origin is inside the hull of all differences of corners: the least way that parts two solids.
Real depth_by_differences(const PlacedSolid& a, const PlacedSolid& b)
{
    std::vector<Vec3> differences;
    for (const Vec3& q : b.vertices)
        for (const Vec3& p : a.vertices) differences.push_back(q - p);
    const Hull all = solid_hull(differences);
    Real depth = infinity;
    for (const std::vector<int>& face : all.faces) {
        const auto at = [&](std::size_t i) { return all.vertices[static_cast<std::size_t>(face[i])]; };
        const Vec3 n = cross(at(1) - at(0), at(2) - at(0)).normalized();
        depth = std::min(depth, n.dot(at(0)));
    }
    return depth;
}

}  // namespace

// ---- hulls --------------------------------------------------------------------------------------

TEST_CASE("a hull has all points inside and the faces and edges of Euler", "[idea]")
{
    Random random(1);
    for (int i = 0; i < 40; ++i) {
        std::vector<Vec3> cloud;
        const int count = 4 + i % 17;
        for (int k = 0; k < count; ++k) cloud.push_back(any_vector(random, 1));
        const SolidForm form = form_of(solid_hull(cloud));
        const auto V = form.hull.vertices.size(), F = form.hull.faces.size(), E = form.edges.size();
        CHECK(V + F == E + 2);
        for (const Vec3& p : cloud)
            for (std::size_t f = 0; f < F; ++f)  // solid_hull() takes 1e-10 of its size for flat
                CHECK(form.normals[f].dot(
                          p - form.hull.vertices[static_cast<std::size_t>(form.hull.faces[f][0])]) < 1e-9);
    }
    // a cube out of a grid: corners alone are left, with faces of four and three directions
    std::vector<Vec3> grid;
    for (int k = 0; k < 27; ++k) grid.push_back(Vec3(k % 3, k / 3 % 3, k / 9));
    const SolidForm cube = form_of(solid_hull(grid));
    CHECK(cube.hull.vertices.size() == 8);
    CHECK(cube.hull.faces.size() == 6);
    CHECK(cube.edges.size() == 12);
    CHECK(cube.directions.size() == 3);
    CHECK(mass_of(cube.hull, 1).mass == Approx(8).epsilon(1e-14));
}

// ---- distance -----------------------------------------------------------------------------------

TEST_CASE("the nearest points of two hulls are as far apart as any of their parts", "[idea]")
{
    Random random(2);
    int apart = 0;
    for (int i = 0; i < 400; ++i) {
        const SolidForm fa = form_of(any_hull(random, 4 + i % 9)), fb = form_of(any_hull(random, 4 + i % 7));
        const Vec3 at = any_vector(random, 2.5), ta = any_vector(random, 2), tb = any_vector(random, 2);
        const PlacedSolid a = placed(fa, {0, 0, 0}, ta), b = placed(fb, at, tb);
        const Nearest near = nearest_points(a, b);
        const Real most = std::max(best_face(a, b, 0).separation, best_across_edges(a, b).separation);
        if (!(most > 0)) {
            CHECK(near.distance < 1e-12);
            continue;
        }
        ++apart;
        // roundings of numbers near 3, times the slope of a thin simplex
        CHECK(std::abs(near.distance - distance_by_parts(a, b)) < 1e-10);
        CHECK(std::abs((near.on_b - near.on_a).norm() - near.distance) < 1e-12);
        CHECK(most <= near.distance + 1e-12);  // (25.31) is never more than the distance
    }
    CHECK(apart > 100);
}

TEST_CASE("the best axis of two hulls that overlap is the least way that parts them", "[idea]")
{
    Random random(3);
    int overlapping = 0;
    for (int i = 0; i < 60; ++i) {
        const SolidForm fa = form_of(any_hull(random, 4 + i % 4)), fb = form_of(any_hull(random, 4 + i % 3));
        const Vec3 at = any_vector(random, 0.6), theta = any_vector(random, 2);
        const PlacedSolid a = placed(fa, {0, 0, 0}), b = placed(fb, at, theta);
        const Real most = std::max(best_face(a, b, 0).separation, best_across_edges(a, b).separation);
        if (!(most < -1e-3)) continue;
        ++overlapping;
        // solid_hull() takes 1e-10 of its size for flat
        CHECK(std::abs(-most - depth_by_differences(a, b)) < 1e-9);
        const SolidTouch touch = touch_of(a, b);
        REQUIRE(touch.count > 0);
        CHECK(least_gap(touch) == Approx(most).margin(1e-9));
        // moved apart by that much they only touch
        const PlacedSolid moved = placed(fb, at - (most - 1e-6) * touch.normal, theta);
        const Nearest near = nearest_points(a, moved);
        CHECK(near.distance > 0);
        CHECK(near.distance < 2e-6);
    }
    CHECK(overlapping > 20);
}

// ---- where they touch ---------------------------------------------------------------------------

TEST_CASE("round solids touch in the points that are known", "[idea]")
{
    const SolidForm ball = form_of(solid_ball(0.5)), rod = form_of(solid_capsule(2, 0.25)),
                    box = form_of(solid_box({2, 2, 2}));
    SolidTouch t = touch_of(placed(ball, {0, 0, 0}), placed(ball, {0.6, 0, 0.8}));
    CHECK(t.count == 1);
    CHECK((t.normal - Vec3(0.6, 0, 0.8)).norm() < 1e-15);
    CHECK(std::abs(t.points[0].gap) < 1e-15);
    // a ball over a face, over an edge, over a corner of a box
    t = touch_of(placed(box, {0, 0, 0}), placed(ball, {0.3, 1.6, 0}));
    CHECK(t.count == 1);
    CHECK((t.normal - Vec3(0, 1, 0)).norm() < 1e-15);
    CHECK(t.points[0].gap == Approx(0.1).margin(1e-15));
    t = touch_of(placed(box, {0, 0, 0}), placed(ball, {1.3, 1.4, 0}));
    CHECK((t.normal - Vec3(0.6, 0.8, 0)).norm() < 1e-14);
    CHECK(t.points[0].gap == Approx(0).margin(1e-14));
    t = touch_of(placed(box, {0, 0, 0}), placed(ball, {1.2, 1.3, 1.6}));
    CHECK((t.normal - Vec3(2, 3, 6) / 7).norm() < 1e-14);
    CHECK(t.points[0].gap == Approx(0.2).margin(1e-14));
    // its centre inside: out by the nearest face
    t = touch_of(placed(box, {0, 0, 0}), placed(ball, {0.2, 0.7, 0}));
    CHECK((t.normal - Vec3(0, 1, 0)).norm() < 1e-15);
    CHECK(t.points[0].gap == Approx(-0.8).margin(1e-14));
    // a rod on a face has two points, beside a rod two, across it one
    t = touch_of(placed(box, {0, 0, 0}), placed(rod, {0.5, 1.25, 0}));
    CHECK(t.count == 2);
    CHECK(std::abs(t.points[0].on_b.x() - t.points[1].on_b.x()) == Approx(1.5));
    t = touch_of(placed(rod, {0, 0, 0}), placed(rod, {0.5, 0.4, 0}));
    CHECK(t.count == 2);
    CHECK((t.normal - Vec3(0, 1, 0)).norm() < 1e-15);
    CHECK(std::abs(t.points[0].on_b.x() - t.points[1].on_b.x()) == Approx(1.5));
    t = touch_of(placed(rod, {0, 0, 0}), placed(rod, {0.1, 0.4, 0.2}, {0, 1.2, 0}));
    CHECK(t.count == 1);
    CHECK((t.normal - Vec3(0, 1, 0)).norm() < 1e-12);
    CHECK(t.points[0].gap == Approx(-0.1).margin(1e-13));
}

TEST_CASE("solids in one place are parted in some direction", "[idea]")
{
    const std::vector<SolidForm> forms = {form_of(solid_ball(0.5)), form_of(solid_capsule(2, 0.25)),
                                          form_of(solid_box({2, 2, 2})), form_of(solid_box({1, 3, 2}))};
    for (const SolidForm& fa : forms)
        for (const SolidForm& fb : forms) {
            const SolidTouch t =
                touch_of(placed(fa, {1, 2, 3}, {0.3, 0.2, 0.1}), placed(fb, {1, 2, 3}, {0.3, 0.2, 0.1}));
            REQUIRE(t.count > 0);
            CHECK(std::abs(t.normal.norm() - 1) < 1e-14);
            CHECK(least_gap(t) < -0.4);  // two balls or capsules of a quarter: half a metre
            for (int i = 0; i < t.count; ++i) CHECK(t.points[static_cast<std::size_t>(i)].on_b.allFinite());
        }
}

TEST_CASE("a box on a box touches at four points that keep their names", "[idea]")
{
    const SolidForm low = form_of(solid_box({1, 1, 1})), high = form_of(solid_box({1, 1, 1}));
    const Real slack = 1e-4;
    std::vector<int> names;
    for (int step = 0; step < 50; ++step) {
        // slides and turns by less than the slack, as what rests does
        const Vec3 at(1e-6 * step, 1 - 1e-5, -5e-7 * step), theta(1e-7 * step, 1e-6 * step, -1e-7 * step);
        const SolidTouch t = touch_of(placed(low, {0, 0, 0}), placed(high, at, theta), 0.02, slack);
        REQUIRE(t.count == 4);
        CHECK((t.normal - Vec3(0, 1, 0)).norm() < 1e-4);
        std::vector<int> now;
        for (const TouchPoint& p : t.points) now.push_back(p.feature);
        if (step == 0) names = now;
        CHECK(now == names);
    }
    // turned by an eighth: an octagon, of which four are kept, with more than half of its area around the middle
    const SolidTouch t =
        touch_of(placed(low, {0, 0, 0}), placed(high, {0, 1, 0}, {0, pi / 4, 0}), 0.02, slack);
    REQUIRE(t.count == 4);
    Vec3 sum(0, 0, 0);
    for (const TouchPoint& p : t.points) sum += p.on_b / 4;
    CHECK(std::hypot(sum.x(), sum.z()) < 0.2);
    // over an edge: the part that lies on the other
    const SolidTouch half = touch_of(placed(low, {0, 0, 0}), placed(high, {0.5, 1, 0.25}), 0.02, slack);
    REQUIRE(half.count == 4);
    for (const TouchPoint& p : half.points) {
        CHECK(p.on_b.x() > -1e-12);
        CHECK(p.on_b.x() < 0.5 + 1e-12);
        CHECK(std::abs(p.gap) < 1e-15);
    }
}

TEST_CASE("two edges that cross touch in one point and parallel ones in two", "[idea]")
{
    const SolidForm box = form_of(solid_box({1, 1, 1}));
    const Real d = std::sqrt(0.5);
    // one stands on an edge along z, the other hangs by an edge along x
    const PlacedSolid low = placed(box, {0, 0, 0}, {0, 0, pi / 4});
    SolidTouch t = touch_of(low, placed(box, {0.1, 2 * d - 0.01, 0.2}, {pi / 4, 0, 0}), 0.02, 1e-4);
    CHECK(t.count == 1);
    CHECK((t.normal - Vec3(0, 1, 0)).norm() < 1e-12);
    CHECK(t.points[0].gap == Approx(-0.01).margin(1e-12));
    CHECK((t.points[0].on_b - Vec3(0, d - 0.01, 0.2)).norm() < 1e-12);
    // apart
    t = touch_of(low, placed(box, {0.1, 2 * d + 0.01, 0.2}, {pi / 4, 0, 0}), 0.02, 1e-4);
    CHECK(t.count == 1);
    CHECK(t.points[0].gap == Approx(0.01).margin(1e-12));
    // both edges along z
    t = touch_of(low, placed(box, {0, 2 * d + 0.01, 0.25}, {0, 0, pi / 4}), 0.02, 1e-4);
    CHECK(t.count == 2);
    CHECK((t.normal - Vec3(0, 1, 0)).norm() < 1e-12);
    CHECK(std::abs(t.points[0].on_b.z() - t.points[1].on_b.z()) == Approx(0.75));
}

TEST_CASE("a touch depends neither on who comes first nor on the axes nor on the unit of length", "[idea]")
{
    Random random(4);
    int touching = 0;
    const Real same = 1e-6;  // what is nearly equal must not be chosen by rounding
    for (int i = 0; i < 600; ++i) {
        Hull ha = any_hull(random, 4 + i % 9), hb = any_hull(random, 4 + i % 7);
        if (i % 5 == 1) ha = solid_capsule(1.5, 0.3);
        if (i % 7 == 2) hb = solid_ball(0.6);
        if (i % 3 == 0) ha.radius = 0.1;
        const SolidForm fa = form_of(ha), fb = form_of(hb);
        const Vec3 xa = any_vector(random, 1), xb = any_vector(random, 1), ta = any_vector(random, 2),
                   tb = any_vector(random, 2), by = any_vector(random, 2);
        const SolidTouch t = touch_of(placed(fa, xa, ta), placed(fb, xb, tb), 0.3, same);
        if (t.count > 0) ++touching;
        const SolidTouch swapped = touch_of(placed(fb, xb, tb), placed(fa, xa, ta), 0.3, same);
        REQUIRE((swapped.count > 0) == (t.count > 0));
        if (t.count == 0) continue;
        CHECK(std::abs(least_gap(swapped) - least_gap(t)) <= same);
        if (std::abs(least_gap(swapped) - least_gap(t)) < 1e-9)
            CHECK((swapped.normal + t.normal).norm() < 1e-7);
        const Mat3 R = rotation_matrix(by);
        const SolidTouch turned = touch_of(placed(fa, R * xa, add_rotation(by, ta)),
                                           placed(fb, R * xb, add_rotation(by, tb)), 0.3, same);
        REQUIRE(turned.count == t.count);
        // roundings, over a normal from two points that may be near each other
        CHECK((turned.normal - R * t.normal).norm() < 1e-7);
        CHECK(std::abs(least_gap(turned) - least_gap(t)) < 1e-9);
        for (const Real scale : {1e-3, 1e3}) {
            const auto grown = [scale](Hull hull) {
                for (Vec3& p : hull.vertices) p *= scale;
                hull.radius *= scale;
                return form_of(hull);
            };
            const SolidForm ga = grown(ha), gb = grown(hb);
            const SolidTouch other =
                touch_of(placed(ga, scale * xa, ta), placed(gb, scale * xb, tb), scale * 0.3, scale * same);
            REQUIRE(other.count == t.count);
            CHECK((other.normal - t.normal).norm() < 1e-7);
            CHECK(std::abs(least_gap(other) / scale - least_gap(t)) < 1e-9);
        }
    }
    CHECK(touching > 200);
}

TEST_CASE("however two solids lie their touch is a number and its deepest gap the true one", "[idea]")
{
    // boxes, balls, rods and hulls, of which half lie face to face, edge to edge or corner to corner, to within 1e-14 … 1
    Random random(6);
    const Real slack = 2e-4;
    std::vector<SolidForm> forms = {form_of(solid_box({1, 1, 1})), form_of(solid_box({0.3, 1, 0.6})),
                                    form_of(solid_ball(0.3)), form_of(solid_capsule(1.2, 0.2)),
                                    form_of(solid_capsule(0.5, 0))};
    for (int i = 0; i < 12; ++i) forms.push_back(form_of(any_hull(random, 4 + i)));
    const auto index = [&random](int count) { return static_cast<int>(random.index(count)); };
    const auto any_turn = [&]() -> Vec3 {
        Vec3 axis(0, 0, 0);
        axis[index(3)] = pi / 4 * index(4);
        const Real small = std::pow(10.0, -index(12));
        const Vec3 other = any_vector(random, 2);
        return index(2) == 0 ? axis : Vec3(small * other);
    };
    for (int n = 0; n < 6000; ++n) {
        const SolidForm &fa = forms[static_cast<std::size_t>(index(17))],
                        &fb = forms[static_cast<std::size_t>(index(17))];
        const Vec3 ta = any_turn(), tb = any_turn();
        const PlacedSolid a = placed(fa, {0, 0, 0}, ta), b0 = placed(fb, {0, 0, 0}, tb);
        Vec3 at = any_vector(random, 1.2);
        if (n % 2 == 0) {
            Vec3 e(0, 0, 0);
            e[index(3)] = 1;
            if (index(2) == 0 && a.has_faces())
                e = a.normals[static_cast<std::size_t>(index(static_cast<int>(a.normals.size())))];
            const int exponent = index(15), some = index(2);
            const Real near = some * std::pow(10.0, -exponent);
            const Vec3 aside = 0.3 * index(2) * (at - e * e.dot(at));
            at = e * (e.dot(a.corner(a.support(e))) - e.dot(b0.corner(b0.support(-e))) + near) + aside;
        }
        const PlacedSolid b = placed(fb, at, tb);
        const SolidTouch t = touch_of(a, b, infinity, slack);
        REQUIRE(t.count > 0);
        CHECK(std::abs(t.normal.norm() - 1) < 1e-12);
        for (int k = 0; k < t.count; ++k) {
            const TouchPoint& p = t.points[static_cast<std::size_t>(k)];
            CHECK((p.on_a.allFinite() && p.on_b.allFinite()));
            for (int l = 0; l < k; ++l) CHECK(p.feature != t.points[static_cast<std::size_t>(l)].feature);
        }
        const bool faces = a.has_faces() || b.has_faces();
        const Real apart = nearest_points(a, b).distance,
                   along = std::max(best_face(a, b, 0).separation, best_across_edges(a, b).separation),
                   truth = apart > 0 || !faces ? apart : along;
        // 1e-7 of their size is where a direction ends
        CHECK(std::abs(least_gap(t) + a.radius() + b.radius() - truth) < slack + 1e-6);
        CHECK(std::abs(least_gap(touch_of(b, a, infinity, slack)) - least_gap(t)) < slack + 1e-6);
    }
}

TEST_CASE("between the points of a touch there is the normal and nothing else", "[idea]")
{
    // what pushes at both pushes along one line: no angular momentum is lost
    Random random(5);
    for (int i = 0; i < 300; ++i) {
        const SolidForm fa = form_of(i % 4 == 0 ? solid_capsule(2, 0.2) : any_hull(random, 8)),
                        fb = form_of(i % 6 == 0 ? solid_ball(0.5) : any_hull(random, 10));
        const Vec3 at = any_vector(random, 1.2), theta = any_vector(random, 2);
        const SolidTouch t = touch_of(placed(fa, {0, 0, 0}), placed(fb, at, theta), 0.3);
        const Real radii = fa.hull.radius + fb.hull.radius;
        for (int k = 0; k < t.count; ++k) {
            const TouchPoint& p = t.points[static_cast<std::size_t>(k)];
            CHECK((p.on_b - p.on_a - (p.gap + radii) * t.normal).norm() < 1e-12);
        }
    }
}

TEST_CASE("hulls that are none are refused with a sentence", "[house]")
{
    const auto with = [](const Hull& hull) { return sentence_of([&] { form_of(hull); }); };
    Hull hull = solid_box({1, 1, 1});
    hull.vertices[0] = {0, 0, 0};
    CHECK(with(hull).find("is not convex") != std::string::npos);
    hull = solid_box({1, 1, 1});
    hull.faces.pop_back();
    CHECK(with(hull) == "a hull is not closed: an edge is one of 1 faces");
    hull = solid_box({1, 1, 0});
    CHECK(with(hull) != "accepted");
    hull = solid_ball(1);
    hull.radius = -1;
    CHECK(with(hull) == "a hull has the radius -1 m; it must be between 0 and 1e75");
    hull = solid_box({1, 1, 1});
    hull.vertices[3].x() = std::nan("");
    CHECK(with(hull).find("a hull has a vertex at (nan, ") == 0);
    // a normal has no direction where its square is no number
    CHECK(with(solid_box({1, 1e76, 1})).find("none beyond 1e75") != std::string::npos);
    CHECK(with(solid_box({1, 1e-76, 1})) == "an edge has no length");
    CHECK(with(solid_ball(1e76)) == "a hull has the radius 1e+76 m; it must be between 0 and 1e75");
    CHECK(with({{Vec3(0, 0, 0), Vec3(0, 0, 0)}, {}, 1}) == "an edge has no length");
    CHECK(sentence_of([] {
              solid_hull({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(1, 1, 0)});
          }) == "the points of a hull lie in a plane");
}
