/// \file peer_soft_body.hpp
/// A cloth in Bullet, where it is installed (bullet-float64), both ways that it has, by its public interface alone:
///
///     btSoftBody      position-based dynamics of links with a share kLST from 0 to 1: no stiffness
///     btDeformable    btDeformableMassSpringForce of k [N/m], one implicit step by conjugate gradients
///
/// Its own defaults, but for damping, which is off, and iterations. Links of the diagonals are its `bending` links: they have
/// the second stiffness, or the second share. It has no bends by a slope.
#pragma once

#include "chapters/27_particles_and_cloth/cloth_scenes.hpp"

#include <BulletSoftBody/btDeformableBodySolver.h>
#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btDeformableMultiBodyConstraintSolver.h>
#include <BulletSoftBody/btDeformableMultiBodyDynamicsWorld.h>
#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <memory>

namespace rigid {

class BulletCloth {
public:
    BulletCloth(const ClothScene& cloth, bool deformable, int substeps,
                int iterations)
        : dispatcher_(&configuration_), substeps_(substeps)
    {
        if (deformable) {
            body_solver_ = std::make_unique<btDeformableBodySolver>();
            auto solver = std::make_unique<btDeformableMultiBodyConstraintSolver>();
            solver->setDeformableSolver(body_solver_.get());
            auto made = std::make_unique<btDeformableMultiBodyDynamicsWorld>(
                &dispatcher_, &pairs_, solver.get(), &configuration_,
                body_solver_.get());
            info_ = &made->getWorldInfo();
            solver_ = std::move(solver), world_ = std::move(made);
        } else {
            solver_ = std::make_unique<btSequentialImpulseConstraintSolver>();
            auto made = std::make_unique<btSoftRigidDynamicsWorld>(
                &dispatcher_, &pairs_, solver_.get(), &configuration_);
            info_ = &made->getWorldInfo();
            world_ = std::move(made);
        }
        world_->setGravity(vector(cloth.gravity));
        info_->m_gravity = vector(cloth.gravity);
        info_->air_density = 0;
        info_->m_sparsesdf.setDefaultVoxelsz(0.25);
        info_->m_sparsesdf.Initialize();
        add_balls(cloth);

        const int K = cloth.count();
        std::vector<btVector3> x;
        std::vector<btScalar> m;
        Real stiff = 0, soft = 0;
        for (const ClothSpring& s : cloth.springs)
            stiff = std::max(stiff, s.stiffness);
        for (int k = 0; k < K; ++k) {
            const Real w = cloth.bodies.inverse_mass[3 * k];
            x.push_back(vector(cloth.bodies.position(k)));
            m.push_back(w > 0 ? 1 / w : 0);
        }
        body_ = new btSoftBody(info_, K, x.data(), m.data());
        btSoftBody::Material* const threads = body_->appendMaterial();
        btSoftBody::Material* const diagonals = body_->appendMaterial();
        threads->m_kLST = 1;
        for (const ClothSpring& s : cloth.springs) {
            const bool thread = s.stiffness >= stiff / 2;
            if (!thread) soft = s.stiffness;
            body_->appendLink(s.a, s.b, thread ? threads : diagonals);
            body_->m_links[body_->m_links.size() - 1].m_bbending = !thread;
        }
        diagonals->m_kLST = soft / stiff;
        for (const auto& t : cloth.triangles) body_->appendFace(t[0], t[1], t[2]);
        body_->m_cfg.kDP = 0;
        body_->m_cfg.piterations = iterations;
        body_->m_cfg.kDF = cloth.shapes.empty() ? 0 : cloth.shapes[0].friction;
        body_->getCollisionShape()->setMargin(std::max(cloth.thickness, 1e-3));
        body_->setActivationState(DISABLE_DEACTIVATION);
        if (deformable) {
            auto* const world =
                static_cast<btDeformableMultiBodyDynamicsWorld*>(world_.get());
            body_->m_cfg.collisions =
                btSoftBody::fCollision::SDF_RD | btSoftBody::fCollision::SDF_RDN;
            world->setImplicit(true);
            world->addSoftBody(body_);
            springs_ =
                std::make_unique<btDeformableMassSpringForce>(stiff, 0, true, soft);
            gravity_ =
                std::make_unique<btDeformableGravityForce>(vector(cloth.gravity));
            world->addForce(body_, springs_.get());
            world->addForce(body_, gravity_.get());
        } else {
            static_cast<btSoftRigidDynamicsWorld*>(world_.get())
                ->addSoftBody(body_);
        }
    }
    ~BulletCloth()
    {
        if (springs_)
            static_cast<btDeformableMultiBodyDynamicsWorld*>(world_.get())
                ->removeSoftBody(body_);
        else
            static_cast<btSoftRigidDynamicsWorld*>(world_.get())
                ->removeSoftBody(body_);
        delete body_;
        for (const auto& ball : balls_) world_->removeRigidBody(ball.get());
    }
    BulletCloth(const BulletCloth&) = delete;
    BulletCloth& operator=(const BulletCloth&) = delete;

    void step(Real h)
    {
        for (int k = 0; k < substeps_; ++k)
            world_->stepSimulation(h / substeps_, 0);
    }
    void read(ClothScene& cloth) const
    {
        for (int k = 0; k < cloth.count(); ++k) {
            const btSoftBody::Node& node = body_->m_nodes[k];
            cloth.bodies.position(k) << node.m_x.x(), node.m_x.y(), node.m_x.z();
            cloth.bodies.velocity(k) << node.m_v.x(), node.m_v.y(), node.m_v.z();
        }
    }

private:
    static btVector3 vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
    void add_balls(const ClothScene& cloth)
    {
        for (std::size_t k = 0; k < cloth.shapes.size(); ++k) {
            const Vec3 at = centre_of(cloth.solids.x, static_cast<Index>(k));
            shapes_.push_back(
                std::make_unique<btSphereShape>(cloth.shapes[k].radius));
            btRigidBody::btRigidBodyConstructionInfo info(0, nullptr,
                                                          shapes_.back().get());
            info.m_startWorldTransform =
                btTransform(btQuaternion::getIdentity(), vector(at));
            info.m_friction = cloth.shapes[k].friction;
            balls_.push_back(std::make_unique<btRigidBody>(info));
            world_->addRigidBody(balls_.back().get());
        }
    }

    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase pairs_;
    std::unique_ptr<btDeformableBodySolver> body_solver_;
    std::unique_ptr<btSequentialImpulseConstraintSolver> solver_;
    std::unique_ptr<btDiscreteDynamicsWorld> world_;
    std::unique_ptr<btDeformableMassSpringForce> springs_;
    std::unique_ptr<btDeformableGravityForce> gravity_;
    std::vector<std::unique_ptr<btSphereShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> balls_;
    btSoftBodyWorldInfo* info_ = nullptr;
    btSoftBody* body_ = nullptr;
    int substeps_ = 1;
};

}  // namespace rigid
