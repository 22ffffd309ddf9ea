/// Chapter 24: rows of contacts in space, friction on a disc, and what becomes of both in a step.

#include "tests/no_allocation.hpp"

#include "chapters/09_active_sets/exact_method.hpp"
#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "chapters/24_friction_is_a_disc/rough_touching.hpp"
#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"

#include "tests/catch.hpp"
#include "tests/sentence.hpp"

using namespace rigid;

namespace {

Vec3 random_triple(Random& random, Real size)
{
    const Real x = random.uniform(-size, size), y = random.uniform(-size, size),
               z = random.uniform(-size, size);
    return {x, y, z};
}

template <class Method>
void go_on(RoughSolids& scene, Method& method, StepData<6>& now, Real h, long steps)
{
    for (long i = 0; i < steps; ++i) step(scene, {.h = h}, method, now);
}

RoughCones tight_cones()
{
    RoughCones method;
    method.solver.sweeps = {20000, 1e-13};
    return method;
}

/// Two hulls on their way to each other, in free flight.
RoughSolids colliding_hulls(Random& random, Real mu)
{
    RoughSolids scene;
    scene.gravity.setZero();
    for (int k = 0; k < 2; ++k) {
        std::vector<Vec3> points;
        for (int i = 0; i < 10; ++i) points.push_back(random_triple(random, 0.5));
        const Vec3 at = Vec3(k == 0 ? -1 : 1, 0, 0) + random_triple(random, 0.1),
                   theta = random_triple(random, 1.5);
        add_body(scene, {solid_hull(points)}, 1000.0, at, theta);
        scene.bodies.velocity(k).head<3>() = Vec3(k == 0 ? 2 : -2, 0, 0);
        scene.bodies.velocity(k).tail<3>() = random_triple(random, 1);
    }
    scene.friction.assign(2, mu);
    return scene;
}

}  // namespace

// ---- rows ---------------------------------------------------------------------------------------

TEST_CASE("J of a contact is the derivative of its gap and of its slide", "[idea]")
{
    Random random(11);
    Real worst = 0;
    for (int n = 0; n < 100; ++n) {
        RoughSolids scene = colliding_hulls(random, 0.5);
        SpaceContact contact;
        contact.a = n % 2 == 0 ? world : 0, contact.b = 1;
        contact.normal = random_triple(random, 1).normalized();
        contact.radius_a = 0.1, contact.radius_b = 0.2;
        contact.at_b = random_triple(random, 1);
        // where the step finds contacts, the way between the points is along the normal
        const Vec3 p = point_of_solid(scene.bodies.x, 1, contact.at_b) - 0.25 * contact.normal;
        contact.at_a =
            rotation_of(scene.bodies.x, contact.a).transpose() * (p - centre_of(scene.bodies.x, contact.a));
        const ContactPlace here = place_of(contact, scene.bodies.x);
        const Real gap = push_constraint(contact, here).C;
        CHECK(gap == Approx(-0.05).margin(1e-14));
        // the point between the surfaces, fixed in either body
        const Vec3 drag = p + (contact.radius_a + gap / 2) * contact.normal;
        const auto fixed = [&](Index k) -> Vec3 {
            return rotation_of(scene.bodies.x, k).transpose() * (drag - centre_of(scene.bodies.x, k));
        };
        const Vec3 of_a = fixed(contact.a), of_b = fixed(1), t1 = across(contact.normal);
        for (const int part : {push_part, int{first_tangent}, int{second_tangent}}) {
            const Vec3 t = part == first_tangent ? t1 : cross(contact.normal, t1);
            const Constraint<6> c = part == push_part
                                        ? push_constraint(contact, here)
                                        : drag_constraint(contact, here, static_cast<SpacePart>(part), 0);
            for (Index k = 0; k < 12; ++k) {
                const auto value = [&](Real d) {
                    VecX x = scene.bodies.x;
                    if (k % 6 < 3) x[k] += d;
                    else {
                        Vec3 turn(0, 0, 0);
                        turn[k % 6 - 3] = d;
                        const Index at = 6 * (k / 6) + 3;
                        x.segment<3>(at) = add_rotation(x.segment<3>(at), turn);
                    }
                    if (part == push_part) return push_constraint(contact, place_of(contact, x)).C;
                    return t.dot(point_of_solid(x, 1, of_b) - point_of_solid(x, contact.a, of_a));
                };
                const Real slope = (value(1e-5) - value(-1e-5)) / 2e-5;
                worst = std::max(worst, std::abs(slope - (k < 6 ? c.Ja[k] : c.Jb[k - 6])));
            }
        }
    }
    CHECK(worst < 1e-9);  // the third derivative times 1e-10 / 6, and roundings over 2e-5
}

TEST_CASE("what rests keeps its rows and starts from their impulses", "[idea]")
{
    RoughSolids scene = box_stack(3, 0.1, 0.5);
    RoughCones method;
    StepData<6> now;
    go_on(scene, method, now, 1.0 / 60, 60);
    CHECK(now.contacts.size() == 12);
    for (int i = 0; i < 60; ++i) {
        go_on(scene, method, now, 1.0 / 60, 1);
        CHECK(method.start.cache.found == static_cast<int>(now.rows.size()));
        CHECK(now.solution.status == Status::solved);
    }
}

TEST_CASE("a box that falls flat stands still on four points", "[idea]")
{
    RoughSolids scene;
    add_body(scene, {solid_box({1, 0.5, 2})}, 1.0, {0, 0.25, 0});
    add_floor(scene, 0.5);
    scene.bodies.u[1] = -3;
    RoughCones method = tight_cones();
    StepData<6> now;
    go_on(scene, method, now, 1.0 / 60, 1);
    CHECK(now.contacts.size() == 4);
    CHECK(scene.bodies.u.norm() < 1e-12);  // four rows on one plane, three of them needed
    // (M v + h M g) is what they carry together
    CHECK(now.solution.lambda.tail(4).sum() == Approx(3 + 9.81 / 60).epsilon(1e-12));
}

TEST_CASE("hulls that collide keep momentum and angular momentum and gain no energy", "[idea]")
{
    Random random(12);
    int hits = 0;
    for (int n = 0; n < 40; ++n) {
        RoughSolids scene = colliding_hulls(random, n % 3 == 0 ? 0 : 0.6);
        RoughCones method = tight_cones();
        method.correction.method = Stabilizer::none;
        const Vec<6> before = momenta(scene.bodies);
        Real energy_before = energy(scene);
        StepData<6> now;
        bool touched = false;
        for (int i = 0; i < 90; ++i) {
            go_on(scene, method, now, 1.0 / 60, 1);
            const Real now_energy = energy(scene);
            // a free spin keeps its energy to second order in h: here to 1e-3 of it
            CHECK(now_energy < energy_before * (1 + 2e-3));
            energy_before = now_energy;
            touched = touched || now.solution.lambda.size() > 0;
        }
        hits += touched;
        // 90 steps of roundings, over all that moves
        Real all = 0;
        for (Index k = 0; k < 2; ++k)
            all += scene.bodies.velocity(k).head<3>().norm() / scene.bodies.inverse_mass[6 * k];
        INFO((momenta(scene.bodies) - before).norm() / all);
        CHECK((momenta(scene.bodies) - before).norm() < 1e-13 * all);
    }
    CHECK(hits > 30);
}

TEST_CASE("a ball bounces as high as its restitution says", "[idea]")
{
    RoughSolids scene = thrown_ball(0, 0);
    scene.bodies.x[1] = 1.5;
    RoughCones method = tight_cones();
    method.correction.restitution = 0.8;
    StepData<6> now;
    Real slowest = 0, fastest = 0;
    for (int i = 0; i < 200; ++i) {
        go_on(scene, method, now, 1.0 / 240, 1);
        slowest = std::min(slowest, scene.bodies.u[1]);
        if (slowest < 0) fastest = std::max(fastest, scene.bodies.u[1]);
    }
    // it hits within a step of the slowest: a step of gravity is 0.041 m/s
    CHECK(fastest == Approx(-0.8 * slowest).margin(0.8 * 9.81 / 240 + 1e-12));
}

// ---- friction -----------------------------------------------------------------------------------

TEST_CASE("the nearest point of a disc is on the way to its middle", "[idea]")
{
    CHECK(onto_disc({0.3, 0.4}, 1) == Vec2(0.3, 0.4));
    CHECK((onto_disc({3, 4}, 1) - Vec2(0.6, 0.8)).norm() < 1e-15);
    CHECK(onto_disc({3, 4}, 0) == Vec2(0, 0));
    // no other point of the disc is nearer
    Random random(13);
    for (int i = 0; i < 1000; ++i) {
        const Real px = random.uniform(-3, 3), py = random.uniform(-3, 3), angle = random.uniform(0, 2 * pi),
                   r = random.uniform();
        const Vec2 p(px, py), other = r * Vec2(std::cos(angle), std::sin(angle));
        CHECK((onto_disc(p, 1) - p).norm() <= (other - p).norm() + 1e-15);
    }
}

TEST_CASE("a block slides as far as v squared over 2 mu g in every direction", "[idea]")
{
    // a whole number of steps: v = 64 μ g h
    const Real h = 1.0 / 256, mu = 0.4, v = 64 * mu * 9.81 * h;
    for (const Real degrees : {0.0, 10.0, 30.0, 45.0, 77.0, 135.0, 200.0}) {
        const Real angle = degrees * pi / 180;
        RoughSolids scene = sliding_block(v, angle, mu);
        RoughCones method = tight_cones();
        StepData<6> now;
        go_on(scene, method, now, h, 80);
        const Vec3 way = scene.bodies.x.head<3>() - Vec3(0, 0.1, 0),
                   ahead(std::cos(angle), 0, -std::sin(angle));
        // 64 steps of sweeps that end at 1e-13 ℓ/s
        CHECK(std::abs(way.dot(ahead) - stopping_distance(v, mu, h)) < 1e-10);
        CHECK((way - ahead * way.dot(ahead)).norm() < 1e-10);
        CHECK(scene.bodies.u.norm() < 1e-10);
    }
}

TEST_CASE("a box of two bounds stops a diagonal slide too strongly by the root of two", "[idea]")
{
    const Real h = 1.0 / 256, mu = 0.4, v = 3;
    RoughSolids scene = sliding_block(v, pi / 4, mu);
    RoughBoxes method;
    method.solver.sweeps = {20000, 1e-13};
    StepData<6> now;
    go_on(scene, method, now, h, 1);
    CHECK((v - scene.bodies.u.head<3>().norm()) / h == Approx(std::sqrt(2.0) * mu * 9.81).epsilon(1e-10));
    // along one of the rows it is right, and between it pulls to the side
    scene = sliding_block(v, 0, mu);
    go_on(scene, method, now, h, 1);
    CHECK((v - scene.bodies.u[0]) / h == Approx(mu * 9.81).epsilon(1e-10));
    scene = sliding_block(v, pi / 12, mu);
    go_on(scene, method, now, h, 1);
    const Vec3 force = (scene.bodies.u.head<3>() - v * Vec3(std::cos(pi / 12), 0, -std::sin(pi / 12))) / h;
    const Real off = std::acos(-force.normalized().dot(Vec3(std::cos(pi / 12), 0, -std::sin(pi / 12))));
    CHECK(off == Approx(pi / 4 - pi / 12).epsilon(1e-8));  // 30 degrees
}

TEST_CASE("on a box a block stops beside where it should as (24.7) says", "[idea]")
{
    const Real h = 1.0 / 2400, mu = 0.4, v = 3, d = v * v / (2 * mu * 9.81);
    for (const Real degrees : {15.0, 30.0, 45.0}) {
        const Real a = degrees * pi / 180, c = std::cos(a), s = std::sin(a);
        RoughSolids scene = sliding_block(v, a, mu);
        RoughBoxes method;
        method.solver.sweeps = {20000, 1e-12};
        StepData<6> now;
        go_on(scene, method, now, h, 2000);
        const Real x = scene.bodies.x[0], z = scene.bodies.x[2];
        // each way is too short by h v / 2 at most, (24.5)
        CHECK(x * c - z * s == Approx(d * (c * c * c + s * s * s)).margin(h * v));
        CHECK(x * s + z * c == Approx(d * s * c * (c - s)).margin(h * v));
    }
}

TEST_CASE("rows that are clamped to a disc one after the other stay where they met its rim", "[idea]")
{
    // exercise 24.1, with A = 1 and a q that pushes both rows outward
    const Vec2 q(-10, -10);
    Vec2 one_by_one(1, 0), together(1, 0);
    for (int i = 0; i < 200; ++i) {
        for (const int k : {0, 1}) {
            const Real other = one_by_one[1 - k], most = std::sqrt(std::max(Real{0}, 1 - other * other));
            one_by_one[k] = std::clamp(-q[k], -most, most);
        }
        together = onto_disc(together - (together + q), 1);
    }
    CHECK(one_by_one == Vec2(1, 0));
    CHECK((together - Vec2(1, 1) / std::sqrt(2.0)).norm() < 1e-15);
}

TEST_CASE("a ball rolls down a slope at five sevenths where friction is enough", "[idea]")
{
    const Real a = 30 * pi / 180, least = 2.0 / 7 * std::tan(a);
    for (const Real mu : {1.01 * least, 0.5 * least}) {
        RoughSolids scene = thrown_ball(0, mu);
        scene.gravity = 9.81 * Vec3(std::sin(a), -std::cos(a), 0);
        RoughCones method = tight_cones();
        StepData<6> now;
        go_on(scene, method, now, 1.0 / 240, 240);
        const Real rolls = 5.0 / 7 * 9.81 * std::sin(a), slides = 9.81 * (std::sin(a) - mu * std::cos(a));
        CHECK(scene.bodies.u[0] ==
              Approx(mu > least ? rolls : slides).epsilon(1e-9));  // of 240 steps at 1e-13
    }
}

TEST_CASE("a block on a slope holds or slides as in the plane in every direction", "[idea]")
{
    const Real h = 1.0 / 240;
    for (const Real direction : {0.0, 0.5, 2.2}) {
        RoughSolids scene = block_on_slope(20, direction, 0.37);  // tan 20° = 0.364
        RoughCones method = tight_cones();
        StepData<6> now;
        go_on(scene, method, now, h, 120);
        CHECK(scene.bodies.u.norm() < 1e-11);
        scene = block_on_slope(20, direction, 0.3);
        go_on(scene, method, now, h, 120);
        const Real a = 20 * pi / 180, speed = 0.5 * 9.81 * (std::sin(a) - 0.3 * std::cos(a));
        CHECK((scene.bodies.u.head<3>() - speed * Vec3(std::cos(direction), 0, -std::sin(direction))).norm() <
              1e-10);
    }
}

TEST_CASE("a ball that slides ends up rolling at five sevenths of its speed", "[idea]")
{
    RoughSolids scene = thrown_ball(7, 0.3);
    RoughCones method = tight_cones();
    StepData<6> now;
    go_on(scene, method, now, 1.0 / 240, 240);  // it rolls after 2 v / (7 μ g) = 0.68 s
    CHECK(scene.bodies.u[0] == Approx(5).epsilon(1e-9));
    CHECK(world_spin(scene.bodies, 0).z() == Approx(-10).epsilon(1e-9));
    CHECK(world_spin(scene.bodies, world).isZero(0));  // the world stands still
    const Real rolled = scene.bodies.x[0];
    go_on(scene, method, now, 1.0 / 240, 240);
    CHECK(scene.bodies.x[0] - rolled == Approx(5).epsilon(1e-9));  // rolling loses nothing
}

TEST_CASE("friction that is said to be solved is Coulomb's", "[idea]")
{
    RoughSolids scene = mixed_heap(12, 0.5, 5);
    RoughCones method;
    method.solver.sweeps = {20000, 1e-9};
    StepData<6> now;
    int sliding = 0, holding = 0, solved = 0;
    for (int i = 0; i < 150; ++i) {
        go_on(scene, method, now, 1.0 / 120, 1);
        if (now.solution.status != Status::solved) continue;
        ++solved;
        // u after the step is written in axes that have turned: u* + M⁻¹Jᵀλ instead
        VecX u = now.u_star;
        for (std::size_t k = 0; k < now.rows.size(); ++k)
            now.rows[k].apply(now.solution.lambda[static_cast<Index>(k)], u);
        for (std::size_t k = 0; k + 1 < now.rows.size(); ++k) {
            if (now.sources[k].part != first_tangent) continue;
            const auto at = [&](std::size_t r) { return now.solution.lambda[static_cast<Index>(r)]; };
            const Vec2 w(now.rows[k].velocity(u), now.rows[k + 1].velocity(u)), lambda(at(k), at(k + 1));
            const Real most = 0.5 * at(static_cast<std::size_t>(now.rows[k].bounded_by));
            // the normal was visited after it: 1e-9 m/s of a body of 200 kg
            CHECK(lambda.norm() <= most + 1e-6);
            if (w.norm() < 1e-4 || most < 1e-2) {
                ++holding;
                continue;
            }
            ++sliding;
            // 1e-9 m/s of 1e-4 turn it by 1e-5, 1e-6 N s of 1e-2 make it so much longer
            CHECK((lambda / most + w.normalized()).norm() < 2e-4);
        }
    }
    CHECK(solved > 120);  // the others end at 1e-6 or below, and say so
    CHECK(sliding > 50);
    CHECK(holding > 50);
}

TEST_CASE("one visit brings two rows to rest or onto their disc and never raises what they minimise",
          "[idea]")
{
    Random random(14);
    int held = 0, slid = 0;
    for (int n = 0; n < 300; ++n) {
        RoughSolids scene = colliding_hulls(random, 0.5);
        SpaceContact contact;
        contact.a = 0, contact.b = 1;
        contact.normal = random_triple(random, 1).normalized();
        contact.at_a = random_triple(random, 0.5), contact.at_b = random_triple(random, 0.5);
        const ContactPlace here = place_of(contact, scene.bodies.x);
        std::vector<Row<6>> rows;
        for (const SpacePart part : {first_tangent, second_tangent})
            rows.push_back(bilateral(drag_constraint(contact, here, part, 2), scene.bodies.inverse_mass));
        std::vector<SolverRow<6>> visited;
        const VecX zero = VecX::Zero(2);
        prepare<6>(rows, {}, zero, visited);
        const DiscOfRows disc = disc_of_rows(visited, 0);
        VecX u = scene.bodies.u;
        const Vec2 q = slide_of(visited.data(), u);
        const Real radius = random.uniform(0, 10) * q.norm() / disc.largest;
        const auto cost = [&](const Vec2& lambda) { return lambda.dot(disc.A * lambda) / 2 + lambda.dot(q); };
        Vec2 lambda(0, 0);
        Real change = infinity;
        for (int visit = 0; visit < 500 && change > 1e-12; ++visit) {
            change = visit_disc(disc, visited.data(), radius, u);
            const Vec2 next(visited[0].lambda, visited[1].lambda);
            CHECK(cost(next) <= cost(lambda) + 1e-12 * std::abs(cost(lambda)));
            CHECK(next.norm() <= radius * (1 + 1e-14));
            lambda = next;
        }
        const Vec2 w = slide_of(visited.data(), u);
        if (lambda.norm() < radius * (1 - 1e-9)) {
            ++held;
            CHECK(w.norm() < 1e-10);
        } else {
            ++slid;
            CHECK((lambda / radius + w.normalized()).norm() < 1e-6);  // 1e-12 m/s of some 1e-6 or more
        }
        CHECK(disc_residual(disc, visited.data(), radius, u) < 1e-11);
    }
    CHECK(held > 30);
    CHECK(slid > 30);
}

// ---- what stands, what falls ---------------------------------------------------------------------

TEST_CASE("a stack of ten boxes stands for ten seconds", "[idea]")
{
    RoughSolids scene = box_stack(10, 0.05, 0.5);
    const VecX start = scene.bodies.x;
    RoughCones method;
    method.solver.sweeps = {500, 1e-6};
    StepData<6> now;
    go_on(scene, method, now, 1.0 / 60, 300);
    const VecX settled = scene.bodies.x;
    for (int i = 0; i < 300; ++i) {
        go_on(scene, method, now, 1.0 / 60, 1);
        CHECK(now.solution.status == Status::solved);
    }
    for (Index k = 0; k < 10; ++k) {
        const Vec3 moved = scene.bodies.x.segment<3>(6 * k) - start.segment<3>(6 * k),
                   crept = scene.bodies.x.segment<3>(6 * k) - settled.segment<3>(6 * k);
        // Each of the k + 1 contacts below may sink by the slop, 1e-3 ℓ.
        CHECK(std::abs(moved.y()) < 1e-3 * static_cast<Real>(k + 1));
        // Until the first start is found, sweeps that are not finished lean it: 0.3 mm at the top, three times that here.
        CHECK(std::hypot(moved.x(), moved.z()) < 1e-3);
        // Five seconds of rows that are off by 1e-6 ℓ/s; what tilts moves the top by ten of them.
        CHECK(crept.norm() < 5 * 1e-6 * 10);
    }
}

TEST_CASE("what is poured loses energy and lies within its pit", "[idea]")
{
    RoughSolids scene = mixed_heap(27, 0.5, 3);
    RoughCones method;
    StepData<6> now;
    const Real h = 1.0 / 120;
    Real last = energy(scene);
    const Real whole = last;
    Real mass = 0;
    for (Index k = 0; k < 27; ++k) mass += 1 / scene.bodies.inverse_mass[6 * k];
    for (int i = 0; i < 600; ++i) {
        go_on(scene, method, now, h, 1);
        const Real present = energy(scene);
        // Corrections lift what has sunk in: by less than a fifth of the deepest overlap, which all bodies share at most.
        Real deepest = 0;
        for (const Constraint<6>& c : now.constraints)
            if (c.kind == ConstraintKind::unilateral) deepest = std::max(deepest, -c.C);
        CHECK(present < last + 0.2 * deepest * mass * 9.81 + 1e-3 * whole);
        last = present;
    }
    for (Index k = 0; k < 27; ++k) {
        CHECK(scene.bodies.x[6 * k + 1] > 0);
        CHECK(scene.bodies.velocity(k).head<3>().norm() < 0.05);
    }
}

TEST_CASE("a scene of solids that is turned or measured in other units moves as it did", "[idea]")
{
    const auto end_of = [](RoughSolids scene) {
        RoughCones method;
        method.solver.sweeps = {5000, 1e-12};
        StepData<6> now;
        go_on(scene, method, now, 1.0 / 120, 60);
        return scene;
    };
    RoughSolids scene = mixed_heap(6, 0.4, 9);
    scene.length = 1;
    const RoughSolids one = end_of(scene);

    for (const Real scale : {1e-3, 1e3}) {
        RoughSolids other = scene;
        other.length = scale, other.gravity *= scale;
        for (auto& shape : other.shapes)
            for (Hull& hull : shape) {
                for (Vec3& p : hull.vertices) p *= scale;
                hull.radius *= scale;
            }
        for (SolidWall& wall : other.walls) wall.offset *= scale;
        for (Index k = 0; k < other.bodies.count(); ++k) {
            other.bodies.x.segment<3>(6 * k) *= scale;
            other.bodies.inverse_mass.segment<3>(6 * k + 3) /= scale * scale;
        }
        const RoughSolids far = end_of(other);
        for (Index k = 0; k < 6; ++k)
            // half a second of tumbling parts what differs by roundings
            CHECK((far.bodies.x.segment<3>(6 * k) / scale - one.bodies.x.segment<3>(6 * k)).norm() < 1e-6);
    }

    RoughSolids turned = scene;
    const Vec3 by(0.4, -1.1, 0.7);
    const Mat3 R = rotation_matrix(by);
    turned.gravity = R * scene.gravity;
    for (SolidWall& wall : turned.walls) wall.normal = R * wall.normal;
    for (Index k = 0; k < 6; ++k) {
        turned.bodies.x.segment<3>(6 * k) = R * scene.bodies.x.segment<3>(6 * k);
        turned.bodies.x.segment<3>(6 * k + 3) = add_rotation(by, scene.bodies.x.segment<3>(6 * k + 3));
    }
    const RoughSolids other = end_of(turned);
    for (Index k = 0; k < 6; ++k)
        CHECK((other.bodies.x.segment<3>(6 * k) - R * one.bodies.x.segment<3>(6 * k)).norm() < 1e-6);
}

TEST_CASE("without friction sweeps and active sets find the same motion of solids", "[idea]")
{
    const auto end_of = [](auto method) {
        RoughSolids scene = mixed_heap(5, 0, 2);
        method.correction.method = Stabilizer::baumgarte;
        StepData<6> now;
        go_on(scene, method, now, 1.0 / 120, 60);
        return scene.bodies.x;
    };
    RoughCones sweeps;
    sweeps.solver.sweeps = {20000, 1e-12};
    CHECK((end_of(sweeps) - end_of(TouchingMethod<ExactSolver, RoughTouching>{})).norm() <
          1e-7);  // roundings, for half a second
}

TEST_CASE("what is no surface and no wall is refused with a sentence", "[house]")
{
    RoughCones method;
    StepData<6> now;
    const auto with = [&](const auto& change) {
        RoughSolids scene = sliding_block(1, 0, 0.5);
        change(scene);
        return sentence_of([&] { step(scene, {}, method, now); });
    };
    CHECK(with([](RoughSolids& s) { s.friction[0] = -1; }) ==
          "number 0 of the bodies has the friction coefficient -1; it must be zero or positive and finite");
    CHECK(with([](RoughSolids& s) { s.wall_friction.push_back(1); }) ==
          "the scene has 2 friction coefficients for 1 walls; each needs its own, or none has one");
    CHECK(with([](RoughSolids& s) { s.walls[0].normal *= 2; }).find("normal of the length 2") !=
          std::string::npos);
    CHECK(with([](RoughSolids& s) { s.shapes[0][0].faces.pop_back(); }).find("not closed") !=
          std::string::npos);
    CHECK(sentence_of([] { mixed_heap(5, 0.5, 1, 0); }) ==
          "a heap has layers of 0 by as many bodies; it must be 1 or more");
    method.contacts.slack = 2;
    CHECK(with([](RoughSolids&) {}) == "the slack of contacts is 2 margins; it must be from 0 to 1");
}

TEST_CASE("the grip of two surfaces is finite where each of them is", "[house]")
{
    CHECK(both_rough({0.5}, 0, {0.5}, 0) == 0.5);
    CHECK(both_rough({0.3}, 0, {0.7}, 0) == std::sqrt(0.3 * 0.7));
    // the products are beyond the largest number and below the least
    CHECK(both_rough({1e200}, 0, {1e180}, 0) == Approx(1e190));
    CHECK(both_rough({1e-200}, 0, {1e-180}, 0) == Approx(1e-190).epsilon(1e-12).scale(0));
    CHECK(both_rough({0}, 0, {1e300}, 0) == 0);
    CHECK(both_rough({}, 0, {1}, 0) == 0);
}

TEST_CASE("bodies that are given friction leave that of others as it was", "[house]")
{
    RoughSolids scene = box_stack(2, 0, 0.3);
    const Index first = add_body(scene, {solid_ball(0.5)}, 1.0, {5, 0.5, 0});
    give_friction(scene, first, 0.7);
    CHECK(scene.friction == std::vector<Real>{0.3, 0.3, 0.7});
    scene.friction.clear();  // nothing has any
    give_friction(scene, first, 0.7);
    CHECK(scene.friction == std::vector<Real>{0, 0, 0.7});
}

TEST_CASE("a steady step of solids that touch asks for no memory", "[house]")
{
    RoughSolids scene = box_stack(4, 0.1, 0.5);
    RoughCones method;
    StepData<6> now;
    go_on(scene, method, now, 1.0 / 60, 10);
    const NoAllocation guard;
    go_on(scene, method, now, 1.0 / 60, 20);
    CHECK(NoAllocation::violations() == 0);
}
