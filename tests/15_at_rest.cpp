/// Chapter 15: bodies on joints that rest sleep, and what wakes them.

#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/14_joints/ragdoll.hpp"
#include "chapters/15_trees/tree_method.hpp"

#include "tests/catch.hpp"
#include "tests/joint_run.hpp"
#include "tests/sleeping_room.hpp"

#include <cmath>
#include <functional>

using namespace rigid;

namespace {

using DollRoom = Room<SkippingJoints>;

/// Dolls above a floor, or stairs, that do not collide with themselves.
DollRoom room_of_dolls(int dolls, int stairs, Real apart)
{
    DollRoom room;
    if (stairs > 0) add_stairs(room.scene, stairs);
    else room.scene.walls.push_back({{0, 1}, 0});
    std::vector<std::pair<Index, Index>> pairs;
    for (int i = 0; i < dolls; ++i) {
        const Vec2 at =
            stairs > 0 ? Vec2(-0.1 + 0.15 * (i % 3), 0.3 * stairs + 1.1 + 1.8 * i) : Vec2(apart * i, 1.1);
        const Index first = add_ragdoll(room.scene, at);
        // it is pushed, or it would stand on its feet until rounding topples it
        for (Index k = first; k < first + 10; ++k) room.scene.bodies.velocity(k)[0] = 0.8;
        forbid_itself(first, [&pairs](Index a, Index b) { pairs.push_back({a, b}); });
    }
    cover(room.scene, {0.6, 0, 0, 0});
    auto& touching = room.method.contacts.touching;
    touching.finder.filter = forbid_pairs(room.scene.bodies.count(), pairs);
    never_stop(touching);
    return room;
}

}  // namespace

TEST_CASE("dolls that lie still sleep and a motor that changes wakes its own doll alone", "[idea]")
{
    DollRoom room = room_of_dolls(2, 0, 6);
    const int took = room.until_asleep(1200);
    INFO("asleep after " << took << " steps");
    REQUIRE(room.all_asleep());
    CHECK(room.worst <= 0.01 * 0.22);  // 1 % of the shortest limb
    const VecX x = room.scene.bodies.x;
    room.run(60);
    CHECK((room.scene.bodies.x == x));
    CHECK(room.scene.bodies.u.isZero(0));
    CHECK(room.now.visits == 0);
    // the neck of the first doll: it now nods
    RigidJoint neck = room.scene.placed[0].joint;
    neck.motor.speed = 2, neck.motor.force = 50;
    change_joint(room.scene, 0, neck);
    room.run(1);
    CHECK(!room.asleep(0));
    CHECK(!room.asleep(9));
    CHECK(room.asleep(10));
    room.run(30);
    CHECK(room.asleep(10));
    CHECK((room.scene.bodies.x.tail(30) == x.tail(30)));
    CHECK((room.scene.bodies.x.head(30) - x.head(30)).cwiseAbs().maxCoeff() > 0.01);
}

TEST_CASE("dolls on stairs come to rest and sleep with all their limbs", "[idea]")
{
    DollRoom room = room_of_dolls(3, 5, 0);
    const int took = room.until_asleep(2400);
    INFO("asleep after " << took << " steps");
    CHECK(room.all_asleep());
    CHECK(room.worst <= 0.01 * 0.22);
}

TEST_CASE("what is pushed out of an overlap ends inside the slop and sleeps no sooner", "[idea]")
{
    for (const Real h : {1.0 / 60, 1.0 / 10}) {
        DollRoom room;
        room.scene.length = 1;
        room.scene.walls.push_back({{0, 1}, 0});
        for (int i = 0; i < 3; ++i) add_body(room.scene, box(1, 1), 1, {0, 0.4 + 0.9 * i});
        cover(room.scene, {0.6, 0, 0, 0});
        int steps = 0;
        do step(room.scene, {.h = h}, room.method, room.now);
        while (!room.all_asleep() && ++steps < 100);
        CHECK(steps < 100);
        Real below = 0;
        for (Index k = 0; k < 3; ++k) {
            const Real y = room.scene.bodies.position(k)[1] - 0.5, gap = y - below;
            INFO("step " << h << ", box " << k << ", gap " << gap);
            // strictly: no margin. In steps of 1/10 s half a second, the time of rest, leaves a quarter of the overlap
            CHECK(gap > -0.005);
            CHECK(gap < 0);  // and what is inside is left alone
            below = y + 1;
        }
    }
}

TEST_CASE("bodies on joints that sleep stay where they are when all are woken and may not sleep", "[house]")
{
    DollRoom room = room_of_dolls(2, 0, 6);
    room.until_asleep(1200);
    REQUIRE(room.all_asleep());
    DollRoom woken = room;
    woken.method.contacts.sleep = false;
    woken.run(30);
    // half a second: what rest allows is v_rest in all of it
    CHECK((woken.scene.bodies.x - room.scene.bodies.x).cwiseAbs().maxCoeff() <= 1e-3 * 0.5);
}
