/// \file peers_box2d.hpp
/// Bodies on revolute joints as a world of Box2D 2.4.1, where the library is installed: the one of Debian 12.
///
/// Bodies with shapes touch each other if they are of different groups; a capsule is a box and two discs, and what is
/// round at its corners gets the engine's own skin of 1 cm. Warm starting on, continuous collision and sleep off. Its numbers are floats. A body moves
/// at most 2 m and turns at most a quarter in one of its steps.
#pragma once

#include "chapters/14_joints/joint.hpp"

#include <box2d/box2d.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace rigid {

class Box2dJoints {
public:
    /// \param group  of each body: those of one do not touch each other; 0 = it is in none. Empty: nothing touches.
    Box2dJoints(const JointedScene& scene, int velocity_iterations,
                int position_iterations, const std::vector<int>& group = {})
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
            def.type = m.isZero(0) ? b2_staticBody : b2_dynamicBody;
            def.position = vector(x.head<2>());
            def.angle = static_cast<float>(x[2]);
            def.linearVelocity = vector(u.head<2>());
            def.angularVelocity = static_cast<float>(u[2]);
            b2Body* const body = world_.CreateBody(&def);
            const auto i = static_cast<std::size_t>(k);
            if (!group.empty()) add_shape(*body, scene.shapes[i], group[i]);
            b2MassData mass{
                static_cast<float>(1 / m[0]), {0, 0}, static_cast<float>(1 / m[2])};
            if (!m.isZero(0)) body->SetMassData(&mass);
            bodies_.push_back(body);
        }
        for (const HalfSpace& wall : scene.walls) {
            b2PolygonShape half;
            half.SetAsBox(
                200, 10, vector((wall.offset - 10.01) * wall.normal),
                static_cast<float>(std::atan2(-wall.normal.x(), wall.normal.y())));
            if (!group.empty()) add(*ground, half, 0);
        }
        for (const PlacedJoint& placed : scene.placed) {
            b2RevoluteJointDef def;
            def.bodyA = placed.joint.a == world ? ground : at(placed.joint.a);
            def.bodyB = at(placed.joint.b);
            def.localAnchorA = vector(placed.joint.at_a);
            def.localAnchorB = vector(placed.joint.at_b);
            def.referenceAngle = static_cast<float>(placed.joint.angle);
            def.enableLimit = placed.joint.lower > -infinity;
            def.lowerAngle = static_cast<float>(std::max(placed.joint.lower, -pi));
            def.upperAngle = static_cast<float>(std::min(placed.joint.upper, pi));
            def.enableMotor = placed.joint.motor.force > 0;
            def.maxMotorTorque = static_cast<float>(placed.joint.motor.force);
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
    static void add(b2Body& body, const b2Shape& shape, int group)
    {
        b2FixtureDef def;
        def.shape = &shape;
        def.density = 1;
        def.friction = 0.6F;
        def.filter.groupIndex = static_cast<int16>(-group);
        body.CreateFixture(&def);
    }
    static void add_shape(b2Body& body, const Polygon& shape, int group)
    {
        const auto r = static_cast<float>(shape.radius);
        std::vector<b2Vec2> corners;
        for (const Vec2& v : shape.vertices) corners.push_back(vector(v));
        if (corners.size() < 3)
            for (const b2Vec2& c : corners) {
                b2CircleShape disc;
                disc.m_radius = r;
                disc.m_p = c;
                add(body, disc, group);
            }
        if (corners.size() == 1) return;
        b2PolygonShape polygon;
        if (corners.size() == 2) polygon.SetAsBox(std::abs(corners[1].x), r);
        else {
            const float more = r - polygon.m_radius;
            for (b2Vec2& c : corners) {
                c.x += c.x > 0 ? more : -more;
                c.y += c.y > 0 ? more : -more;
            }
            polygon.Set(corners.data(), static_cast<int>(corners.size()));
        }
        add(body, polygon, group);
    }
    b2Body* at(Index k) const { return bodies_[static_cast<std::size_t>(k)]; }

    b2World world_;
    int velocity_iterations_, position_iterations_;
    std::vector<b2Body*> bodies_;
};

}  // namespace rigid
