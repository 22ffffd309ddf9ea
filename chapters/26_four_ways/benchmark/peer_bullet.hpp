/// \file peer_bullet.hpp
/// A scene of the ways in Bullet: impulses, by its ten sweeps, its own defaults but for the step and no sleep.
#pragma once

#include "chapters/26_four_ways/benchmark/peer_bodies.hpp"

#include <btBulletDynamicsCommon.h>

#include <cmath>

namespace rigid {

class BulletWays {
public:
    static constexpr const char* name = "Bullet";

    explicit BulletWays(const WayScene& way)
        : dispatcher_(&configuration_),
          world_(&dispatcher_, &pairs_, &solver_, &configuration_)
    {
        const JointedScene& scene = way.scene;
        world_.setGravity(btVector3(scene.gravity.x(), scene.gravity.y(), 0));
        const Surface surface =
            scene.surfaces.empty() ? Surface{} : scene.surfaces.front();
        const auto add = [&](std::unique_ptr<btCollisionShape> shape, Real mass,
                             Real inertia, const btTransform& at) {
            btRigidBody::btRigidBodyConstructionInfo info(
                mass, nullptr, shape.get(), btVector3(inertia, inertia, inertia));
            info.m_startWorldTransform = at;
            // they multiply both
            info.m_friction = std::sqrt(surface.friction);
            info.m_restitution = std::sqrt(surface.restitution);
            auto body = std::make_unique<btRigidBody>(info);
            body->setActivationState(DISABLE_DEACTIVATION);
            const int others =
                (meets_something(scene) ? 1 : 0) + (meet_each_other(scene) ? 2 : 0);
            const bool moves = mass > 0;
            world_.addRigidBody(body.get(), moves ? 2 : 1, moves ? others : 2);
            shapes_.push_back(std::move(shape));
            bodies_.push_back(std::move(body));
            return bodies_.back().get();
        };
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Polygon& shape = scene.shapes[static_cast<std::size_t>(k)];
            const Vec2 half = half_sides(shape);
            std::unique_ptr<btCollisionShape> made;
            if (is_disc(shape))
                made = std::make_unique<btSphereShape>(shape.radius);
            else if (is_capsule(shape))
                made = std::make_unique<btCapsuleShapeX>(radius_of(shape),
                                                         length_of(shape));
            else
                made = std::make_unique<btBoxShape>(
                    btVector3(half.x(), half.y(), 0.5));
            const Vec<3> x = scene.bodies.position(k), u = scene.bodies.velocity(k);
            btRigidBody* const body = add(
                std::move(made), mass_of_body(scene, k), inertia_of_body(scene, k),
                btTransform(btQuaternion(btVector3(0, 0, 1), x[2]),
                            btVector3(x[0], x[1], 0)));
            body->setLinearVelocity(btVector3(u[0], u[1], 0));
            body->setAngularVelocity(btVector3(0, 0, u[2]));
        }
        for (const HalfSpace& wall : scene.walls)
            add(std::make_unique<btStaticPlaneShape>(
                    btVector3(wall.normal.x(), wall.normal.y(), 0),
                    wall.offset - stands_back(scene)),
                0, 0, btTransform::getIdentity());
        for (const PlacedJoint& placed : scene.placed) {
            const RigidJoint& joint = placed.joint;
            btRigidBody& b = *bodies_[static_cast<std::size_t>(joint.b)];
            btRigidBody& a = joint.a == world
                                 ? btTypedConstraint::getFixedBody()
                                 : *bodies_[static_cast<std::size_t>(joint.a)];
            const btVector3 at_a(joint.at_a.x(), joint.at_a.y(), 0),
                at_b(joint.at_b.x(), joint.at_b.y(), 0), z(0, 0, 1);
            if (joint.kind == JointKind::prismatic) {  // along x here
                const auto id = btQuaternion::getIdentity();
                joints_.push_back(std::make_unique<btSliderConstraint>(
                    a, b, btTransform(id, at_a), btTransform(id, at_b), true));
            } else {
                auto hinge =
                    std::make_unique<btHingeConstraint>(a, b, at_a, at_b, z, z);
                if (is_limited(joint)) {  // of their angle, which has its own sign
                    const Real now = coordinate(scene.bodies.x, joint),
                               theirs = hinge->getHingeAngle();
                    hinge->setLimit(theirs - (joint.upper - now),
                                    theirs - (joint.lower - now));
                }
                joints_.push_back(std::move(hinge));
            }
            world_.addConstraint(joints_.back().get(), true);
        }
    }
    ~BulletWays()
    {
        for (const auto& joint : joints_) world_.removeConstraint(joint.get());
        for (const auto& body : bodies_) world_.removeRigidBody(body.get());
    }
    BulletWays(const BulletWays&) = delete;
    BulletWays& operator=(const BulletWays&) = delete;

    static bool can_take(const WayScene&) { return true; }
    void step(Real h) { world_.stepSimulation(h, 0); }
    void read(JointedScene& scene) const
    {
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const btRigidBody& body = *bodies_[static_cast<std::size_t>(k)];
            const btTransform& at = body.getCenterOfMassTransform();
            const btQuaternion q = at.getRotation();
            scene.bodies.position(k) << at.getOrigin().x(), at.getOrigin().y(),
                std::remainder(2 * atan2(q.z(), q.w()), 2 * pi);
            scene.bodies.velocity(k) << body.getLinearVelocity().x(),
                body.getLinearVelocity().y(), body.getAngularVelocity().z();
        }
    }

private:
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_;
    btDbvtBroadphase pairs_;
    btSequentialImpulseConstraintSolver solver_;
    btDiscreteDynamicsWorld world_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btTypedConstraint>> joints_;
};

}  // namespace rigid
