/// \file peers_box2d.hpp
/// A scene of discs as a world of Box2D 2.4.1, where the library is installed: the one of Debian 12. (Box2D 3 exists and is another solver.)
///
/// 8 velocity and 3 position iterations, its own advice, or one of each in a small step; circles with fixed rotation,
/// distance joints, warm starting on, continuous collision off (this book has none; it only saves Box2D time). Its
/// numbers are floats.
///
/// Its lengths are constants of the compiled library: an error of up to 5 mm (`b2_linearSlop`) is left alone, a larger
/// one is moved by at most 0.2 m an iteration, no body moves farther than 2 m in a step, and one that is slower than
/// 1 cm/s may fall asleep. So a slop of 0.5 mm is had by a world in which all lengths and gravity are ten times ours:
/// the same motion, with all four lengths a tenth of that in our units. Positions come back in ours.
#pragma once

#include "chapters/08_warm_starting/benchmark/engine_scenes.hpp"

#include <box2d/box2d.h>

#include <vector>

namespace rigid {

class Box2dWorld {
public:
    explicit Box2dWorld(const EngineScene& from, const PeerSettings& settings = {})
        : scale_(static_cast<Real>(b2_linearSlop) / settings.slop),
          world_(vector(from.scene.gravity))
    {
        const DiscScene& scene = from.scene;
        world_.SetAllowSleeping(settings.may_sleep);
        world_.SetContinuousPhysics(false);
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Real inverse_mass = scene.bodies.inverse_mass[2 * k];
            b2BodyDef def;
            def.type = inverse_mass > 0 ? b2_dynamicBody : b2_staticBody;
            def.position = vector(scene.bodies.position(k));
            def.linearVelocity = vector(scene.bodies.velocity(k));
            def.fixedRotation = true;
            b2Body* const body = world_.CreateBody(&def);
            if (from.collides) {
                b2CircleShape circle;
                circle.m_radius = static_cast<float>(scale_ * scene.radius[k]);
                add(*body, circle);
            }
            if (inverse_mass > 0) {
                b2MassData mass{static_cast<float>(1 / inverse_mass), {0, 0}, 0};
                body->SetMassData(&mass);
            }
            bodies_.push_back(body);
        }
        for (const Link& link : scene.links) {
            b2Body* const a = bodies_[static_cast<std::size_t>(link.a)];
            b2Body* const b = bodies_[static_cast<std::size_t>(link.b)];
            b2DistanceJointDef def;
            def.Initialize(a, b, a->GetPosition(), b->GetPosition());
            def.length = def.minLength = def.maxLength =
                static_cast<float>(scale_ * link.length);
            world_.CreateJoint(&def);
        }
        if (!from.collides) return;
        b2BodyDef ground_def;
        b2Body* const ground = world_.CreateBody(&ground_def);
        const Real reach = wall_reach(scene);
        for (const HalfSpace& wall : scene.walls) {
            // Solid behind its surface, as the half-space is: nothing falls through
            // an edge. A polygon has a skin of its own; it is set back by it, so that
            // the wall is where the scene says.
            b2PolygonShape box;
            const Real skin = static_cast<Real>(box.m_radius) / scale_;
            const Vec2 middle = (wall.offset - skin - reach / 2) * wall.normal;
            box.SetAsBox(
                static_cast<float>(scale_ * reach),
                static_cast<float>(scale_ * reach / 2), vector(middle),
                static_cast<float>(std::atan2(-wall.normal.x(), wall.normal.y())));
            add(*ground, box);
        }
    }

    /// One step, or several small ones with one iteration of each kind, as this book takes them.
    void step(Real h, int substeps)
    {
        if (substeps == 1) world_.Step(static_cast<float>(h), 8, 3);
        else
            for (int k = 0; k < substeps; ++k)
                world_.Step(static_cast<float>(h / substeps), 1, 1);
    }

    /// How many bodies that can move are awake.
    int awake() const
    {
        int count = 0;
        for (const b2Body* const body : bodies_)
            count += body->GetType() == b2_dynamicBody && body->IsAwake();
        return count;
    }

    /// Writes the positions into the scene.
    void poses(DiscScene& scene) const
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            const b2Vec2& p = bodies_[k]->GetPosition();
            scene.bodies.position(static_cast<Index>(k))
                << static_cast<Real>(p.x) / scale_,
                static_cast<Real>(p.y) / scale_;
        }
    }

private:
    /// A place, a velocity or gravity in this world's lengths.
    b2Vec2 vector(const Vec2& v) const
    {
        return {static_cast<float>(scale_ * v.x()),
                static_cast<float>(scale_ * v.y())};
    }

    static void add(b2Body& body, const b2Shape& shape)
    {
        b2FixtureDef def;
        def.shape = &shape;
        def.friction = 0;
        def.restitution = 0;
        body.CreateFixture(&def);
    }

    Real scale_;  ///< its metres in one of ours
    b2World world_;
    std::vector<b2Body*> bodies_;
};

}  // namespace rigid
