/// Chapter 15: a hand that pulls at a tree.

#include "chapters/14_joints/hand.hpp"
#include "chapters/14_joints/ragdoll.hpp"
#include "chapters/15_trees/tree_method.hpp"

#include "tests/catch.hpp"
#include "tests/joint_run.hpp"

using namespace rigid;

TEST_CASE("a hand carries what hangs together and lets the joints be", "[idea]")
{
    JointedScene scene;
    const Index first = add_ragdoll(scene, {0, 0});
    const Vec2 wrist = scene.bodies.position(first + 3).head<2>();
    const std::size_t number = add_joint(scene, hand_joint(scene, first + 3, wrist));
    JointTrees<AllBodies> method;
    StepData<3> now;
    for (int i = 0; i < 600; ++i) {
        move_hand(scene, number, wrist + Vec2(std::min(1.0, i / 60.0), 0.5));
        step(scene, {.h = 1.0 / 120}, method, now);
        REQUIRE(scene.bodies.x.allFinite());
        CHECK(largest_joint_error(scene) <= 1e-6);
    }
}
