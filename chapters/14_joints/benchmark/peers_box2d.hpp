/// \file peers_box2d.hpp
/// Bodies on revolute joints as a world of Box2D 2.4.1, where the library is installed: the one of Debian 12.
///
/// Nothing touches anything. Warm starting on, continuous collision and sleep off. Its numbers are floats. A body moves
/// at most 2 m and turns at most a quarter in one of its steps.
#pragma once

#include "chapters/14_joints/joint.hpp"

#include <box2d/box2d.h>

#include <vector>

namespace rigid {

class Box2dJoints {
public:
    Box2dJoints(const JointedScene& scene, int velocity_iterations,
                int position_iterations)
        : world_(vector(scene.gravity)), velocity_iterations_(velocity_iterations),
          position_iterations_(position_iterations)
    {
        world_.SetAllowSleeping(false);
        world_.SetContinuousPhysics(false);
        b2BodyDef fixed;
        b2Body* const ground = world_.CreateBody(&fixed);
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Vec<3> x = scene.bodies.position(k), u = scene.bodies.velocity(k),
                         m = scene.bodies.inverse_mass.segment<3>(3 * k);
            b2BodyDef def;
            def.type = b2_dynamicBody;
            def.position = vector(x.head<2>());
            def.angle = static_cast<float>(x[2]);
            def.linearVelocity = vector(u.head<2>());
            def.angularVelocity = static_cast<float>(u[2]);
            b2Body* const body = world_.CreateBody(&def);
            b2MassData mass{
                static_cast<float>(1 / m[0]), {0, 0}, static_cast<float>(1 / m[2])};
            body->SetMassData(&mass);
            bodies_.push_back(body);
        }
        for (const PlacedJoint& placed : scene.placed) {
            b2RevoluteJointDef def;
            def.bodyA = placed.joint.a == world ? ground : at(placed.joint.a);
            def.bodyB = at(placed.joint.b);
            def.localAnchorA = vector(placed.joint.at_a);
            def.localAnchorB = vector(placed.joint.at_b);
            world_.CreateJoint(&def);
        }
    }

    void step(Real h)
    {
        world_.Step(static_cast<float>(h), velocity_iterations_,
                    position_iterations_);
    }

    /// Writes positions and velocities into the scene.
    void read(JointedScene& scene) const
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            const b2Vec2 p = bodies_[k]->GetPosition(),
                         v = bodies_[k]->GetLinearVelocity();
            const auto i = static_cast<Index>(k);
            scene.bodies.position(i) << static_cast<Real>(p.x),
                static_cast<Real>(p.y), static_cast<Real>(bodies_[k]->GetAngle());
            scene.bodies.velocity(i) << static_cast<Real>(v.x),
                static_cast<Real>(v.y),
                static_cast<Real>(bodies_[k]->GetAngularVelocity());
        }
    }

private:
    static b2Vec2 vector(const Vec2& v)
    {
        return {static_cast<float>(v.x()), static_cast<float>(v.y())};
    }
    b2Body* at(Index k) const { return bodies_[static_cast<std::size_t>(k)]; }

    b2World world_;
    int velocity_iterations_, position_iterations_;
    std::vector<b2Body*> bodies_;
};

}  // namespace rigid
