/// \file peers_chipmunk.hpp
/// Bodies on pivot joints as a space of Chipmunk 7, where the library is installed.
///
/// Nothing touches anything; sleep is off. A tenth of an error is repaid in a sixtieth of a second, its own choice. Its
/// numbers are doubles. Debian builds it with its assertions on.
#pragma once

#include "chapters/14_joints/joint.hpp"

#include <chipmunk/chipmunk.h>

#include <vector>

namespace rigid {

class ChipmunkJoints {
public:
    ChipmunkJoints(const JointedScene& scene, int iterations) : space_(cpSpaceNew())
    {
        cpSpaceSetGravity(space_, vector(scene.gravity));
        cpSpaceSetDamping(space_, 1);  // what is left of a velocity after a second
        cpSpaceSetIterations(space_, iterations);
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Vec<3> x = scene.bodies.position(k), u = scene.bodies.velocity(k),
                         m = scene.bodies.inverse_mass.segment<3>(3 * k);
            cpBody* const body =
                cpSpaceAddBody(space_, cpBodyNew(1 / m[0], 1 / m[2]));
            cpBodySetPosition(body, vector(x.head<2>()));
            cpBodySetAngle(body, x[2]);
            cpBodySetVelocity(body, vector(u.head<2>()));
            cpBodySetAngularVelocity(body, u[2]);
            bodies_.push_back(body);
        }
        for (const PlacedJoint& placed : scene.placed) {
            cpBody* const a = placed.joint.a == world ? cpSpaceGetStaticBody(space_)
                                                      : at(placed.joint.a);
            joints_.push_back(cpSpaceAddConstraint(
                space_,
                cpPivotJointNew2(a, at(placed.joint.b), vector(placed.joint.at_a),
                                 vector(placed.joint.at_b))));
        }
    }
    ~ChipmunkJoints()
    {
        for (cpConstraint* const joint : joints_) {
            cpSpaceRemoveConstraint(space_, joint);
            cpConstraintFree(joint);
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

    cpSpace* space_;
    std::vector<cpBody*> bodies_;
    std::vector<cpConstraint*> joints_;
};

}  // namespace rigid
