/// Chapter 21: bodies in space, and their joints, on the step of Part I.

#include "tests/no_allocation.hpp"

#include "chapters/11_rotation/mechanisms.hpp"
#include "chapters/21_joints_in_space/hung_scenes.hpp"
#include "chapters/21_joints_in_space/joint_methods.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/order.hpp"
#include "tests/sentence.hpp"

using namespace rigid;

namespace {

Vec3 somewhere(Random& random, Real size)
{
    const Real x = random.uniform(-size, size), y = random.uniform(-size, size),
               z = random.uniform(-size, size);
    return {x, y, z};
}

template <class Method>
void run(JointedSolids& scene, Method& method, Real h, long steps, int substeps = 1)
{
    StepData<6> now;
    for (long i = 0; i < steps; ++i) step(scene, {.h = h, .substeps = substeps}, method, now);
}

SpaceExact exact_method(Stabilizer stabilizer = Stabilizer::baumgarte)
{
    SpaceExact method;
    method.correction.method = stabilizer;
    return method;
}

/// Two boxes, somewhere, and a joint at a point between them or between the world and the second.
JointedSolids two_boxes(Random& random)
{
    JointedSolids scene;
    for (int k = 0; k < 2; ++k) {
        const Vec3 at = somewhere(random, 2), theta = somewhere(random, 1.5);
        add_body(scene, {solid_box({1, 2, 3})}, 1.0, at, theta);
    }
    return scene;
}

}  // namespace

// ---- the step -----------------------------------------------------------------------------------

TEST_CASE("J of every coordinate of a joint is the derivative of its value", "[idea]")
{
    Random random(7);
    Real worst = 0;
    for (int i = 0; i < 200; ++i) {
        JointedSolids scene = two_boxes(random);
        const Vec3 axis = somewhere(random, 1), moved = somewhere(random, 1);
        const SpaceJoint joint = joint_at(scene, i % 2 == 0 ? world : 0, 1, {0.3, 0.2, -0.1}, axis);
        scene.bodies.x.segment<3>(9) = add_rotation(scene.bodies.x.segment<3>(9), moved);
        scene.bodies.x.segment<3>(6) += moved;
        for (int c = 0; c < coordinates; ++c) {
            const auto which = static_cast<Coordinate>(c);
            const Constraint<6> at = coordinate_of(frames_of(scene.bodies.x, joint), joint, which);
            for (Index k = 0; k < 12; ++k) {
                const auto value = [&](Real d) {
                    VecX x = scene.bodies.x;
                    const Index body = k / 6, i6 = k % 6;
                    if (i6 < 3) x[k] += d;
                    else {
                        Vec3 turn(0, 0, 0);
                        turn[i6 - 3] = d;
                        x.segment<3>(6 * body + 3) = add_rotation(x.segment<3>(6 * body + 3), turn);
                    }
                    return coordinate_of(frames_of(x, joint), joint, which).C;
                };
                const Real slope = (value(1e-5) - value(-1e-5)) / 2e-5;
                worst = std::max(worst, std::abs(slope - (k < 6 ? at.Ja[k] : at.Jb[k - 6])));
            }
        }
    }
    CHECK(worst < 1e-7);  // the cone turns sharply where it is nearly straight
}

TEST_CASE("joints start where they are and lock what their names say", "[idea]")
{
    Random random(8);
    JointedSolids scene = two_boxes(random);
    const Vec3 p(0.1, 0.2, 0.3), axis(1, 2, -2);
    const std::vector<std::pair<SpaceJoint, int>> joints = {
        {ball_joint(scene, 0, 1, p), 3},      {hinge(scene, 0, 1, p, axis), 5},
        {slider(scene, 0, 1, p, axis), 5},    {constant_velocity(scene, 0, 1, p, axis), 4},
        {universal(scene, 0, 1, p, axis), 4}, {fixed_joint(scene, 0, 1, p), 6}};
    for (const auto& [joint, rows] : joints) {
        const JointFrames f = frames_of(scene.bodies.x, joint);
        int count = 0;
        for_each_slot(f, joint, [&, &one = joint](int slot) {
            ++count;
            CHECK(std::abs(joint_constraint(f, one, slot).C) < 1e-14);
        });
        CHECK(count == rows);
    }
}

TEST_CASE("a frame lies along its axis also where that is nearly turned about", "[house]")
{
    for (const Real aside : {1.0, 1e-2, 1e-3, 1e-4, 1e-5, 1e-7, 1e-9, 1e-20, 1e-300, 0.0})
        for (const Real other : {0.0, 0.5, -1.0}) {
            const Vec3 axis = Vec3(-1, aside, other * aside).normalized();
            // 1e-16 of 1 + x·n, where that is 1e-8 or more, over a lean of 1e-4
            CHECK((rotation_matrix(frame_along(axis)).col(0) - axis).norm() < 1e-11);
        }
    // and what rounding leaves beside it does not choose how the frame lies
    CHECK(frame_along({-1, 0, 0}) == Vec3(0, pi, 0));
    CHECK(frame_along({-1, 1e-16, -1e-17}) == Vec3(0, pi, 0));
}

TEST_CASE("a universal joint hands a spin on unevenly as (21.7b) says and a constant-velocity joint evenly",
          "[idea]")
{
    // A shaft along x on a motor, a second one that leans by b and turns in a bearing, and the joint between them.
    const Real b = 0.6, speed = 2, h = 1.0 / 2000;
    const Vec3 lean(std::cos(b), std::sin(b), 0);
    const auto shafts = [&](auto&& make) {
        JointedSolids scene;
        scene.gravity.setZero();
        add_body(scene, {solid_box({1, 0.2, 0.2})}, 1.0, {-0.5, 0, 0});
        add_body(scene, {solid_box({1, 0.2, 0.2})}, 1.0, 0.5 * lean, {0, 0, b});
        SpaceJoint driven = hinge(scene, world, 0, {-1, 0, 0}, {1, 0, 0});
        driven.motor = twist, driven.speed = speed, driven.force = 100;
        SpaceJoint between = make(scene, 0, 1, Vec3(0, 0, 0), Vec3(1, 0, 0));
        between.frame_b = make(scene, 0, 1, Vec3(0, 0, 0), lean).frame_b;
        SpaceJoint bearing = joint_at(scene, world, 1, lean, lean);  // the other end is held by the joint
        bearing.lock({swing_y, swing_z});
        scene.joints = {driven, between, bearing};
        return scene;
    };
    JointedSolids uneven = shafts(universal), even = shafts(constant_velocity);
    uneven.bodies.velocity(0)[3] = even.bodies.velocity(0)[3] = speed;
    uneven.bodies.velocity(1)[3] = speed * std::cos(b), even.bodies.velocity(1)[3] = speed;
    SpaceExact method = exact_method(), other = exact_method();
    StepData<6> now, now_of_other;
    Real worst = 0, most = 0, least = infinity, uneven_most = 0;
    for (int i = 0; i < 7000; ++i) {  // a turn
        step(uneven, {.h = h}, method, now);
        step(even, {.h = h}, other, now_of_other);
        // the pin z of A, and how far it is from the plane of the shafts
        const Real cosine = rotation_of(uneven.bodies.x, 0)(1, 2);
        const Real here = speed * std::cos(b) / (1 - std::pow(std::sin(b) * cosine, 2));
        worst = std::max(worst, std::abs(uneven.bodies.u[9] - here));
        most = std::max(most, uneven.bodies.u[9]), least = std::min(least, uneven.bodies.u[9]);
        uneven_most = std::max(uneven_most, std::abs(even.bodies.u[9] - speed));
    }
    CHECK(most == Approx(speed / std::cos(b)).epsilon(2e-3));
    CHECK(least == Approx(speed * std::cos(b)).epsilon(2e-3));
    CHECK(worst < 2e-3);  // of first order in h
    CHECK(uneven_most < 2e-3);
}

TEST_CASE("what joints do between bodies changes neither momentum nor angular momentum", "[idea]")
{
    JointedSolids scene;
    scene.gravity.setZero();
    add_body(scene, {solid_box({1, 0.2, 0.4})}, 1.0, {0, 0, 0});
    add_body(scene, {solid_box({0.3, 1, 0.5})}, 1.0, {1, 0.3, 0.1});
    scene.bodies.u << 0.1, 0.2, 0, 1, 2, 0.5, 0, 0, 0, 0.3, -1, 0.2;
    SpaceJoint joint = hinge(scene, 0, 1, {0.5, 0.1, 0}, {1, 1, 0});
    joint.motor = twist, joint.speed = 3, joint.force = 0.05;
    scene.joints.push_back(joint);
    SpaceExact method = exact_method();
    const Vec<6> before = momenta(scene.bodies);
    run(scene, method, 1.0 / 240, 600);
    const Vec<6> change = momenta(scene.bodies) - before;
    CHECK(change.norm() < 1e-13 * 600);  // a rounding of numbers near 1 in each step
    CHECK(largest_joint_error(scene) < 2e-3);
}

TEST_CASE("what starts in a plane moves as in chapter 11", "[idea]")
{
    // The pendulum of two rods, with hinges along z; its links are drawn as boxes.
    const Real h = 1.0 / 240;
    RigidScene plane;
    JointedSolids space;
    for (int i = 0; i < 2; ++i) {
        const Vec2 at(i + 0.5, 0);
        add_body(plane, box(1, 0.1), Real{10}, at);
        add_body(space, {solid_box({1, 0.1, 1})}, 10.0, {at.x(), 0, 0});
        // rows that turn with the upper rod, as those of a joint in space do
        for (const Vec2& n : {Vec2(1, 0), Vec2(0, 1)}) {
            PointJoint half;
            half.measure = PointJoint::Measure::turning;
            half.a = i - 1, half.b = i;
            half.at_a = i == 0 ? Vec2(0, 0) : Vec2(0.5, 0), half.at_b = {-0.5, 0};
            half.direction = n;
            plane.joints.push_back(half);
        }
        space.joints.push_back(hinge(space, i - 1, i, Vec3(i, 0, 0), {0, 0, 1}));
    }
    RigidExact flat;
    flat.correction.method = Stabilizer::baumgarte;
    SpaceExact solid = exact_method();
    StepData<3> flat_now;
    StepData<6> solid_now;
    for (int i = 0; i < 240; ++i) {
        step(plane, {.h = h}, flat, flat_now);
        step(space, {.h = h}, solid, solid_now);
    }
    for (Index k = 0; k < 2; ++k) {
        // the axes of the second joint lie otherwise: rounding, for a second of free motion
        CHECK((space.bodies.x.segment<2>(6 * k) - plane.bodies.x.segment<2>(3 * k)).norm() < 1e-9);
        CHECK(std::abs(space.bodies.x[6 * k + 2]) < 1e-12);
        CHECK(std::abs(space.bodies.u[6 * k + 5] - plane.bodies.u[3 * k + 2]) < 1e-8);
    }
}

TEST_CASE("a top precesses at the rate of (21.8) to first order", "[idea]")
{
    TopShape top;
    const Real axial = top.radius * top.radius / 2,
               rate = slow_precession(axial / 2 + top.length * top.length, axial, top.spin, 9.81 * top.length,
                                      top.tilt);
    std::vector<Real> errors;
    for (const int steps : {250, 500, 1000, 2000}) {
        JointedSolids scene = spinning_top(top);
        SpaceExact method = exact_method();
        run(scene, method, 0.5 / steps, steps);
        const Vec3 p = centre_of(scene.bodies.x, 0), axis = p / top.length;
        // it starts over the x axis and goes about y; x turns towards -z
        const Real turned = std::atan2(-p.z(), p.x());
        errors.push_back(std::abs(std::remainder(turned - rate * 0.5, 2 * pi)) +
                         std::abs(std::acos(std::min(axis.y(), Real{1})) - top.tilt));
    }
    CHECK(errors.back() < errors.front());
    CHECK(order_of(errors) > 0.85);
    CHECK(errors.back() < 0.02);
    // reference value S2: moments about the tip 0.1 and 0.05, m g l = 2.943, spin 40
    CHECK(slow_precession(0.1, 0.05, 40, 2.943, pi / 6) == Approx(1.579533463148246).epsilon(1e-13));
    // spun the other way it goes around the other way
    CHECK(slow_precession(0.1, 0.05, -40, 2.943, pi / 6) == -slow_precession(0.1, 0.05, 40, 2.943, pi / 6));
    CHECK(sentence_of([] { slow_precession(0.1, 0.05, 20, 2.943, pi / 6); }).find("too slow") !=
          std::string::npos);
}

TEST_CASE("a motor brings a hinge to its speed within its torque and a stop holds it", "[idea]")
{
    JointedSolids scene = driven_door(1.5, 20, 75 * pi / 180);
    SpaceExact method = exact_method();
    StepData<6> now;
    const Real h = 1.0 / 240;
    // I about the hinge: m (w²/3 + d²/12); the motor turns it from rest with its full torque
    const Real inertia = 20 * (0.64 / 3 + 0.0016 / 12);
    for (int i = 0; i < 12; ++i) step(scene, {.h = h}, method, now);
    CHECK(world_spin(scene.bodies, 0).y() ==
          Approx(20 * 12 * h / inertia).epsilon(1e-3));  // the arc of its steps
    for (int i = 0; i < 80; ++i) step(scene, {.h = h}, method, now);
    CHECK(world_spin(scene.bodies, 0).y() == Approx(1.5).epsilon(1e-6));  // far above rounding
    for (int i = 0; i < 400; ++i) step(scene, {.h = h}, method, now);
    const JointFrames f = frames_of(scene.bodies.x, scene.joints[0]);
    CHECK(turn_of(twist, f.q).value == Approx(75 * pi / 180).margin(1e-3));
    CHECK(std::abs(world_spin(scene.bodies, 0).y()) < 1e-3);
    CHECK(largest_joint_error(scene) < 1e-3);
}

TEST_CASE("a door goes back to a stop at half a turn the short way and one that is locked there rests",
          "[idea]")
{
    // how far it is from half a turn, at most on its way and in the end
    const auto off = [](Real lo, Real hi, Real open) {
        JointedSolids scene = driven_door(0, 0, 1);
        scene.joints[0].lo[twist] = lo, scene.joints[0].hi[twist] = hi, scene.joints[0].motor = -1;
        const Vec3 theta(0, open, 0);
        scene.bodies.x << rotation_matrix(theta) * scene.bodies.x.head<3>(), theta;
        SpaceExact method = exact_method(Stabilizer::split_impulse);
        StepData<6> now;
        Vec2 most_and_last(0, 0);
        for (int i = 0; i < 400; ++i) {
            step(scene, {.h = 1.0 / 60}, method, now);
            const Real angle = turn_of(twist, frames_of(scene.bodies.x, scene.joints[0]).q).value;
            most_and_last[1] = std::abs(std::remainder(angle - pi, 2 * pi));
            most_and_last[0] = std::max(most_and_last[0], most_and_last[1]);
        }
        return most_and_last;
    };
    // 0.01 rad too far, or too little, of which each step takes back a part; 1e-9: what is left is far below
    for (const Vec2& r : {off(0, pi, pi + 0.01), off(-pi, 0, -pi - 0.01), off(pi, pi, pi + 0.01),
                          off(pi, pi, pi - 0.01), off(-pi, -pi, pi - 0.01)}) {
        CHECK(r[0] < 0.01);
        CHECK(r[1] < 1e-9);
    }
    CHECK(off(pi, pi, pi)[0] < 1e-9);  // where rounding chooses the sign of the twist
}

TEST_CASE("sweeps and islands and active sets find the same motion", "[idea]")
{
    const auto end = [](auto method) {
        JointedSolids scene = rod_chain(4);
        run(scene, method, 1.0 / 240, 60, 2);
        return scene.bodies.x;
    };
    SpaceSweeps sweeps;
    sweeps.solver.sweeps = {20000, 1e-12};
    SpaceIslands islands;
    islands.solver.sweeps = {20000, 1e-12};
    const VecX exact = end(exact_method());
    // each step within 1e-12 m/s, for half a second of a motion that parts slowly
    CHECK((end(sweeps) - exact).norm() < 1e-8);
    CHECK((end(islands) - exact).norm() < 1e-8);
}

TEST_CASE("a scene that is turned moves as it did and is turned", "[idea]")
{
    const Vec3 by(0.4, -1.1, 0.7);
    const Mat3 R = rotation_matrix(quaternion_of(by));
    JointedSolids scene = rod_chain(3), turned;
    turned.gravity = R * scene.gravity;
    turned.bodies = scene.bodies;
    turned.shapes = scene.shapes;
    for (Index k = 0; k < 3; ++k) {
        turned.bodies.x.segment<3>(6 * k) = R * scene.bodies.x.segment<3>(6 * k);
        turned.bodies.x.segment<3>(6 * k + 3) = add_rotation(by, scene.bodies.x.segment<3>(6 * k + 3));
        turned.bodies.u.segment<3>(6 * k) = R * scene.bodies.u.segment<3>(6 * k);
    }
    turned.joints = scene.joints;  // their frames go with the bodies, but for that in the world
    turned.joints[0].frame_a = add_rotation(by, scene.joints[0].frame_a);
    SpaceExact one = exact_method(), other = exact_method();
    run(scene, one, 1.0 / 240, 120);
    run(turned, other, 1.0 / 240, 120);
    for (Index k = 0; k < 3; ++k)
        CHECK((turned.bodies.x.segment<3>(6 * k) - R * scene.bodies.x.segment<3>(6 * k)).norm() < 1e-10);
}

TEST_CASE("split impulses repair joints in space and leave no velocity", "[idea]")
{
    JointedSolids scene;
    scene.gravity.setZero();
    add_body(scene, {solid_box({1, 0.2, 0.4})}, 1.0, {0, 0, 0});
    add_body(scene, {solid_box({1, 0.2, 0.4})}, 1.0, {1, 0, 0});
    scene.joints.push_back(fixed_joint(scene, 0, 1, {0.5, 0, 0}));
    scene.bodies.x.segment<3>(9) = Vec3(0.02, -0.01, 0.03);  // pulled out of place
    scene.bodies.x.segment<3>(6) += Vec3(0.01, 0.02, 0);
    SpaceExact method = exact_method(Stabilizer::split_impulse);
    CHECK(largest_joint_error(scene) > 1e-2);
    run(scene, method, 1.0 / 60, 200);
    CHECK(largest_joint_error(scene) < 1e-6);
    CHECK(scene.bodies.u.norm() < 1e-12);
}

TEST_CASE("what no body has is refused with a sentence", "[house]")
{
    JointedSolids scene;
    const auto with = [&](const Vec3& moments) {
        return sentence_of([&] {
            SolidMass mass;
            mass.mass = 1;
            mass.inertia = moments.asDiagonal();
            add_body(scene, {solid_ball(1)}, mass, {0, 0, 0});
        });
    };
    CHECK(with({1, 1, 3}) == "a body has the principal moments of inertia 1, 1, 3 kg m²; they must be "
                             "positive, and none larger than the "
                             "sum of the other two");
    CHECK(with({1, 1, -1}).find("must be positive") != std::string::npos);
    CHECK(with({1, 1, 2}) == "accepted");  // a thin disc
    CHECK(sentence_of([] {
              mass_of(solid_box({1, 1, 0}), 1);
          }) == "the volume of the body in m³ is 0; it must be positive: a radius, or faces counterclockwise "
                "from outside");
    CHECK(sentence_of([] { mass_of(solid_ball(1), -2); }) ==
          "the density in kg/m³ is -2; it must be positive and finite");
    Hull rounded = solid_box({1, 1, 1});
    rounded.radius = 0.1;
    CHECK(sentence_of([&] { mass_of(rounded, 1); }).find("0.1") != std::string::npos);
    CHECK(sentence_of([&] {
              hinge(scene, 0, 5, {0, 0, 0}, {1, 0, 0});
          }).find("0 and 5 among 1") != std::string::npos);
    CHECK(sentence_of([&] {
              hinge(scene, world, 0, {0, 0, 0}, {0, 0, 0});
          }).find("axis without direction") != std::string::npos);
    SpaceExact method = exact_method(Stabilizer::projection);
    StepData<6> now;
    const VecX before = scene.bodies.x;
    CHECK(sentence_of([&] { step(scene, {}, method, now); }).find("no projection and no relaxation") !=
          std::string::npos);
    CHECK(scene.bodies.x == before);
    scene.joints.push_back(hinge(scene, world, 0, {0, 0, 0}, {0, 1, 0}));
    scene.joints[0].lo[twist] = 1, scene.joints[0].hi[twist] = 0;
    method = exact_method();
    CHECK(sentence_of([&] { step(scene, {}, method, now); }).find("limits 1 and 0") != std::string::npos);
}

TEST_CASE("a joint whose point or frame is not finite and limits without a value are refused", "[house]")
{
    const auto with = [](const auto& change) {
        JointedSolids scene = rod_chain(2);
        change(scene.joints[1]);
        SpaceExact method = exact_method();
        StepData<6> now;
        const VecX before = scene.bodies.x;
        const std::string said = sentence_of([&] { step(scene, {}, method, now); });
        CHECK(scene.bodies.x == before);
        return said;
    };
    for (auto vector : {&SpaceJoint::at_a, &SpaceJoint::at_b, &SpaceJoint::frame_a, &SpaceJoint::frame_b})
        for (Index d = 0; d < 3; ++d)
            for (const Real value : {std::nan(""), infinity, -infinity})
                CHECK(with([&](SpaceJoint& joint) { (joint.*vector)[d] = value; }) ==
                      "joint 1 has a point or a frame that is not finite");
    // a free coordinate that is given the same infinity twice is not locked there
    CHECK(with([](SpaceJoint& joint) {
              joint.lo[cone] = joint.hi[cone] = infinity;
          }).find("a finite value must lie between them") != std::string::npos);
    CHECK(with([](SpaceJoint& joint) {
              joint.lo[cone] = joint.hi[cone] = -infinity;
          }).find("a finite value must lie between them") != std::string::npos);
}

TEST_CASE("limits that a coordinate cannot reach are refused and its ends are not", "[house]")
{
    const auto with = [](Coordinate c, Real lo, Real hi) {
        JointedSolids scene = rod_chain(1);
        const auto i = static_cast<std::size_t>(c);
        scene.joints[0].lo[i] = lo, scene.joints[0].hi[i] = hi;
        return sentence_of([&] { require_bodies(scene); });
    };
    // 4 rad of a twist are those of −2.28 rad
    CHECK(with(twist, -4, 1) ==
          "joint 0 has the limits -4 and 1 of coordinate 3; it lies between "
          "-3.141592653589793 and 3.141592653589793, and so must a limit that is finite");
    CHECK(with(swing_y, 3, 4).find("it lies between -2 and 2") != std::string::npos);
    CHECK(with(cone, -1, -0.5).find("it lies between 0 and 3.14") != std::string::npos);
    CHECK(with(pins, 2, infinity).find("it lies between -1 and 1") != std::string::npos);
    CHECK(with(twist, -pi, pi) == "accepted");
    CHECK(with(swing_z, -2, 2) == "accepted");
    CHECK(with(cone, 0, pi) == "accepted");
    CHECK(with(pins, -1, infinity) == "accepted");
    CHECK(with(along_x, -4, 1e6) == "accepted");
    JointedSolids scene = rod_chain(1);
    scene.joints[0].motor = -2;
    CHECK(sentence_of([&] { require_bodies(scene); }) ==
          "joint 0 has a motor on coordinate -2 of the force 0 and the speed 0");
    CHECK(sentence_of([] { rod_chain(0); }) == "a chain has 0 rods; it needs at least one");
    CHECK(sentence_of([] { plate_chain(-1, 0); }) == "a chain has -1 plates; it needs at least one");
}

TEST_CASE("a steady step in space asks for no memory", "[house]")
{
    JointedSolids scene = rod_chain(4);
    SpaceIslands method;
    StepData<6> now;
    for (int i = 0; i < 5; ++i) step(scene, {.h = 1.0 / 240}, method, now);
    const NoAllocation guard;
    for (int i = 0; i < 20; ++i) step(scene, {.h = 1.0 / 240}, method, now);
    CHECK(NoAllocation::violations() == 0);
}
