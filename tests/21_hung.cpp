/// Chapter 21: what hangs on hinges, a gyroscope, and how stiff a load is.

#include "chapters/14_joints/joint_method.hpp"
#include "chapters/14_joints/placed_joints.hpp"
#include "chapters/21_joints_in_space/gyroscope.hpp"
#include "chapters/21_joints_in_space/joint_methods.hpp"
#include "chapters/21_joints_in_space/loaded_solids.hpp"

#include "tests/catch.hpp"
#include "tests/eigenvalues.hpp"
#include "tests/order.hpp"
#include "tests/solids.hpp"

using namespace rigid;

namespace {

/// One second of a chain of plates in space and in the plane: how far apart they are at its end.
Real plates_apart(int steps)
{
    JointedSolids space = plate_chain(4, 0);
    JointedScene plane;
    for (int k = 0; k < 4; ++k) {
        const Real m = 1 / space.bodies.inverse_mass[6 * k], I = 1 / space.bodies.inverse_mass[6 * k + 5];
        RigidJoint pin;
        pin.a = k - 1;
        pin.b = add_body(plane, capsule(0.9, 0), Mass{m, {0, 0}, I}, Vec2(k + 0.5, 0), 0);
        pin.at_a = k == 0 ? Vec2(0, 0) : Vec2(0.5, 0);
        pin.at_b = {-0.5, 0};
        add_joint(plane, pin);
    }
    plane.length = space.length = 1;
    SpaceSweeps in_space;
    JointSweeps<AllBodies> in_plane;
    in_space.solver.sweeps = in_plane.solver.sweeps = {20000, 1e-13};
    StepData<6> now;
    StepData<3> flat;
    for (int i = 0; i < steps; ++i) {
        step(space, {.h = 1.0 / steps}, in_space, now);
        step(plane, {.h = 1.0 / steps}, in_plane, flat);
    }
    Real most = 0;
    for (Index k = 0; k < 4; ++k)
        most = std::max(most, (space.bodies.x.segment<2>(6 * k) - plane.bodies.x.segment<2>(3 * k)).norm());
    return most;
}

}  // namespace

TEST_CASE("a chain of plates on hinges moves in space as it does in the plane", "[idea]")
{
    // rows along the axes of the joint's frame turn with it, those of the plane do not: by second order in h
    std::vector<Real> apart;
    for (const int steps : {240, 480, 960, 1920}) apart.push_back(plates_apart(steps));
    INFO(apart[0] << " " << apart[1] << " " << apart[2] << " " << apart[3]);
    CHECK(apart.back() < 1e-5);
    for (std::size_t i = 0; i + 1 < apart.size(); ++i) CHECK(std::log2(apart[i] / apart[i + 1]) > 1.5);
}

TEST_CASE("plates on hinges stay in their plane however they are pushed", "[idea]")
{
    JointedSolids scene = plate_chain(4, 3);
    SpaceExact method;
    StepData<6> now;
    Real aside = 0;
    for (int i = 0; i < 480; ++i) {
        step(scene, {.h = 1.0 / 480}, method, now);
        for (Index k = 0; k < 4; ++k) aside = std::max(aside, std::abs(scene.bodies.x[6 * k + 2]));
    }
    // 3 m/s would carry it 3 m away
    CHECK(aside < 0.02);
    CHECK(scene.bodies.x[1] < -0.1);
}

TEST_CASE("a gyroscope in a gimbal precesses at M g l over I omega", "[idea]")
{
    const Gyroscope gyroscope;
    std::vector<Real> errors;
    for (const int n : {960, 1920, 3840, 7680}) {
        JointedSolids scene = gyroscope_in_gimbal(gyroscope);
        SpaceExact method;
        StepData<6> now;
        for (int i = 0; i < n; ++i) step(scene, {.h = 1.0 / n}, method, now);
        // the angle that the outer ring has gone in one second
        const Vec3 axis = rotation_of(scene.bodies.x, 2).col(0);
        errors.push_back(std::abs(std::atan2(-axis.z(), axis.x()) - precession_of(gyroscope)));
        INFO(n << " " << axis.transpose() << " " << precession_of(gyroscope));
        CHECK(std::abs(axis.y()) < 0.02);  // it does not fall
        CHECK(largest_joint_error(scene) < 1e-3);
    }
    INFO(errors[0] << " " << errors[1] << " " << errors[2] << " " << errors[3]);
    // the hinges turn a wheel at 0.16 rad a step, and that makes it nod by less than 1e-3 rad
    for (const Real error : errors) CHECK(error < 1e-3 * precession_of(gyroscope));
}

TEST_CASE("the stiffness of a load is how its torque changes when the body turns", "[ch18][load][idea]")
{
    Random random(3);
    for (int n = 0; n < 100; ++n) {
        const Vec3 f = any_vector(random, 1);
        const Vec3 r = any_vector(random, 1);
        const Mat3 K = turning_stiffness(f, r);
        CHECK(K == K.transpose());
        Mat3 change;  // d(τ)/dφ by central differences
        const Real small = 1e-5;
        for (int i = 0; i < 3; ++i) {
            const Vec3 phi = small * Vec3::Unit(i);
            const Vec3 there = rotation_matrix(phi) * r, back = rotation_matrix(Vec3(-phi)) * r;
            change.col(i) = (cross(there, f) - cross(back, f)) / (2 * small);
        }
        const Mat3 symmetric = -(change + change.transpose()) / 2;
        // differences of second order: 1e-10 of |f||r| < 3, and rounding, 1e-16/1e-5
        CHECK((K - symmetric).norm() < 1e-9);
    }
}

TEST_CASE("what is added is never less than the stiffness and exact where the load is along an axis",
          "[ch18][load][idea]")
{
    Random random(4);
    for (int n = 0; n < 1000; ++n) {
        Mat3 K = Mat3::Zero();
        for (int i = 0; i < 2; ++i) {
            const Vec3 f = any_vector(random, 1);
            K += turning_stiffness(f, any_vector(random, 1));
        }
        const Vec3 kappa = at_least(K);
        CHECK(kappa.minCoeff() >= 0);
        const Mat3 left = Mat3(kappa.asDiagonal()) - K;
        // rounding of entries below 20
        CHECK(symmetric_eigenvalues(left).minCoeff() > -1e-13);
    }
    const Vec3 pull(0, 7, 0), arm(0, 0.5, 0);
    CHECK(at_least(turning_stiffness(pull, arm)) == Vec3(3.5, 0, 3.5));
    CHECK(at_least(turning_stiffness(-pull, arm)) == Vec3(0, 0, 0));  // a push makes it tip over
}
