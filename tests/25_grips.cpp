/// Chapter 25: what grips, and loops of more rows than they need.

#include "chapters/11_rotation/mechanisms.hpp"
#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"
#include "chapters/25_world_in_space/space_method.hpp"

#include "tests/catch.hpp"
#include "tests/sentence.hpp"
#include "tests/solids.hpp"

using namespace rigid;

namespace {

struct Gripper {
    Hull thing;
    Real half = 0;  ///< from its middle to a pad [m]
    Real mass = 0, pad_mass = 0;
    Vec3 pad = {0, 0, 0};  ///< edges [m]
    Real force = 0, mu = 0, length = 0;
};

/// Two pads on rails, each with a motor that presses it against a thing between them. Body 0 is the thing.
SpaceScene scene_of(const Gripper& grip)
{
    SpaceScene scene;
    scene.length = grip.length;
    const auto add = [&](const Hull& hull, Real mass, const Vec3& at) {
        SolidMass solid = mass_of({hull}, 1);
        solid.inertia *= mass / solid.mass, solid.mass = mass;
        return add_body(scene, {hull}, solid, at);
    };
    add(grip.thing, grip.mass, {0, 0, 0});
    for (const Real side : {-1.0, 1.0}) {
        const Vec3 at(side * (grip.half + grip.pad.x() / 2), 0, 0);
        const Index pad = add(solid_box(grip.pad), grip.pad_mass, at);
        SpaceJoint rail = slider(scene, world, pad, at, {1, 0, 0});
        rail.motor = along_x, rail.speed = -side * 10, rail.force = grip.force;
        scene.joints.push_back(rail);
    }
    scene.friction.assign(3, grip.mu);
    return scene;
}

/// A box of 45 g between pads of 12 N: two of 0.32 N would do.
Gripper small_box()
{
    return {solid_box({0.008, 0.008, 0.038}), 0.004, 0.045, 0.18, {0.01, 0.03, 0.06}, 12, 0.7, 0.01};
}

/// Boxes of 3 mm to 1 m, of a tenth to ten times the density of water, with forces of ten to 300 times what is needed.
Gripper any_grip(Random& random)
{
    Gripper grip;
    const auto power = [&](Real low, Real high) { return std::pow(10, random.uniform(low, high)); };
    grip.length = power(-2.5, 0);
    grip.mass = 1000 * std::pow(grip.length, 3) * power(-1, 1);
    Vec3 edges;
    for (Index d = 0; d < 3; ++d) edges[d] = grip.length * random.uniform(0.3, 1.5);
    grip.thing = solid_box(edges), grip.half = edges.x() / 2;
    grip.mu = random.uniform(0.2, 1.2);
    grip.force = grip.mass * 9.81 / 2 / grip.mu * power(1, 2.5);
    grip.pad_mass = grip.mass * power(-1, 1);
    for (Index d = 0; d < 3; ++d) grip.pad[d] = grip.length * random.uniform(0.5, 1.5);
    return grip;
}

/// Rods of 10 kg a metre in the plane z = 0, end to end between two points of the world, on hinges along z.
struct Loop {
    std::vector<Vec2> points;
    Real length(std::size_t i) const { return (points[i + 1] - points[i]).norm(); }
    Real angle(std::size_t i) const
    {
        const Vec2 way = points[i + 1] - points[i];
        return rigid::atan2(way.y(), way.x());
    }
    Vec2 middle(std::size_t i) const { return (points[i] + points[i + 1]) / 2; }
    std::size_t rods() const { return points.size() - 1; }
};

Loop leaning_loop(int rods)
{
    Loop loop;
    for (int i = 0; i <= rods; ++i) {
        const Real t = pi * i / rods, lean = i > 0 && i < rods ? 0.15 * rods : 0;
        loop.points.push_back(0.25 * rods * Vec2(-rigid::cos(t), -rigid::sin(t)) + Vec2(lean, 0.1 * lean));
    }
    return loop;
}

/// \param R  turns all of it
SpaceScene in_space(const Loop& loop, const Mat3& R = Mat3::Identity(), const Vec3& theta = {0, 0, 0})
{
    SpaceScene scene;
    scene.length = 1;
    const auto at = [&](const Vec2& p) -> Vec3 { return R * Vec3(p.x(), p.y(), 0); };
    for (std::size_t i = 0; i < loop.rods(); ++i) {
        const Real l = loop.length(i);
        SolidMass mass;
        mass.mass = 10 * l;
        mass.inertia = mass.mass * l * l / 12 * Mat3::Identity();
        const Index rod = add_body(scene, {solid_box({l, 0.01, 0.01})}, mass, at(loop.middle(i)),
                                   add_rotation(theta, {0, 0, loop.angle(i)}));
        scene.joints.push_back(hinge(scene, i == 0 ? world : rod - 1, rod, at(loop.points[i]), R.col(2)));
    }
    scene.joints.push_back(
        hinge(scene, world, static_cast<Index>(loop.rods()) - 1, at(loop.points.back()), R.col(2)));
    return scene;
}

/// The same with pins, in the plane.
RigidScene in_plane(const Loop& loop)
{
    RigidScene scene;
    for (std::size_t i = 0; i < loop.rods(); ++i) {
        const Real l = loop.length(i);
        const Index rod = add_body(scene, box(l, 0.01), Real{1000}, loop.middle(i));
        scene.bodies.x[3 * rod + 2] = loop.angle(i);
        scene.bodies.inverse_mass[3 * rod + 2] = 12 / (10 * l * l * l);
    }
    const auto seen = [&](Index k, const Vec2& p, bool as_way) -> Vec2 {
        if (k == world) return p;
        const Vec3 x = scene.bodies.x.segment<3>(3 * k);
        const Vec2 r = as_way ? p : Vec2(p - x.head<2>());
        return {rigid::cos(x[2]) * r.x() + rigid::sin(x[2]) * r.y(),
                rigid::cos(x[2]) * r.y() - rigid::sin(x[2]) * r.x()};
    };
    const auto pin = [&](Index a, Index b, const Vec2& p) {
        // rows that turn with body a, as those of a joint in space do
        for (const Vec2& n : {Vec2(1, 0), Vec2(0, 1)}) {
            PointJoint half;
            half.measure = PointJoint::Measure::turning;
            half.a = a, half.b = b;
            half.at_a = seen(a, p, false), half.at_b = seen(b, p, false);
            half.direction = seen(a, n, true);
            scene.joints.push_back(half);
        }
    };
    for (std::size_t i = 0; i < loop.rods(); ++i) {
        const auto rod = static_cast<Index>(i);
        pin(i == 0 ? world : rod - 1, rod, loop.points[i]);
    }
    pin(world, static_cast<Index>(loop.rods()) - 1, loop.points.back());
    return scene;
}

/// Bricard's mechanism: five rods of 1 m and 1 kg along edges of a cube, six hinges, each across both of its rods. It
/// has thirty rows for thirty coordinates, and it moves.
SpaceScene bricard()
{
    SpaceScene scene;
    scene.length = 1;
    const std::array<Vec3, 6> points = {
        {{0, 0, 0}, {1, 0, 0}, {1, -1, 0}, {1, -1, 1}, {0, -1, 1}, {0, 0, 1}}};
    for (std::size_t i = 0; i < 5; ++i) {
        SolidMass mass;
        mass.mass = 1;
        mass.inertia = Vec3(1e-3, 1.0 / 12, 1.0 / 12).asDiagonal();
        const Index rod = add_body(scene, {solid_box({0.9, 0.02, 0.02})}, mass,
                                   (points[i] + points[i + 1]) / 2, frame_along(points[i + 1] - points[i]));
        scene.joints.push_back(hinge(scene, i == 0 ? world : rod - 1, rod, points[i],
                                     Vec3::Unit((static_cast<Index>(i) + 1) % 3)));
    }
    scene.joints.push_back(hinge(scene, world, 4, points[5], {1, 0, 0}));
    return scene;
}

}  // namespace

TEST_CASE("two pads hold a small box for ten seconds", "[ch18][grip][idea]")
{
    for (const bool exact : {false, true}) {
        SpaceScene scene = scene_of(small_box());
        TouchingCones method = exact ? exact_cones() : TouchingCones{};
        StepData<6> now;
        Real worst = 0;
        int unsolved = 0;
        for (int n = 0; n < 600; ++n) {
            step(scene, {.h = sixtieth}, method, now);
            unsolved += method.solver.unsolved;
            if (n >= 30) worst = std::max(worst, scene.bodies.u.cwiseAbs().maxCoeff());
        }
        CHECK(scene.bodies.x.head<3>().norm() < 1e-6);
        CHECK(std::abs(scene.bodies.x[6] + 0.009) < 1e-6);
        // the tolerance, over half an edge where it is an angle
        CHECK(worst < 1e-6 * scene.length / 0.004);
        CHECK(unsolved <= 10);  // six: from nothing to 12 N in fifty sweeps a step
    }
}

TEST_CASE("a capsule as long as its pads does not pivot between them", "[ch18][grip][idea]")
{
    for (const bool upright : {false, true}) {
        Gripper grip = small_box();
        grip.thing = solid_capsule(0.06, 0.004);
        for (Vec3& p : grip.thing.vertices)
            p = upright ? Vec3(p.y(), p.x(), p.z()) : Vec3(p.y(), p.z(), p.x());
        grip.pad = {0.01, 0.06, 0.06};
        SpaceScene scene = scene_of(grip);
        TouchingCones method = exact_cones();
        StepData<6> now;
        for (int n = 0; n < 120; ++n) {
            step(scene, {.h = sixtieth}, method, now);
            CHECK(method.solver.unsolved == 0);
            // the tolerance, over the radius where it is an angle
            CHECK(scene.bodies.u.cwiseAbs().maxCoeff() < 1e-9 * scene.length / 0.004);
        }
    }
}

TEST_CASE("grips of any size and mass and force hold what they hold", "[ch18][grip][idea]")
{
    Random random(18);
    int unsolved = 0;
    for (int i = 0; i < 300; ++i) {
        const Gripper grip = any_grip(random);
        const Real h = std::pow(10, random.uniform(-2.7, -1.5));
        for (const bool exact : {false, true}) {
            SpaceScene scene = scene_of(grip);
            const Real pad = scene.bodies.x[6];
            TouchingCones method = exact ? exact_cones() : TouchingCones{};
            StepData<6> now;
            for (int n = 0; n < 60; ++n) {
                step(scene, {.h = h}, method, now);
                unsolved += method.solver.unsolved;
                // what is not solved is said
                CHECK((method.solver.unsolved == 0) ==
                      (now.solution.residual <= method.solver.sweeps.tolerance * now.length));
            }
            INFO("grip " << i << (exact ? " exact" : " swept"));
            // a hundredth of it
            CHECK(scene.bodies.x.head<3>().norm() < 0.01 * grip.length);
            CHECK(std::abs(scene.bodies.x[6] - pad) < 0.01 * grip.length);
        }
    }
    CHECK(unsolved > 0);
}

TEST_CASE("sweeps that may go on fewer times than once and a negative margin are refused",
          "[ch18][grip][house]")
{
    ConeSolver solver;
    solver.patience.times = 0;
    CHECK(sentence_of([&] { solver.require_valid(); }) ==
          "sweeps may go on to 0 times as many, beyond a margin of 0.05; these must be 1 or more, and zero "
          "or positive");
}

TEST_CASE("a loop of rods on hinges in space moves as on pins in the plane", "[ch18][loop][idea]")
{
    // Each hinge has five rows where a pin has two: three of each loop are too many.
    for (const int rods : {3, 4}) {
        const Real h = 1.0 / 240;
        const Loop loop = leaning_loop(rods);
        RigidScene plane = in_plane(loop);
        SpaceScene space = in_space(loop);
        RigidExact flat;
        flat.correction.method = Stabilizer::baumgarte;
        TouchingCones solid = exact_cones();
        static_cast<Correction&>(solid.correction) = flat.correction;
        StepData<3> flat_now;
        StepData<6> solid_now;
        Real moved = 0;
        for (int i = 0; i < 480; ++i) {
            step(plane, {.h = h}, flat, flat_now);
            step(space, {.h = h}, solid, solid_now);
            CHECK(solid.solver.unsolved == 0);
            moved = std::max(moved, (space.bodies.x.head<2>() - Vec2(loop.middle(0))).norm());
            // 1e-9 m/s in each of 480 steps, and what a swing makes of it
            for (Index k = 0; k < rods; ++k) {
                CHECK((space.bodies.x.segment<2>(6 * k) - plane.bodies.x.segment<2>(3 * k)).norm() < 1e-6);
                CHECK(std::abs(space.bodies.x[6 * k + 2]) < 1e-6);
            }
        }
        CHECK(moved > 0.2);
    }
}

TEST_CASE("a loop that lies in any plane gains no energy and what is not solved is said",
          "[ch18][loop][idea]")
{
    const Vec3 theta(0.5, 0.7, 0.3);
    for (const int rods : {3, 4, 5})
        for (const bool exact : {false, true}) {
            SpaceScene scene = in_space(leaning_loop(rods), rotation_matrix(theta), theta);
            TouchingCones method = exact ? exact_cones() : TouchingCones{};
            StepData<6> now;
            const Real before = energy(scene);
            Real most = -infinity;
            for (int n = 0; n < 300; ++n) {
                step(scene, {.h = sixtieth}, method, now);
                most = std::max(most, energy(scene) - before);
                if (exact) CHECK(method.solver.unsolved == 0);
                CHECK((method.solver.unsolved == 0) ==
                      (now.solution.residual <= method.solver.sweeps.tolerance * now.length));
            }
            CHECK(most < 0);
            CHECK(energy(scene) < before - 1);  // it moved
            if (exact) CHECK(largest_joint_error(scene) < 0.02);
        }
}

TEST_CASE("Bricard's mechanism gains no energy and is not called solved where it is held",
          "[ch18][loop][idea]")
{
    for (const bool exact : {false, true}) {
        SpaceScene scene = bricard();
        TouchingCones method = exact ? exact_cones() : TouchingCones{};
        StepData<6> now;
        const Real before = energy(scene);
        Real most = -infinity, far = 0;
        int held = 0;
        for (int n = 0; n < 300; ++n) {
            step(scene, {.h = sixtieth}, method, now);
            most = std::max(most, energy(scene) - before);
            far = std::max(far, std::abs(scene.bodies.x[12] - 1));
            // a swing takes 2.4 s to the other side: what is not on its way within the first of them is held
            if (n > 15 && n < 60 && scene.bodies.u.cwiseAbs().maxCoeff() < 0.1)
                held += method.solver.unsolved == 0;
        }
        CHECK(most < 1e-3);
        CHECK(held == 0);
        if (!exact) CHECK(far > 1.9);
    }
}
