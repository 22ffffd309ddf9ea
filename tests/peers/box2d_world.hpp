/// \file box2d_world.hpp
/// A World's bodies, walls and joints (revolute, distance, rope, weld) in Box2D 2.4.1, where it is installed: the one of Debian 12.
///
/// By its own defaults: iterations 8 and 3, warm starting, continuous collision and sleep on. Its polygons have a skin, so
/// shapes are made smaller by it; its numbers are floats.
#pragma once

#include "tests/peers/poses.hpp"

#include <box2d/box2d.h>

#include <map>
#include <tuple>

namespace rigid {

class Box2dPeer {
public:
    explicit Box2dPeer(const World& here, bool sleeps = true, int substeps = 1)
        : world_(vector(here.settings().gravity)), substeps_(substeps)
    {
        world_.SetAllowSleeping(sleeps);
        b2BodyDef fixed;
        b2Body* const ground = world_.CreateBody(&fixed);
        std::map<BodyId, b2Body*> known;
        for (const BodyId id : here.bodies()) {
            b2BodyDef def;
            const bool moves = here.mass(id) < infinity;
            const bool goes = !here.velocity(id).isZero(0) || here.spin(id) != 0;
            def.type = moves ? b2_dynamicBody : goes ? b2_kinematicBody : b2_staticBody;
            def.position = vector(here.position(id));
            def.angle = static_cast<float>(here.angle(id));
            def.linearVelocity = vector(here.velocity(id));
            def.angularVelocity = static_cast<float>(here.spin(id));
            b2Body* const body = world_.CreateBody(&def);
            add_shape(*body, here, id);
            if (moves) {
                const b2MassData mass{
                    static_cast<float>(here.mass(id)), {0, 0}, static_cast<float>(here.inertia(id))};
                body->SetMassData(&mass);
            }
            bodies_.push_back(body);
            known[id] = body;
        }
        for (const WallId id : here.walls()) {
            const HalfSpace& wall = here.wall(id);
            b2EdgeShape edge;
            const Vec2 middle = wall.normal * wall.offset, along = wall_reach * perpendicular(wall.normal);
            edge.SetTwoSided(vector(middle - along), vector(middle + along));
            b2FixtureDef def;
            def.shape = &edge;
            def.friction = 0.6f;
            ground->CreateFixture(&def);
        }
        const auto find = [&](BodyId id) {
            const auto found = known.find(id);
            return found == known.end() ? ground : found->second;
        };
        for (const JointId id : here.joints())
            add_joint(here.joint(id), find(here.body_a(id)), find(here.body_b(id)));
    }

    void step(Real h)
    {
        for (int k = 0; k < substeps_; ++k) world_.Step(static_cast<float>(h / substeps_), 8, 3);
    }
    void drive(std::size_t k, const Vec2& velocity, Real spin)
    {
        bodies_[k]->SetLinearVelocity(vector(velocity));
        bodies_[k]->SetAngularVelocity(static_cast<float>(spin));
    }
    void read(Poses& poses) const
    {
        poses.clear();
        for (const b2Body* const body : bodies_)
            poses.push_back({static_cast<Real>(body->GetPosition().x),
                             static_cast<Real>(body->GetPosition().y), static_cast<Real>(body->GetAngle())});
    }
    void read_velocities(Poses& velocities) const
    {
        velocities.clear();
        for (const b2Body* const body : bodies_)
            velocities.push_back({static_cast<Real>(body->GetLinearVelocity().x),
                                  static_cast<Real>(body->GetLinearVelocity().y),
                                  static_cast<Real>(body->GetAngularVelocity())});
    }

private:
    static b2Vec2 vector(const Vec2& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }
    void add_joint(const RigidJoint& joint, b2Body* a, b2Body* b)
    {
        const auto add = [&](auto def) {
            def.bodyA = a, def.bodyB = b;
            def.localAnchorA = vector(joint.at_a);
            def.localAnchorB = vector(joint.at_b);
            world_.CreateJoint(&def);
        };
        if (joint.kind == JointKind::revolute) {
            b2RevoluteJointDef def;
            def.referenceAngle = static_cast<float>(joint.angle);
            def.enableLimit = joint.lower > -infinity;
            if (def.enableLimit) {
                def.lowerAngle = static_cast<float>(joint.lower);
                def.upperAngle = static_cast<float>(joint.upper);
            }
            def.enableMotor = joint.motor.force > 0;
            def.motorSpeed = static_cast<float>(joint.motor.speed);
            def.maxMotorTorque = static_cast<float>(joint.motor.force);
            add(def);
        } else if (joint.kind == JointKind::distance || joint.kind == JointKind::rope) {
            b2DistanceJointDef def;
            def.length = def.maxLength = static_cast<float>(joint.length);
            def.minLength = joint.kind == JointKind::rope ? 0 : def.length;
            add(def);
        } else if (joint.kind == JointKind::weld) {
            b2WeldJointDef def;
            def.referenceAngle = static_cast<float>(joint.angle);
            add(def);
        } else refuse(joint.kind, "Box2D 2.4");
    }
    static void add_shape(b2Body& body, const World& here, BodyId id)
    {
        const Polygon& shape = here.shape(id);
        b2PolygonShape polygon;
        b2CircleShape circle;
        b2FixtureDef def;
        def.density = 1;
        def.friction = static_cast<float>(here.surface(id).friction);
        def.restitution = static_cast<float>(here.surface(id).restitution);
        def.filter.groupIndex = static_cast<std::int16_t>(here.filter(id).group);
        if (shape.vertices.size() == 1) {
            circle.m_radius = static_cast<float>(shape.radius);
            def.shape = &circle;
        } else {
            // its corners moved in by the skin that the engine puts around them, out by
            // the radius that ours has
            const Real out = shape.radius - static_cast<Real>(polygon.m_radius);
            std::vector<b2Vec2> points;
            if (shape.vertices.size() == 2) {
                const Vec2 d = (shape.vertices[1] - shape.vertices[0]).normalized(), n = perpendicular(d);
                for (const auto& [i, s, t] : {std::tuple{0, -1, -1}, {1, 1, -1}, {1, 1, 1}, {0, -1, 1}})
                    points.push_back(
                        vector(shape.vertices[static_cast<std::size_t>(i)] + out * (s * d + t * n)));
            } else
                for (std::size_t i = 0; i < shape.vertices.size(); ++i) {
                    const std::size_t n = shape.vertices.size();
                    const Vec2 before = (shape.vertices[i] - shape.vertices[(i + n - 1) % n]).normalized(),
                               next = (shape.vertices[(i + 1) % n] - shape.vertices[i]).normalized();
                    // both edges move out by `out`
                    points.push_back(
                        vector(shape.vertices[i] + out * (before - next) / cross2(before, next)));
                }
            polygon.Set(points.data(), static_cast<int>(points.size()));
            def.shape = &polygon;
        }
        body.CreateFixture(&def);
    }

    b2World world_;
    int substeps_;
    std::vector<b2Body*> bodies_;
};

}  // namespace rigid
