/// The small programs of chapters 22 to 24, solids that touch, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/22_distance_of_solids/gjk.hpp"
#include "chapters/22_distance_of_solids/separating_axes.hpp"
#include "chapters/24_friction_is_a_disc/rough_touching.hpp"
#include "common/random.hpp"
#include "tests/catch.hpp"
#include "tests/placed_solids.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small22 {
#include "chapters/22_distance_of_solids/small.cpp"
}
namespace small23 {
#include "chapters/23_faces_that_touch/small.cpp"
}
namespace small24 {
#include "chapters/24_friction_is_a_disc/small.cpp"
}
#undef main

using namespace rigid;

TEST_CASE("the small program of chapter 22 walks from guess to guess as section 22.1 does")
{
    const small22::Solid a = small22::triangle(0, 0, 4, 4, 1, 3), b = small22::triangle(5, 1, 8, 2, 5, 5);
    const small22::Nearest near = small22::nearest_points(a, b);
    REQUIRE(near.v.size() == 4);
    // numbers below ten, to their last digits
    CHECK((near.v[0] - Vec3(5, 1, 0)).norm() < 1e-14);
    CHECK((near.v[1] - Vec3(2, -2, 0)).norm() < 1e-14);
    CHECK((near.v[2] - Vec3(2, -1, 0)).norm() < 1e-14);
    CHECK((near.v[3] - Vec3(1, 0, 0)).norm() < 1e-14);
    CHECK((near.on_a - Vec3(4, 4, 0)).norm() < 1e-14);
    CHECK((near.on_b - Vec3(5, 4, 0)).norm() < 1e-14);
}

TEST_CASE(
    "the small program of chapter 22 finds the distance and the way out of two boxes as the library does")
{
    Random random(22);
    const auto solid_of = [](const PlacedSolid& p) {
        small22::Solid s;
        const auto columns = [](const std::vector<Vec3>& from) {
            small22::Matrix3Xd to(3, Index(from.size()));
            for (std::size_t i = 0; i < from.size(); ++i) to.col(Index(i)) = from[i];
            return to;
        };
        s.corners = columns(p.vertices), s.normals = columns(p.normals), s.edges = columns(p.directions);
        return s;
    };
    int apart = 0, overlapping = 0;
    for (int i = 0; i < 200; ++i) {
        const SolidForm fa = form_of(any_hull(random, 4 + i % 5)), fb = form_of(any_hull(random, 4 + i % 3));
        const Vec3 theta_a = any_vector(random, 2), at = any_vector(random, 1.5),
                   theta_b = any_vector(random, 2);
        const PlacedSolid a = placed(fa, {0, 0, 0}, theta_a), b = placed(fb, at, theta_b);
        const small22::Solid sa = solid_of(a), sb = solid_of(b);
        const Nearest near = nearest_points(a, b);
        const small22::Nearest same = small22::nearest_points(sa, sb);
        // roundings of numbers near 3, times the slope of a thin simplex
        CHECK(std::abs(near.distance - same.distance) < 1e-11);
        const Real most = std::max(best_face(a, b, 0).separation, best_across_edges(a, b).separation);
        const Real found = small22::separation(sa, sb, small22::best_axis(sa, sb));
        // where they overlap only outward normals count; apart, the other side of a face may part them farther
        if (most < 0) CHECK(std::abs(found - most) < 1e-12);
        else CHECK(found > most - 1e-12);
        ++(most > 0 ? apart : overlapping);
    }
    CHECK(apart > 30);
    CHECK(overlapping > 30);
    // Section 22.3: edges across each other, which no face sees.
    const Real eighth = pi / 4, touch = 2 * std::sqrt(2.0);
    const small22::Solid low = small22::box({2, 2, 2}, {0, 0, 0}, {0, 0, eighth}),
                         high = small22::box({2, 2, 2}, {0, touch - 0.1, 0}, {eighth, 0, 0});
    CHECK(small22::separation(low, high, small22::best_axis(low, high)) == Approx(-0.1).margin(1e-14));
    CHECK(small22::separation(low, high, low.normals.col(0)) < -0.77);
}

TEST_CASE("the small program of chapter 23 cuts the square of section 23.1 and keeps its four corners")
{
    const std::vector<small23::Corner> polygon = small23::by_hand();
    REQUIRE(polygon.size() == 5);
    const Vec3 expected[] = {{0.5, -0.75, 0}, {1, -0.25, 0}, {1, 1, 0}, {-0.25, 1, 0}, {-0.75, 0.5, 0}};
    std::vector<small23::Contact> points;
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK((polygon[i].at - expected[i]).norm() < 1e-14);
        points.push_back({0, 1, polygon[i].name, polygon[i].at, 0});
    }
    const std::vector<small23::Contact> kept = small23::four_of(points, {0, 0, 1});
    REQUIRE(kept.size() == 4);
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 3}, {2, 2}, {3, 4}})
        CHECK(kept[std::size_t(i)].name == polygon[std::size_t(j)].name);
}

TEST_CASE("the small program of chapter 23 finds the points of two cubes and their rows as the library does")
{
    const SolidForm cube = form_of(solid_box({1, 1, 1}));
    ClipRoom room;
    for (const Real turn : {0.1, 0.3, 0.7}) {
        small23::Bodies d = small23::stack(2, turn);
        d.x.segment<3>(6) << 0.1, 0.05, 0.999;
        const std::vector<small23::Contact> found = small23::touch(d, 0, 1);
        const PlacedSolid a = placed(cube, {0, 0, 0}), b = placed(cube, d.x.segment<3>(6), d.x.segment<3>(9));
        SolidTouch touch;
        collide(a, b, {0.02, 1e-4}, room, touch);
        REQUIRE(found.size() == 4);
        REQUIRE(touch.count == 4);
        for (const small23::Contact& c : found) {
            // the library's are in the order of their names
            const TouchPoint* same = nullptr;
            for (int i = 0; i < 4; ++i)
                if ((touch.points[std::size_t(i)].on_b - c.at).norm() < 1e-12)
                    same = &touch.points[std::size_t(i)];
            REQUIRE(same);
            CHECK(same->gap == Approx(c.C).margin(1e-14));
            SpaceContact contact;
            contact.a = 0, contact.b = 1, contact.normal = touch.normal;
            contact.at_a = same->on_a;
            contact.at_b = rotation_of(d.x, 1).transpose() * (same->on_b - centre_of(d.x, 1));
            const Constraint<6> row = push_constraint(contact, place_of(contact, d.x));
            CHECK((row.Ja.transpose() - c.Ja).norm() < 1e-12);
            CHECK((row.Jb.transpose() - c.Jb).norm() < 1e-12);
        }
    }
}

TEST_CASE("the small program of chapter 23 stands on four points and sinks on one")
{
    for (const std::size_t most : {std::size_t(4), std::size_t(1)}) {
        small23::Bodies d = small23::stack(5, 0.1);
        d.points = most;
        for (int n = 0; n < 45; ++n) small23::step(d, 1.0 / 60, 0.2, 200);
        // the top of five; where one point carries, each cube falls beside it
        const Real down = 4 - d.x[6 * 4 + 2];
        if (most == 4) CHECK(std::abs(down) < 1e-5);
        else CHECK(down == Approx(0.55).margin(0.02));
    }
}

TEST_CASE("the small program of chapter 24 visits the hoop of section 24.1 with the impulses of the text")
{
    small24::Bodies d = small24::hoop(1.8, 2.4);
    std::vector<small24::Contact> contacts = small24::find_contacts(d);
    REQUIRE(contacts.size() == 1);
    small24::Contact& c = contacts[0];
    c.lambda[2] = 1;
    const auto slide = [&]() -> Vec2 {
        return c.J.topLeftCorner<2, 2>().transpose() * (c.J * d.u).head<2>();
    };
    CHECK((slide() - Vec2(1.8, 2.4)).norm() < 1e-14);
    small24::visit(c, d);
    CHECK((small24::drag(c) - Vec2(-0.3, -0.4)).norm() < 1e-14);
    CHECK((slide() - Vec2(1.2, 1.2)).norm() < 1e-14);
    small24::visit(c, d);
    // the text has four decimals
    CHECK((small24::drag(c) - Vec2(-0.3293, -0.3763)).cwiseAbs().maxCoeff() < 0.5e-4);
    CHECK((slide() - Vec2(1.1415, 1.2711)).cwiseAbs().maxCoeff() < 0.5e-4);
    for (int n = 2; n < 20; ++n) small24::visit(c, d);
    CHECK((small24::drag(c) - Vec2(-0.3321, -0.3738)).cwiseAbs().maxCoeff() < 0.5e-4);
    // straight against what slides
    CHECK(std::abs(small24::drag(c).normalized().dot(slide().normalized()) + 1) < 1e-12);
}

TEST_CASE(
    "the small program of chapter 24 visits a point as the library does and stops alike in all directions")
{
    small24::Bodies d{{}, {}, {}, {}, VecX{{0, 0, 1, 0}}};
    small24::add_box(d, {1, 0.8, 0.2}, 1, {0, 0, 0.1});
    d.u << 2, 1, -0.3, 0.1, 0.2, 0.5;
    std::vector<small24::Contact> contacts = small24::find_contacts(d);
    REQUIRE(contacts.size() == 4);
    VecX u = d.u;
    std::vector<Row<6>> rows;
    for (const small24::Contact& c : contacts)
        for (const int i : {0, 1, 2}) {
            Constraint<6> constraint;
            constraint.a = world, constraint.b = 0;
            constraint.Jb = c.J.row(i);
            rows.push_back(bilateral(constraint, d.inverse_mass, 0));
            if (i == 2) rows.back().lo = 0;
        }
    std::vector<SolverRow<6>> visited;
    prepare<6>(rows, {}, VecX::Zero(Index(rows.size())), visited);
    for (int n = 0; n < 100; ++n)
        for (std::size_t k = 0; k < contacts.size(); ++k) {
            visit_disc(disc_of_rows(visited, 3 * k), &visited[3 * k], d.mu * visited[3 * k + 2].lambda, u);
            visit(visited[3 * k + 2], u);
            small24::visit(contacts[k], d);
            REQUIRE((d.u - u).cwiseAbs().maxCoeff() < 1e-12);
        }
    CHECK(contacts[0].lambda.head<2>().norm() > 0);

    for (const Real angle : {0.0, pi / 6, pi / 4}) {
        small24::Bodies block{{}, {}, {}, {}, VecX{{0, 0, 1, 0}}};
        small24::add_box(block, {1, 1, 0.2}, 1, {0, 0, 0.1});
        block.u.head<2>() << 2 * std::cos(angle), 2 * std::sin(angle);
        for (int n = 0; n < 480; ++n) small24::step(block, 1.0 / 240, 0.2, 20);
        // v²/(2 μ g), less half a step's way: symplectic Euler brakes first
        CHECK(block.x.head<2>().norm() == Approx(2 / 9.81 * 2 - 2.0 / 480).margin(2e-4));
        CHECK(std::atan2(block.x[1], block.x[0]) == Approx(angle).margin(2e-3));
        CHECK(block.u.norm() < 1e-3);
    }
}

namespace {

// What the sentences of these chapters say.

Numbers triangles(Numbers in)
{
    const double up = in["up"];
    return {{"distance", small22::nearest_points(small22::triangle(0, 0, 4, 4, 1, 3),
                                                 small22::triangle(5, 1 + up, 8, 2 + up, 5, 5 + up))
                             .distance}};
}

Numbers squares(Numbers in)
{
    const double right = in["right"], x[] = {0.5, 1.75, 0.5, -0.75}, y[] = {-0.75, 0.5, 1.75, 0.5};
    std::vector<small23::Corner> polygon;
    for (int k = 0; k < 4; ++k) polygon.push_back({{x[k] + right, y[k], 0}, k, k});
    for (int k = 0; k < 4; ++k) {
        const Eigen::Vector3d out(k == 0 ? 1 : k == 2 ? -1 : 0, k == 1 ? 1 : k == 3 ? -1 : 0, 0);
        polygon = small23::cut(polygon, out, out, k);
    }
    double twice = 0;
    for (std::size_t i = 0; i < polygon.size(); ++i)
        twice += polygon[i].at.cross(polygon[(i + 1) % polygon.size()].at).z();
    return {{"area", twice / 2}};
}

Numbers hoop(Numbers in)
{
    small24::Bodies d = small24::hoop(1.8, in["across"]);
    small24::Contact c = small24::find_contacts(d)[0];
    c.lambda[2] = 1;
    small24::visit(c, d);
    return {{"along", -small24::drag(c)[0]}, {"aside", -small24::drag(c)[1]}};
}

const Sentence says_triangles("triangles", triangles, 1e-12);
const Sentence says_squares("squares", squares, 1e-12);
const Sentence says_hoop("hoop", hoop, 1e-12);

}  // namespace
