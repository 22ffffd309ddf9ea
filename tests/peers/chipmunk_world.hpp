/// \file chipmunk_world.hpp
/// A World's bodies, walls and joints (revolute, distance, rope, weld) in Chipmunk 7, where it is installed.
///
/// By its own defaults: ten iterations, a tenth of an error repaid in a sixtieth of a second; sleep after half a second, slop
/// as ours. Its numbers are doubles; Debian builds it with assertions.
#pragma once

#include "tests/peers/poses.hpp"

#include <chipmunk/chipmunk.h>

#include <cmath>
#include <map>

namespace rigid {

class ChipmunkWorld {
public:
    explicit ChipmunkWorld(const World& here, bool sleeps = true, int substeps = 1)
        : space_(cpSpaceNew()), substeps_(substeps)
    {
        cpSpaceSetGravity(space_, vector(here.settings().gravity));
        cpSpaceSetIterations(space_, 10);
        cpSpaceSetCollisionSlop(space_, 5e-3 * here.settings().length);
        cpSpaceSetSleepTimeThreshold(space_, sleeps ? 0.5 : static_cast<cpFloat>(infinity));
        for (const BodyId id : here.bodies()) {
            const bool moves = here.mass(id) < infinity,
                       goes = !here.velocity(id).isZero(0) || here.spin(id) != 0;
            cpBody* const body = cpSpaceAddBody(space_, moves  ? cpBodyNew(here.mass(id), here.inertia(id))
                                                        : goes ? cpBodyNewKinematic()
                                                               : cpBodyNewStatic());
            cpBodySetPosition(body, vector(here.position(id)));
            cpBodySetAngle(body, here.angle(id));
            if (moves || goes) {
                cpBodySetVelocity(body, vector(here.velocity(id)));
                cpBodySetAngularVelocity(body, here.spin(id));
            }
            bodies_.push_back(body);
            known_[id] = body;
            add_shape(body, here, id);
        }
        for (const WallId id : here.walls()) {
            const HalfSpace& wall = here.wall(id);
            const Vec2 middle = (wall.offset - 10) * wall.normal,
                       along = wall_reach * perpendicular(wall.normal);
            add(cpSegmentShapeNew(cpSpaceGetStaticBody(space_), vector(middle - along),
                                  vector(middle + along), 10),
                0.6, 0, 0);
        }
        for (const JointId id : here.joints())
            add_joint(here.joint(id), find(here.body_a(id)), find(here.body_b(id)));
    }
    ~ChipmunkWorld()
    {
        for (cpConstraint* const joint : joints_)
            cpSpaceRemoveConstraint(space_, joint), cpConstraintFree(joint);
        for (cpShape* const shape : shapes_) cpSpaceRemoveShape(space_, shape), cpShapeFree(shape);
        for (cpBody* const body : bodies_) cpSpaceRemoveBody(space_, body), cpBodyFree(body);
        cpSpaceFree(space_);
    }
    ChipmunkWorld(const ChipmunkWorld&) = delete;
    ChipmunkWorld& operator=(const ChipmunkWorld&) = delete;

    void step(Real h)
    {
        for (int k = 0; k < substeps_; ++k) cpSpaceStep(space_, h / substeps_);
    }
    void drive(std::size_t k, const Vec2& velocity, Real spin)
    {
        cpBodySetVelocity(bodies_[k], vector(velocity));
        cpBodySetAngularVelocity(bodies_[k], spin);
    }
    void read(Poses& poses) const
    {
        poses.clear();
        for (cpBody* const body : bodies_) {
            const cpVect p = cpBodyGetPosition(body);
            poses.push_back({p.x, p.y, cpBodyGetAngle(body)});
        }
    }
    void read_velocities(Poses& velocities) const
    {
        velocities.clear();
        for (cpBody* const body : bodies_) {
            const cpVect v = cpBodyGetVelocity(body);
            velocities.push_back({v.x, v.y, cpBodyGetAngularVelocity(body)});
        }
    }

private:
    static cpVect vector(const Vec2& v) { return cpv(v.x(), v.y()); }
    cpBody* find(BodyId id) const
    {
        const auto found = known_.find(id);
        return found == known_.end() ? cpSpaceGetStaticBody(space_) : found->second;
    }
    void add_joint(const RigidJoint& joint, cpBody* a, cpBody* b)
    {
        const cpVect at_a = vector(joint.at_a), at_b = vector(joint.at_b);
        if (joint.kind == JointKind::distance) {
            cpConstraint* const rod = cpPinJointNew(a, b, at_a, at_b);
            cpPinJointSetDist(rod, joint.length);
            add(rod);
        } else if (joint.kind == JointKind::rope) add(cpSlideJointNew(a, b, at_a, at_b, 0, joint.length));
        else if (joint.kind == JointKind::revolute || joint.kind == JointKind::weld)
            add(cpPivotJointNew2(a, b, at_a, at_b));
        else refuse(joint.kind, "Chipmunk");
        if (joint.kind == JointKind::weld) add(cpGearJointNew(a, b, joint.angle, 1));
        if (joint.lower > -infinity)
            add(cpRotaryLimitJointNew(a, b, joint.lower + joint.angle, joint.upper + joint.angle));
        if (joint.motor.force > 0) {
            cpConstraint* const motor = cpSimpleMotorNew(a, b, joint.motor.speed);
            cpConstraintSetMaxForce(motor, joint.motor.force);
            add(motor);
        }
    }
    void add_shape(cpBody* body, const World& here, BodyId id)
    {
        const Polygon& shape = here.shape(id);
        const Surface& surface = here.surface(id);
        std::vector<cpVect> points;
        for (const Vec2& v : shape.vertices) points.push_back(vector(v));
        cpShape* const made = points.size() == 1 ? cpCircleShapeNew(body, shape.radius, points[0])
                              : points.size() == 2
                                  ? cpSegmentShapeNew(body, points[0], points[1], shape.radius)
                                  : cpPolyShapeNew(body, static_cast<int>(points.size()), points.data(),
                                                   cpTransformIdentity, shape.radius);
        add(made, surface.friction, surface.restitution, here.filter(id).group);
    }
    /// Of two it takes the product: each has the root. (Of two that bounce differently we take the larger e.)
    void add(cpShape* shape, Real mu, Real restitution, int group)
    {
        cpShapeSetFriction(shape, std::sqrt(mu));
        cpShapeSetElasticity(shape, std::sqrt(restitution));
        if (group < 0)
            cpShapeSetFilter(
                shape, cpShapeFilterNew(static_cast<cpGroup>(-group), CP_ALL_CATEGORIES, CP_ALL_CATEGORIES));
        shapes_.push_back(cpSpaceAddShape(space_, shape));
    }
    void add(cpConstraint* joint)
    {
        cpConstraintSetCollideBodies(joint, cpFalse);
        joints_.push_back(cpSpaceAddConstraint(space_, joint));
    }

    cpSpace* space_;
    int substeps_;
    std::vector<cpBody*> bodies_;
    std::map<BodyId, cpBody*> known_;
    std::vector<cpShape*> shapes_;
    std::vector<cpConstraint*> joints_;
};

}  // namespace rigid
