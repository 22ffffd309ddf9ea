/// \file peers_chipmunk.hpp
/// A scene of discs as a space of Chipmunk 7, where the library is installed.
///
/// 10 iterations, its own choice, or one in a small step; the slop that it is given (its own choice is 0.1 m); circles
/// of infinite moment, pin joints; a tenth of an error is repaid in a sixtieth of a second, its own choice for contacts
/// and joints. Its numbers are doubles. Debian builds it with its assertions on.
#pragma once

#include "chapters/08_warm_starting/benchmark/engine_scenes.hpp"

#include <chipmunk/chipmunk.h>

#include <limits>
#include <vector>

namespace rigid {

class ChipmunkSpace {
public:
    /// It may sleep by its own rule: slower than g h, for half a second.
    explicit ChipmunkSpace(const EngineScene& from,
                           const PeerSettings& settings = {})
        : space_(cpSpaceNew())
    {
        const DiscScene& scene = from.scene;
        cpSpaceSetGravity(space_, vector(scene.gravity));
        // what is left of a velocity after a second: all
        cpSpaceSetDamping(space_, 1);
        cpSpaceSetCollisionSlop(space_, settings.slop);
        cpSpaceSetSleepTimeThreshold(
            space_,
            settings.may_sleep ? 0.5 : std::numeric_limits<cpFloat>::infinity());
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Real inverse_mass = scene.bodies.inverse_mass[2 * k];
            cpBody* const body = inverse_mass > 0
                                     ? cpBodyNew(1 / inverse_mass, infinity)
                                     : cpBodyNewStatic();
            cpSpaceAddBody(space_, body);
            cpBodySetPosition(body, vector(scene.bodies.position(k)));
            cpBodySetVelocity(body, vector(scene.bodies.velocity(k)));
            bodies_.push_back(body);
            if (from.collides)
                add(cpCircleShapeNew(body, scene.radius[k], cpvzero));
        }
        for (const Link& link : scene.links) {
            cpConstraint* const pin = cpPinJointNew(
                bodies_[static_cast<std::size_t>(link.a)],
                bodies_[static_cast<std::size_t>(link.b)], cpvzero, cpvzero);
            cpPinJointSetDist(pin, link.length);
            cpConstraintSetCollideBodies(pin, cpFalse);
            joints_.push_back(cpSpaceAddConstraint(space_, pin));
        }
        if (!from.collides) return;
        const Real reach = wall_reach(scene);
        for (const HalfSpace& wall : scene.walls) {
            // As thick as its radius: nothing falls through a line.
            const Vec2 middle = (wall.offset - reach) * wall.normal,
                       along = reach * perpendicular(wall.normal);
            add(cpSegmentShapeNew(cpSpaceGetStaticBody(space_),
                                  vector(middle - along), vector(middle + along),
                                  reach));
        }
    }

    ~ChipmunkSpace()
    {
        for (cpConstraint* const joint : joints_) {
            cpSpaceRemoveConstraint(space_, joint);
            cpConstraintFree(joint);
        }
        for (cpShape* const shape : shapes_) {
            cpSpaceRemoveShape(space_, shape);
            cpShapeFree(shape);
        }
        for (cpBody* const body : bodies_) {
            cpSpaceRemoveBody(space_, body);
            cpBodyFree(body);
        }
        cpSpaceFree(space_);
    }
    ChipmunkSpace(const ChipmunkSpace&) = delete;
    ChipmunkSpace& operator=(const ChipmunkSpace&) = delete;

    /// One step, or several small ones with one iteration in each, as this book takes them.
    void step(Real h, int substeps)
    {
        cpSpaceSetIterations(space_, substeps == 1 ? 10 : 1);
        for (int k = 0; k < substeps; ++k) cpSpaceStep(space_, h / substeps);
    }

    /// How many bodies that can move are awake.
    int awake() const
    {
        int count = 0;
        for (cpBody* const body : bodies_)
            count += cpBodyGetType(body) == CP_BODY_TYPE_DYNAMIC &&
                     !cpBodyIsSleeping(body);
        return count;
    }

    /// Writes the positions into the scene.
    void poses(DiscScene& scene) const
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            const cpVect p = cpBodyGetPosition(bodies_[k]);
            scene.bodies.position(static_cast<Index>(k)) << p.x, p.y;
        }
    }

private:
    static cpVect vector(const Vec2& v) { return cpv(v.x(), v.y()); }

    void add(cpShape* shape)
    {
        cpShapeSetFriction(shape, 0);
        cpShapeSetElasticity(shape, 0);
        shapes_.push_back(cpSpaceAddShape(space_, shape));
    }

    cpSpace* space_;
    std::vector<cpBody*> bodies_;
    std::vector<cpShape*> shapes_;
    std::vector<cpConstraint*> joints_;
};

}  // namespace rigid
