/// Chapter 15: what joints must not change, and what must not break them.

#include "chapters/14_joints/bar_linkages.hpp"
#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/15_trees/tree_method.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"
#include "tests/joint_run.hpp"
#include "tests/sentence.hpp"

#include <functional>

using namespace rigid;

namespace {

using Trees = JointTrees<AllBodies>;

/// How a scene is placed: mirrored at the y axis, turned, in other units, with its bodies in another order.
struct Placing {
    Real angle = 0, length = 1, mass = 1;
    bool mirror = false, swap = false;

    Real sign() const { return mirror ? -1 : 1; }
    Vec2 direction(const Vec2& p) const
    {
        const Real c = std::cos(angle), s = std::sin(angle);
        return {c * sign() * p.x() - s * p.y(), s * sign() * p.x() + c * p.y()};
    }
    Vec2 place(const Vec2& p) const { return length * direction(p); }
    /// of a point or direction in a body's own axes: the body is its own mirror image after a flip of x
    Vec2 own(const Vec2& p) const { return {sign() * p.x(), p.y()}; }
    Index number(Index k, Index count) const { return k == world ? world : swap ? count - 1 - k : k; }
};

/// A machine of all that bears on invariance: pins, a rail, a weld, a gear, a loop, limits, motors, a spring, and a
/// floating pair of boxes besides.
JointedScene machine(const Placing& in)
{
    constexpr Index count = 7;
    JointedScene scene;
    scene.gravity = in.place({0, -9.81});
    const std::array<Vec2, count> at = {Vec2(0.5, 0.1),  Vec2(1.4, -0.2), Vec2(2.2, -0.9), Vec2(0.3, -1.2),
                                        Vec2(1.1, -1.6), Vec2(5, 0),      Vec2(6, 0.3)};
    const std::array<Real, count> turn = {0.3, -0.8, 0.2, 0, 0.5, 1, -1};
    for (Index i = 0; i < count; ++i) {
        const Index k = in.number(i, count);  // the body that is added now
        const auto n = static_cast<std::size_t>(k);
        const Index b = add_body(scene, box(0.8 * in.length, 0.2 * in.length),
                                 (2 + static_cast<Real>(k)) * in.mass / (in.length * in.length),
                                 in.place(at[n]), in.sign() * turn[n] + in.angle);
        scene.bodies.velocity(b) << in.place({0.3 * static_cast<Real>(k % 3), 0.2}),
            in.sign() * (static_cast<Real>(k) - 3) / 2;
    }
    const auto join = [&](JointKind kind, Index a, Index b, const Vec2& place, const Vec2& axis = {1, 0}) {
        RigidJoint joint = joint_at(scene, kind, in.number(a, count), in.number(b, count), in.place(place));
        joint.axis = a == world ? in.direction(axis) : in.own(axis);
        return joint;
    };
    const Real force = in.mass * in.length, torque = force * in.length;
    RigidJoint axle = join(JointKind::revolute, world, 0, {0, 0});
    axle.motor.speed = in.sign() * 2, axle.motor.force = 30 * torque;
    add_joint(scene, axle);
    RigidJoint elbow = join(JointKind::revolute, 0, 1, {1, 0});
    (in.mirror ? elbow.upper : elbow.lower) = -0.1 * in.sign();
    (in.mirror ? elbow.lower : elbow.upper) = 0.4 * in.sign();
    add_joint(scene, elbow);
    RigidJoint slide = join(JointKind::prismatic, 1, 2, {1.8, -0.5}, {0.6, 0.8});
    slide.spring = {0, 0, 200 * in.mass, 3 * in.mass, 0.05 * in.length};
    add_joint(scene, slide);
    add_joint(scene, join(JointKind::weld, 0, 3, {0.4, -0.5}));
    add_joint(scene, join(JointKind::revolute, 3, 4, {0.7, -1.4}));
    RigidJoint link = join(JointKind::distance, 4, 2, {1.5, -1.5});  // a loop
    link.at_b = in.length * in.own({0.2, 0.1});
    link.length =
        (point_of(scene.bodies.x, link.b, link.at_b) - point_of(scene.bodies.x, link.a, link.at_a)).norm();
    add_joint(scene, link);
    RigidJoint rope = join(JointKind::rope, 5, 6, {5.5, 0});
    rope.length = 0.01 * in.length;
    add_joint(scene, rope);
    return scene;
}

}  // namespace

TEST_CASE("turning and mirroring and other units and another order of bodies do the same to a machine",
          "[idea]")
{
    const auto moved = [](const Placing& in) {
        JointedScene scene = machine(in);
        scene.length = in.length * typical_length(machine({}));
        Trees method;
        method.correction.tolerance = 1e-12;
        run(scene, method, 1.0 / 240, 120);
        return scene.bodies.x;
    };
    const VecX plain = moved({});
    const Index count = plain.size() / 3;
    for (const Placing& in :
         {Placing{.angle = 1}, Placing{.mirror = true}, Placing{.swap = true},
          Placing{.angle = 2.5, .mirror = true, .swap = true}, Placing{.length = 8},
          Placing{.mass = 1.0 / 1024},
          Placing{.angle = -1, .length = 0.01, .mass = 1000, .mirror = true, .swap = true}}) {
        const VecX other = moved(in);
        CAPTURE(in.angle, in.length, in.mass, in.mirror, in.swap);
        for (Index k = 0; k < count; ++k) {
            const Index mine = in.number(k, count);
            // 120 steps of answers to 1e-9 grow by some powers of ten
            CHECK((other.segment<2>(3 * mine) - in.place(plain.segment<2>(3 * k))).norm() <=
                  1e-6 * in.length);
            CHECK(std::abs(other[3 * mine + 2] - in.sign() * plain[3 * k + 2] - in.angle) <= 1e-6);
        }
    }
}

TEST_CASE("hostile joints leave numbers finite and are never called solved where they cannot be met",
          "[house]")
{
    struct Case {
        const char* name;
        std::function<void(JointedScene&)> build;
        bool possible;
    };
    const auto two = [](JointedScene& scene) {
        add_body(scene, box(1, 1), 1.0, {0, 0});
        add_body(scene, box(1, 1), 1e3, {2, 0});
    };
    const Case cases[] = {
        {"the same pin three times",
         [&](JointedScene& scene) {
             two(scene);
             for (int i = 0; i < 3; ++i)
                 add_joint(scene, joint_at(scene, JointKind::revolute, world, 0, {0, 0.5}));
             add_joint(scene, joint_at(scene, JointKind::revolute, 0, 1, {1, 0}));
         },
         true},
        {"a frame of four welds",
         [&](JointedScene& scene) {
             two(scene);
             for (const Index k : {0, 1})
                 add_joint(scene, joint_at(scene, JointKind::weld, world, k, {k, 1}));
             for (int i = 0; i < 2; ++i) add_joint(scene, joint_at(scene, JointKind::weld, 0, 1, {1, 0}));
         },
         true},
        {"limits of two joints that cross",
         [&](JointedScene& scene) {
             two(scene);
             for (const Real side : {-1.0, 1.0}) {
                 RigidJoint rail = joint_at(scene, JointKind::prismatic, world, 0, {0, 0});
                 rail.axis = {0, 1};
                 (side > 0 ? rail.lower : rail.upper) = side * 0.5;
                 add_joint(scene, rail);
             }
         },
         true},  // no velocity has to be other than zero; it is the positions that have no answer
        {"welds to the world and to what moves",
         [&](JointedScene& scene) {
             two(scene);
             add_body(scene, box(1, 1), Mass{}, {-2, 0});
             scene.bodies.velocity(2)[0] = 0.5;
             add_joint(scene, joint_at(scene, JointKind::weld, world, 0, {0, 0}));
             add_joint(scene, joint_at(scene, JointKind::weld, 2, 0, {-1, 0}));
         },
         false},
        {"motors of no bound in practice that want different speeds",
         [&](JointedScene& scene) {
             two(scene);
             for (const Real speed : {1.0, -1.0}) {
                 RigidJoint axle = joint_at(scene, JointKind::revolute, world, 0, {0, 0});
                 axle.motor.speed = speed, axle.motor.force = 1e9;
                 add_joint(scene, axle);
             }
         },
         true},
        {"a link of no length between two points that are one",
         [&](JointedScene& scene) {
             two(scene);
             RigidJoint link = joint_at(scene, JointKind::distance, 0, 1, {1, 0});
             add_joint(scene, link);
             scene.gravity = {0, 0};
         },
         true},
        {"a rope of no length that is pulled apart",
         [&](JointedScene& scene) {
             two(scene);
             RigidJoint rope = joint_at(scene, JointKind::rope, 0, 1, {1, 0});
             add_joint(scene, rope);
             scene.gravity = {0, 0};
             scene.bodies.velocity(1)[0] = 3;
         },
         true},
        {"gears in a triangle that cannot turn",
         [&](JointedScene& scene) {
             two(scene);
             add_body(scene, disc(1), 1.0, {1, 2});
             for (Index k = 0; k < 3; ++k) {
                 const Vec2 middle = scene.bodies.position(k).head<2>();
                 RigidJoint axle = joint_at(scene, JointKind::revolute, world, k, middle);
                 axle.motor.speed = 5, axle.motor.force = 2;
                 add_joint(scene, axle);
                 RigidJoint gear;
                 gear.kind = JointKind::gear;
                 gear.a = std::min(k, (k + 1) % 3), gear.b = std::max(k, (k + 1) % 3);
                 add_joint(scene, gear);
             }
         },
         true},
    };
    for (const Case& one : cases) {
        JointedScene scene;
        one.build(scene);
        Trees method;
        StepData<3> now;
        bool solved = true;
        for (int i = 0; i < 600; ++i) {
            step(scene, {}, method, now);
            INFO(one.name << ", step " << i);
            REQUIRE(scene.bodies.x.allFinite());
            REQUIRE(scene.bodies.u.allFinite());
            REQUIRE(scene.bodies.u.norm() <= 150);  // what floats falls for ten seconds
            solved = solved && now.solution.status == Status::solved;
        }
        INFO(one.name);
        CHECK(solved == one.possible);
    }
}

TEST_CASE("links that do not fit keep their misfit and throw nothing", "[house]")
{
    for (const Real longer : {1e-4, 1e-3, 0.01, 0.1}) {
        CAPTURE(longer);
        JointedScene scene;
        const Index platform = add_body(scene, box(2, 0.1), 100, {0.5, -std::sqrt(0.75)});
        for (const int place : {-1, 0, 1}) {
            RigidJoint link;
            link.kind = JointKind::distance;
            link.b = platform;
            link.at_a = link.at_b = {place * 1.0, 0};
            link.length = place == 0 ? 1 + longer : 1;
            add_joint(scene, link);
        }
        Trees method;
        StepData<3> now;
        const Real start = energy(scene);
        for (int n = 0; n < 120; ++n) {
            step(scene, {}, method, now);
            // one link has all of the error or two have it with opposite signs, and the platform is locked there
            CHECK(method.correction.left <= 2.1 * longer);
            // a hundredth of what lifts it by the length of a link: a swing in steps of 1/60 s gains a thousandth
            CHECK(energy(scene) - start <= 0.01 * 20 * 9.81);
        }
    }
}
