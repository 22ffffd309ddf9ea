/// \file peer_soft_body.hpp
/// A cloth as Bullet's btSoftBody, where that is installed (bullet-float64), by its public interface alone: position-based
/// dynamics of links with a share kLST from 0 to 1, and no stiffness. Its own defaults, but for damping, which is off, and
/// iterations. It has no bends by a slope.
#pragma once

#include "chapters/27_particles_and_cloth/cloth_scenes.hpp"

#include <BulletSoftBody/btSoftBodyRigidBodyCollisionConfiguration.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <memory>

namespace rigid {

class BulletCloth {
public:
    BulletCloth(const ClothScene& cloth, int substeps, int iterations)
        : dispatcher_(&configuration_),
          world_(&dispatcher_, &pairs_, &solver_, &configuration_),
          substeps_(substeps)
    {
        btSoftBodyWorldInfo& info = world_.getWorldInfo();
        world_.setGravity(vector(cloth.gravity));
        info.m_gravity = vector(cloth.gravity);
        info.air_density = 0;
        info.m_sparsesdf.setDefaultVoxelsz(0.25);
        info.m_sparsesdf.Initialize();
        add_balls(cloth);

        std::vector<btVector3> x;
        std::vector<btScalar> m;
        Real stiff = 0;
        for (const ClothSpring& s : cloth.springs)
            stiff = std::max(stiff, s.stiffness);
        for (int k = 0; k < cloth.count(); ++k) {
            const Real w = cloth.bodies.inverse_mass[3 * k];
            x.push_back(vector(cloth.bodies.position(k)));
            m.push_back(w > 0 ? 1 / w : 0);
        }
        body_ =
            std::make_unique<btSoftBody>(&info, cloth.count(), x.data(), m.data());
        btSoftBody::Material* const threads = body_->appendMaterial();
        btSoftBody::Material* const diagonals = body_->appendMaterial();
        threads->m_kLST = 1;
        for (const ClothSpring& s : cloth.springs) {
            const bool thread = s.stiffness >= stiff / 2;
            if (!thread) diagonals->m_kLST = s.stiffness / stiff;
            body_->appendLink(s.a, s.b, thread ? threads : diagonals);
        }
        for (const auto& t : cloth.triangles) body_->appendFace(t[0], t[1], t[2]);
        body_->m_cfg.kDP = 0;
        body_->m_cfg.piterations = iterations;
        body_->m_cfg.kDF = cloth.shapes.empty() ? 0 : cloth.shapes[0].friction;
        body_->getCollisionShape()->setMargin(std::max(cloth.thickness, 1e-3));
        body_->setActivationState(DISABLE_DEACTIVATION);
        world_.addSoftBody(body_.get());
    }
    ~BulletCloth()
    {
        world_.removeSoftBody(body_.get());
        for (const auto& ball : balls_) world_.removeRigidBody(ball.get());
    }
    BulletCloth(const BulletCloth&) = delete;
    BulletCloth& operator=(const BulletCloth&) = delete;

    void step(Real h)
    {
        for (int k = 0; k < substeps_; ++k) world_.stepSimulation(h / substeps_, 0);
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
            world_.addRigidBody(balls_.back().get());
        }
    }

    btSoftBodyRigidBodyCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase pairs_;
    btSequentialImpulseConstraintSolver solver_;
    btSoftRigidDynamicsWorld world_;
    std::vector<std::unique_ptr<btSphereShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> balls_;
    std::unique_ptr<btSoftBody> body_;
    int substeps_ = 1;
};

}  // namespace rigid
