/// Chapter 14: a machine that walks, and a hand.

#include "chapters/14_joints/hand.hpp"
#include "chapters/14_joints/joint_method.hpp"
#include "chapters/14_joints/ragdoll.hpp"
#include "chapters/14_joints/walker.hpp"

#include "tests/catch.hpp"
#include "tests/joint_run.hpp"
#include "tests/sentence.hpp"

using namespace rigid;

TEST_CASE("a walker goes a step to the left for each turn of its crank and back", "[idea]")
{
    for (const Real speed : {5.0, -5.0}) {
        JointedScene scene;
        scene.walls.push_back({{0, 1}, 0});
        const Walker walker = add_walker(scene, 0, 0.01, {speed, 300, 0, 0, 0});
        cover(scene, {1, 0, 0, 0});
        ExactJoints<Manifolds> method;
        auto& touching = method.contacts;
        auto& filter = touching.finder.filter;
        filter.group.assign(static_cast<std::size_t>(scene.bodies.count()), 1);
        for (const Index foot : walker.feet) filter.group[static_cast<std::size_t>(foot)] = 0;
        filter.set_meets(0, 0, false), filter.set_meets(0, 1, false), filter.set_meets(1, 1, false);
        never_stop(touching);
        const Real turns = 2;
        const Real worst = run(scene, method, 1.0 / 240, std::lround(240 * turns * 2 * pi / 5));
        // arcs: a bar of 0.3 m that turns at 10 rad/s leaves (h ω)² r/2 = 0.3 mm in a step
        CHECK(worst <= 1e-3);
        CHECK(scene.bodies.x.allFinite());
        CHECK(std::abs(scene.bodies.x[3 * walker.chassis + 2]) < 0.5);  // it has not fallen over
        const Real way = scene.bodies.x[3 * walker.chassis] / turns;
        // three feet of a side bear in turn, each for less than half a metre; 1.3 m was measured
        CHECK(way * (speed > 0 ? -1 : 1) > 0.9);
        CHECK(way * (speed > 0 ? -1 : 1) < 1.5);
    }
}

TEST_CASE("a hand pulls all that hangs together with its bound and no more", "[idea]")
{
    JointedScene scene;
    const Index first = add_ragdoll(scene, {0, 0});
    CHECK(std::abs(held_mass(scene, first + 3) - 70) <= 1e-12);
    CHECK_THROWS_WITH(hand_joint(scene, world, {0, 0}),
                      "a hand holds body -1; it must be one of the 10 bodies, from 0 on");
    CHECK_THROWS_WITH(hand_joint(scene, 10, {0, 0}),
                      "a hand holds body 10; it must be one of the 10 bodies, from 0 on");
    const Vec2 wrist = scene.bodies.position(first + 3).head<2>();
    const std::size_t number = add_joint(scene, hand_joint(scene, first + 3, wrist));
    ExactJoints<AllBodies> method;
    StepData<3> now;
    for (int i = 0; i < 600; ++i) {
        move_hand(scene, number, wrist + Vec2(std::min(1.0, i / 60.0), 0.5));
        step(scene, {.h = 1.0 / 120}, method, now);
        REQUIRE(scene.bodies.x.allFinite());
        // no more than ten times the weight of 70 kg
        CHECK(reaction(scene, now, number).force.norm() <= 10 * 70 * 9.81 * (1 + 1e-9) * std::sqrt(2.0));
    }
    remove_last_joint(scene);
    CHECK(scene.placed.size() == 9);
    const Real y = scene.bodies.x[1];
    run(scene, method, 1.0 / 120, 60);
    CHECK(scene.bodies.x[1] < y - 0.5);  // it falls
    scene.placed.clear();
    CHECK(sentence_of([&] { remove_last_joint(scene); }) == "there is no joint that could be removed");
}
