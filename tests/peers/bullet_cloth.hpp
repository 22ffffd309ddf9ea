/// \file bullet_cloth.hpp
/// A cloth in Bullet, where that is installed (bullet-float64), by its public interface alone, in one of its two kinds:
///
///     btSoftBody               position-based dynamics of links with a share kLST from 0 to 1, and no stiffness
///     btDeformable             implicit Euler of the same springs as ours, by Newton's method and conjugate gradients
///
/// Their own defaults, but for damping, which is off, and iterations. Neither has bends by a slope.
#pragma once

#ifdef RIGID_HAS_BULLET

#include "chapters/27_particles_and_cloth/cloth.hpp"
#include "tests/peers/bullet_deformable_world.hpp"

#include <BulletSoftBody/btDeformableMassSpringForce.h>
#include <BulletSoftBody/btSoftRigidDynamicsWorld.h>
#include <btBulletDynamicsCommon.h>

#include <memory>
#include <vector>

namespace rigid {

/// Places and masses of the particles; zero for those that are pinned.
inline void put_nodes(const ClothScene& cloth, std::vector<btVector3>& x, std::vector<btScalar>& mass)
{
    for (int k = 0; k < cloth.count(); ++k) {
        const Real w = cloth.bodies.inverse_mass[3 * k];
        x.push_back(bullet_vector(cloth.bodies.position(k)));
        mass.push_back(w > 0 ? 1 / w : 0);
    }
}
inline void read_node(const btSoftBody::Node& node, int k, ClothScene& cloth)
{
    cloth.bodies.position(k) << node.m_x.x(), node.m_x.y(), node.m_x.z();
    cloth.bodies.velocity(k) << node.m_v.x(), node.m_v.y(), node.m_v.z();
}

/// A ball that cannot move, for the cloth to fall on.
struct BulletBall {
    Vec3 at = {0, 0, 0};
    Real radius = 1, friction = 0;
};

class BulletCloth {
public:
    BulletCloth(const ClothScene& cloth, const std::vector<BulletBall>& balls, Real thickness, int substeps,
                int iterations)
        : dispatcher_(&configuration_), world_(&dispatcher_, &pairs_, &solver_, &configuration_),
          substeps_(substeps)
    {
        btSoftBodyWorldInfo& info = world_.getWorldInfo();
        world_.setGravity(bullet_vector(cloth.gravity));
        info.m_gravity = bullet_vector(cloth.gravity);
        info.air_density = 0;
        info.m_sparsesdf.setDefaultVoxelsz(0.25);
        info.m_sparsesdf.Initialize();
        add_balls(balls);

        std::vector<btVector3> x;
        std::vector<btScalar> m;
        Real stiff = 0;
        for (const ClothSpring& s : cloth.springs) stiff = std::max(stiff, s.stiffness);
        put_nodes(cloth, x, m);
        body_ = std::make_unique<btSoftBody>(&info, cloth.count(), x.data(), m.data());
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
        body_->m_cfg.kDF = balls.empty() ? 0 : balls[0].friction;
        body_->getCollisionShape()->setMargin(std::max(thickness, 1e-3));
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
        for (int k = 0; k < cloth.count(); ++k) read_node(body_->m_nodes[k], k, cloth);
    }

private:
    void add_balls(const std::vector<BulletBall>& balls)
    {
        for (const BulletBall& ball : balls) {
            shapes_.push_back(std::make_unique<btSphereShape>(ball.radius));
            btRigidBody::btRigidBodyConstructionInfo info(0, nullptr, shapes_.back().get());
            info.m_startWorldTransform = btTransform(btQuaternion::getIdentity(), bullet_vector(ball.at));
            info.m_friction = ball.friction;
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

/// A sheet as a deformable body: springs of one stiffness for threads and one for diagonals, of one damping [N s/m].
class BulletDeformableCloth : public BulletDeformableWorld {
public:
    BulletDeformableCloth(const ClothScene& cloth, int substeps, int newton,
                          const std::vector<BulletBall>& balls = {}, Real thickness = 0, Real damping = 0)
        : BulletDeformableWorld(cloth.gravity, newton), substeps_(substeps)
    {
        std::vector<btVector3> x;
        std::vector<btScalar> m;
        put_nodes(cloth, x, m);
        btSoftBody& body = begin(x, m);
        // one stiffness for all links of a body, and one for those that count as bends: our diagonals
        Real stiff = 0, soft = infinity;
        for (const ClothSpring& s : cloth.springs)
            stiff = std::max(stiff, s.stiffness), soft = std::min(soft, s.stiffness);
        for (const ClothSpring& s : cloth.springs) {
            body.appendLink(s.a, s.b);
            body.m_links[body.m_links.size() - 1].m_bbending = s.stiffness < stiff;
        }
        put_in(std::make_unique<btDeformableMassSpringForce>(stiff, damping, false, soft));
        for (const BulletBall& ball : balls)
            add_ball(ball.at, ball.radius, ball.friction, std::max(thickness, 1e-3));
    }

    void step(Real h)
    {
        for (int k = 0; k < substeps_; ++k) BulletDeformableWorld::step(h / substeps_);
    }
    void read(ClothScene& cloth) const
    {
        for (int k = 0; k < cloth.count(); ++k) read_node(node(k), k, cloth);
    }

private:
    int substeps_ = 1;
};

}  // namespace rigid

#endif
