/// Chapter 14: joints on the step of Part I, and trees of them solved at once.

#include "tests/no_allocation.hpp"

#include "chapters/14_joints/joint_method.hpp"
#include "chapters/14_joints/joint_scenes.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/joint_run.hpp"
#include "tests/sentence.hpp"

#include <set>

using namespace rigid;

namespace {

using Trees = JointTrees<AllBodies>;

/// Two bodies somewhere, and a joint of this kind with all that it may have.
JointedScene random_joint(Random& random, JointKind kind, bool on_world)
{
    JointedScene scene;
    for (int k = 0; k < 2; ++k) {
        const Real x = random.uniform(-2, 2), y = random.uniform(-2, 2), angle = random.uniform(-3, 3),
                   density = random.uniform(0.5, 3);
        add_body(scene, box(1, 0.5), density, {x, y}, angle);
    }
    RigidJoint joint;
    joint.kind = kind;
    joint.a = on_world ? world : 0, joint.b = 1;
    const Real turn = random.uniform(-3, 3), p = random.uniform(-1, 1), q = random.uniform(-1, 1);
    joint.axis = {std::cos(turn), std::sin(turn)};
    joint.at_a = {p, q}, joint.at_b = {q, 0.3};
    joint.angle = p, joint.length = 1.5, joint.ratio = 0.7;
    joint.over_a = {-4, 6}, joint.over_b = {4, 7};
    if (has_coordinate(kind)) {
        joint.lower = -1, joint.upper = 2;
        joint.motor = {0.5, 3, 0, 0, 0};
        joint.spring = {0, 0, 40, 2, 0.3};
    } else {
        joint.motor.force = 5;
        joint.spring = {0, 7, 40, 2, 0};
        joint.torque = 3;
        if (kind < JointKind::mouse) joint.motor = joint.spring = {};
    }
    add_joint(scene, joint);
    for (Index i = 0; i < 6; ++i) scene.bodies.u[i] = random.uniform(-2, 2);
    return scene;
}

/// Bodies of very different masses on a tree of joints of several kinds; `loops` of them close a loop each.
JointedScene random_tree(Random& random, int bodies, bool floats, int loops)
{
    JointedScene scene;
    for (int k = 0; k < bodies; ++k) {
        const Real x = random.uniform(-2, 2), y = random.uniform(-2, 2), angle = random.uniform(-3, 3),
                   exponent = random.uniform(-1.5, 1.5);
        add_body(scene, box(1, 0.5), std::pow(10.0, exponent), {x, y}, angle);
    }
    for (Index i = 0; i < 3 * bodies; ++i) scene.bodies.u[i] = random.uniform(-1, 1);
    const auto join = [&](JointKind kind, Index a, Index b) {
        RigidJoint joint;
        joint.kind = kind;
        joint.a = a, joint.b = b;
        for (Vec2* const at : {&joint.at_a, &joint.at_b})
            for (const int i : {0, 1}) (*at)[i] = random.uniform(-1, 1);
        joint.length = 1;
        if (kind == JointKind::wheel) joint.spring = {0, 0, 100, 1, 0};
        add_joint(scene, joint);
    };
    for (Index k = floats ? 1 : 0; k < bodies; ++k) {
        const Index parent = k == 0 ? world : static_cast<Index>(random.uniform(0, 1) * static_cast<Real>(k));
        constexpr JointKind some[] = {JointKind::revolute, JointKind::prismatic, JointKind::weld,
                                      JointKind::distance, JointKind::wheel};
        const JointKind kind = some[static_cast<int>(random.uniform(0, 4.999))];
        const bool swapped = parent != world && random.uniform(0, 1) < 0.5;
        join(kind, swapped ? k : parent, swapped ? parent : k);
    }
    for (int i = 0; i < loops; ++i)
        join(i % 2 ? JointKind::distance : JointKind::revolute, i, bodies - 1 - i);
    return scene;
}

/// The rows of all joints of a scene, with random errors to take back.
std::vector<Row<3>> rows_of(const JointedScene& scene, Random& random)
{
    const Real h = 1.0 / 60;
    std::vector<Row<3>> rows;
    for (const PointJoint& joint : scene.joints) {
        const Constraint<3> c = joint_constraint(scene.bodies.x, joint);
        const Real b = has_error(c.kind) ? random.uniform(-1, 1) : own_bias(c, h);
        rows.push_back(row_of(c, scene.bodies.inverse_mass, b, h));
    }
    return rows;
}

}  // namespace

// ---- identities of the scheme

TEST_CASE("J of every kind of joint is the derivative of its C", "[idea]")
{
    Random random(14);
    std::set<std::pair<int, int>> seen;
    for (int round = 0; round < 100; ++round)
        for (int kind = 0; kind < joint_kind_count; ++kind) {
            const JointedScene scene = random_joint(random, static_cast<JointKind>(kind), round % 3 == 0);
            const VecX& x = scene.bodies.x;
            REQUIRE_FALSE(scene.joints.empty());
            for (const PointJoint& joint : scene.joints) {
                seen.insert({kind, static_cast<int>(joint.measure)});
                const Constraint<3> c = joint_constraint(x, joint);
                if (joint.measure == PointJoint::Measure::distance &&
                    std::abs(joint.sense * c.C + joint.length) < 0.1)
                    continue;  // where the points nearly meet C bends without bound
                for (Index i = 0; i < 6; ++i) {
                    const Real t = 1e-5;  // error t² C'''/6 of about 1e-9, and rounding 1e-16/t
                    VecX more = x, less = x;
                    more[i] += t, less[i] -= t;
                    const Real slope =
                        (joint_constraint(more, joint).C - joint_constraint(less, joint).C) / (2 * t);
                    const Real J = i >= 3 ? c.Jb[i - 3] : c.a == 0 ? c.Ja[i] : 0;
                    CHECK(std::abs(slope - J) <= 1e-7);
                }
            }
        }
    CHECK(seen.size() == 18);  // every kind with all its measures, counted in the table of section 14.2
}

TEST_CASE("a tree solved from the leaves to the root and back gives what the whole matrix gives", "[idea]")
{
    Random random(7);
    int compared = 0;
    for (int round = 0; round < 200; ++round) {
        const int bodies = 2 + round % 15, loops = bodies > 4 ? round % 3 : 0;
        const JointedScene scene = random_tree(random, bodies, round % 2 == 0, loops);
        const std::vector<Row<3>> rows = rows_of(scene, random);
        JointFactor factor;
        factor.factor(rows, scene.bodies.inverse_mass);
        VecX u = scene.bodies.u, lambda = VecX::Zero(static_cast<Index>(rows.size()));
        factor.solve(rows, biases_of(rows), u, lambda);
        const RowsAnswer whole = solve_rows(rows, scene.bodies.u);
        VecX v = scene.bodies.u;
        apply(rows, whole.lambda, v);
        if (whole.verdict != Verdict::independent) continue;  // rows that contradict each other
        ++compared;
        // Masses differ by up to 1000: the dense matrix itself is only good to about 1e-11.
        CHECK((u - v).norm() <= 1e-9 * (1 + v.norm()));
        // and what moved the bodies are these impulses
        VecX moved = scene.bodies.u;
        apply(rows, lambda, moved);
        // λ comes through K and u through G: rounding times the masses' ratio, 1000, and that of their inertias
        CHECK((moved - u).norm() <= 1e-7 * (1 + u.norm() + lambda.norm()));
    }
    CHECK(compared >= 150);
}

TEST_CASE("the work on a chain grows with its length and not faster", "[house]")
{
    for (const int links : {50, 500, 5000}) {
        const JointedScene scene = chain_scene({links, 0.1, 0.1, 1000, 0.3});
        Random random(1);
        const std::vector<Row<3>> rows = rows_of(scene, random);
        JointFactor factor;
        factor.factor(rows, scene.bodies.inverse_mass);
        VecX u = scene.bodies.u, lambda = VecX::Zero(static_cast<Index>(rows.size()));
        factor.solve(rows, biases_of(rows), u, lambda);
        const TreeWork& work = factor.tree.work;
        CHECK(work.factored_rows == static_cast<std::int64_t>(rows.size()));
        CHECK(work.solved_rows == static_cast<std::int64_t>(rows.size()));
        // once more: the tree is known
        factor.factor(rows, scene.bodies.inverse_mass);
        CHECK(work.orders == 1);
    }
}

TEST_CASE("two level rods start as (14.2) says", "[idea]")
{
    JointedScene scene = chain_scene({2, 1, 1, 1, pi / 2});
    scene.bodies.inverse_mass.tail<3>().setZero();  // without the weight
    scene.placed.pop_back();
    scene.joints.resize(4);
    scene.bodies.resize(2);
    scene.shapes.resize(2);
    Trees method;
    method.correction.most_follow = 0;  // what the rows say, without the arcs
    StepData<3> now;
    step(scene, {.h = 0.01}, method, now);
    const Real gh = 9.81 * 0.01;  // to rounding of a few operations
    CHECK(std::abs(scene.bodies.u[2] + 9.0 / 7 * gh) <= 1e-14);
    CHECK(std::abs(scene.bodies.u[5] - 3.0 / 7 * gh) <= 1e-14);
    CHECK(std::abs(now.solution.lambda[1] - 2.0 / 7 * gh) <= 1e-14);
    CHECK(std::abs(now.solution.lambda[3] + 1.0 / 14 * gh) <= 1e-14);
}

TEST_CASE("a joint bears what statics says", "[idea]")
{
    // A rod of 2 kg on a weld in a wall, level: the weld bears its weight and the moment of it.
    JointedScene scene;
    add_body(scene, capsule(1, 0), thin_rod(1, 2), {0.5, 0});
    RigidJoint weld = joint_at(scene, JointKind::weld, world, 0, {0, 0});
    add_joint(scene, weld);
    Trees method;
    StepData<3> now;
    for (int i = 0; i < 10; ++i) step(scene, {}, method, now);
    const Reaction bears = reaction(scene, now, 0);
    CHECK(std::abs(bears.force.x()) <= 1e-10);
    CHECK(std::abs(bears.force.y() - 2 * 9.81) <= 1e-9);  // to rounding over h
    CHECK(std::abs(bears.torque - 2 * 9.81 * 0.5) <= 1e-9);
}

TEST_CASE("an Atwood machine whose pulley turns starts with the acceleration and the tensions by hand",
          "[idea]")
{
    JointedScene scene = atwood_scene();
    Trees method;
    StepData<3> now;
    step(scene, {}, method, now);
    // B4 of the reference values; one step from rest is exact, to rounding over h
    CHECK(std::abs(-60 * scene.bodies.u[7] - 2.802857142857143) <= 1e-12);
    CHECK(std::abs(atwood_by_hand() - 2.802857142857143) <= 1e-12);
    CHECK(std::abs(reaction(scene, now, 2).force.y() - 14.01428571428571) <= 1e-11);
    CHECK(std::abs(reaction(scene, now, 1).force.y() - 12.61285714285714) <= 1e-11);
}

TEST_CASE("a rope over a pulley that is tied to the world has one line and holds", "[house]")
{
    for (const int substeps : {1, 4}) {
        JointedScene scene;
        add_body(scene, disc(0.05), Mass{1, {0, 0}, 0.01}, {1, -1});
        RigidJoint pulley;
        pulley.kind = JointKind::pulley;
        pulley.a = world, pulley.b = 0;
        pulley.at_a = {-1, -1};
        pulley.over_a = {-1, 0}, pulley.over_b = {1, 0};
        pulley.length = 2;
        add_joint(scene, pulley);
        JointTrees<AllBodies> method;
        StepData<3> now;
        for (int n = 0; n < 60; ++n) {
            step(scene, {.substeps = substeps}, method, now);
            for (const Source& source : now.sources) REQUIRE(source.part != 1);  // the end that is tied
        }
        CHECK(std::abs(scene.bodies.x[1] + 1) < 1e-6);
    }
}

TEST_CASE("a pulley of two to one holds twice the weight and moves what is not in balance by hand", "[idea]")
{
    // ‖p_a − q_a‖ + 2 ‖p_b − q_b‖ stays: T pulls at a, 2T at b. With m_a = 1 kg and a_a = −2 a_b (downwards) that is
    // T = 3g / (1/m_a + 4/m_b), a_b = g − 2T/m_b.
    for (const Real mass : {2.0, 3.0}) {
        JointedScene scene;
        add_body(scene, box(1, 1), 1, {-2, 0});
        add_body(scene, box(1, 1), mass, {2, 0});
        RigidJoint pulley;
        pulley.kind = JointKind::pulley;
        pulley.a = 0, pulley.b = 1;
        pulley.over_a = {-2, 5}, pulley.over_b = {2, 5};
        pulley.ratio = 2;
        pulley.length = 15;
        add_joint(scene, pulley);
        Trees method;
        StepData<3> now;
        step(scene, {}, method, now);
        const Real g = 9.81, T = 3 * g / (1 + 4 / mass), down = g - 2 * T / mass;
        // one step from rest is exact, to rounding over h
        CHECK(std::abs(-60 * scene.bodies.u[4] - down) <= 1e-12);
        CHECK(std::abs(-60 * scene.bodies.u[1] + 2 * down) <= 1e-12);
        CHECK((mass == 2) == (std::abs(down) < 1e-12));
    }
}

TEST_CASE("a mouse pulls with its force and no more", "[idea]")
{
    JointedScene scene;
    scene.gravity = {0, 0};
    add_body(scene, box(1, 1), 2.0, {0, 0});
    RigidJoint mouse;
    mouse.kind = JointKind::mouse;
    mouse.at_a = {100, 0};
    mouse.spring = {0, 6, 1000, 10, 0};
    add_joint(scene, mouse);
    Trees method;
    StepData<3> now;
    step(scene, {.h = 0.01}, method, now);
    CHECK(std::abs(scene.bodies.u[0] - 6.0 / 2 * 0.01) <= 1e-14);  // F h / m, one operation each
    CHECK(std::abs(reaction(scene, now, 0).force.x() - 6) <= 1e-12);
}

TEST_CASE("a motor reaches its speed as far as its torque lets it", "[idea]")
{
    JointedScene scene;
    scene.gravity = {0, 0};
    add_body(scene, disc(1), Mass{1, {0, 0}, 0.5}, {0, 0});
    RigidJoint axle;
    axle.motor = {2, 3, 0, 0, 0};  // 2 rad/s, at most 3 N m
    add_joint(scene, axle);
    Trees method;
    StepData<3> now;
    for (int i = 1; i <= 50; ++i) {
        step(scene, {.h = 0.01}, method, now);
        CHECK(std::abs(scene.bodies.u[2] - std::min(2.0, 3 / 0.5 * 0.01 * i)) <= 1e-12);
    }
}

TEST_CASE("a pendulum between its limits moves the same to the bit when far limits have no rows", "[house]")
{
    const auto swing = [](bool skip, int most_exact, int& skipped) {
        JointedScene scene = chain_scene({3, 0.5, 1, 2, 1.2});
        for (std::size_t i = 0; i < 3; ++i) {
            RigidJoint joint = scene.placed[i].joint;
            joint.kind = JointKind::revolute;
            joint.angle = i == 0 ? -pi / 2 : 0;
            joint.lower = -1.3, joint.upper = 0.9;
            add_joint(scene, joint);
        }
        Trees method;
        method.contacts.skip_far_limits = skip;
        method.solver.most_exact = most_exact;
        StepData<3> now;
        skipped = 0;
        for (int i = 0; i < 600; ++i) {
            step(scene, {.h = 1.0 / 120}, method, now);
            skipped += method.contacts.limits_skipped;
        }
        // the limits hold: to the slop of an overlap, and what a step swings beyond
        for (std::size_t i = 0; i < 3; ++i) {
            const Real q = coordinate(scene.bodies.x, scene.placed[4 + i].joint);
            CHECK(q > -1.4);
            CHECK(q < 1.0);
        }
        return scene.bodies.x;
    };
    int some = 0, none = 0;
    const VecX lean = swing(true, 0, some), full = swing(false, 0, none);
    CHECK(lean == full);
    CHECK(some > 1000);
    CHECK(none == 0);
    // found exactly, their rows are factored in another order: rounding, that five seconds of a triple pendulum grow
    CHECK((swing(true, 400, some) - swing(false, 400, none)).cwiseAbs().maxCoeff() <= 1e-8);
}

TEST_CASE("a knock counts as its impulse over the sub-step and a load as what it is", "[idea]")
{
    // a body that moves at 2 m/s is caught by its pin in one step; then it hangs there
    for (const int substeps : {1, 2, 8}) {
        JointedScene scene;
        add_body(scene, box(1, 1), Mass{3, {0, 0}, 0.5}, {0, 0});
        add_joint(scene, joint_at(scene, JointKind::revolute, world, 0, {0, 0}));
        const Vec2 g = scene.gravity;
        scene.bodies.u[0] = 2;
        Trees method;
        StepData<3> now;
        const Real h = 1.0 / 60 / substeps;
        step(scene, {.h = h}, method, now);
        CHECK(reaction(scene, now, 0).force.x() == Approx(-3 * 2 / h).epsilon(1e-12));
        step(scene, {.h = h}, method, now);
        CHECK(reaction(scene, now, 0).force.y() == Approx(-3 * g.y()).epsilon(1e-9));  // rounding over h
    }
}

TEST_CASE("the bound of a friction joint holds along x and along y each", "[idea]")
{
    for (const Vec2& way : {Vec2(1, 0), Vec2(0, 1), Vec2(1, 1)}) {
        JointedScene scene;
        scene.gravity = {0, 0};
        add_body(scene, box(1, 1), 2, {0, 0});  // 2 kg
        RigidJoint brake = joint_at(scene, JointKind::friction, world, 0, {0, 0});
        brake.motor.force = 10;
        brake.torque = 1;
        add_joint(scene, brake);
        scene.bodies.velocity(0) << 5 * way, 0;
        Trees method;
        StepData<3> now;
        step(scene, {.h = 0.01}, method, now);
        // a solve to rounding over h
        CHECK((reaction(scene, now, 0).force + 10 * way).norm() <= 1e-9);
    }
}

TEST_CASE("a joint that bears too much breaks and its rows are gone", "[house]")
{
    JointedScene scene;
    add_body(scene, box(1, 1), 1.0, {0, 0});
    RigidJoint hook = joint_at(scene, JointKind::revolute, world, 0, {0, 0.5});
    hook.breaking_force = 9.7;  // it weighs 9.81 N
    add_joint(scene, hook);
    Trees method;
    StepData<3> now;
    step(scene, {}, method, now);
    CHECK(scene.placed[0].broken);
    CHECK(method.contacts.broken == 1);
    for (int i = 0; i < 60; ++i) step(scene, {}, method, now);
    CHECK(now.rows.empty());
    CHECK(scene.bodies.x[1] < -4.8);  // half of g after a second
}

// ---- properties

TEST_CASE("a joint that makes no sense is refused with a sentence that names it", "[house]")
{
    const auto says = [](const std::function<void(RigidJoint&)>& change) {
        JointedScene scene;
        for (int k = 0; k < 2; ++k) add_body(scene, box(1, 1), 1.0, {2.0 * k, 0});
        add_body(scene, box(1, 1), Mass{}, {5, 0});
        RigidJoint joint;
        joint.a = 0, joint.b = 1;
        change(joint);
        return sentence_of([&] { add_joint(scene, joint); });
    };
    CHECK(says([](RigidJoint&) {}) == "accepted");
    CHECK(says([](RigidJoint& joint) { joint.at_a.x() = NAN; }) ==
          "the revolute joint 0 has a frame, a length, a ratio, a speed or a target that is not finite");
    CHECK(says([](RigidJoint& joint) { joint.b = 0; }) ==
          "the revolute joint 0 joins body 0 to itself; it needs two bodies");
    CHECK(says([](RigidJoint& joint) { joint.b = 3; }) ==
          "the revolute joint 0 joins bodies 0 and 3 among 3; only its a may be the world (-1)");
    CHECK(says([](RigidJoint& joint) { joint.a = world, joint.b = 2; }) ==
          "the revolute joint 0 joins bodies -1 and 2, which cannot move; one of them must have a mass");
    CHECK(says([](RigidJoint& joint) { joint.lower = 1, joint.upper = 0.5; }) ==
          "the revolute joint 0 has the lower limit 1 and the upper 0.5; lower must not be above upper");
    CHECK(says([](RigidJoint& joint) { joint.lower = joint.upper = infinity; }) ==
          "the revolute joint 0 has the limits inf and inf; no number is between them");
    CHECK(says([](RigidJoint& joint) {
              joint.at_b = {0, 1e76};
          }) == "the revolute joint 0 has a frame, a length or a ratio of 1e+76; none may be beyond 1e75");
    CHECK(says([](RigidJoint& joint) { joint.spring.stiffness = -2; }) ==
          "the revolute joint 0 has the stiffness -2; it must be zero or positive and finite");
    CHECK(says([](RigidJoint& joint) {
              joint.axis = {1, 1};
          }) == "the revolute joint 0 has an axis of the length 1.4142135623730951; it must be 1");
    CHECK(says([](RigidJoint& joint) {
              joint.kind = JointKind::weld;
              joint.upper = 1;
          }) ==
          "the weld joint 0 has limits, a motor or a spring; it has no coordinate that they could act on");
    CHECK(says([](RigidJoint& joint) { joint.kind = JointKind::mouse; }) ==
          "the mouse joint 0 pulls by a spring of no stiffness and no damping; give it one");
}
