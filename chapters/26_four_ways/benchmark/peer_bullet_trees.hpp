/// \file peer_bullet_trees.hpp
/// A scene of the ways in Bullet's coordinates of joints, btMultiBody, without damping.
#pragma once

#include "chapters/26_four_ways/benchmark/peer_bodies.hpp"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyConstraintSolver.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

namespace rigid {

/// Trees of revolute joints from the world, without contacts.
class BulletTreeWays {
public:
    static constexpr const char* name = "Bullet's trees";

    explicit BulletTreeWays(const WayScene& way)
        : tree_(way.scene), links_(links_of(way.scene)),
          dispatcher_(&configuration_),
          world_(&dispatcher_, &pairs_, &solver_, &configuration_),
          body_(static_cast<int>(links_.size()), 0, btVector3(0, 0, 0), true, false)
    {
        const JointedScene& scene = way.scene;
        world_.setGravity(btVector3(scene.gravity.x(), scene.gravity.y(), 0));
        const VecX q = tree_.coordinates(scene.bodies.x);
        for (std::size_t i = 0; i < links_.size(); ++i) {
            const RigidJoint& joint = links_[i].joint;
            const Real I = inertia_of_body(scene, joint.b);
            body_.setupRevolute(
                static_cast<int>(i), mass_of_body(scene, joint.b),
                btVector3(I, I, I), links_[i].parent,
                btQuaternion(btVector3(0, 0, 1), -joint.angle), btVector3(0, 0, 1),
                btVector3(joint.at_a.x(), joint.at_a.y(), 0),
                btVector3(-joint.at_b.x(), -joint.at_b.y(), 0), true);
        }
        body_.finalizeMultiDof();
        body_.setLinearDamping(0);
        body_.setAngularDamping(0);
        for (std::size_t i = 0; i < links_.size(); ++i)
            body_.setJointPos(static_cast<int>(i), q[static_cast<Index>(i)]);
        world_.addMultiBody(&body_);
    }
    ~BulletTreeWays() { world_.removeMultiBody(&body_); }
    BulletTreeWays(const BulletTreeWays&) = delete;
    BulletTreeWays& operator=(const BulletTreeWays&) = delete;

    static bool can_take(const WayScene& way) { return is_tree_of_pins(way); }
    void step(Real h) { world_.stepSimulation(h, 0); }
    void read(JointedScene& scene)
    {
        VecX q(static_cast<Index>(links_.size())), dq = q;
        for (std::size_t i = 0; i < links_.size(); ++i) {
            q[static_cast<Index>(i)] = body_.getJointPos(static_cast<int>(i));
            dq[static_cast<Index>(i)] = body_.getJointVel(static_cast<int>(i));
        }
        tree_.place(q, scene.bodies.x);
        tree_.move(dq, scene.bodies.x, scene.bodies.u);
    }

private:
    ReducedTree tree_;
    std::vector<ReducedLink> links_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase pairs_;
    btMultiBodyConstraintSolver solver_;
    btMultiBodyDynamicsWorld world_;
    btMultiBody body_;
};

}  // namespace rigid
