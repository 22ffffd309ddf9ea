/// \file peers_chipmunk.hpp
/// Bodies on pivot joints as a space of Chipmunk 7, where the library is installed.
///
/// Bodies with shapes touch each other if they are of different groups; sleep is off. A tenth of an error is repaid in a sixtieth of a second, its own choice. Its
/// numbers are doubles. Debian builds it with its assertions on.
#pragma once

#include "chapters/14_joints/joint.hpp"

#include <chipmunk/chipmunk.h>

#include <cmath>
#include <vector>

namespace rigid {

class ChipmunkJoints {
public:
    /// \param group  of each body: those of one do not touch each other; 0 = it is in none. Empty: nothing touches.
    ChipmunkJoints(const JointedScene& scene, int iterations,
                   const std::vector<int>& group = {})
        : space_(cpSpaceNew())
    {
        cpSpaceSetGravity(space_, vector(scene.gravity));
        cpSpaceSetDamping(space_, 1);  // what is left of a velocity after a second
        cpSpaceSetIterations(space_, iterations);
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Vec<3> x = scene.bodies.position(k), u = scene.bodies.velocity(k),
                         m = scene.bodies.inverse_mass.segment<3>(3 * k);
            cpBody* const body =
                cpSpaceAddBody(space_, m.isZero(0) ? cpBodyNewStatic()
                                                   : cpBodyNew(1 / m[0], 1 / m[2]));
            cpBodySetPosition(body, vector(x.head<2>()));
            cpBodySetAngle(body, x[2]);
            cpBodySetVelocity(body, vector(u.head<2>()));
            cpBodySetAngularVelocity(body, u[2]);
            bodies_.push_back(body);
            const auto i = static_cast<std::size_t>(k);
            if (!group.empty()) add_shape(body, scene.shapes[i], group[i]);
        }
        cpBody* const ground = cpSpaceGetStaticBody(space_);
        for (const HalfSpace& wall : scene.walls) {
            const Vec2 middle = (wall.offset - 10) * wall.normal,
                       along = 200 * perpendicular(wall.normal);
            if (!group.empty())
                add(cpSegmentShapeNew(ground, vector(middle - along),
                                      vector(middle + along), 10),
                    0);
        }
        for (const PlacedJoint& placed : scene.placed) {
            cpBody* const a = placed.joint.a == world ? cpSpaceGetStaticBody(space_)
                                                      : at(placed.joint.a);
            joints_.push_back(cpSpaceAddConstraint(
                space_,
                cpPivotJointNew2(a, at(placed.joint.b), vector(placed.joint.at_a),
                                 vector(placed.joint.at_b))));
            const RigidJoint& joint = placed.joint;
            if (joint.lower > -infinity)
                joints_.push_back(cpSpaceAddConstraint(
                    space_,
                    cpRotaryLimitJointNew(a, at(joint.b), joint.angle + joint.lower,
                                          joint.angle + joint.upper)));
            if (joint.motor.force > 0) {
                joints_.push_back(cpSpaceAddConstraint(
                    space_, cpSimpleMotorNew(a, at(joint.b), 0)));
                cpConstraintSetMaxForce(joints_.back(), joint.motor.force);
            }
        }
    }
    ~ChipmunkJoints()
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
    ChipmunkJoints(const ChipmunkJoints&) = delete;
    ChipmunkJoints& operator=(const ChipmunkJoints&) = delete;

    void step(Real h) { cpSpaceStep(space_, h); }

    /// Writes positions and velocities into the scene.
    void read(JointedScene& scene) const
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            const cpVect p = cpBodyGetPosition(bodies_[k]),
                         v = cpBodyGetVelocity(bodies_[k]);
            const auto i = static_cast<Index>(k);
            scene.bodies.position(i) << p.x, p.y, cpBodyGetAngle(bodies_[k]);
            scene.bodies.velocity(i) << v.x, v.y,
                cpBodyGetAngularVelocity(bodies_[k]);
        }
    }

private:
    static cpVect vector(const Vec2& v) { return cpv(v.x(), v.y()); }
    cpBody* at(Index k) const { return bodies_[static_cast<std::size_t>(k)]; }

    void add(cpShape* shape, int group)
    {
        cpShapeSetFriction(shape, std::sqrt(0.6));  // of two it takes the product
        cpShapeSetFilter(shape,
                         cpShapeFilterNew(static_cast<cpGroup>(group),
                                          CP_ALL_CATEGORIES, CP_ALL_CATEGORIES));
        shapes_.push_back(cpSpaceAddShape(space_, shape));
    }
    void add_shape(cpBody* body, const Polygon& shape, int group)
    {
        std::vector<cpVect> corners;
        for (const Vec2& v : shape.vertices) corners.push_back(vector(v));
        if (corners.size() == 1)
            add(cpCircleShapeNew(body, shape.radius, corners[0]), group);
        else if (corners.size() == 2)
            add(cpSegmentShapeNew(body, corners[0], corners[1], shape.radius),
                group);
        else
            add(cpPolyShapeNewRaw(body, static_cast<int>(corners.size()),
                                  corners.data(), shape.radius),
                group);
    }

    cpSpace* space_;
    std::vector<cpBody*> bodies_;
    std::vector<cpConstraint*> joints_;
    std::vector<cpShape*> shapes_;
};

}  // namespace rigid
