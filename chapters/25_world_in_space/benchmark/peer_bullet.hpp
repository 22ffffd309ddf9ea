/// \file peer_bullet.hpp
/// A scene of solids in Bullet, where it is installed (bullet-float64): balls, boxes and capsules on walls, by its public
/// interface alone. Its own defaults, but for the iterations, the sub-steps, and no sleep.
#pragma once

#include "chapters/25_world_in_space/benchmark/peer_shapes.hpp"

#include <btBulletDynamicsCommon.h>

#include <memory>

namespace rigid {

class BulletWorld {
public:
    BulletWorld(const SpaceScene& here, int substeps, int iterations)
        : dispatcher_(&configuration_),
          world_(&dispatcher_, &pairs_, &solver_, &configuration_),
          substeps_(substeps)
    {
        world_.setGravity(vector(here.gravity));
        world_.getSolverInfo().m_numIterations = iterations;
        for (std::size_t w = 0; w < here.walls.size(); ++w)
            add(std::make_unique<btStaticPlaneShape>(vector(here.walls[w].normal),
                                                     here.walls[w].offset),
                0, btTransform::getIdentity(), {0, 0, 0}, here.wall_friction[w]);
        for (Index k = 0; k < here.bodies.count(); ++k) {
            const SimpleSolid solid =
                simple_solid(here.shapes[static_cast<std::size_t>(k)]);
            std::unique_ptr<btCollisionShape> shape;
            if (solid.kind == SimpleSolid::ball)
                shape = std::make_unique<btSphereShape>(solid.radius);
            else if (solid.kind == SimpleSolid::capsule)
                shape =
                    std::make_unique<btCapsuleShapeX>(solid.radius, solid.size.x());
            else shape = std::make_unique<btBoxShape>(vector(solid.size / 2));
            const Vec3 theta = here.bodies.x.segment<3>(6 * k + 3);
            const Quaternion q = quaternion_of(theta);
            const btTransform at(btQuaternion(q.v.x(), q.v.y(), q.v.z(), q.w),
                                 vector(centre_of(here.bodies.x, k)));
            const bool moves = here.bodies.can_move(k);
            const Vec3 inverse = here.bodies.inverse_mass.segment<3>(6 * k + 3);
            bodies_.push_back(add(
                std::move(shape), moves ? 1 / here.bodies.inverse_mass[6 * k] : 0,
                at, moves ? Vec3(inverse.cwiseInverse()) : Vec3(0, 0, 0),
                here.friction[static_cast<std::size_t>(k)]));
            bodies_.back()->setLinearVelocity(
                vector(here.bodies.u.segment<3>(6 * k)));
            bodies_.back()->setAngularVelocity(vector(world_spin(here.bodies, k)));
        }
        for (const SpaceJoint& joint : here.joints) add_joint(joint);
    }
    ~BulletWorld()
    {
        for (const auto& joint : joints_) world_.removeConstraint(joint.get());
        for (const auto& body : owned_) world_.removeRigidBody(body.get());
    }
    BulletWorld(const BulletWorld&) = delete;
    BulletWorld& operator=(const BulletWorld&) = delete;

    void step(Real h)
    {
        for (int k = 0; k < substeps_; ++k) world_.stepSimulation(h / substeps_, 0);
    }
    void read(VecX& x, VecX& u) const
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            const btTransform& at = bodies_[k]->getCenterOfMassTransform();
            const btQuaternion q = at.getRotation();
            x.segment<6>(6 * static_cast<Index>(k)) << at.getOrigin().x(),
                at.getOrigin().y(), at.getOrigin().z(),
                rotation_vector({q.w(), {q.x(), q.y(), q.z()}});
            const btVector3 v = bodies_[k]->getLinearVelocity(),
                            w = at.getBasis().transpose() *
                                bodies_[k]->getAngularVelocity();
            u.segment<6>(6 * static_cast<Index>(k)) << v.x(), v.y(), v.z(), w.x(),
                w.y(), w.z();
        }
    }

private:
    static btVector3 vector(const Vec3& v) { return {v.x(), v.y(), v.z()}; }
    btRigidBody* add(std::unique_ptr<btCollisionShape> shape, Real mass,
                     const btTransform& at, const Vec3& inertia, Real friction)
    {
        btRigidBody::btRigidBodyConstructionInfo info(mass, nullptr, shape.get(),
                                                      vector(inertia));
        info.m_startWorldTransform = at;
        info.m_friction = std::sqrt(friction);  // it multiplies both
        // it has friction against rolling and damping at zero by itself
        owned_.push_back(std::make_unique<btRigidBody>(info));
        shapes_.push_back(std::move(shape));
        owned_.back()->setActivationState(DISABLE_DEACTIVATION);
        world_.addRigidBody(owned_.back().get());
        return owned_.back().get();
    }

    /// A frame whose z axis is the joint's x axis where a hinge wants it so.
    static btTransform frame(const Vec3& at, const Vec3& theta, bool about_z)
    {
        Quaternion q = quaternion_of(theta);
        if (about_z) q = q * quaternion_of(Vec3(0, pi / 2, 0));
        return btTransform(btQuaternion(q.v.x(), q.v.y(), q.v.z(), q.w),
                           vector(at));
    }
    void add_joint(const SpaceJoint& joint)
    {
        btRigidBody& b = *bodies_[static_cast<std::size_t>(joint.b)];
        btRigidBody& a = joint.a == world
                             ? btTypedConstraint::getFixedBody()
                             : *bodies_[static_cast<std::size_t>(joint.a)];
        const bool turns = joint.locked(swing_y);
        const btTransform A = frame(joint.at_a, joint.frame_a, turns),
                          B = frame(joint.at_b, joint.frame_b, turns);
        const auto bend = static_cast<Real>(joint.hi[cone]);
        if (turns) {
            auto made = std::make_unique<btHingeConstraint>(a, b, A, B);
            // its angle is that of a against b
            if (std::isfinite(joint.hi[twist]))
                made->setLimit(-joint.hi[twist], -joint.lo[twist]);
            joints_.push_back(std::move(made));
        } else if (std::isfinite(bend)) {
            auto made = std::make_unique<btConeTwistConstraint>(a, b, A, B);
            made->setLimit(bend, bend, joint.hi[twist]);
            joints_.push_back(std::move(made));
        } else {
            joints_.push_back(std::make_unique<btPoint2PointConstraint>(
                a, b, A.getOrigin(), B.getOrigin()));
        }
        world_.addConstraint(joints_.back().get(), true);
    }

    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase pairs_;
    btSequentialImpulseConstraintSolver solver_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> owned_;
    std::vector<std::unique_ptr<btTypedConstraint>> joints_;
    btDiscreteDynamicsWorld world_;
    int substeps_;
    std::vector<btRigidBody*> bodies_;
};

}  // namespace rigid
