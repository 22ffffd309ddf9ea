/// The small programs of chapters 11 to 13, whose bodies turn, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/11_rotation/rigid_method.hpp"
#include "chapters/12_contact_manifolds/manifold_method.hpp"
#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/slopes.hpp"
#include "tests/catch.hpp"
#include "tests/small/quiet_sweeps.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small11 {
#include "chapters/11_rotation/small.cpp"
}
namespace small12 {
#include "chapters/12_contact_manifolds/small.cpp"
}
namespace small13 {
#include "chapters/13_friction/small.cpp"
}
#undef main

using namespace rigid;

namespace {

/// Chapters 12 and 13: body 0 is the floor, which the library has as a wall.
small12::Bodies six_boxes()
{
    small12::Bodies d;
    small12::add_box(d, 50, 0.5, INFINITY, {0, -0.5, 0});
    for (int k = 0; k < 6; ++k) small12::add_box(d, 0.5, 0.5, 1, {0, 0.5 + k, 0});
    return d;
}

/// Sweeps with friction, ten a step, from the last impulses: none of what the library's method has besides.
struct PlainFriction {
    WithFriction<Manifolds> contacts;
    Correction correction;
    WarmStart start;
    ImpulseSolver<3> solver;
};

template <class Bodies>
Real apart(const Bodies& d, const RigidScene& scene)
{
    const Index n = scene.bodies.x.size();
    return std::max((d.x.tail(n) - scene.bodies.x).cwiseAbs().maxCoeff(),
                    (d.u.tail(n) - scene.bodies.u).cwiseAbs().maxCoeff());
}

}  // namespace

TEST_CASE("the small program of chapter 11 has the numbers of the text and the library's to 1e-12")
{
    // By hand, section 11.1.
    small11::Bodies rod{{}, {}, {}, {}, VecX{{0, 1, 0}}};
    small11::add_box(rod, 0.5, 0, 1, {0, 0.25, pi / 6});
    rod.u[1] = -1;
    small11::Contact c = small11::find_contacts(rod).at(0);
    c.bias = 0.5 * c.J.dot(rod.u);
    small11::visit(c, rod);
    CHECK(c.lambda == Approx(6.0 / 13).epsilon(1e-14));
    CHECK((rod.u - VecX{{0, -7.0 / 13, -18 * std::sqrt(3.0) / 13}}).norm() < 1e-14);

    small11::Bodies d{{}, {}, {}, {}, VecX{{0, 1, 0}}};
    small11::add_box(d, 0.5, 0, 1, {0, 0.3, pi / 6});
    small11::add_box(d, 0.2, 0.1, 1, {-0.9, 1, 0.5});
    RigidScene scene;
    scene.walls.push_back({{0, 1}, 0});
    scene.length = 1;
    add_body(scene, capsule(1, 0), thin_rod(1, 1), {0, 0.3}, pi / 6);
    add_body(scene, box(0.4, 0.2), 1 / 0.08, {-0.9, 1}, 0.5);
    REQUIRE((d.inverse_mass - scene.bodies.inverse_mass).norm() < 1e-12);
    QuietMethod<3, AllBodies, Correction, WarmStart> method;
    method.correction.method = Stabilizer::baumgarte;
    method.correction.beta = 0.2;
    method.start.from = Start::previous;
    Real farthest = 0;
    for (int n = 0; n < 240; ++n) {
        INFO("step " << n);
        const int sweeps = small11::step(d, 1.0 / 240, 0.2);
        REQUIRE(method(scene) == sweeps);
        farthest = std::max(farthest, apart(d, scene));
    }
    CHECK(farthest < 1e-12);  // the same visits, whose sums have another order
    CHECK(d.x[0] == 0);       // a floor without friction pushes straight up
    CHECK(d.x[2] == Approx(0).margin(1e-9));
}

TEST_CASE("the small program of chapter 12 has the numbers of the text and the library's to 1e-12")
{
    // By hand, section 12.1, from zero to rows that are off by 1e-6 m/s.
    small12::Bodies across{{}, {}, {}, {}, 10};
    small12::add_box(across, 2, 1, INFINITY, {0, 0, 0});
    small12::add_box(across, 1, 0.5, 3, {1.5, 1.49, 0});
    for (int n = 0; n < 30; ++n) {  // the rest from what it remembers, where it is
        small12::Bodies before = across;
        small12::step(across, 0.1, 0);
        before.contacts = across.contacts;
        if (n < 29) across = before;
    }
    REQUIRE(across.contacts.size() == 2);
    for (const small12::Contact& c : across.contacts) {
        const bool right = c.name == 2;
        CHECK(c.name == (right ? 2 : 4));
        CHECK((c.p - Vec2(right ? 2 : 0.5, 0.995)).norm() < 1e-15);
        CHECK(c.C == Approx(-0.01).epsilon(1e-12));
        CHECK(c.lambda == Approx(right ? 2 : 1).epsilon(1e-12));
    }

    // Six boxes, each narrower than the one below it. (Where corners lie over each other the library may list a point by
    // its new name in another place, and sweeps that have not converged depend on the order.)
    small12::Bodies d;
    small12::add_box(d, 50, 0.5, INFINITY, {0, -0.5, 0});
    RigidScene scene;
    scene.walls.push_back({{0, 1}, 0});
    for (int k = 0; k < 6; ++k) {
        const Real width = 2 - 0.2 * k;
        small12::add_box(d, width / 2, 0.5, 1, {0.01 * (k % 2), 0.5 + k, 0});
        add_body(scene, box(width, 1), 1 / width, {0.01 * (k % 2), 0.5 + k});
    }
    scene.length = 1;
    QuietMethod<3, Manifolds, Correction, WarmStart> method;
    method.solver.most = 10;
    method.correction.method = Stabilizer::baumgarte;
    method.correction.beta = 0.2;
    method.start.from = Start::previous;
    Real farthest = 0;
    for (int n = 0; n < 100; ++n) {
        INFO("step " << n);
        const int sweeps = small12::step(d, 1.0 / 60, 0.2, 10);
        REQUIRE(method(scene, 1.0 / 60) == sweeps);
        farthest = std::max(farthest, apart(d, scene));
    }
    CHECK(farthest < 1e-12);
}

TEST_CASE("the small program of chapter 12 lets a stack fall on one point and stand on two with names")
{
    const auto top = [](int points, bool remembered) {
        small12::Bodies d = six_boxes();
        d.points = points;
        for (int n = 0; n < 240; ++n) {
            if (!remembered) d.contacts.clear();
            small12::step(d, 1.0 / 60, 0.2, 10);
        }
        return d.x[19];
    };
    CHECK(top(2, true) == Approx(5.5).margin(1e-3));
    CHECK(top(2, false) < 5.49);
    CHECK(top(1, true) < 4);
}

TEST_CASE("the small program of chapter 13 has the numbers of the text and of Coulomb's law")
{
    // By hand, section 13.1. Sweeps over four rows shrink the error by less than 0.9 each: 300 of them reach rounding.
    for (const auto& [mu, speed] : {std::pair{0.9, 0.0}, {0.75, 0.0}, {0.5, 0.2}, {0.0, 0.6}}) {
        small13::Bodies d = small13::boxes(1, std::atan(0.75), mu, 10);
        small13::step(d, 0.1, 300);
        // The floor is 200 m wide: its corners are rounded by 1e-14 m, and a gap of that closes in h.
        CHECK(d.u.segment<2>(3).norm() == Approx(speed).margin(1e-12));
    }
    // A slope holds up to arctan 0.3, and beyond it a box slides by (13.1): from rest, n steps end at a h² n (n + 1)/2.
    for (const Real degrees : {16.5, 16.9, 30.0}) {
        INFO(degrees);
        small13::Bodies d = small13::boxes(1, degrees * pi / 180, 0.3);
        const VecX start = d.x;
        for (int n = 0; n < 480; ++n) small13::step(d, 1.0 / 240, 10);
        const Real way = block_by_hand(degrees, 0.3) * 2 * (1 + 1.0 / 480);
        // Ten sweeps leave four rows on three velocities off by some µm/s.
        CHECK((d.x - start).segment<2>(3).norm() == Approx(way).margin(2e-5));
    }
}

TEST_CASE("the small program of chapter 13 makes the visits of the library to 1e-12")
{
    // The same for four boxes, whose top one is pushed aside.
    small13::Bodies d{{}, {}, {}, {}, 9.81, 0.6};
    small13::add_box(d, 50, 0.5, INFINITY, {0, -0.5, 0});
    RoughScene scene;
    add_body(scene, box(100, 1), Mass{}, {0, -0.5});  // on a wall drag would act on the wall, half a gap away
    for (int k = 0; k < 4; ++k) {
        const Real width = 2 - 0.2 * k;
        small13::add_box(d, width / 2, 0.5, 1, {0, 0.5 + k, 0});
        add_body(scene, box(width, 1), 1 / width, {0, 0.5 + k});
    }
    d.u[12] = scene.bodies.u[12] = 0.5;
    scene.length = 1;
    cover(scene, {0.6, 0, 0, 0});
    PlainFriction method;
    method.correction.method = Stabilizer::baumgarte;
    method.correction.beta = 0.2;
    method.correction.slop = 0.005;
    method.start.from = Start::previous;
    method.solver.sweeps.max_sweeps = 10;
    method.solver.sweeps.tolerance = 0;
    StepData<3> now;
    Real farthest = 0;
    for (int n = 0; n < 100; ++n) {
        small13::step(d, 1.0 / 240, 10);
        step(scene, {.h = 1.0 / 240}, method, now);
        farthest = std::max(farthest, apart(d, scene));
        if (n == 2) CHECK(farthest < 1e-12);  // the same visits
    }
    // From the fourth step on some remembered friction is above μ times its remembered normal, which sank after it; the
    // library presses it into that bound before the sweeps, the small program with their first visit. What ten sweeps
    // leave differs by that.
    CHECK(farthest < 2e-4);
    CHECK(d.x[12] - d.x[9] > 0.01);  // it slid
    // Section 13.5: a stack of ten stands.
    small13::Bodies tower = small13::boxes(10, 0, 0.6);
    for (int n = 0; n < 2400; ++n) small13::step(tower, 1.0 / 240, 10);
    CHECK(tower.u.cwiseAbs().maxCoeff() < 1e-3);
    CHECK((tower.x - small13::boxes(10, 0, 0.6).x).cwiseAbs().maxCoeff() < 0.01);
}

namespace {

// What the sentences of these chapters say.

Numbers rod(Numbers in)
{
    small11::Bodies d{{}, {}, {}, {}, Eigen::VectorXd{{0, 1, 0}}};
    const double angle = in["angle"] * degree;
    small11::add_box(d, 0.5, 0, 1, {0, 0.5 * std::sin(angle), angle});
    d.u[1] = -1;
    small11::Contact c = small11::find_contacts(d).at(0);
    c.bias = in["e"] * c.J.dot(d.u);
    small11::visit(c, d);
    return {{"lambda", c.lambda}, {"v", d.u[1]}, {"omega", d.u[2]}};
}

Numbers across(Numbers in)
{
    small12::Bodies d{{}, {}, {}, {}, 10};
    small12::add_box(d, 2, 1, INFINITY, {0, 0, 0});
    small12::add_box(d, 1, 0.5, 3, {in["x"], 1.49, 0});
    small12::step(d, 0.1, 0);
    REQUIRE(d.contacts.size() == 2);
    const bool first = d.contacts[0].p.x() < d.contacts[1].p.x();
    return {{"left", d.contacts[first ? 0 : 1].lambda}, {"right", d.contacts[first ? 1 : 0].lambda}};
}

Numbers slope(Numbers in)
{
    small13::Bodies d = small13::boxes(1, in["angle"] * degree, in["mu"], 10);
    small13::step(d, 0.1, 1000);
    return {{"speed", d.u.segment<2>(3).norm()}, {"limit", std::atan(in["mu"]) / degree}};
}

const Sentence says_rod("rod", rod, 1e-12);
const Sentence says_across("across", across, 1e-5);  // sweeps to 1e-6 m/s on 3 kg
const Sentence says_slope("slope", slope, 1e-9);     // a thousand sweeps

}  // namespace
