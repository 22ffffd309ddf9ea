/// \file peer_ode.hpp
/// A scene of solids in ODE, where it is installed: balls, boxes and capsules on walls, by its public interface alone.
/// Its quick step, or its exact one. Its own defaults, but for the iterations, the sub-steps, and no sleep.
#pragma once

#include "chapters/25_world_in_space/benchmark/peer_shapes.hpp"

#include <ode/ode.h>

#include <array>

namespace rigid {

/// ODE keeps what it needs for all worlds in one place.
class OdeLibrary {
public:
    OdeLibrary() { dInitODE2(0); }
    ~OdeLibrary() { dCloseODE(); }
    OdeLibrary(const OdeLibrary&) = delete;
    OdeLibrary& operator=(const OdeLibrary&) = delete;
};

class OdeWorld {
public:
    /// \param iterations  of the quick step; 0: the exact step
    OdeWorld(const SpaceScene& here, int substeps, int iterations)
        : mu_(here.friction.front()), substeps_(substeps), iterations_(iterations)
    {
        dWorldSetGravity(world_, here.gravity.x(), here.gravity.y(),
                         here.gravity.z());
        if (iterations > 0) dWorldSetQuickStepNumIterations(world_, iterations);
        for (const SolidWall& wall : here.walls)
            dCreatePlane(space_, wall.normal.x(), wall.normal.y(), wall.normal.z(),
                         wall.offset);
        for (Index k = 0; k < here.bodies.count(); ++k) {
            const SimpleSolid solid =
                simple_solid(here.shapes[static_cast<std::size_t>(k)]);
            const bool moves = here.bodies.can_move(k);
            const dBodyID body = dBodyCreate(world_);
            dGeomID geom = nullptr;
            if (solid.kind == SimpleSolid::ball)
                geom = dCreateSphere(space_, solid.radius);
            else if (solid.kind == SimpleSolid::capsule)
                geom = dCreateCapsule(space_, solid.radius, solid.size.x());
            else
                geom = dCreateBox(space_, solid.size.x(), solid.size.y(),
                                  solid.size.z());
            dGeomSetBody(geom, body);
            if (solid.kind == SimpleSolid::capsule) {
                // its capsules lie along z
                dMatrix3 turn;
                dRFromAxisAndAngle(turn, 0, 1, 0, pi / 2);
                dGeomSetOffsetRotation(geom, turn);
            }
            const Vec3 I =
                here.bodies.inverse_mass.segment<3>(6 * k + 3).cwiseInverse();
            dMass mass;
            if (moves) {
                dMassSetParameters(&mass, 1 / here.bodies.inverse_mass[6 * k], 0, 0,
                                   0, I.x(), I.y(), I.z(), 0, 0, 0);
                dBodySetMass(body, &mass);
            } else {
                dBodySetKinematic(body);
            }
            const Vec3 at = centre_of(here.bodies.x, k),
                       v = here.bodies.u.segment<3>(6 * k),
                       spin = world_spin(here.bodies, k);
            const Quaternion q = quaternion_of(here.bodies.x.segment<3>(6 * k + 3));
            const dQuaternion turned = {q.w, q.v.x(), q.v.y(), q.v.z()};
            dBodySetPosition(body, at.x(), at.y(), at.z());
            dBodySetQuaternion(body, turned);
            dBodySetLinearVel(body, v.x(), v.y(), v.z());
            dBodySetAngularVel(body, spin.x(), spin.y(), spin.z());
            bodies_.push_back(body);
        }
        for (const SpaceJoint& joint : here.joints) add_joint(here, joint);
    }
    ~OdeWorld()
    {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
    }
    OdeWorld(const OdeWorld&) = delete;
    OdeWorld& operator=(const OdeWorld&) = delete;

    void step(Real h)
    {
        for (int k = 0; k < substeps_; ++k) {
            dSpaceCollide(space_, this, &near);
            if (iterations_ > 0) dWorldQuickStep(world_, h / substeps_);
            else dWorldStep(world_, h / substeps_);
            dJointGroupEmpty(contacts_);
        }
    }
    void read(VecX& x, VecX& u) const
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            const dReal* const at = dBodyGetPosition(bodies_[k]);
            const dReal* const q = dBodyGetQuaternion(bodies_[k]);
            x.segment<6>(6 * static_cast<Index>(k)) << at[0], at[1], at[2],
                rotation_vector({q[0], {q[1], q[2], q[3]}});
            const dReal* const v = dBodyGetLinearVel(bodies_[k]);
            const dReal* const w = dBodyGetAngularVel(bodies_[k]);
            const Vec3 spin =
                rotation_matrix(Quaternion{q[0], {q[1], q[2], q[3]}}).transpose() *
                Vec3(w[0], w[1], w[2]);
            u.segment<6>(6 * static_cast<Index>(k)) << v[0], v[1], v[2], spin;
        }
    }

private:
    /// Hinges with stops, and ball joints, which have no limits here: it knows those by
    /// Euler angles alone.
    void add_joint(const SpaceScene& here, const SpaceJoint& joint)
    {
        const bool turns = joint.locked(swing_y);
        const dJointID made = turns ? dJointCreateHinge(world_, nullptr)
                                    : dJointCreateBall(world_, nullptr);
        // its angle is that of its first body against its second
        dJointAttach(made, bodies_[static_cast<std::size_t>(joint.b)],
                     joint.a == world ? nullptr
                                      : bodies_[static_cast<std::size_t>(joint.a)]);
        const Vec3 p = point_of_solid(here.bodies.x, joint.b, joint.at_b);
        if (!turns) {
            dJointSetBallAnchor(made, p.x(), p.y(), p.z());
            return;
        }
        const Vec3 n = rotation_of(here.bodies.x, joint.b) *
                       rotation_matrix(joint.frame_b) * Vec3(1, 0, 0);
        dJointSetHingeAnchor(made, p.x(), p.y(), p.z());
        dJointSetHingeAxis(made, n.x(), n.y(), n.z());
        if (!std::isfinite(joint.hi[twist])) return;
        dJointSetHingeParam(made, dParamLoStop, joint.lo[twist]);
        dJointSetHingeParam(made, dParamHiStop, joint.hi[twist]);
    }
    static void near(void* data, dGeomID a, dGeomID b)
    {
        auto& self = *static_cast<OdeWorld*>(data);
        const dBodyID p = dGeomGetBody(a), q = dGeomGetBody(b);
        const auto rests = [](dBodyID body) {
            return body == nullptr || dBodyIsKinematic(body) != 0;
        };
        if ((rests(p) && rests(q)) ||
            (p != nullptr && q != nullptr && dAreConnected(p, q) != 0))
            return;
        std::array<dContactGeom, 8> points;
        const int count = dCollide(a, b, 8, points.data(), sizeof(dContactGeom));
        for (int i = 0; i < count; ++i) {
            dContact contact = {};
            contact.surface.mode = dContactApprox1;  // μ times the normal force
            contact.surface.mu = self.mu_;
            contact.geom = points[static_cast<std::size_t>(i)];
            dJointAttach(dJointCreateContact(self.world_, self.contacts_, &contact),
                         dGeomGetBody(a), dGeomGetBody(b));
        }
    }

    OdeLibrary library_;
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    dJointGroupID contacts_ = dJointGroupCreate(0);
    Real mu_;
    int substeps_, iterations_;
    std::vector<dBodyID> bodies_;
};

}  // namespace rigid
