/// Chapter 23: where solids touch.

#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "chapters/23_faces_that_touch/smooth_touching.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/placed_solids.hpp"
#include "tests/sentence.hpp"

using namespace rigid;

namespace {

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

}  // namespace

// ---- hulls --------------------------------------------------------------------------------------

// ---- distance -----------------------------------------------------------------------------------

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

TEST_CASE("a plate that is thinner than the margin lies on its lower corners", "[idea]")
{
    for (const Real thickness : {0.05, 0.02, 0.01, 0.001})
        for (const bool on_wall : {true, false}) {
            WalledSolids scene;
            const Index k = add_body(scene, {solid_box({1, thickness, 0.7})}, 1000.0, {0, thickness / 2, 0});
            if (on_wall) scene.walls.push_back({{0, 1, 0}, 0});
            else add_body(scene, {solid_box({3, 1, 3})}, SolidMass{}, {0, -0.5, 0});
            SmoothSweeps method;
            method.solver.sweeps = {1000, 1e-10};
            StepData<6> now;
            for (int i = 0; i < 60; ++i) {
                step(scene, {.h = 1.0 / 60}, method, now);
                CHECK(now.contacts.size() == 4);
            }
            // a second of the speeds that the tolerance leaves
            CHECK(std::abs(scene.bodies.x[6 * k + 1] - thickness / 2) < 1e-9);
            CHECK(scene.bodies.x.segment<3>(6 * k + 3).norm() < 1e-9);
        }
}

TEST_CASE("of the corners over a wall those that stand over others are left out", "[house]")
{
    const SolidForm box = form_of(solid_box({1, 0.01, 0.5}));
    Random random(4);
    for (int i = 0; i < 200; ++i) {
        const Vec3 theta = any_vector(random, 0.4), at(0, random.uniform(0, 1), 0);
        const PlacedSolid plate = placed(box, at, theta);
        ClipRoom room;
        SolidTouch touch;
        collide(SolidWall{{0, 1, 0}, 0}, plate, {infinity, 0}, room, touch);
        REQUIRE(touch.count == 4);
        Real lowest = infinity, least = infinity;
        for (const Vec3& p : plate.vertices) lowest = std::min(lowest, p.y());
        for (int c = 0; c < 4; ++c) {
            const TouchPoint& p = touch.points[static_cast<std::size_t>(c)];
            CHECK(box.hull.vertices[static_cast<std::size_t>(p.feature)].y() < 0);  // of the lower face
            least = std::min(least, p.gap);
        }
        CHECK(least == lowest);
    }
}

TEST_CASE("what a joint joins does not collide", "[idea]")
{
    for (const bool joined : {false, true}) {
        WalledSolids scene;
        for (int k = 0; k < 2; ++k) add_body(scene, {solid_box({1, 0.2, 0.2})}, 100.0, {0.9 * k, 0, 0});
        if (joined) scene.joints.push_back(hinge(scene, 0, 1, {0.45, 0, 0}, {0, 0, 1}));
        SmoothSweeps method;
        StepData<6> now;
        step(scene, {}, method, now);
        CHECK(now.contacts.empty() == joined);
    }
}

TEST_CASE("a hull that is none is refused in each step and then the run goes on", "[house]")
{
    const auto stack = [](int boxes) {
        WalledSolids scene;
        for (int k = 0; k < boxes; ++k) add_body(scene, {solid_box({1, 1, 1})}, 1.0, {0, k + 0.5, 0});
        scene.walls = {{{0, 1, 0}, 0}};
        return scene;
    };
    WalledSolids scene = stack(2), spoilt = stack(3), same = stack(2);
    spoilt.shapes[1][0].radius = -1;
    SmoothSweeps method, undisturbed;
    StepData<6> now, then;
    for (int i = 0; i < 3; ++i) {
        for (int again = 0; again < 2; ++again)
            CHECK(sentence_of([&] { step(spoilt, {}, method, now); }) ==
                  "a hull has the radius -1 m; it must be between 0 and 1e75");
        step(scene, {}, method, now);
        step(same, {}, undisturbed, then);
        CHECK(now.contacts.size() == 8);
        CHECK((scene.bodies.x.array() == same.bodies.x.array()).all());
    }
}

// ---- their rows ---------------------------------------------------------------------------------

TEST_CASE("the row of a contact is the derivative of its gap", "[idea]")
{
    Random random(11);
    for (int n = 0; n < 100; ++n) {
        SolidScene scene;
        for (int k = 0; k < 2; ++k) {
            const Vec3 at = any_vector(random, 2), theta = any_vector(random, 2);
            add_body(scene, {solid_box({1, 0.7, 0.4})}, 1.0, at, theta);
        }
        const VecX& x0 = scene.bodies.x;
        SpaceContact contact;
        contact.a = n % 2 == 0 ? world : 0, contact.b = 1;
        contact.normal = any_vector(random, 1).normalized();
        contact.radius_a = 0.1, contact.radius_b = 0.2;
        contact.at_b = any_vector(random, 1);
        // where the step finds contacts, the way between the points is along the normal
        const Vec3 p = point_of_solid(x0, 1, contact.at_b) - 0.25 * contact.normal;
        contact.at_a = rotation_of(x0, contact.a).transpose() * (p - centre_of(x0, contact.a));
        const Constraint<6> c = push_constraint(contact, place_of(contact, x0));
        CHECK(c.C == Approx(-0.05).margin(1e-14));
        for (Index k = 0; k < 12; ++k) {
            const auto gap = [&](Real d) {
                VecX x = x0;
                if (k % 6 < 3) x[k] += d;
                else {
                    Vec3 turn(0, 0, 0);
                    turn[k % 6 - 3] = d;
                    const Index at = 6 * (k / 6) + 3;
                    x.segment<3>(at) = add_rotation(x.segment<3>(at), turn);
                }
                return push_constraint(contact, place_of(contact, x)).C;
            };
            const Real row = k < 6 ? (contact.a == world ? 0 : c.Ja[k]) : c.Jb[k - 6];
            // arms of 2 m: d² of the third derivative and 1e-16/d of rounding are both below 1e-9
            CHECK((gap(1e-5) - gap(-1e-5)) / 2e-5 == Approx(row).margin(1e-9));
        }
    }
}
