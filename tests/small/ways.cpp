/// The small program of chapter 26, one bead in five ways, beside the library.

#include "tests/small/alone.hpp"

#include "chapters/26_four_ways/acceleration_level.hpp"
#include "chapters/26_four_ways/reduced_motion.hpp"
#include "chapters/26_four_ways/spring_forces.hpp"
#include "chapters/26_four_ways/ways.hpp"
#include "tests/catch.hpp"
#include "tests/small/sentences.hpp"

#define main small_main
namespace small26 {
#include "chapters/26_four_ways/small.cpp"
}
#undef main

using namespace rigid;

namespace {

/// How far two beads are apart, with their velocities.
Real apart(const small26::Body& small, const JointedScene& scene)
{
    return std::max((small.x - scene.bodies.x.head<2>()).norm(), (small.u - scene.bodies.u.head<2>()).norm());
}

/// Twenty steps of h by the small program's way and by a method of the library.
template <class Step>
Real after_twenty(void (*way)(small26::Body&, double, double), double h, double k, const Step& step)
{
    small26::Body small = small26::by_hand();
    JointedScene scene = bead_on_a_wire();
    for (int i = 0; i < 20; ++i) {
        way(small, h, k);
        step(scene);
    }
    return apart(small, scene);
}

}  // namespace

TEST_CASE("the small program of chapter 26 moves its bead as the library does in every way")
{
    const Real h = 0.01, k = 1000;  // no chaos in one bead: rounding of some tens of sums of size 1
    StepData<3> now;
    ExplicitPenalty<Manifolds> spring;
    ImplicitPenalty<Manifolds> soft;
    for (PenaltySprings* const springs : {&spring.correction.springs, &soft.correction.springs}) {
        springs->stiffness = k;
        springs->joint_ratio = 0;
    }
    CHECK(after_twenty(small26::spring_step, h, k,
                       [&](JointedScene& s) { step(s, {.h = h}, spring, now); }) <= 1e-12);
    // the solver of the library stops at 1e-11 of the numbers in the row
    CHECK(after_twenty(small26::soft_step, h, k, [&](JointedScene& s) { step(s, {.h = h}, soft, now); }) <=
          1e-9);

    AccelerationLevel level;
    CHECK(after_twenty(small26::runge_kutta_step, h, k, [&](JointedScene& s) { level.advance(s, h); }) <=
          1e-12);
    CHECK(after_twenty(small26::acceleration_step, h, k, [&](JointedScene& s) {
              VecX a;
              level.close(s, 0);
              level.accelerations(s, s.bodies.x, s.bodies.u, a);
              s.bodies.u += h * a;
              s.bodies.x += h * s.bodies.u;
          }) <= 1e-12);
    CHECK(after_twenty(small26::row_step, h, k, [&](JointedScene& s) {
              const Row<3> row = bilateral(joint_constraint(s.bodies.x, s.joints[0]), s.bodies.inverse_mass);
              s.bodies.u[1] -= 10 * h;
              row.apply(solve_row(row, s.bodies.u).lambda, s.bodies.u);
              s.bodies.x += h * s.bodies.u;
          }) <= 1e-12);

    WayScene bead;
    bead.scene = bead_on_a_wire();
    WayRun positions(Way::positions, bead, {1, 1});
    small26::Body small = small26::by_hand();
    for (int i = 0; i < 20; ++i) {
        small26::position_step(small, h, 0);
        positions.advance(h);
    }
    CHECK(apart(small, positions.scene()) <= 1e-12);

    // the angle: (26.8) by the recursion of a body that is a point on a pin
    JointedScene pinned = bead_on_a_wire();
    pinned.joints.clear(), pinned.placed.clear(), pinned.owner.clear();
    pinned.bodies.inverse_mass[2] = 1e12;
    RigidJoint pin;
    pin.b = 0, pin.at_b = {-0.6, 0.8};
    add_joint(pinned, pin);
    pinned.bodies.u[2] = 1;
    ReducedMotion reduced(pinned);
    ReducedTree tree(pinned);
    VecX q = reduced.q(), dq = reduced.dq();
    small = small26::by_hand();
    for (int i = 0; i < 20; ++i) {
        small26::angle_step(small, h, 0);
        dq += h * reduced.forward_dynamics(q, dq, {});
        q += h * dq;
    }
    tree.place(q, pinned.bodies.x);
    tree.move(dq, pinned.bodies.x, pinned.bodies.u);
    CHECK(apart(small, pinned) <= 1e-10);  // the point has an inertia of 1e-12 kg m²
}

namespace {

// What the sentences of these chapters say.

Numbers bead_ways(Numbers in)
{
    const auto off = [&](void (*step)(small26::Body&, double, double)) {
        small26::Body body = small26::by_hand();
        step(body, in["h"], 0);
        return 1000 * small26::off(body);
    };
    return {{"spring", off(small26::spring_step)},
            {"inside", -off(small26::acceleration_step)},
            {"velocity", off(small26::row_step)}};
}

const Sentence says_bead_ways("bead_ways", bead_ways, 1e-9);  // millimetres off a radius of a metre

}  // namespace
