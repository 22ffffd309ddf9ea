/// Chapter 15: rows with bounds above joints that are solved at once.

#include "tests/no_allocation.hpp"

#include "chapters/14_joints/bar_linkages.hpp"
#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/14_joints/ragdoll.hpp"
#include "chapters/15_trees/tree_method.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/joint_run.hpp"
#include "tests/sentence.hpp"

using namespace rigid;

namespace {

using Trees = JointTrees<AllBodies>;

/// The whole problem as one matrix, joints and all, by chapter 13.
struct MatrixOfAll : CoulombSolver<FindFriction> {
    std::vector<int> all = {};

    template <class Visit>
    void for_each_problem(const StepData<3>& now, const Visit& visit)
    {
        all.resize(now.rows.size());
        std::iota(all.begin(), all.end(), 0);
        visit(all, now.active, *this, Corrected::arcs_and_errors);
    }
    void factor_again(const Bodies<3>&, const StepData<3>& now)
    {
        assemble(now.rows, now.u_star, scratch, mlcp);
    }
    void bounce_late(Bodies<3>&, StepData<3>&) const {}
};
struct WholeMatrix {
    WithJoints<WithFriction<AllBodies>> contacts;
    NewtonPositions correction;
    WarmStart start = last_impulses();
    MatrixOfAll solver;
};

/// Boxes on a tree of pins and rails with motors and limits that are near, some loops, and ropes.
JointedScene driven_tree(Random& random, int bodies, int loops)
{
    JointedScene scene;
    for (int k = 0; k < bodies; ++k) {
        const Real x = random.uniform(-2, 2), y = random.uniform(-2, 2), angle = random.uniform(-3, 3),
                   exponent = random.uniform(-1, 1);
        add_body(scene, box(1, 0.5), std::pow(10.0, exponent), {x, y}, angle);
    }
    for (Index i = 0; i < 3 * bodies; ++i) scene.bodies.u[i] = random.uniform(-1, 1);
    for (Index k = 0; k < bodies; ++k) {
        const Real share = random.uniform(0, 1), x = random.uniform(-2, 2), y = random.uniform(-2, 2);
        RigidJoint joint =
            joint_at(scene, random.uniform(0, 1) < 0.7 ? JointKind::revolute : JointKind::prismatic,
                     k == 0 ? world : static_cast<Index>(share * static_cast<Real>(k)), k, {x, y});
        const Real speed = random.uniform(-3, 3), force = random.uniform(0, 30);
        joint.motor.speed = speed, joint.motor.force = force;
        if (k % 3 == 1) joint.spring = {0, 50, 40, 2, 0.3};       // a servo: a soft row with a bound
        if (k % 2 == 0) joint.lower = -1e-3, joint.upper = 1e-3;  // both within a step's reach
        add_joint(scene, joint);
    }
    for (int i = 0; i < loops; ++i) {
        RigidJoint rope;
        rope.kind = JointKind::rope;
        rope.a = i, rope.b = bodies - 1 - i;
        rope.length = (scene.bodies.position(rope.a) - scene.bodies.position(rope.b)).head<2>().norm() + 1e-3;
        if (rope.a < rope.b) add_joint(scene, rope);
    }
    return scene;
}

/// The rows of a step of 1/100 s, and the bodies moved by it.
StepData<3> after_one_step(JointedScene& scene)
{
    Trees method;
    method.correction.stiff = false;
    StepData<3> now;
    step(scene, {.h = 1.0 / 100}, method, now);
    return now;
}

}  // namespace

TEST_CASE("motors and limits and ropes above joints move the bodies as the whole matrix says", "[idea]")
{
    Random random(3);
    for (int round = 0; round < 60; ++round) {
        JointedScene scene = driven_tree(random, 2 + round % 9, round % 3), twin = scene;
        Trees method;
        method.correction.stiff = false;
        WholeMatrix whole;
        StepData<3> now, all;
        step(scene, {.h = 1.0 / 100}, method, now);
        step(twin, {.h = 1.0 / 100}, whole, all);
        CAPTURE(round);
        REQUIRE(all.solution.status == Status::solved);
        CHECK(now.solution.status == Status::solved);
        CHECK(method.solver.sweeps_made == 0);
        CHECK(method.solver.bounded.islands.listed > 0);
        // the velocities are unique, the impulses need not be; masses differ by 100
        CHECK((scene.bodies.u - twin.bodies.u).norm() <= 1e-8 * (1 + twin.bodies.u.norm()));
    }
}

TEST_CASE("the joints eliminated leave the matrix that the whole one leaves", "[house]")
{
    Random random(9);
    for (int round = 0; round < 30; ++round) {
        JointedScene scene = driven_tree(random, 3 + round % 6, round % 3);
        // the bridge of section 15.B: a loop
        if (round % 2) pin(scene, world, scene.bodies.count() - 1, {2.5, 0});
        const StepData<3> now = after_one_step(scene);
        JointFactor factor;
        factor.factor(now.rows, scene.bodies.inverse_mass);
        BoundedRows bounded;
        bounded.eliminate(factor, now.rows, {}, scene.bodies.count());
        // A in parts: J of joints, B of rows with bounds
        const MatX A = MatX(assemble(now.rows, scene.bodies.u).A);
        std::vector<Index> J, B;
        for (std::size_t i = 0; i < now.rows.size(); ++i)
            (JointTree::takes(now.rows[i]) ? J : B).push_back(static_cast<Index>(i));
        const auto part = [&A](const std::vector<Index>& r, const std::vector<Index>& c) {
            MatX some(static_cast<Index>(r.size()), static_cast<Index>(c.size()));
            for (std::size_t i = 0; i < r.size(); ++i)
                for (std::size_t j = 0; j < c.size(); ++j)
                    some(static_cast<Index>(i), static_cast<Index>(j)) = A(r[i], c[j]);
            return some;
        };
        const MatX left =
            part(B, B) - part(B, J) * part(J, J).completeOrthogonalDecomposition().solve(part(J, B));
        std::vector<Index> place(now.rows.size(), -1);
        for (std::size_t i = 0; i < B.size(); ++i)
            place[static_cast<std::size_t>(B[i])] = static_cast<Index>(i);
        Index entries = 0;
        for (int k = 0; k < bounded.islands.count; ++k) {
            const auto& rows = bounded.islands.rows[static_cast<std::size_t>(k)];
            const MatX S = MatX(bounded.matrix(k));
            for (std::size_t i = 0; i < rows.size(); ++i)
                for (std::size_t j = 0; j < rows.size(); ++j) {
                    ++entries;
                    CHECK(std::abs(S(static_cast<Index>(i), static_cast<Index>(j)) -
                                   left(place[static_cast<std::size_t>(rows[i])],
                                        place[static_cast<std::size_t>(rows[j])])) <=
                          1e-9 * (1 + A.diagonal().maxCoeff()));
                }
            CHECK(S == S.transpose());
        }
        CHECK(entries > 0);
    }
}

TEST_CASE("what a problem of fewer rows has of the same joints is taken from the larger one", "[house]")
{
    Random random(19);
    for (int round = 0; round < 60; ++round) {
        JointedScene scene = driven_tree(random, 3 + round % 6, round % 3);
        const StepData<3> now = after_one_step(scene);
        JointFactor factor;
        factor.factor(now.rows, scene.bodies.inverse_mass);
        std::vector<char> left_out(now.rows.size(), 0);
        for (std::size_t i = 0; i < left_out.size(); ++i)
            left_out[i] = !JointTree::takes(now.rows[i]) && random.uniform(0, 1) < 0.4;
        const Index bodies = scene.bodies.count();
        BoundedRows whole, part, taken;
        whole.eliminate(factor, now.rows, {}, bodies);
        part.eliminate(factor, now.rows, left_out, bodies);
        taken.eliminate(factor, now.rows, left_out, bodies, &whole);
        CHECK(taken.columns == 0);
        CHECK(part.columns == part.islands.listed);
        REQUIRE(taken.islands.count == part.islands.count);
        for (int k = 0; k < part.islands.count; ++k) CHECK(MatX(taken.matrix(k)) == MatX(part.matrix(k)));
        // a row that the larger one left out has to be found
        BoundedRows found;
        found.eliminate(factor, now.rows, {}, bodies, &part);
        for (int k = 0; k < whole.islands.count; ++k) CHECK(MatX(found.matrix(k)) == MatX(whole.matrix(k)));
    }
}

TEST_CASE("arcs and errors of a step take the columns that velocities had", "[house]")
{
    Random random(3);
    JointedScene scene = driven_tree(random, 8, 0);
    Trees method;
    method.correction.stiff = false;
    StepData<3> now;
    step(scene, {.h = 1.0 / 100}, method, now);
    CHECK(method.solver.bounded.columns > 0);
    CHECK(method.solver.others[true].bounded.islands.listed > 0);
    CHECK(method.solver.others[true].bounded.columns == 0);
}

TEST_CASE("a leg with a motor turns at its speed from the first step without a sweep", "[idea]")
{
    JointedScene scene;
    const Index crank = add_jansen_leg(scene, 0.4, {6, 1e3, 0, 0, 0});
    JointedScene twin = scene;
    Trees method, swept;
    swept.solver.most_exact = 0;
    swept.solver.sweeps = 10;
    StepData<3> now, then;
    for (int i = 0; i < 240; ++i) {
        step(scene, {.h = 1.0 / 240}, method, now);
        REQUIRE(now.solution.status == Status::solved);
        CHECK(method.solver.sweeps_made == 0);
        CHECK(std::abs(scene.bodies.u[3 * crank + 2] - 6) <= 1e-8);
    }
    step(twin, {.h = 1.0 / 240}, swept, then);
    // ten sweeps are not enough, and it is not called solved
    CHECK(std::abs(twin.bodies.u[3 * crank + 2] - 6) > 0.1);
    CHECK(then.solution.status == Status::iteration_limit);
}

TEST_CASE("what joints hold does not move and its motor pushes with all it has", "[idea]")
{
    JointedScene scene;
    scene.gravity = {0, 0};
    add_body(scene, box(1, 1), 1.0, {0, 0});
    add_joint(scene, joint_at(scene, JointKind::weld, world, 0, {0, 0}));
    RigidJoint axle = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
    axle.motor = {2, 7, 0, 0, 0};
    const std::size_t motor = add_joint(scene, axle);
    Trees method;
    StepData<3> now;
    step(scene, {.h = 0.01}, method, now);
    CHECK(now.solution.status == Status::solved);
    CHECK(scene.bodies.u.norm() <= 1e-12);
    CHECK(std::abs(reaction(scene, now, motor).torque - 7) <= 1e-12);  // its bound
    CHECK(std::abs(reaction(scene, now, 0).torque + 7) <= 1e-9);       // and the weld bears it
}

TEST_CASE("two motors that want different speeds pull with their bounds and the stronger one wins", "[idea]")
{
    JointedScene scene;
    scene.gravity = {0, 0};
    add_body(scene, disc(1), Mass{1, {0, 0}, 0.5}, {0, 0});
    for (const auto& [speed, torque] : {std::pair{3.0, 5.0}, std::pair{-2.0, 2.0}}) {
        RigidJoint axle = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
        axle.motor.speed = speed, axle.motor.force = torque;
        add_joint(scene, axle);
    }
    Trees method;
    StepData<3> now;
    for (int i = 1; i <= 100; ++i) {
        step(scene, {.h = 0.01}, method, now);
        CHECK(now.solution.status == Status::solved);
        // 5 - 2 N m on 0.5 kg m^2 until it is as fast as the stronger one wants
        CHECK(std::abs(scene.bodies.u[2] - std::min(3.0, 6 * 0.01 * i)) <= 1e-9);
    }
}

namespace {

/// Dolls one above the other. \param pairs  out: limbs of one doll, which do not touch each other
JointedScene dolls_above_stairs(int count, std::vector<std::pair<Index, Index>>& pairs)
{
    JointedScene scene;
    add_stairs(scene, 5);
    for (int i = 0; i < count; ++i)
        forbid_itself(add_ragdoll(scene, {-0.1 + 0.15 * (i % 3), 2.6 + 1.8 * i}), [&pairs](Index a, Index b) {
            pairs.push_back({a, b});
        });
    cover(scene, {0.6, 0, 0, 0});
    return scene;
}

void let_touch(JointTrees<Manifolds>& method, const JointedScene& scene,
               const std::vector<std::pair<Index, Index>>& pairs)
{
    method.contacts.finder.filter = forbid_pairs(scene.bodies.count(), pairs);
    never_stop(method.contacts);
}

}  // namespace

TEST_CASE("a pile of dolls is solved exactly as long as no island has too many rows", "[house]")
{
    std::vector<std::pair<Index, Index>> pairs;
    JointedScene scene = dolls_above_stairs(3, pairs);
    JointTrees<Manifolds> method;
    let_touch(method, scene, pairs);
    JointedScene twin = scene;
    StepData<3> now;
    int solved = 0;
    std::size_t largest = 0;
    for (int i = 0; i < 240; ++i) {
        step(scene, {}, method, now);
        solved += now.solution.status == Status::solved;
        REQUIRE(scene.bodies.x.allFinite());
        CHECK(largest_joint_error(scene) <= 0.01 * 0.22);
        for (int k = 0; k < method.solver.bounded.islands.count; ++k)
            largest =
                std::max(largest, method.solver.bounded.islands.rows[static_cast<std::size_t>(k)].size());
    }
    CHECK(solved >= 238);
    CHECK(largest > 60);
    // the same dolls where that is too many: the steps that are not exact are those with such an island
    method = {};
    let_touch(method, twin, pairs);
    method.solver.most_exact = 60;
    int large = 0;
    for (int i = 0; i < 240; ++i) {
        step(twin, {}, method, now);
        REQUIRE(twin.bodies.x.allFinite());
        if (now.solution.status == Status::solved) continue;
        ++large;
        CHECK(method.solver.bounded.swept > 0);
    }
    CHECK(large > 20);
}

TEST_CASE("joints close where the rows with bounds have no answer", "[house]")
{
    // two sweeps are nowhere near one: pushes of contacts and limits tear at joints, and have to give way
    std::vector<std::pair<Index, Index>> pairs;
    JointedScene scene = dolls_above_stairs(6, pairs);
    JointTrees<Manifolds> method;
    let_touch(method, scene, pairs);
    method.solver.most_exact = 10;
    method.solver.sweeps = 2;
    StepData<3> now;
    int unsolved = 0, alone = 0;
    Real gap = 0;
    for (int i = 0; i < 120; ++i) {
        step(scene, {.h = 1.0 / 60}, method, now);
        REQUIRE(scene.bodies.x.allFinite());
        unsolved += now.solution.status != Status::solved;
        alone += method.correction.joints_alone;
        gap = std::max(gap, largest_joint_error(scene));
    }
    CHECK(unsolved > 30);
    CHECK(alone > 0);
    CHECK(gap <= 1e-9);  // the tolerance of Newton's method, at a length of 1 m
}

TEST_CASE("sweeps over what the joints leave come nearer than rounds of as many sweeps", "[house]")
{
    // the leg's motor: a row that measures itself by the crank alone needs a thousand rounds
    JointedScene eliminated, rounds;
    for (JointedScene* scene : {&eliminated, &rounds}) add_jansen_leg(*scene, 0.4, {6, 1e3, 0, 0, 0});
    Trees by_sweeps, by_rounds;
    by_sweeps.solver.most_exact = 1;  // smaller than no island but this one: the motor and nothing else
    by_rounds.solver.most_exact = 0;
    by_sweeps.solver.sweeps = by_rounds.solver.sweeps = 10;
    RigidJoint second = joint_at(eliminated, JointKind::revolute, 0, 1, JansenLeg(0.4).p[0]);
    second.motor.force = 1e-3;  // friction in the crank's end: the second row
    for (JointedScene* scene : {&eliminated, &rounds}) {
        RigidJoint knee = scene->placed[1].joint;
        knee.motor = second.motor;
        knee.collide_connected = false;
        add_joint(*scene, knee);
    }
    StepData<3> now, then;
    step(eliminated, {.h = 1.0 / 240}, by_sweeps, now);
    step(rounds, {.h = 1.0 / 240}, by_rounds, then);
    CHECK(by_sweeps.solver.bounded.swept == 1);
    CHECK(std::abs(eliminated.bodies.u[2] - 6) <= 1e-6);
    CHECK(std::abs(rounds.bodies.u[2] - 6) > 0.01);
    CHECK(now.solution.residual < 1e-3 * then.solution.residual);
}

TEST_CASE("a limit is left alone up to the slop of an angle however thin its body is", "[house]")
{
    for (const Real over : {0.003, 0.01}) {
        JointedScene scene;
        scene.gravity = {0, 0};
        scene.length = 1;
        add_body(scene, capsule(1, 0.001), 1.0, {0.5, 0});
        RigidJoint hinge = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
        hinge.lower = -1, hinge.upper = -over;
        add_joint(scene, hinge);
        Trees method;
        method.correction.slops = {1e-6};  // metres, for its contacts
        StepData<3> now;
        step(scene, {}, method, now);
        // (15.17): from 0.005 rad on by a fifth of what is missing to 0.0025
        CHECK(std::abs(scene.bodies.x[2] + (over > 0.005 ? 0.2 * (over - 0.0025) : 0)) <= 1e-12);
    }
}

TEST_CASE("an overlap that joints all but hold is left and does not throw its body around", "[house]")
{
    // a rod on a pin; a block lies across its end, so that the push goes past the pin by a millimetre
    JointedScene scene;
    scene.gravity = {0, 0};
    add_body(scene, box(2, 0.2), Mass{}, {0, -1});
    add_body(scene, capsule(1, 0.05), 5.0, {0, -0.45}, -pi / 2);
    RigidJoint hook = joint_at(scene, JointKind::revolute, world, 1, {0.001, 0.05});
    hook.collide_connected = true;
    add_joint(scene, hook);
    JointTrees<Manifolds> method;
    never_stop(method.contacts);
    StepData<3> now;
    const VecX x = scene.bodies.x;
    step(scene, {}, method, now);
    CHECK(method.correction.gave_up_pushing);
    for (int i = 0; i < 10; ++i) step(scene, {}, method, now);
    CHECK((scene.bodies.x - x).cwiseAbs().maxCoeff() <= 0.05);
    CHECK(largest_joint_error(scene) <= 1e-8);
}

TEST_CASE(
    "an island with more rows than are wanted exactly is swept and settings that make no sense are refused",
    "[house]")
{
    Random random(5);
    JointedScene scene = driven_tree(random, 6, 0);
    Trees method;
    method.solver.most_exact = 3;
    method.solver.sweeps = 1;
    StepData<3> now;
    step(scene, {.h = 1.0 / 100}, method, now);
    CHECK(method.solver.bounded.swept == 1);
    CHECK(method.solver.bounded.unsolved == 1);
    CHECK(now.solution.status == Status::iteration_limit);
    CHECK(now.solution.iterations == 1);
    // sweeps that change nothing more are not made, and not counted
    method.solver.sweeps = 100000;
    step(scene, {.h = 1.0 / 100}, method, now);
    CHECK(now.solution.status == Status::solved);
    CHECK(now.solution.iterations > 1);
    CHECK(now.solution.iterations < 100000);
    method.solver.most_exact = -1;
    CHECK(sentence_of([&] { step(scene, {}, method, now); }) ==
          "the rows with bounds that are found exactly are at most -1; it must be zero or positive");
}

TEST_CASE("a steady step with motors and limits above joints asks for no memory", "[house]")
{
    JointedScene scene = chain_scene({8, 0.3, 1, 2, 0.5});
    for (std::size_t i = 0; i < 4; ++i) {
        RigidJoint joint = scene.placed[i].joint;
        joint.motor.force = 0.1;
        joint.lower = -4, joint.upper = 4;
        add_joint(scene, joint);
    }
    Trees method;
    method.contacts.skip_far_limits = false;
    StepData<3> now;
    for (int i = 0; i < 100; ++i) step(scene, {}, method, now);
    {
        const NoAllocation none;
        for (int i = 0; i < 20; ++i) step(scene, {}, method, now);
    }
    CHECK(NoAllocation::violations() == 0);
}
