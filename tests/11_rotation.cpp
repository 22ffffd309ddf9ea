/// Chapter 11: bodies that turn, on the step of Part I.

#include "tests/no_allocation.hpp"

#include "chapters/01_euler_integration/exact.hpp"
#include "chapters/04_pgs/pgs_method.hpp"
#include "chapters/05_lemke/lemke_method.hpp"
#include "chapters/06_sequential_impulse/restitution.hpp"
#include "chapters/09_active_sets/exact_method.hpp"
#include "chapters/11_rotation/mechanisms.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/limit.hpp"
#include "tests/order.hpp"
#include "tests/says.hpp"
#include "tests/sentence.hpp"

#include <array>

using namespace rigid;

namespace {

template <class Method>
void run(RigidScene& scene, Method& method, Real h, long steps, int substeps = 1)
{
    StepData<3> now;
    for (long i = 0; i < steps; ++i) step(scene, {.h = h, .substeps = substeps}, method, now);
}

RigidExact exact_method()
{
    RigidExact method;
    method.correction = exact_repair();
    return method;
}

Polygon random_polygon(Random& random, int corners)
{
    Polygon shape;
    const Real first = random.uniform(0, 2 * pi), size = random.uniform(0.5, 2);
    for (int i = 0; i < corners; ++i) {  // on an ellipse: convex
        const Real angle = first + 2 * pi * (i + random.uniform(0, 0.5)) / corners;
        shape.vertices.push_back(size * Vec2(2 * std::cos(angle), std::sin(angle)) + Vec2(3, -1));
    }
    shape.radius = random.uniform(0, 0.5);
    return shape;
}

Real distance_to(const Polygon& shape, const Vec2& p)
{
    const std::size_t n = shape.vertices.size();
    bool inside = n > 2;
    Real nearest = infinity;
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 a = shape.vertices[i], e = shape.vertices[(i + 1) % n] - a, d = p - a;
        const Real t = e.squaredNorm() > 0 ? std::clamp(d.dot(e) / e.squaredNorm(), Real{0}, Real{1}) : 0;
        nearest = std::min(nearest, (d - t * e).norm());
        inside = inside && cross2(e, d) >= 0;
    }
    return inside ? 0 : nearest;
}

/// Two bodies somewhere, and a joint of each kind between them or the world and the second.
RigidScene random_joints(Random& random)
{
    using Measure = PointJoint::Measure;
    RigidScene scene;
    for (int k = 0; k < 2; ++k) {
        const Real m = random.uniform(0.5, 3), inertia = random.uniform(0.1, 2);
        const Real x = random.uniform(-2, 2), y = random.uniform(-2, 2), angle = random.uniform(-7, 7);
        add_body(scene, box(1, 0.6), Mass{m, {0, 0}, inertia}, {x, y}, angle);
    }
    for (Index i = 0; i < 6; ++i) scene.bodies.u[i] = random.uniform(-2, 2);
    for (const Measure measure : {Measure::distance, Measure::along, Measure::turning, Measure::angle})
        for (const Index a : {world, Index{0}})
            for (const Real sense : {1.0, -1.0}) {
                PointJoint joint;
                joint.measure = measure, joint.a = a, joint.b = 1, joint.sense = sense;
                for (Vec2* const at : {&joint.at_a, &joint.at_b}) {
                    (*at)[0] = random.uniform(-1, 1);
                    (*at)[1] = random.uniform(-1, 1);
                }
                const Real turn = random.uniform(0, 2 * pi);
                joint.direction = {std::cos(turn), std::sin(turn)};
                joint.gear_a = random.uniform(-2, 2);
                joint.gear_b = random.uniform(-2, 2);
                joint.length = random.uniform(-1, 1);
                scene.joints.push_back(joint);
            }
    scene.walls.push_back({{0.6, 0.8}, 0.3});
    // these two have another point each for what they lead over
    for (std::size_t i = 0; i < 4; ++i)
        for (const Measure measure : {Measure::pulley, Measure::rack}) {
            PointJoint joint = scene.joints[i];
            joint.measure = measure;
            joint.over_a = {-4, 6}, joint.over_b = {4, 7};
            scene.joints.push_back(joint);
        }
    return scene;
}

/// J u beside the difference of C over a short time to both sides.
Real jacobian_error(const Constraint<3>& c, const std::function<Real(const VecX&)>& C, const VecX& x,
                    const VecX& u)
{
    const Real t = 1e-5;  // error t² C'''/6 of about 1e-9, and rounding 1e-16/t
    Real rate = c.Jb.dot(u.segment<3>(3 * c.b));
    if (c.a != world) rate += c.Ja.dot(u.segment<3>(3 * c.a));
    return std::abs(rate - (C(x + t * u) - C(x - t * u)) / (2 * t));
}

/// The accelerations of two rods in a row, in angles from straight down, without constraints: R1's own equations.
Vec<4> double_rates(const Vec<4>& s)
{
    const Real g = 9.81, c = std::cos(s[0] - s[1]), d = std::sin(s[0] - s[1]);
    const Real m11 = 4.0 / 3, m12 = c / 2, m22 = 1.0 / 3;
    const Real f1 = -d / 2 * s[3] * s[3] - 1.5 * g * std::sin(s[0]),
               f2 = d / 2 * s[2] * s[2] - 0.5 * g * std::sin(s[1]), det = m11 * m22 - m12 * m12;
    return {s[2], s[3], (m22 * f1 - m12 * f2) / det, (m11 * f2 - m12 * f1) / det};
}

Vec<4> double_by_rk4(Vec<4> s, Real h, long steps)
{
    for (long i = 0; i < steps; ++i) {
        const Vec<4> k1 = double_rates(s), k2 = double_rates(s + h / 2 * k1),
                     k3 = double_rates(s + h / 2 * k2), k4 = double_rates(s + h * k3);
        s += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    return s;
}

}  // namespace

// ---- identities of the scheme

TEST_CASE("sines that are remembered have the bits of those that are not", "[house]")
{
    Turns turns;
    Random random(17);
    std::vector<Real> angles(5, 0);
    for (int n = 0; n < 2000; ++n) {
        const Index k = random.index(5);
        Real& angle = angles[static_cast<std::size_t>(k)];
        if (n % 3 == 0)
            angle = n % 9 == 0 ? -angle * 0 : random.uniform(-10, 10);  // −0 is another angle than 0
        const auto [sine, cosine] = turns.of(k, angle);
        REQUIRE(sine == rigid::sin(angle));
        REQUIRE(std::signbit(sine) == std::signbit(rigid::sin(angle)));
        REQUIRE(cosine == rigid::cos(angle));
    }
    CHECK(std::isnan(turns.of(2, std::nan("")).sine));
    CHECK(turns.of(2, 0).cosine == 1);
}

TEST_CASE("a rod struck at its end by hand gets the impulse and the spin of (11.8)", "[idea]")
{
    RigidScene scene = struck_rod(pi / 6);
    RigidExact method;
    method.correction.restitution = 0.5;
    StepData<3> now;
    step(scene, {.h = 1.0 / 60}, method, now);
    // To rounding of a dozen operations on numbers of size 1.
    CHECK(now.solution.lambda.size() == 1);
    CHECK(std::abs(now.solution.lambda[0] - 6.0 / 13) <= 1e-12);
    CHECK(std::abs(scene.bodies.u[0]) <= 1e-12);
    CHECK(std::abs(scene.bodies.u[1] + 7.0 / 13) <= 1e-12);
    CHECK(std::abs(scene.bodies.u[2] + 18 * std::sqrt(3.0) / 13) <= 1e-12);
    CHECK((struck_rod_by_hand(pi / 6, 0.5) - Vec<3>(6.0 / 13, -7.0 / 13, -18 * std::sqrt(3.0) / 13)).norm() <=
          1e-12);
}

TEST_CASE("sweeps and Lemke and sequential impulses and active sets give the struck rod the same impulse",
          "[idea]")
{
    const auto check = [](auto method) {
        RigidScene scene = struck_rod(pi / 6);
        StepData<3> now;
        step(scene, {.h = 1.0 / 60}, method, now);
        CHECK(now.solution.status == Status::solved);
        // e = 0: 4/13. Sweeps end at a residual of 1e-10 m/s at the latest, one row is exact after one visit.
        CHECK(std::abs(now.solution.lambda[0] - 4.0 / 13) <= 1e-9);
    };
    check(RigidExact{});
    RigidSweeps sweeps;
    sweeps.solver.sweeps.tolerance =
        1e-12;  // without one no residual is computed, and nothing is called solved
    check(sweeps);
    struct ByLemke {
        AllBodies contacts;
        LeaveErrors correction;
        ColdStart start;
        MatrixSolver<FindByLemke> solver;
    };
    check(ByLemke{});
    struct ByPgs {
        AllBodies contacts;
        LeaveErrors correction;
        ColdStart start;
        MatrixSolver<FindBySweeps> solver;
    };
    check(ByPgs{});
}

TEST_CASE("the point two thirds from the struck end stays where it is at first as (11.10) says", "[idea]")
{
    RigidScene scene;
    scene.gravity = {0, 0};
    add_body(scene, capsule(1, 0), thin_rod(1, 1), {0, 0}, 0);
    Row<3> row;
    row.Jb = point_row({0.5, 0}, {0, 1});
    row.Wb = scene.bodies.inverse_mass.cwiseProduct(row.Jb.transpose());
    CHECK(std::abs(row.inverse_effective_mass() - 4) <= 1e-12);  // 1/m + (r × n)²/I = 1 + 3
    row.apply(1, scene.bodies.u);
    CHECK(velocity_at(scene.bodies, 0, {-1.0 / 6, 0}).norm() <= 1e-12);
    CHECK(std::abs(velocity_at(scene.bodies, 0, {-0.5, 0}).y() + 2) <= 1e-12);  // the far end moves backwards
    CHECK(std::abs(velocity_at(scene.bodies, 0, {0.5, 0}).y() - 4) <= 1e-12);
    CHECK(velocity_at(scene.bodies, world, {0.5, 0}).isZero(0));  // the world stands still
}

TEST_CASE("a pin feels nothing when its rod is struck at two thirds", "[idea]")
{
    RigidScene scene = rod_pendulum(std::array{0.0});  // the pin at the origin, the rod straight down
    scene.gravity = {0, 0};
    Row<3> row;
    row.Jb = point_row({0, -1.0 / 6}, {1, 0});
    row.Wb = scene.bodies.inverse_mass.cwiseProduct(row.Jb.transpose());
    row.apply(1, scene.bodies.u);
    RigidExact method;
    StepData<3> now;
    step(scene, {.h = 0.01}, method, now);
    CHECK(now.solution.lambda.cwiseAbs().maxCoeff() <= 1e-14);  // rounding of numbers of size 1
}

TEST_CASE("an upright rod bounces like a disc and a flat one weighs a quarter", "[idea]")
{
    for (const Real angle : {pi / 2, 1e-4}) {
        RigidScene scene = struck_rod(angle);
        scene.bodies.x[1] = std::sin(angle) / 2;
        RigidExact method;
        method.correction.restitution = 0.5;
        StepData<3> now;
        // The far end of the flat rod is 0.1 mm up: no margin, so that only the struck end is looked at.
        step(scene, {.h = 1e-6, .margin = 1e-6}, method, now);
        REQUIRE(now.solution.lambda.size() == 1);
        const Vec<3> hand = struck_rod_by_hand(angle, 0.5);
        CHECK(std::abs(now.solution.lambda[0] - hand[0]) <= 1e-12);
        CHECK(std::abs(scene.bodies.u[2] - hand[2]) <= 1e-12);
        const bool upright = angle > 1;
        CHECK(std::abs(hand[0] - (upright ? 1.5 : 1.5 / 4)) <= 1e-7);  // cos² of 1e-4 is 1 - 1e-8
        CHECK(std::abs(hand[2] - (upright ? 0 : -1.5 * 1.5)) <= 1e-7);
    }
}

TEST_CASE("a pin loses the arc of one step as (11.16) says", "[idea]")
{
    for (const Real h : {0.1, 0.01}) {
        RigidScene scene = rod_pendulum(std::array{pi / 2});
        scene.gravity = {0, 0};
        scene.bodies.u << 0, 1.5, 3;  // 3 rad/s about the pin
        RigidExact method;
        method.correction.method = Stabilizer::none;
        run(scene, method, h, 1);
        const Real phi = 3 * h;
        const Vec2 off = point_of(scene.bodies.x, 0, {-0.5, 0});
        // The centre goes along the tangent by r φ, the arm turns by φ: rounding alone is left.
        CHECK((off - 0.5 * Vec2(1 - std::cos(phi), phi - std::sin(phi))).norm() <= 1e-14);
        CHECK(off.norm() >= 0.99 * 0.25 * phi * phi * (1 - phi * phi));  // ½ r φ² to the leading order
        CHECK(off.norm() <= 1.01 * 0.25 * phi * phi);
    }
}

TEST_CASE("exact repair of a pin takes the spin that (11.17) says and velocity rows alone take none",
          "[idea]")
{
    const Real h = 0.02;
    const auto after_two = [h](Stabilizer way, Real& turned) {
        RigidScene scene = rod_pendulum(std::array{pi / 2});
        scene.gravity = {0, 0};
        scene.bodies.u << 0, 1.5, 3;
        RigidExact method = exact_method();
        method.correction.method = way;
        run(scene, method, h, 1);
        turned = scene.bodies.x[2];
        run(scene, method, h, 1);
        return std::array{scene.bodies.u[2] / 3, momenta(scene.bodies)[2]};  // both 1 at the start
    };
    Real phi = 0;
    const Real left = after_two(Stabilizer::projection, phi)[0];
    // The positions are repaired to 1e-13, which the spin inherits.
    CHECK(std::abs(left - (1 + 3 * std::cos(phi)) / 4) <= 1e-12);
    CHECK(left < 1 - 1e-3);
    // Without repair the impulse acts at the end, which is off the pin by 0.9 mm: (11.23), 1e-3 times smaller.
    CHECK(std::abs(after_two(Stabilizer::none, phi)[1] - 1) <= 1e-4);
}

TEST_CASE("a ball falls on a floor and lies a radius over it", "[idea]")
{
    RigidScene scene;
    scene.walls.push_back({{0, 1}, -0.5});
    add_body(scene, disc(0.25), 1, {0.3, 1}, 0.1);
    scene.bodies.u[2] = 2;
    RigidExact method = exact_method();
    run(scene, method, 1.0 / 240, 480);
    CHECK(std::abs(scene.bodies.x[1] + 0.25) <= 1e-12);
    CHECK(std::abs(scene.bodies.u[2] - 2) <= 1e-12);  // a floor without friction does not turn it
    CHECK(std::abs(scene.bodies.x[2] - 4.1) <= 1e-10);
}

TEST_CASE("a train of gears starts as one wheel with the inertia of (11.15)", "[idea]")
{
    const std::array<Real, 4> radii = {0.2, 0.5, 0.3, 0.6};
    RigidScene scene = gear_train(radii, 30, 2);
    RigidExact method = exact_method();
    const Real h = 0.01;
    run(scene, method, h, 1);
    const Real rate = 2 * h / gear_inertia(radii);
    const VecX& u = scene.bodies.u;
    // Twelve rows whose matrix has entries up to 100: rounding times a condition of 1e3.
    CHECK(std::abs(u[2] - rate) <= 1e-12);
    for (Index k = 1; k < 4; ++k)
        CHECK(std::abs(u[3 * k + 2] * radii[static_cast<std::size_t>(k)] +
                       u[3 * k - 1] * radii[static_cast<std::size_t>(k - 1)]) <= 1e-12);
    run(scene, method, h, 1000);
    CHECK(std::abs(u[2] - 30) <= 1e-9);  // the motor has reached its speed and holds it
    CHECK(scene.bodies.x[2] > 2 * pi);   // and no angle was wrapped, to the last bit:
    CHECK(joint_constraint(scene.bodies.x, scene.joints.back()).C == scene.bodies.x[2]);
    CHECK(largest_joint_error(scene) <= 1e-9);
}

TEST_CASE("a level seesaw starts with the angular acceleration by hand", "[idea]")
{
    for (const Real right : {10.0, 12.0, 3.0}) {
        RigidScene scene = seesaw(10, right);
        RigidExact method = exact_method();
        run(scene, method, 0.01, 1);
        // The ropes hang straight down, so the first step's impulses are those of rest: rounding alone.
        CHECK(std::abs(scene.bodies.u[2] / 0.01 - seesaw_by_hand(10, right)) <= 1e-10);
    }
}

TEST_CASE("momentum is kept to rounding and angular momentum where no anchor is off", "[idea]")
{
    Random random(4);
    for (int round = 0; round < 20; ++round) {
        RigidScene scene;
        scene.gravity = {0, 0};
        for (int k = 0; k < 4; ++k) {
            add_body(scene, box(0.8, 0.3), 2, {k, 0}, 0);
            for (Index i = 0; i < 3; ++i) scene.bodies.u[3 * k + i] = random.uniform(-1, 1);
        }
        for (Index k = 1; k < 4; ++k) {
            PointJoint link;  // its impulses are along the line through both anchors, whatever its error
            link.a = k - 1, link.b = k;
            link.at_a = {0.4, 0}, link.at_b = {-0.4, 0.1};
            link.length = std::hypot(0.2, 0.1);
            scene.joints.push_back(link);
        }
        const Vec<3> before = momenta(scene.bodies);
        RigidExact method;  // Baumgarte: errors stay, and still nothing turns
        run(scene, method, 0.01, 200);
        // 1e-13 a step of momenta of about 1 would be 2e-11; the errors are random and stay below 1e-12.
        CHECK((momenta(scene.bodies) - before).cwiseAbs().maxCoeff() <= 1e-12);
    }
}

TEST_CASE("angular momentum of pinned bodies changes by the impulse times the error of the pin", "[idea]")
{
    std::vector<Real> drifts;
    for (const Real h : {0.01, 0.005, 0.0025, 0.00125, 0.000625}) {
        RigidScene scene;
        scene.gravity = {0, 0};
        add_body(scene, capsule(1, 0), thin_rod(1, 1), {0.5, 0});
        add_body(scene, capsule(1, 0), thin_rod(1, 2), {1.5, 0});
        add_pin(scene, 0, {0.5, 0}, 1, {-0.5, 0});
        scene.bodies.u << 0, 0.5, 1, 0.3, 0, 2;
        RigidExact method;
        StepData<3> now;
        Real predicted = 0, start = 0;
        const long steps = std::lround(1 / h);
        for (long i = 0; i < steps; ++i) {
            const VecX x = scene.bodies.x;
            const Real L = momenta(scene.bodies)[2];
            if (i == 0) start = L;
            step(scene, {.h = h}, method, now);
            const Vec2 off = point_of(x, 1, {-0.5, 0}) - point_of(x, 0, {0.5, 0});
            predicted = cross2(off, Vec2(now.solution.lambda[0], now.solution.lambda[1]));
            // (11.23), step by step, to rounding.
            REQUIRE(std::abs(momenta(scene.bodies)[2] - L - predicted) <= 1e-13);
        }
        drifts.push_back(std::abs(momenta(scene.bodies)[2] - start));
    }
    for (const Real d : drifts) UNSCOPED_INFO(d);
    CHECK(drifts.front() > 1e-9);
    CHECK(std::abs(order_of(drifts) - 2) <= 0.15);
}

TEST_CASE("what a body cannot do has no share in its energy and momentum", "[house]")
{
    RigidScene scene;
    add_body(scene, box(1, 1), 2, {3, 1});
    add_body(scene, box(1, 1), 2, {5, 1});
    scene.bodies.u << 1, 2, 0, 0, 0, 3;
    scene.bodies.inverse_mass[2] = 0;                   // the first one does not turn
    scene.bodies.inverse_mass.segment<2>(3).setZero();  // the second one does nothing else
    const Real inertia = mass_of(box(1, 1), 2).inertia;
    // rounding of a few operations
    CHECK(std::abs(energy(scene) - (2 * 5.0 / 2 + 2 * 9.81 * 1 + inertia * 9 / 2)) <= 1e-13);
    CHECK((momenta(scene.bodies) - Vec<3>(2, 4, 2 * (3 * 2 - 1 * 1) + inertia * 3)).norm() <= 1e-13);
}

// ---- mass

TEST_CASE("mass and centroid and inertia agree with a sum over small squares", "[idea]")
{
    Random random(1);
    for (const int corners : {1, 2, 3, 4, 5, 8}) {
        Polygon shape = random_polygon(random, corners);
        if (corners < 3) shape.radius += 0.3;
        const Mass mass = mass_of(shape, 3);
        const int n = 600;
        Real area = 0, inertia = 0;
        Vec2 first(0, 0);
        const Vec2 low(-3, -4.5), size(12, 7);
        for (int pass = 0; pass < 2; ++pass)
            for (int i = 0; i < n; ++i)
                for (int j = 0; j < n; ++j) {
                    const Vec2 p = low + Vec2((i + 0.5) / n, (j + 0.5) / n).cwiseProduct(size);
                    if (distance_to(shape, p) > shape.radius) continue;
                    const Real piece = size.x() * size.y() / n / n;
                    if (pass == 0) area += piece, first += piece * p;
                    else inertia += 3 * piece * (p - mass.centroid).squaredNorm();
                }
        // Squares of 2 cm: an edge is off by a square's width at random, which averages to some 1e-3.
        CHECK(std::abs(3 * area / mass.mass - 1) <= 5e-3);
        CHECK((first / area - mass.centroid).norm() <= 5e-3);
        CHECK(std::abs(inertia / mass.inertia - 1) <= 1e-2);
    }
}

TEST_CASE("disc and box and capsule have the masses of the tables", "[idea]")
{
    const Mass round = mass_of(disc(0.5), 2), brick = mass_of(box(2, 1), 3),
               pill = mass_of(capsule(2, 0.5), 1);
    // Rounding of a dozen operations.
    CHECK(std::abs(round.inertia - round.mass * 0.25 / 2) <= 1e-14);
    CHECK(std::abs(brick.inertia - 6 * 5.0 / 12) <= 1e-14);
    const Real half = pi / 8, far = 4 * 0.5 / (3 * pi),
               ends = 2 * (half * 0.125 + half * ((1 + far) * (1 + far) - far * far));
    CHECK(std::abs(pill.mass - (2 + pi / 4)) <= 1e-14);
    CHECK(std::abs(pill.inertia - (2 * 5.0 / 12 + ends)) <= 1e-13);
    // The thin rod is the limit of both.
    const Mass thin = mass_of(box(1, 1e-5), 1e5), thin_pill = mass_of(capsule(1, 1e-6), 5e5);
    CHECK(std::abs(thin.inertia - 1.0 / 12) <= 1e-10);
    CHECK(std::abs(thin_pill.inertia / thin_pill.mass - 1.0 / 12) <= 1e-5);
}

TEST_CASE(
    "the mass of a polygon does not depend on its first vertex and its inertia not on its place or angle",
    "[idea]")
{
    Random random(2);
    for (int round = 0; round < 200; ++round) {
        const Polygon shape = random_polygon(random, 3 + round % 6);
        const Mass mass = mass_of(shape, 2);
        Polygon other = shape;
        std::rotate(other.vertices.begin(), other.vertices.begin() + 1, other.vertices.end());
        const Real angle = random.uniform(0, 6), c = std::cos(angle), s = std::sin(angle);
        const auto turned = [&](const Vec2& p) {
            return Vec2(c * p.x() - s * p.y() + 5, s * p.x() + c * p.y() - 7);
        };
        for (Vec2& v : other.vertices) v = turned(v);
        const Mass moved = mass_of(other, 2);
        // Rounding of numbers up to 10, squared.
        CHECK(std::abs(moved.mass - mass.mass) <= 1e-11);
        CHECK(std::abs(moved.inertia - mass.inertia) <= 1e-10);
        CHECK((moved.centroid - turned(mass.centroid)).norm() <= 1e-11);
    }
}

// ---- rows

TEST_CASE("J of every joint and of a corner is the derivative of C", "[idea]")
{
    Random random(3);
    for (int round = 0; round < 200; ++round) {
        const RigidScene scene = random_joints(random);
        const VecX &x = scene.bodies.x, &u = scene.bodies.u;
        for (const PointJoint& joint : scene.joints) {
            const auto C = [&](const VecX& at) { return joint_constraint(at, joint).C; };
            const Constraint<3> c = joint_constraint(x, joint);
            if (joint.measure == PointJoint::Measure::distance && c.C * joint.sense + joint.length < 0.1)
                continue;  // where the points nearly meet C bends without bound
            CHECK(jacobian_error(c, C, x, u) <= 1e-7);
        }
        for (std::size_t corner = 0; corner < 4; ++corner) {
            const auto C = [&](const VecX& at) { return corner_constraint(scene, at, 0, 1, corner).C; };
            CHECK(jacobian_error(corner_constraint(scene, x, 0, 1, corner), C, x, u) <= 1e-7);
        }
    }
}

TEST_CASE("a positive impulse of a corner pushes the corner off the wall", "[idea]")
{
    RigidScene scene = struck_rod(pi / 6);
    const Row<3> row =
        unilateral(corner_constraint(scene, scene.bodies.x, 0, 0, 0), scene.bodies.inverse_mass);
    const Vec2 end = point_of(scene.bodies.x, 0, {-0.5, 0});
    const Real before = velocity_at(scene.bodies, 0, end).y();
    row.apply(1, scene.bodies.u);
    CHECK(velocity_at(scene.bodies, 0, end).y() > before);
    CHECK(std::abs(velocity_at(scene.bodies, 0, end).y() - before - row.inverse_effective_mass()) <= 1e-12);
}

// ---- physics

TEST_CASE("light rods under a load shake themselves apart from the step of (11.21) on and not below",
          "[idea]")
{
    const Real load = 1000;
    for (const int rods : {2, 10})
        for (const Real part : {0.95, 1.05}) {
            RigidScene scene;
            for (int k = 0; k < rods; ++k) {
                add_body(scene, capsule(1, 0), thin_rod(1, 1), {0, -0.5 - k}, -pi / 2);
                add_pin(scene, k - 1, k == 0 ? Vec2(0, 0) : Vec2(0.5, 0), k, {-0.5, 0});
            }
            const Index end = add_body(scene, disc(0.2), Mass{load, {0, 0}, 20}, {0, -1.0 * rods});
            add_pin(scene, rods - 1, {0.5, 0}, end, {0, 0});
            // The pull differs by a hundredth from the upper end to the lower one; 5 % are far from either.
            const Real pull = 9.81 * (load + 0.5 * rods), cosine = std::cos(pi * (rods - 1) / rods);
            const Real h = part * 2 / std::sqrt(6 * pull * (1 - cosine) / (2 + cosine));
            for (int k = 0; k < rods; ++k) scene.bodies.u[3 * k + 2] = k % 2 == 0 ? 1e-6 : -1e-6;
            RigidExact method;
            method.correction = exact_correction();
            Real largest = 0;
            StepData<3> now;
            for (int n = 0; n < 400 && largest < 0.1; ++n) {
                step(scene, {.h = h}, method, now);
                for (int k = 0; k < rods; ++k)
                    largest = std::max(largest, std::abs(scene.bodies.x[3 * k + 2] + pi / 2));
            }
            INFO(rods << " rods at " << part << " of the step: " << largest);
            // 1e-6 rad/s for a step is 1e-8 rad; what does not grow stays near that.
            CHECK((part < 1 ? largest < 1e-5 : largest >= 0.1));
        }
}

TEST_CASE("RATTLE's impulse of a struck rod is off by the first order in h", "[idea]")
{
    const auto errors = [](int n) {
        RigidScene scene;
        scene.gravity.setZero();
        scene.walls.push_back({{0, 1}, 0});
        add_body(scene, capsule(1, 0), thin_rod(1, 1), {0, 0.25}, pi / 6);
        scene.bodies.u << 0, -1, 0;
        RigidRattle method;
        method.correction.restitution = 0.5;
        StepData<3> now;
        step(scene, {.h = 1.0 / n}, method, now);
        return std::abs(scene.bodies.u[1] + 7.0 / 13);
    };
    // measured: 0.0063 at 1/60 s; a quarter of the step, a quarter of the error
    CHECK(errors(60) <= 0.007);
    for (const int n : {60, 240, 960}) {
        const Real ratio = errors(n) / errors(4 * n);
        CHECK(ratio >= 3.7);
        CHECK(ratio <= 4.3);
    }
}

TEST_CASE("a rod on a pin swings as its closed form to first order in h", "[idea]")
{
    CHECK(std::abs(pendulum_period({.g = 9.81, .length = 2.0 / 3}, pi / 2) - 1.933334854373246) <= 1e-13);
    CHECK(std::abs(exact_pendulum({.g = 9.81, .length = 2.0 / 3}, pi / 2, 10).x[0] - 0.7709576225747731) <=
          1e-11);
    std::vector<Real> errors;
    for (const long steps : {16000L, 32000L, 64000L, 128000L, 256000L}) {
        RigidScene scene = rod_pendulum(std::array{pi / 2});
        RigidExact method = exact_method();
        run(scene, method, 10.0 / static_cast<Real>(steps), steps);
        errors.push_back(std::abs(rod_angle(scene, 0) - 0.7709576225747731));
        CHECK(largest_joint_error(scene) <= 1e-10);
    }
    CHECK(std::abs(order_of(errors) - 1) <= 0.15);
    CHECK(errors.back() <= 0.02);
}

TEST_CASE("two rods in a row follow their equations in angles to first order in h", "[idea]")
{
    // R1 of the reference values, and Runge-Kutta's own answer beside it.
    const Vec<4> truth = double_by_rk4({pi / 2, pi / 2, 0, 0}, 1e-3, 1000);
    CHECK((truth - Vec<4>(-1.207716238190638, -0.8143910230912964, -3.406517532971958, -0.5160454721052089))
              .cwiseAbs()
              .maxCoeff() <= 1e-8);
    std::vector<Real> errors;
    for (const long steps : {250L, 500L, 1000L, 2000L, 4000L}) {
        RigidScene scene = rod_pendulum(std::array{pi / 2, pi / 2});
        RigidExact method = exact_method();
        run(scene, method, 1.0 / static_cast<Real>(steps), steps);
        errors.push_back(
            std::max(std::abs(rod_angle(scene, 0) - truth[0]), std::abs(rod_angle(scene, 1) - truth[1])));
    }
    CHECK(std::abs(order_of(errors) - 1) <= 0.15);
    CHECK(errors.back() <= 2e-3);  // 1.42e-3 when it was written
}

TEST_CASE("RATTLE swings one rod and two rods to second order in h and keeps their energy so", "[idea]")
{
    std::vector<Real> one, two, energies;
    for (const long halving : {1L, 2L, 4L, 8L, 16L}) {
        RigidScene scene = rod_pendulum(std::array{pi / 2});
        RigidRattle method;
        StepData<3> now;
        Real worst = 0;
        for (long i = 0; i < 1000 * halving; ++i) {
            step(scene, {.h = 0.01 / static_cast<Real>(halving)}, method, now);
            worst = std::max(worst, std::abs(energy(scene)));
        }
        energies.push_back(worst);
        one.push_back(std::abs(rod_angle(scene, 0) - 0.7709576225747731));
        scene = rod_pendulum(std::array{pi / 2, pi / 2});
        run(scene, method, 0.004 / static_cast<Real>(halving), 250 * halving);
        two.push_back(std::abs(rod_angle(scene, 0) + 1.207716238190638));
        CHECK(largest_joint_error(scene) <= 1e-10);
    }
    CHECK(std::abs(order_of(one) - 2) <= 0.15);
    CHECK(std::abs(order_of(two) - 2) <= 0.15);
    CHECK(std::abs(order_of(energies) - 2) <= 0.15);
    CHECK(one.back() <= 4e-5);  // 3.0e-5 when it was written
    CHECK(two.back() <= 1e-6);  // 5.8e-7
}

TEST_CASE("RATTLE adds no energy to a box that turns by more than a radian in a step", "[idea]")
{
    for (const Real spin : {100.0, 1000.0, 10000.0})
        for (const int substeps : {1, 8}) {
            RigidScene scene;
            scene.walls = {{{0, 1}, 0}, {{1, 0}, -2}, {{-1, 0}, -2}};
            add_body(scene, box(1, 1), 1, {0, 1});
            scene.bodies.u[2] = spin;
            RigidRattle method;
            StepData<3> now;
            const Real start = energy(scene);
            Real most = start;
            for (int i = 0; i < 120; ++i) {
                step(scene, {.h = 1.0 / 60, .substeps = substeps}, method, now);
                most = std::max(most, energy(scene));
            }
            CHECK(most - start <= 1e-12 * start);  // rounding; it was 0.2 of it at 1000 rad/s
            CHECK(energy(scene) < 0.95 * start);   // it has struck
        }
}

TEST_CASE("a bead on a wire that turns runs out as the hyperbolic cosine to second order in h", "[idea]")
{
    std::vector<Real> errors;
    for (const long steps : {100L, 200L, 400L, 800L, 1600L}) {
        RigidScene scene;
        scene.gravity = {0, 0};
        add_body(scene, capsule(4, 0), Mass{}, {0, 0});  // turns at 2 rad/s whatever happens
        scene.bodies.u[2] = 2;
        add_body(scene, disc(0.05), 100, {0.5, 0});
        scene.bodies.u.tail<3>() << 0, 1, 0;
        PointJoint wire;
        wire.measure = PointJoint::Measure::turning;
        wire.a = 0, wire.b = 1;
        wire.direction = {0, 1};
        scene.joints.push_back(wire);
        RigidRattle method;
        run(scene, method, 1.0 / static_cast<Real>(steps), steps);
        errors.push_back(std::abs(scene.bodies.position(1).head<2>().norm() - 0.5 * std::cosh(2.0)));
        CHECK(largest_joint_error(scene) <= 1e-11);
    }
    CHECK(std::abs(order_of(errors) - 2) <= 0.15);
    CHECK(errors.back() <= 2e-6);  // 9.4e-7 when it was written
}

TEST_CASE("two starts of the double pendulum that differ by a hair part and two equal ones do not", "[idea]")
{
    const auto end_after = [](Real hair) {
        RigidScene scene = rod_pendulum(std::array{2.5, 2.5 + hair});
        RigidExact method = exact_method();
        run(scene, method, 1.0 / 500, 4000);
        return point_of(scene.bodies.x, 1, {0.5, 0});
    };
    const Vec2 plain = end_after(0);
    CHECK((plain - end_after(0)).norm() == 0);
    CHECK((plain - end_after(1e-6)).norm() > 1e-3);  // a thousand times as far in 8 s
}

TEST_CASE("a ladder without friction leaves the wall at two thirds of its height", "[idea]")
{
    std::vector<Real> errors;
    for (const Real h : {1.0 / 240, 1.0 / 480, 1.0 / 960, 1.0 / 1920, 1.0 / 3840}) {
        const Real start = pi / 9;
        RigidScene scene = ladder(start);
        RigidExact method = exact_method();
        StepData<3> now;
        bool leans = true;
        Real height = 0;
        for (Limit steps(20000); leans && steps.left();) {
            height = scene.bodies.x[1] / std::cos(start);
            step(scene, {.h = h}, method, now);
            leans = false;
            for (std::size_t i = 0; i < now.contacts.size(); ++i)
                leans = leans ||
                        (now.contacts[i].normal.x() > 0.5 && now.solution.lambda[static_cast<Index>(i)] > 0);
        }
        errors.push_back(std::abs(height - 2.0 / 3));
    }
    CHECK(errors.front() <= 0.03);
    CHECK(errors.back() <= 0.003);  // one step is 0.001 of the height there
}

TEST_CASE("the slider of a crank is where the closed form says to ten digits with exact repair", "[idea]")
{
    RigidScene scene = slider_crank();
    RigidExact method = exact_method();
    StepData<3> now;
    for (int i = 0; i < 1000; ++i) {
        step(scene, {.h = 1.0 / 960}, method, now);
        const Vec2 slider = point_of(scene.bodies.x, 1, {0.25, 0});
        REQUIRE(std::abs(slider.x() - slider_by_hand(scene.bodies.x[2])) <= 1e-10);
        REQUIRE(std::abs(slider.y()) <= 1e-10);
    }
}

TEST_CASE("the slider is off by the square of h where Baumgarte corrects", "[idea]")
{
    std::vector<Real> errors;
    for (const Real h : {1.0 / 240, 1.0 / 480, 1.0 / 960, 1.0 / 1920, 1.0 / 3840}) {
        RigidScene scene = slider_crank();
        RigidExact method;
        Real largest = 0;
        StepData<3> now;
        for (long i = 0; i < std::lround(1 / h); ++i) {
            step(scene, {.h = h}, method, now);
            const Vec2 slider = point_of(scene.bodies.x, 1, {0.25, 0});
            if (static_cast<Real>(i) * h > 0.25)
                largest = std::max(largest, std::abs(slider.x() - slider_by_hand(scene.bodies.x[2])));
        }
        errors.push_back(largest);
    }
    CHECK(std::abs(order_of(errors) - 2) <= 0.15);
}

TEST_CASE("small steps make a rod pendulum better for the same number of row visits", "[idea]")
{
    const auto error_of = [](Real h, int substeps, int sweeps) {
        RigidScene scene = rod_pendulum(std::array{pi / 2, pi / 2});
        RigidSweeps method;
        method.correction.method = Stabilizer::projection;
        method.correction.beta = 1;
        method.correction.correction_sweeps = 1;
        method.start.from = Start::previous;
        method.solver.sweeps.max_sweeps = sweeps;
        run(scene, method, h, std::lround(1 / h), substeps);
        return std::abs(rod_angle(scene, 0) + 1.207716238190638);
    };
    CHECK(error_of(1.0 / 50, 16, 1) < 0.5 * error_of(1.0 / 50, 1, 16));
}

// ---- properties

TEST_CASE("turning and mirroring and reordering a scene of bodies does the same to its motion", "[idea]")
{
    const auto build = [](Real angle, bool mirror, bool swap) {
        const Real c = std::cos(angle), s = std::sin(angle), f = mirror ? -1 : 1;
        const auto map = [&](const Vec2& p) {
            return Vec2(c * f * p.x() - s * p.y(), s * f * p.x() + c * p.y());
        };
        RigidScene scene;
        scene.gravity = map({0, -9.81});
        const std::array<Vec2, 2> at = {Vec2(0.5, 0.1), Vec2(1.4, -0.2)};
        const std::array<Real, 2> turn = {0.3, -0.8};
        for (int i = 0; i < 2; ++i) {
            const std::size_t k = static_cast<std::size_t>(swap ? 1 - i : i);
            add_body(scene, box(1, 0.2), 3 + static_cast<Real>(k), map(at[k]), f * turn[k] + angle);
        }
        const Index first = swap ? 1 : 0, second = 1 - first;
        // Points in the body's own axes, mirrored with it (the box is its own mirror image after a flip of y).
        const Vec2 left(-0.5, 0.1), right(0.5, 0.05);
        const auto own = [&](const Vec2& p) { return mirror ? Vec2(-p.x(), p.y()) : p; };
        add_pin(scene, world, map({0, 0}), first, own(left));
        PointJoint link;
        link.a = first, link.b = second;
        link.at_a = own(right), link.at_b = own({-0.4, 0});
        link.length = 0.4;
        scene.joints.push_back(link);
        scene.walls.push_back({map({0, 1}), -1.2});
        return std::pair(scene, first);
    };
    // Both problems solved exactly: a sweep over positions would depend on how the two rows of a pin are turned.
    const auto move = [](RigidScene& scene) {
        RigidExact method;
        method.correction.method = Stabilizer::split_impulse;
        run(scene, method, 1.0 / 240, 100);
    };
    auto [plain, zero] = build(0, false, false);
    move(plain);
    for (const bool mirror : {false, true})
        for (const bool swap : {false, true})
            for (const Real angle : {0.0, 1.0, 2.5}) {
                auto [other, first] = build(angle, mirror, swap);
                move(other);
                const Real c = std::cos(angle), s = std::sin(angle), f = mirror ? -1 : 1;
                for (Index k = 0; k < 2; ++k) {
                    const Vec2 p = plain.bodies.position(k).head<2>();
                    const Index mine = k == 0 ? first : 1 - first;
                    // 100 steps grow rounding by some powers of ten.
                    CHECK((other.bodies.position(mine).head<2>() -
                           Vec2(c * f * p.x() - s * p.y(), s * f * p.x() + c * p.y()))
                              .norm() <= 1e-8);
                    CHECK(std::abs(other.bodies.x[3 * mine + 2] - f * plain.bodies.x[3 * k + 2] - angle) <=
                          1e-8);
                }
            }
}

TEST_CASE("other units of mass and length give the same motion in those units", "[idea]")
{
    const auto angle_of = [](Real mass, Real length) {
        RigidScene scene;
        scene.gravity = {0, -9.81 * length};
        add_body(scene, box(length, 0.1 * length), 10 * mass / (length * length), {0.5 * length, 0});
        add_pin(scene, world, {0, 0}, 0, {-0.5 * length, 0});
        RigidExact method = exact_method();
        run(scene, method, 1.0 / 240, 240);
        return scene.bodies.x[2];
    };
    const Real plain = angle_of(1, 1);
    for (const Real mass : {1.0, 1e-3, 1e3})
        for (const Real length : {1.0, 1e-2, 1e2}) CHECK(std::abs(angle_of(mass, length) - plain) <= 1e-8);
}

TEST_CASE("nothing random makes a number that is not finite", "[idea]")
{
    Random random(9);
    for (int round = 0; round < 50; ++round) {
        RigidScene scene = random_joints(random);
        scene.joints.resize(4);
        RigidSweeps method;
        run(scene, method, 1.0 / 60, 60);
        CHECK(scene.bodies.x.allFinite());
        CHECK(scene.bodies.u.allFinite());
    }
}

TEST_CASE("a steady step of bodies that turn allocates nothing", "[house]")
{
    RigidScene scene = rod_pendulum(std::array{0.1, 0.1});
    RigidSweeps method;
    StepData<3> now;
    for (int i = 0; i < 5; ++i) step(scene, {.h = 1.0 / 240}, method, now);
    {
        const NoAllocation watch;
        for (int i = 0; i < 50; ++i) step(scene, {.h = 1.0 / 240}, method, now);
    }
    CHECK(NoAllocation::violations() == 0);
}

TEST_CASE("a wall without direction and a shape that was spoilt are refused with a sentence", "[idea]")
{
    RigidScene scene = rod_pendulum(std::array{0.1});
    scene.walls = {{{0, 1}, -3}, {{0, 2}, -3}};
    const auto stepped = [&] {
        return sentence_of([&] {
            RigidSweeps method;
            RigidScene broken = scene;
            run(broken, method, 0.01, 1);
        });
    };
    CHECK(stepped() == "the length of the normal of wall 1 is 2; it must be 1");
    scene.walls[1] = {{0, 1}, std::nan("")};
    CHECK(stepped() == "the offset of wall 1 is nan; it must be finite");
    scene.walls.clear();
    CHECK_NOTHROW(require_valid(scene));
    // A step does not look at shapes each time: code that changes one calls require_valid(scene).
    scene.shapes[0].radius = -1;
    CHECK(sentence_of([&] { require_valid(scene); }) ==
          "the shape of body 0: the radius of the polygon is -1 m; it must be between 0 and 1e75");
}

TEST_CASE("bad polygons and masses and joints are refused with a sentence", "[idea]")
{
    const auto refused = [](const Polygon& shape, Real density) {
        return sentence_of([&] { mass_of(shape, density); });
    };
    CHECK(refused({}, 1) == "the polygon has no vertex; it needs one or more");
    CHECK(refused(disc(-1), 1) == "the radius of the polygon is -1 m; it must be between 0 and 1e75");
    CHECK(refused(disc(1e76), 1) == "the radius of the polygon is 1e+76 m; it must be between 0 and 1e75");
    CHECK(refused(box(1e76, 1), 1) ==
          "vertex 0 of the polygon is (-5e+75, -0.5); both must be numbers between -1e75 and 1e75");
    CHECK(refused(box(1e-76, 1), 1) ==
          "the edge of the polygon from vertex 0 is 1e-76 m long; it must be 1e-75 or more");
    CHECK(refused(disc(0), 1) ==
          "the polygon has the area 0 m²; it must be positive: three vertices, or a radius");
    CHECK(refused(capsule(1, 0), 1) ==
          "the polygon has the area 0 m²; it must be positive: three vertices, or a radius");
    CHECK(refused(disc(1), 0) == "the density is 0 kg/m²; it must be positive and finite");
    CHECK(refused({{{0, 0}, {0, 1}, {1, 0}}, 0}, 1).find("a convex one, counterclockwise") !=
          std::string::npos);
    CHECK(refused({{{0, 0}, {2, 0}, {0.5, 0.5}, {0, 2}}, 0}, 1).find("at vertex 2") != std::string::npos);
    CHECK(refused({{{0, 0}, {0, 0}, {1, 1}}, 0}, 1) ==
          "vertices 0 and 1 of the polygon are the same point; each must be its own");
    CHECK(refused({{{0, 0}, {1, std::nan("")}, {1, 1}}, 0}, 1) ==
          "vertex 1 of the polygon is (1, nan); both must be numbers between -1e75 and 1e75");
    Polygon star;
    for (int i = 0; i < 5; ++i) star.vertices.push_back({std::cos(4 * pi * i / 5), std::sin(4 * pi * i / 5)});
    CHECK(refused(star, 1) == "the polygon goes around 2 times; a convex one goes around once");

    RigidScene scene;
    CHECK(sentence_of([&] {
              add_body(scene, disc(1), Mass{0, {0, 0}, 1}, {0, 0});
          }) == "a body has the mass 0 kg and the inertia 1 kg m²; both must be positive, or both zero (it "
                "cannot move)");
    CHECK(sentence_of([&] {
              add_body(scene, disc(1), Mass{-1, {0, 0}, 1}, {0, 0});
          }).find("the mass -1 kg") != std::string::npos);
    CHECK(
        sentence_of([&] {
            add_body(scene, disc(1), Mass{1, {std::nan(""), 2}, 1}, {0, 0});
        }) ==
        "a body has its centroid at (nan, 2) m of its own axes; both must be numbers between -1e75 and 1e75");
    CHECK(scene.bodies.count() == 0);
    CHECK(sentence_of([&] {
              add_gears(scene, world, 1, 3, 2);
          }).find("joint 0 joins bodies -1 and 3 among 0") == 0);
    CHECK(scene.joints.empty());

    scene = rod_pendulum(std::array{0.1});
    const auto stepped = [](RigidScene broken) {
        return sentence_of([&] {
            RigidSweeps method;
            run(broken, method, 0.01, 1);
        });
    };
    CHECK(stepped(scene) == "accepted");
    RigidScene broken = scene;
    broken.joints[1].b = 7;
    CHECK(stepped(broken).find("joint 1 joins bodies -1 and 7 among 1") == 0);
    broken = scene;
    broken.joints[0].direction = {1, 1};
    CHECK(stepped(broken).find("joint 0 has a direction of the length 1.41") == 0);
    broken = scene;
    broken.shapes.clear();
    CHECK(stepped(broken) == "the scene has 0 shapes and 1 bodies; each needs its own");
    broken = scene;
    broken.length = -2;
    CHECK(stepped(broken) ==
          "the length of the scene is -2 m; it must be positive and finite, or zero to be derived");
    broken = scene;
    broken.bodies.x[2] = std::nan("");
    CHECK(stepped(broken) == "x[2] is nan; it must be a finite number");
}
