/// \file bullet_deformable.hpp
/// A body of tetrahedra in Bullet's world of deformable bodies, which steps by implicit Euler.
#pragma once

#ifdef RIGID_HAS_BULLET

#include "chapters/30_elastic_bodies/elastic_solver.hpp"

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableGravityForce.h>
#include <BulletSoftBody/btDeformableLinearElasticityForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btDeformableNeoHookeanForce.h>
#include <BulletSoftBody/btSoftBody.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>

#include <memory>
#include <vector>

namespace rigid {

class BulletDeformable {
public:
    /// \param newton   iterations a step at most; 1 is Bullet's own number
    /// \param damping  share of K in its damping, β [s]
    explicit BulletDeformable(const ElasticBody<3>& body, int newton = 1, Real damping = 0)
        : dispatcher_(&configuration_),
          world_(&dispatcher_, &broadphase_, &constraints_, &configuration_, &solver_)
    {
        constraints_.setDeformableSolver(&solver_);
        solver_.set(newton, 1e-9);
        world_.setImplicit(true);
        world_.setLineSearch(false);
        world_.setUseProjection(true);  // without it what is pinned holds all else
        const Vec3 g = body.gravity;
        const btVector3 gravity(g.x(), g.y(), g.z());
        world_.setGravity(gravity);
        world_.getWorldInfo().m_gravity = gravity;
        const ElasticMesh<3>& mesh = body.model.mesh();
        std::vector<btVector3> x;
        std::vector<btScalar> m;
        for (int i = 0; i < mesh.nodes(); ++i) {
            const Vec3 p = mesh.at(i);
            x.emplace_back(p.x(), p.y(), p.z());
            m.push_back(body.fixed[static_cast<std::size_t>(3 * i)] ? 0 : body.model.mass_at(i));
        }
        soft_ = new btSoftBody(&world_.getWorldInfo(), mesh.nodes(), x.data(), m.data());
        for (int e = 0; e < mesh.count(); ++e)
            soft_->appendTetra(mesh.node(e, 0), mesh.node(e, 1), mesh.node(e, 2), mesh.node(e, 3));
        soft_->initializeDmInverse();
        soft_->m_tetraScratches.resize(soft_->m_tetras.size());
        soft_->m_tetraScratchesTn.resize(soft_->m_tetras.size());
        soft_->m_cfg.collisions = 0;
        soft_->setActivationState(DISABLE_DEACTIVATION);
        world_.addSoftBody(soft_);
        const Lame& lame = body.model.lame();
        if (body.model.material().law == StrainLaw::neo_hookean)
            elastic_ = std::make_unique<btDeformableNeoHookeanForce>(lame.mu, lame.lambda, damping);
        else elastic_ = std::make_unique<btDeformableLinearElasticityForce>(lame.mu, lame.lambda, 0, damping);
        weight_ = std::make_unique<btDeformableGravityForce>(gravity);
        world_.addForce(soft_, weight_.get());
        world_.addForce(soft_, elastic_.get());
    }
    ~BulletDeformable()
    {
        world_.removeSoftBody(soft_);
        delete soft_;
    }
    BulletDeformable(const BulletDeformable&) = delete;
    BulletDeformable& operator=(const BulletDeformable&) = delete;

    void step(Real h) { world_.stepSimulation(h, 0); }
    Vec3 at(int node) const
    {
        const btVector3& p = soft_->m_nodes[node].m_x;
        return {p.x(), p.y(), p.z()};
    }

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
    btSoftBody* soft_ = nullptr;
    std::unique_ptr<btDeformableLagrangianForce> elastic_;
    std::unique_ptr<btDeformableGravityForce> weight_;
};

}  // namespace rigid

#endif
