/// The small programs of chapters 22 to 24, solids that touch, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/22_distance_of_solids/gjk.hpp"
#include "chapters/22_distance_of_solids/separating_axes.hpp"
#include "common/random.hpp"
#include "tests/catch.hpp"
#include "tests/placed_solids.hpp"

#define main small_main
namespace small22 {
#include "chapters/22_distance_of_solids/small.cpp"
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

TEST_CASE("the small program of chapter 22 finds the distance and the way out of two boxes as the library does")
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
        const PlacedSolid a = placed(fa, {0, 0, 0}, any_vector(random, 2)),
                          b = placed(fb, any_vector(random, 1.5), any_vector(random, 2));
        const small22::Solid sa = solid_of(a), sb = solid_of(b);
        const Nearest near = nearest_points(a, b);
        const small22::Nearest same = small22::nearest_points(sa, sb);
        // roundings of numbers near 3, times the slope of a thin simplex
        CHECK(std::abs(near.distance - same.distance) < 1e-11);
        const Real most = std::max(best_face(a, b, 0).separation, best_across_edges(a, b).separation);
        CHECK(std::abs(small22::separation(sa, sb, small22::best_axis(sa, sb)) - most) < 1e-12);
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
