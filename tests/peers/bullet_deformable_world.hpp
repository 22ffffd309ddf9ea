/// \file bullet_deformable_world.hpp
/// Bullet's world of deformable bodies, which steps by implicit Euler, with one body in it.
#pragma once

#ifdef RIGID_HAS_BULLET

#include "common/math.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableLagrangianForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

namespace rigid {

inline btVector3 bullet_vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }

class BulletDeformableWorld {
public:
    BulletDeformableWorld(const BulletDeformableWorld&) = delete;
    BulletDeformableWorld& operator=(const BulletDeformableWorld&) = delete;

    void step(Real h) { world_.stepSimulation(h, 0); }

protected:
    /// \param newton  iterations a step at most; 1 is Bullet's own number
    BulletDeformableWorld(const Vec3& gravity, int newton)
        : dispatcher_(&configuration_),
          world_(&dispatcher_, &broadphase_, &constraints_, &configuration_, &solver_),
          gravity_(bullet_vector(gravity))
    {
        constraints_.setDeformableSolver(&solver_);
        solver_.set(newton, 1e-9);
        world_.setImplicit(true);
        world_.setLineSearch(false);
        world_.setUseProjection(true);  // without it what is pinned holds all else
        world_.setGravity(gravity_);
        world_.getWorldInfo().m_gravity = gravity_;
    }
    ~BulletDeformableWorld()
    {
        if (body_) world_.removeSoftBody(body_.get());
        for (const auto& ball : balls_) world_.removeRigidBody(ball.get());
    }

    /// The body, of nodes alone; a mass of zero is pinned.
    btSoftBody& begin(const std::vector<btVector3>& x, const std::vector<btScalar>& mass)
    {
        body_ = std::make_unique<btSoftBody>(&world_.getWorldInfo(), static_cast<int>(x.size()), x.data(),
                                             mass.data());
        body_->m_cfg.collisions = 0;
        body_->setActivationState(DISABLE_DEACTIVATION);
        return *body_;
    }
    /// What acts on it besides its weight. It has its links or tetrahedra by now.
    void put_in(std::unique_ptr<btDeformableLagrangianForce> force)
    {
        world_.addSoftBody(body_.get());
        force_ = std::move(force);
        weight_ = std::make_unique<btDeformableGravityForce>(gravity_);
        world_.addForce(body_.get(), weight_.get());
        world_.addForce(body_.get(), force_.get());
    }
    /// A ball that cannot move, for the nodes of the body to touch: its distances are kept in cells of a tenth of its radius.
    void add_ball(const Vec3& at, Real radius, Real friction, Real margin)
    {
        shapes_.push_back(std::make_unique<btSphereShape>(radius));
        btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shapes_.back().get());
        info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), bullet_vector(at));
        info.m_friction = friction;
        balls_.push_back(std::make_unique<btRigidBody>(info));
        world_.addRigidBody(balls_.back().get());
        body_->getCollisionShape()->setMargin(margin);
        body_->m_cfg.kDF = friction;
        body_->m_cfg.collisions = btSoftBody::fCollision::SDF_RD | btSoftBody::fCollision::SDF_RDN |
                                  btSoftBody::fCollision::SDF_RDF;
    }
    const btSoftBody::Node& node(int k) const { return body_->m_nodes[k]; }

private:
    struct Solver : btDeformableBodySolver {
        void set(int most, btScalar tolerance)
        {
            m_maxNewtonIterations = most, m_newtonTolerance = tolerance;
        }
    };
    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase broadphase_;
    Solver solver_;
    btDeformableMultiBodyConstraintSolver constraints_;
    btDeformableMultiBodyDynamicsWorld world_;
    btVector3 gravity_;
    std::vector<std::unique_ptr<btSphereShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> balls_;
    std::unique_ptr<btSoftBody> body_;
    std::unique_ptr<btDeformableLagrangianForce> force_;
    std::unique_ptr<btDeformableGravityForce> weight_;
};

}  // namespace rigid

#endif
