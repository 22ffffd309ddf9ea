/// Chapter 26: one constraint as a spring, an acceleration, a velocity, a position, and a coordinate that is not there.

#include "tests/catch.hpp"
#include "tests/eigenvalues.hpp"
#include "tests/limit.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

#include "chapters/13_friction/slopes.hpp"
#include "chapters/14_joints/bar_linkages.hpp"
#include "chapters/26_four_ways/acceleration_level.hpp"
#include "chapters/26_four_ways/reduced_motion.hpp"
#include "chapters/26_four_ways/single_impulses.hpp"
#include "chapters/26_four_ways/spring_forces.hpp"
#include "chapters/26_four_ways/ways.hpp"
#include "common/random.hpp"

#include <Eigen/LU>

using namespace rigid;

namespace {

WayScene bead()
{
    WayScene way;
    way.scene = bead_on_a_wire();
    return way;
}

/// The bead where the wire is a rod without mass that carries it, on a pin.
JointedScene bead_on_a_rod()
{
    JointedScene scene = bead_on_a_wire();
    scene.joints.clear(), scene.placed.clear(), scene.owner.clear();
    scene.bodies.inverse_mass[2] = 1e12;  // a point
    scene.bodies.u[2] = 1;
    RigidJoint pin;
    pin.b = 0, pin.at_b = {-0.6, 0.8};
    add_joint(scene, pin);
    return scene;
}

/// Where a bead is after one step, and how fast.
struct Bead {
    Vec2 x, u;
};
Bead after(Way way, Real h, Real stiffness = 100, int sweeps = 1)
{
    WayRun run(way, bead(), {stiffness, sweeps});
    run.advance(h);
    return {run.scene().bodies.x.head<2>(), run.scene().bodies.u.head<2>()};
}

Real error_of(Way way, const WayScene& scene, int steps, WaySettings settings = {})
{
    const WayResult result = run_way(way, scene, scene.time / steps, settings);
    INFO(to_string(way) << " on " << scene.name << ": " << result.why_not);
    CHECK(result.why_not.empty());
    return result.error;
}

Real order(Way way, const WayScene& scene, int steps, WaySettings settings = {})
{
    std::vector<Real> errors;
    for (int i = 0; i < 4; ++i) errors.push_back(error_of(way, scene, steps << i, settings));
    return order_of(errors);
}

}  // namespace

TEST_CASE("a bead on a wire takes the step of the text in each of the ways", "[house]")
{
    const Real h = 0.1;
    const auto close = [](const Bead& bead, Real ux, Real uy, Real x, Real y) {
        // the damper of a spring is zero on the wire only if the bead moves along it: here it does
        CHECK((bead.u - Vec2(ux, uy)).norm() <= 1e-12);
        CHECK((bead.x - Vec2(x, y)).norm() <= 1e-12);
    };
    close(after(Way::spring, h), 0.8, -0.4, 0.68, -0.84);
    ImplicitPenalty<Manifolds> soft;  // without a damper, as in the text
    soft.correction.springs.stiffness = 100;
    soft.correction.springs.joint_ratio = 0;
    JointedScene scene = bead_on_a_wire();
    StepData<3> now;
    step(scene, {.h = h}, soft, now);
    close({scene.bodies.x.head<2>(), scene.bodies.u.head<2>()}, 0.56, -0.08, 0.656, -0.808);

    // the accelerations, and symplectic Euler with them
    scene = bead_on_a_wire();
    AccelerationLevel level;
    level.close(scene, 0);
    VecX a;
    REQUIRE(level.accelerations(scene, scene.bodies.x, scene.bodies.u, a) == Status::solved);
    CHECK((a.head<2>() - Vec2(-5.4, -2.8)).norm() <= 1e-12);
    const Vec2 u = scene.bodies.u.head<2>() + h * a.head<2>();
    close({scene.bodies.x.head<2>() + h * u, u}, 0.26, 0.32, 0.626, -0.768);

    // a velocity: the row of chapter 2
    const Row<3> row =
        bilateral(joint_constraint(scene.bodies.x, scene.joints[0]), scene.bodies.inverse_mass);
    VecX v = scene.bodies.u;
    v[1] -= 10 * h;
    row.apply(solve_row(row, v).lambda, v);
    close({scene.bodies.x.head<2>() + h * v.head<2>(), v.head<2>()}, 0.32, 0.24, 0.632, -0.776);

    // a position: straight on, and back along the radius
    const Vec2 straight(0.68, -0.84);
    const Vec2 x = straight.normalized();
    close(after(Way::positions, h), (x.x() - 0.6) / h, (x.y() + 0.8) / h, x.x(), x.y());

    // a coordinate: the angle from straight down has d²φ/dt² = −g sin φ = −6
    ReducedMotion reduced(bead_on_a_rod());
    const VecX bend = reduced.forward_dynamics(reduced.q(), reduced.dq(), {});
    CHECK(std::abs(bend[0] + 6) <= 1e-10);  // the point has an inertia of 1e-12 kg m²
    CHECK(std::abs(reduced.dq()[0] - 1) <= 1e-12);
}

TEST_CASE("a damped spring is stable up to the stiffness of (26.3) and not beyond", "[idea]")
{
    Random random(193);
    for (int round = 0; round < 40; ++round) {
        const Real m = 0.1 + random.uniform(0, 10), h = 0.001 + random.uniform(0, 0.1),
                   c = round % 4 == 0 ? 0 : random.uniform(0, 1.9) * m / h,
                   limit = largest_stiffness(m, c, h);
        CHECK(std::abs(largest_step(m, limit, c) - h) <= 1e-12 * h);  // the same equation, solved for h
        for (const Real beyond : {-0.04, 0.04}) {                     // of the 4 m in (26.3)
            const Real k = limit + beyond * m / (h * h);
            Real x = 1, v = 0, largest = 0;
            for (int i = 0; i < 4000; ++i) {
                v -= h / m * (k * x + c * v);
                x += h * v;
                largest = std::max(largest, std::abs(x));
            }
            // below: bounded by the energy of the start, which an eigenvector that is nearly double raises
            // about 0.04^-1/2 = 5 times; above: grows by 0.04/1.9 a step and more
            if (beyond < 0) CHECK(largest <= 30);
            else CHECK(largest > 1e6);
        }
    }
}

TEST_CASE("a joint under a proportional-derivative force explodes beyond the limit and as a row never",
          "[idea]")
{
    // a wheel of 1 kg m² on a pin through its middle, half a radian out, 240 steps a second
    const Real h = 1.0 / 240, d = 100, limit = largest_stiffness(1, d, h);
    const auto swings = [&](auto method, Real k) {
        JointedScene scene;
        scene.gravity = {0, 0};
        add_body(scene, disc(0.5), Mass{1, {0, 0}, 1}, {0, 0}, 0.5);
        RigidJoint joint;
        joint.b = 0;
        joint.spring = {0, 0, k, d, 0};
        add_joint(scene, joint);
        StepData<3> now;
        Real largest = 0;
        for (int i = 0; i < 2000; ++i) {
            step(scene, {.h = h}, method, now);
            largest = std::max(largest, std::abs(scene.bodies.x[2]));
        }
        return std::pair{largest, std::abs(scene.bodies.x[2])};
    };
    CHECK(limit == Approx(4.0 * 57600 - 2 * 100 * 240));                       // k h² + 2 d h = 4 I
    CHECK(swings(ExplicitPenalty<Manifolds>{}, 0.99 * limit).second <= 1e-3);  // it has come to rest
    CHECK(swings(ExplicitPenalty<Manifolds>{}, 1.01 * limit).first > 1e6);
    for (const Real k : {0.99 * limit, 1.01 * limit, 1e3 * limit, 1e9 * limit}) {
        const auto [largest, last] = swings(JointTrees<Manifolds>{}, k);
        CHECK(largest <= 0.5);
        CHECK(last <= 1e-3);
    }
}

TEST_CASE("the force at the end of a step is stable for any gains as (26.14) says", "[idea]")
{
    Random random(9);
    for (int round = 0; round < 200; ++round) {
        const Real kappa = std::pow(10, random.uniform(-6, 12)), delta = std::pow(10, random.uniform(-6, 12)),
                   D = 1 + kappa + delta;
        Eigen::Matrix<Real, 2, 2> map;  // of (x, h v): v ← (v − κ x/h)/D, x ← x + h v
        map << 1 - kappa / D, 1 / D, -kappa / D, 1 / D;
        // to rounding of numbers of size 1
        CHECK(std::abs(map.determinant() - 1 / D) <= 1e-15);
        CHECK(std::abs(map.trace() - (2 + delta) / D) <= 1e-15);
        CHECK(eigenvalues(map).cwiseAbs().maxCoeff() < 1);
    }
}

TEST_CASE("what must be and what is not there take steps of order four and the others of order one",
          "[house]")
{
    // ± 0.15 over four halvings of h, from steps where the next term is small
    CHECK(std::abs(order(Way::acceleration, pendulum(), 60) - 4) <= 0.15);
    CHECK(std::abs(order(Way::impulses, pendulum(), 60) - 1) <= 0.15);
    CHECK(std::abs(order(Way::positions, pendulum(), 480) - 1) <= 0.15);
    CHECK(std::abs(order(Way::acceleration, double_pendulum(), 120) - 4) <= 0.15);
    CHECK(std::abs(order(Way::coordinates, double_pendulum(), 120) - 4) <= 0.15);
    CHECK(std::abs(order(Way::coordinates, slider_crank_loop(), 120) - 4) <= 0.15);
    CHECK(std::abs(order(Way::acceleration, slider_crank_loop(), 120) - 4) <= 0.15);
    // a rod that nothing accelerates but its joints: what the step leaves cancels at full turns
    CHECK(std::abs(order(Way::impulses, slider_crank_loop(), 120) - 2) <= 0.15);
    CHECK(std::abs(order(Way::impulses, sliding_block(), 60) - 1) <= 0.15);
    CHECK(error_of(Way::acceleration, sliding_block(), 60) <= 1e-12);  // a parabola: exact (G2)
}

TEST_CASE("a double pendulum in coordinates is where the reference says after three seconds", "[house]")
{
    WayRun run(Way::coordinates, double_pendulum(), {});
    for (int i = 0; i < 3000; ++i) run.advance(1e-3);
    // R1; Runge-Kutta of a millisecond is good to 1e-8 here
    CHECK(std::abs(rod_angle(run.scene(), 0) - 1.025086012288729) <= 1e-8);
    CHECK(std::abs(rod_angle(run.scene(), 1) - 0.4957346476269754) <= 1e-8);
    CHECK(std::abs(run.scene().bodies.u[2] + 4.59335710547498) <= 1e-7);
    CHECK(std::abs(run.scene().bodies.u[5] - 1.18432088061423) <= 1e-7);
}

TEST_CASE("a chain with a hundred times a link at its end moves alike by accelerations and by coordinates",
          "[house]")
{
    for (const Way way : {Way::acceleration, Way::coordinates})
        CHECK(error_of(way, heavy_chain(), 1000) <= 1e-11);  // twelve digits are given
    // both are explicit under the load, and lose it at 60 steps a second; the row of velocities does not
    for (const Way way : {Way::acceleration, Way::coordinates})
        CHECK_FALSE(run_way(way, heavy_chain(), 1.0 / 60, {}).why_not.empty());
    CHECK(error_of(Way::impulses, heavy_chain(), 30) <= 0.02);  // order one, 0.6 m of way
}

TEST_CASE("recursive Newton-Euler gives the forces of which the articulated body gives the accelerations",
          "[house]")
{
    Random random(1914);
    for (int round = 0; round < 40; ++round) {
        JointedScene scene;
        const int bodies = 1 + round % 9;
        for (int k = 0; k < bodies; ++k) {
            const Real mass = random.uniform(0.1, 5), angle = random.uniform(-2, 2),
                       place = random.uniform(-1, 1);
            add_body(scene, box(1, 0.5), mass, {0, 0});
            RigidJoint joint;
            joint.kind = (round + k) % 3 == 1 ? JointKind::prismatic : JointKind::revolute;
            joint.a = k == 0 ? world : static_cast<Index>(random.uniform(0, 0.999) * k);
            joint.b = k;
            joint.at_a = {place, 0.5}, joint.at_b = {-0.5, 0.25};
            joint.axis = {std::cos(angle), std::sin(angle)};
            add_joint(scene, joint);
        }
        ReducedMotion motion(scene);
        VecX q(bodies), dq(bodies), tau(bodies);
        for (Index i = 0; i < bodies; ++i) {
            q[i] = random.uniform(-2, 2);
            dq[i] = random.uniform(-2, 2);
            tau[i] = random.uniform(-5, 5);
        }
        const VecX ddq = motion.forward_dynamics(q, dq, tau);
        const VecX back = motion.inverse_dynamics(q, dq, ddq);
        // to rounding of what is summed up, masses times accelerations along the tree
        CHECK((back - tau).norm() <= 1e-11 * (1 + 100 * ddq.norm()));
    }
}

namespace {

/// Bodies on joints of which none is the world's, with any masses, places and rates.
JointedScene floating_tree(Random& random, int bodies, bool slides)
{
    JointedScene scene;
    scene.gravity = {0, 0};
    for (int k = 0; k < bodies; ++k) {
        const Real mass = random.uniform(0.1, 5), angle = random.uniform(-2, 2), x = random.uniform(-1, 1);
        add_body(scene, box(1, 0.5), mass, {2.0 * k, x}, angle);
        if (k == 0) continue;
        RigidJoint joint;
        joint.kind = slides && k % 3 == 1 ? JointKind::prismatic : JointKind::revolute;
        joint.a = static_cast<Index>(random.uniform(0, 0.999) * k);
        joint.b = k;
        joint.at_a = {x, 0.5}, joint.at_b = {-0.5, 0.25};
        joint.axis = {std::cos(angle), std::sin(angle)};
        add_joint(scene, joint);
    }
    ReducedTree tree(split_loops(scene).tree);
    const auto n = static_cast<Index>(tree.size());
    VecX q(n), dq(n), x = split_loops(scene).tree.bodies.x, u = VecX::Zero(x.size());
    for (Index i = 0; i < n; ++i) {
        q[i] = random.uniform(-2, 2);
        dq[i] = random.uniform(-2, 2);
    }
    tree.place(q, x);
    tree.move(dq, x, u);
    scene.bodies.x = x.head(3 * bodies);
    scene.bodies.u = u.head(3 * bodies);
    return scene;
}

/// Momentum, and angular momentum about the origin.
Vec<3> momentum(const Bodies<3>& bodies)
{
    Vec<3> sum = Vec<3>::Zero();
    for (Index k = 0; k < bodies.count(); ++k) {
        const Vec2 p = bodies.velocity(k).head<2>() / bodies.inverse_mass[3 * k];
        sum.head<2>() += p;
        sum[2] +=
            cross2(bodies.position(k).head<2>(), p) + bodies.u[3 * k + 2] / bodies.inverse_mass[3 * k + 2];
    }
    return sum;
}

}  // namespace

TEST_CASE("a tree that floats has three coordinates more and gives its forces back", "[house]")
{
    Random random(2608);
    for (int round = 0; round < 40; ++round) {
        const int bodies = 1 + round % 8;
        JointedScene scene = floating_tree(random, bodies, true);
        scene.gravity = {0.3, -9.81};
        ReducedMotion motion(scene);
        REQUIRE(motion.coordinates() == bodies + 2);  // a joint for each body but one, and three
        VecX tau(bodies + 2);
        for (Index i = 0; i < tau.size(); ++i) tau[i] = random.uniform(-5, 5);
        const VecX ddq = motion.forward_dynamics(motion.q(), motion.dq(), tau);
        const VecX back = motion.inverse_dynamics(motion.q(), motion.dq(), ddq);
        // to rounding of what is summed up, as of a tree on the world
        CHECK((back - tau).norm() <= 1e-11 * (1 + 100 * ddq.norm()));
        // without forces the three of the base have none: the whole falls with g
        const VecX falls = motion.forward_dynamics(motion.q(), motion.dq(), {});
        CHECK(motion.inverse_dynamics(motion.q(), motion.dq(), falls).norm() <=
              1e-11 * (1 + 100 * falls.norm()));
    }
}

TEST_CASE("what floats keeps momentum and energy to order four and moves as by accelerations", "[house]")
{
    Random random(44);
    JointedScene start = floating_tree(random, 6, false);
    CollisionFilter none;
    none.set_meets(0, 0, false);
    std::vector<Real> momenta, energies;
    JointedScene at_end;
    for (const int steps : {200, 400, 800, 1600}) {
        JointedScene scene = start;
        ReducedMotion motion(scene);
        motion.filter = none;
        for (int i = 0; i < steps; ++i) REQUIRE(motion.advance(scene, 1.0 / steps) == Status::solved);
        CHECK(largest_joint_error(scene) <= 1e-12);  // a joint cannot be off
        momenta.push_back((momentum(scene.bodies) - momentum(start.bodies)).norm());
        energies.push_back(std::abs(energy(scene) - energy(start)));
        at_end = scene;
    }
    // ± 0.3: two quantities that are sums of errors of several signs; the method's order is 4
    CHECK(order_of(momenta) >= 3.7);
    CHECK(order_of(energies) >= 3.7);
    CHECK(momenta.back() <= 1e-7 * momentum(start.bodies).norm());
    AccelerationLevel level;
    level.filter = none;
    JointedScene other = start;
    for (int i = 0; i < 1600; ++i) REQUIRE(level.advance(other, 1.0 / 1600) == Status::solved);
    CHECK((other.bodies.x - at_end.bodies.x).norm() <= 1e-6);  // both to order four
    // one body alone is thrown in a parabola, which four evaluations have to rounding
    JointedScene stone;
    add_body(stone, box(1, 0.5), 2.0, {1, 3}, 0.3);
    stone.bodies.u << 2, 5, 7;
    ReducedMotion flight(stone);
    for (int i = 0; i < 10; ++i) REQUIRE(flight.advance(stone, 0.1) == Status::solved);
    CHECK((stone.bodies.x - Vec<3>(3, 8 - 9.81 / 2, 7.3)).norm() <= 1e-13 * 10);
}

TEST_CASE("joints that are no coordinates and joints in a ring are rows above what floats", "[house]")
{
    // a bead on a wire: a distance, so it floats and has one row
    JointedScene scene = bead_on_a_wire();
    ReducedMotion motion(scene);
    CHECK(motion.coordinates() == 3);
    for (int i = 0; i < 100; ++i) REQUIRE(motion.advance(scene, 0.01) == Status::solved);
    CHECK(std::abs(scene.bodies.x.head<2>().norm() - 1) <= 1e-7);  // of order four, not repaired
    // a ring of four rods, each on the one before: three joints of a tree, one of rows
    JointedScene ring;
    ring.gravity = {0, 0};
    const std::array<Vec2, 4> corners{Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)};
    for (std::size_t k = 0; k < 4; ++k) add_bar(ring, corners[k], corners[(k + 1) % 4], 1);
    for (Index k = 0; k < 4; ++k) pin(ring, (k + 3) % 4, k, corners[static_cast<std::size_t>(k)]);
    for (Index k = 0; k < 4; ++k) {  // turning as one body, pushed in at two sides
        const Vec2 r = ring.bodies.position(k).head<2>() - Vec2(0.5, 0.5);
        ring.bodies.velocity(k) << perpendicular(r), 1;
    }
    const TreeAndLoops parts = split_loops(ring);
    CHECK(parts.tree.placed.size() == 6);  // three pins, and three of what floats
    CHECK(parts.loops.size() == 2);
    ReducedMotion turns(ring);
    const Vec<3> before = momentum(ring.bodies);
    for (int i = 0; i < 200; ++i) REQUIRE(turns.advance(ring, 0.005) == Status::solved);
    CHECK(largest_joint_error(ring) <= 1e-8);
    CHECK((momentum(ring.bodies) - before).norm() <= 1e-8);
}

TEST_CASE("a doll goes one way by accelerations and by coordinates until it lands", "[house]")
{
    const WayScene doll = falling_doll();
    const auto after = [&](Way way, Real time) {
        WayRun run(way, doll, {});
        for (int i = 0; i < 100; ++i) REQUIRE(run.advance(time / 100) == Status::solved);
        VecX x = run.scene().bodies.x;
        for (Index k = x.size() / 3; k-- > 0;)
            x.segment<2>(3 * k) -= x.head<2>();  // as its first limb sees it
        return x;
    };
    // it has not touched the floor yet; its limbs rest at limits of joints, which coordinates meet by steps of order
    // one, so by 2 rad/s times a millisecond
    CHECK((after(Way::acceleration, 0.1) - after(Way::coordinates, 0.1)).norm() <= 2e-3);
}

TEST_CASE("forces at the level of accelerations change what is free as little as they can", "[house]")
{
    // Gauss' principle: M (a − a_free) is along Jᵀ, so it does no work on any motion that the joints allow
    JointedScene scene = double_pendulum().scene;
    scene.bodies.u.head<3>() << 0, 1, 2;
    scene.bodies.u.tail<3>() << 0, 3.5, 3;  // both joints move together
    AccelerationLevel level;
    level.close(scene, 0);
    VecX a, free;
    REQUIRE(level.accelerations(scene, scene.bodies.x, scene.bodies.u, a) == Status::solved);
    free_accelerations(scene, free);
    const VecX push = (a - free).cwiseQuotient(scene.bodies.inverse_mass);
    ReducedTree tree(scene);
    for (int k = 0; k < 2; ++k) {
        VecX allowed = VecX::Zero(6);
        tree.move(VecX::Unit(2, k), scene.bodies.x, allowed);
        CHECK(std::abs(push.dot(allowed)) <= 1e-12 * push.norm());
    }
}

TEST_CASE("the rod of Painleve has no finite force beyond four thirds and a velocity at any friction",
          "[house]")
{
    for (const Real mu : {1.3, 1.36, 1.6, 3.0}) {
        WayScene way = jammed_rod();
        cover(way.scene, {mu, 0, 0, 0});
        AccelerationLevel level;
        JointedScene scene = way.scene;
        const Status status = level.advance(scene, 1e-4);
        // A_nn − μ A_nt = 1.6 − 1.2 μ
        CHECK((status == Status::solved) == (mu < 4.0 / 3));
        CHECK((scene.bodies.x.array().isFinite()).all());
        if (mu > 4.0 / 3) {
            CHECK((status == Status::ray_termination || status == Status::infeasible));
            CHECK((scene.bodies.x - way.scene.bodies.x).norm() == 0);  // it stands where that was found
            WayRun run(Way::impulses, way, {});
            REQUIRE(run.advance(1e-4) == Status::solved);
            // the end stops in one step; what is left is the turn of a tenth of a millisecond of weight
            CHECK(way.error(run.scene()) <= 1e-2);
        }
    }
}

TEST_CASE("five balls in a row bounce one after the other or all together", "[house]")
{
    const auto speeds = [](Way way) {
        WayRun run(way, newtons_cradle(), settings_of(newtons_cradle()));
        for (int i = 0; i < 30; ++i) run.advance(0.01);
        VecX found(5);
        for (Index k = 0; k < 5; ++k) found[k] = run.scene().bodies.u[3 * k];
        return found;
    };
    CHECK((speeds(Way::single) - VecX::Unit(5, 4)).norm() <= 1e-12);    // as the experiment
    CHECK((speeds(Way::impulses) - VecX::Unit(5, 4)).norm() <= 1e-12);  // reflections of chapter 15
    VecX together = VecX::Constant(5, 0.4);
    together[0] = -0.6;  // C8: −(N − 2)/N, 2/N
    for (const Way way : {Way::acceleration, Way::coordinates})
        CHECK((speeds(way) - together).norm() <= 1e-12);
    const VecX springs = [&] {
        WayScene cradle = newtons_cradle();
        cradle.stiffness = 1e7;
        WayRun run(Way::spring, cradle, settings_of(cradle));
        for (int i = 0; i < 30000; ++i) run.advance(1e-5);
        VecX found(5);
        for (Index k = 0; k < 5; ++k) found[k] = run.scene().bodies.u[3 * k];
        return found;
    }();
    // linear springs spread the blow: the last ball gets less than all, momentum and energy stay
    CHECK(std::abs(springs.sum() - 1) <= 1e-12);
    CHECK(std::abs(springs.squaredNorm() - 1) <= 1e-2);  // a sum of symplectic steps, not exact
    CHECK(springs[4] > 0.9);
    CHECK(springs[4] < 0.999);
}
