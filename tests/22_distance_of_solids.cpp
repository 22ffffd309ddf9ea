/// Chapter 22: the distance of solids.

#include "chapters/22_distance_of_solids/gjk.hpp"
#include "chapters/22_distance_of_solids/separating_axes.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/placed_solids.hpp"
#include "tests/sentence.hpp"

using namespace rigid;

namespace {

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

TEST_CASE("points that are one but for rounding are one corner of a hull", "[house]")
{
    Random random(5);
    for (const Real apart : {0.0, 1e-16, 1e-13, 1e-11})
        for (int i = 0; i < 50; ++i) {
            std::vector<Vec3> points = solid_box({1, 1, 1}).vertices;
            const Vec3 corner = points[static_cast<std::size_t>(random.index(8))];
            points.push_back(corner + any_vector(random, apart));
            points.insert(points.begin(), corner + any_vector(random, apart));
            const SolidForm form = form_of(solid_hull(points));
            CHECK(form.hull.vertices.size() == 8);
            CHECK(form.hull.faces.size() == 6);
            CHECK(form.edges.size() == 12);
        }
}

TEST_CASE("a hull closes however near its points are to each other and to its faces and edges", "[house]")
{
    Random random(6);
    const auto closes = [](const std::vector<Vec3>& points, Real apart) {
        const SolidForm form = form_of(solid_hull(points));  // refuses what is not closed
        const auto V = form.hull.vertices.size(), F = form.hull.faces.size(), E = form.edges.size();
        CHECK(V + F == E + 2);
        for (std::size_t f = 0; f < F; ++f)
            for (const Vec3& p :
                 points)  // what is left out lies 1e-5 of the spread outside, and so again by what held it
                CHECK(form.normals[f].dot(
                          p - form.hull.vertices[static_cast<std::size_t>(form.hull.faces[f][0])]) <
                      1e-9 + (apart < 1e-4 ? std::min(4 * apart, 4e-5) : 0));
        return form;
    };
    for (const Real apart : {1e-11, 1e-10, 3e-10, 5e-10, 1e-9, 3e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4})
        for (int i = 0; i < 20; ++i) {
            INFO(apart << " " << i);
            const Mat3 R = rotation_matrix(any_vector(random, 2));
            const auto beside = [&](Vec3 p) -> Vec3 { return R * p + any_vector(random, apart); };
            std::vector<Vec3> corners, grid, can;
            for (const Vec3& p : solid_box({1, 1, 1}).vertices) corners.push_back(R * p);
            for (int k = 0; k < 3; ++k) corners.push_back(beside({0.5, 0.5, 0.5}));
            corners.push_back(beside({0.5, 0.5, 0.1}));  // on an edge
            corners.push_back(beside({0.5, 0.2, 0.1}));  // on a face
            closes(corners, apart);
            for (int k = 0; k < 27; ++k)
                grid.push_back(beside(0.5 * Vec3(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1)));
            closes(grid, apart);
            for (int k = 0; k < 20; ++k)
                can.push_back(
                    beside(Vec3(std::cos(k / 2 * pi / 5), k % 2 - 0.5, std::sin(k / 2 * pi / 5)) / 2));
            const SolidForm form = closes(can, apart);
            CHECK(form.hull.vertices.size() == 20);
            CHECK(mass_of(form.hull, 1).mass == Approx(2.5 * std::sin(pi / 5) / 4).margin(1e-9 + 10 * apart));
        }
    // a board whose thickness its points do not tell
    int refused = 0;
    for (int i = 0; i < 20; ++i) {
        const Mat3 R = rotation_matrix(any_vector(random, 2));
        std::vector<Vec3> board;
        for (const Vec3& p : solid_box({1, 1e-9, 1}).vertices) board.push_back(R * p);
        refused += sentence_of([&] { solid_hull(board); }) ==
                   "the points of a hull lie within 1e-5 of their spread "
                   "of a plane, and do not tell its sides apart";
    }
    CHECK(refused == 20);
}

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
        CHECK(most <= near.distance + 1e-12);  // (22.3) is never more than the distance
    }
    CHECK(apart > 100);
}

TEST_CASE("the distance of a small solid from a large one is as exact as its corners", "[idea]")
{
    Random random(7);
    for (const Real ratio : {1.0, 100.0, 400.0, 4000.0, 100000.0}) {
        int apart = 0;
        Real worst = 0;
        for (int i = 0; i < 1000; ++i) {
            const Vec3 sa = any_vector(random, 1).cwiseAbs() + Vec3(0.1, 0.1, 0.1);
            const Vec3 sb = ratio * (any_vector(random, 1).cwiseAbs() + Vec3(0.1, 0.1, 0.1));
            const SolidForm fa = form_of(solid_box(sa)), fb = form_of(solid_box(sb));
            const Vec3 ta = any_vector(random, 3), tb = any_vector(random, 3);
            // over a point of a face of the large one, or of an edge
            Vec3 at = 0.5 * any_vector(random, 1).cwiseProduct(sb), out(0, 0, 0);
            const int axis = i % 3, other = (axis + 1) % 3;
            at[axis] = 0.5 * sb[axis], out[axis] = 1;
            if (i % 2 == 0) at[other] = 0.5 * sb[other], out[other] = 1;
            const Real part = random.uniform();
            const Real height = 0.5 * sa.norm() * part + 0.1 * random.uniform();
            const PlacedSolid b = placed(fb, {0, 0, 0}, tb);
            const PlacedSolid a = placed(fa, rotation_matrix(tb) * (at + height * out.normalized()), ta);
            if (!(std::max(best_face(a, b, 0).separation, best_across_edges(a, b).separation) >
                  1e-12 * ratio))
                continue;
            ++apart;
            const Nearest near = nearest_points(a, b);
            worst = std::max(worst, std::abs(near.distance - distance_by_parts(a, b)));
            worst = std::max(worst, std::abs((near.on_b - near.on_a).norm() - near.distance));
        }
        INFO("ratio " << ratio);
        CHECK(worst < 1e-15 * ratio);
        CHECK(apart > 200);
    }
}

TEST_CASE("the best axis of two hulls that overlap is the least way that parts them", "[idea]")
{
    Random random(3);
    int overlapping = 0;
    for (int i = 0; i < 60; ++i) {
        const SolidForm fa = form_of(any_hull(random, 4 + i % 4)), fb = form_of(any_hull(random, 4 + i % 3));
        const Vec3 at = any_vector(random, 0.6), theta = any_vector(random, 2);
        const PlacedSolid a = placed(fa, {0, 0, 0}), b = placed(fb, at, theta);
        const Axis face = best_face(a, b, 0), edges = best_across_edges(a, b);
        const Axis& best = edges.separation > face.separation ? edges : face;
        const Real most = best.separation;
        if (!(most < -1e-3)) continue;
        ++overlapping;
        // solid_hull() takes 1e-10 of its size for flat
        CHECK(std::abs(-most - depth_by_differences(a, b)) < 1e-9);
        // moved apart by that much they only touch
        const PlacedSolid moved = placed(fb, at - (most - 1e-6) * best.normal, theta);
        const Nearest near = nearest_points(a, moved);
        CHECK(near.distance > 0);
        CHECK(near.distance < 2e-6);
    }
    CHECK(overlapping > 20);
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
    for (const int vertex : {-1, 8}) {
        hull = solid_box({1, 1, 1});
        hull.faces[2][1] = vertex;
        CHECK(with(hull) == "a face names vertex " + std::to_string(vertex) + " among 8");
    }
    // two opposite corners of a face pushed in: its plane lies through the two others, and its ridge is no edge
    hull = solid_box({1, 1, 1});
    hull.vertices[2].x() = hull.vertices[4].x() = -0.4;
    CHECK(with(hull) ==
          "a hull has a face that is not flat: vertex 4 is 0.09999999999999998 m inside of face 0");
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
    CHECK(sentence_of([] {
              solid_hull({Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)});
          }) == "a hull has 3 points in different places; it needs at least four");
    for (const Real size : {1e-70, 1e80}) {
        std::vector<Vec3> points = solid_box({1, 1, 1}).vertices;
        for (Vec3& p : points) p *= size;
        CHECK(sentence_of([&] { solid_hull(points); }).find(" m apart; it must be from 1e-65 to 1e75 m") !=
              std::string::npos);
    }
    CHECK(sentence_of([] {
              solid_hull(
                  {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(std::nan(""), 0, 0)});
          }) == "a point of a hull is not finite");
}
