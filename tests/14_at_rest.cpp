/// Chapter 14: bodies on joints that rest sleep, and what wakes them.

#include "chapters/14_joints/joint_method.hpp"
#include "chapters/14_joints/placed_joints.hpp"

#include "tests/catch.hpp"
#include "tests/joint_run.hpp"
#include "tests/sleeping_room.hpp"

#include <cmath>

using namespace rigid;

namespace {

/// Two boxes on a floor, 3 m apart, on a rope of 6 m. Exactly, a rope leaves its sleeper where it is; sweeps have a
/// tolerance below which what hangs is at rest.
Room<ExactJoints<AwakeManifolds>> room_of_a_slack_rope()
{
    Room<ExactJoints<AwakeManifolds>> room;
    room.scene.walls.push_back({{0, 1}, 0});
    add_body(room.scene, box(1, 1), 1, {0, 0.5});
    add_body(room.scene, box(1, 1), 1, {3, 0.5});
    RigidJoint rope;
    rope.kind = JointKind::rope;
    rope.a = 0, rope.b = 1;
    rope.length = 6;
    add_joint(room.scene, rope);
    cover(room.scene, {0.3, 0, 0, 0});
    return room;
}

}  // namespace

TEST_CASE("what hangs at rest sleeps and falls when its joint breaks or is gone", "[idea]")
{
    for (const bool breaks : {true, false}) {
        Room<JointSweeps<AwakeManifolds>> room;
        add_body(room.scene, box(1, 1), 1, {0, 0});
        add_joint(room.scene, joint_at(room.scene, JointKind::revolute, world, 0, {0, 0.5}));
        cover(room.scene, {0.6, 0, 0, 0});
        room.until_asleep(300);
        REQUIRE(room.asleep(0));
        if (breaks) room.scene.placed[0].broken = true;
        else {
            room.scene.placed.clear();
            room.scene.joints.clear();
            room.scene.owner.clear();
        }
        room.run(60);
        CHECK(!room.asleep(0));
        CHECK(room.scene.bodies.x[1] < -4.8);  // half of g after a second
    }
}

TEST_CASE("a rope that was slack wakes the sleeper that it pulls at", "[idea]")
{
    auto room = room_of_a_slack_rope();
    room.until_asleep(300);
    REQUIRE(room.all_asleep());
    room.scene.bodies.velocity(1)[0] = 10;
    room.run(1);
    CHECK(!room.asleep(1));
    CHECK((room.asleep(0) || room.scene.bodies.x[3] > 3));  // the rope's bodies may wake with it
    room.run(120);
    CHECK(room.scene.bodies.x[0] > 0.05);  // it was pulled along
    CHECK((room.scene.bodies.position(1) - room.scene.bodies.position(0)).head<2>().norm() <= 6.05);
}

TEST_CASE("a rope wakes the sleeper at its end when what slides at the other end has tightened it", "[idea]")
{
    auto room = room_of_a_slack_rope();
    room.scene.surfaces[1].friction = 0;  // this one slides on, and is never at rest
    room.scene.bodies.velocity(1)[0] = 1;
    room.run(150);
    REQUIRE(room.asleep(0));
    REQUIRE(!room.asleep(1));
    REQUIRE(std::abs(room.scene.bodies.x[0]) < 1e-9);
    room.run(
        60);  // the rope is tight after 3 s: both go on at half the speed, and the first is braked by 0.3 g
    CHECK(room.scene.bodies.x[0] > 0.5 * 0.5 * 0.5 / (2 * 0.3 * 9.81) / 2);
    CHECK(room.worst <= 0.03);  // the step in which it tightens: 1 m/s · h, and what is left of it
}
