/// \file peer_ode.hpp
/// A scene of the ways in ODE: impulses, all at once, by its exact step, its own defaults.
#pragma once

#include "chapters/26_four_ways/benchmark/peer_bodies.hpp"

#include <ode/ode.h>

#include <cmath>

namespace rigid {

/// ODE keeps what it needs for all worlds in one place.
class OdeWays {
public:
    static constexpr const char* name = "ODE";

    explicit OdeWays(const WayScene& way) : given_(way.scene)
    {
        dInitODE2(0);
        world_ = dWorldCreate();
        space_ = dHashSpaceCreate(nullptr);
        contacts_ = dJointGroupCreate(0);
        const JointedScene& scene = way.scene;
        dWorldSetGravity(world_, scene.gravity.x(), scene.gravity.y(), 0);
        for (const HalfSpace& wall : scene.walls)
            dCreatePlane(space_, wall.normal.x(), wall.normal.y(), 0,
                         wall.offset - stands_back(scene));
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const dBodyID body = dBodyCreate(world_);
            const Real I = inertia_of_body(scene, k);
            dMass mass;
            dMassSetParameters(&mass, mass_of_body(scene, k), 0, 0, 0, I, I, I, 0,
                               0, 0);
            dBodySetMass(body, &mass);
            const Vec<3> x = scene.bodies.position(k), u = scene.bodies.velocity(k);
            const dQuaternion turned = {cos(x[2] / 2), 0, 0, sin(x[2] / 2)};
            dBodySetPosition(body, x[0], x[1], 0);
            dBodySetQuaternion(body, turned);
            dBodySetLinearVel(body, u[0], u[1], 0);
            dBodySetAngularVel(body, 0, 0, u[2]);
            bodies_.push_back(body);
            if (!meets_something(scene)) continue;
            const Polygon& shape = scene.shapes[static_cast<std::size_t>(k)];
            const dGeomID geometry = geometry_of(shape);
            dGeomSetBody(geometry, body);
            if (!is_capsule(shape)) continue;
            const dQuaternion along_x = {std::sqrt(0.5), 0, std::sqrt(0.5), 0};
            dGeomSetOffsetQuaternion(geometry, along_x);  // it is made along z
        }
        for (const PlacedJoint& placed : scene.placed) {
            const RigidJoint& joint = placed.joint;
            const dBodyID a = joint.a == world
                                  ? nullptr
                                  : bodies_[static_cast<std::size_t>(joint.a)],
                          b = bodies_[static_cast<std::size_t>(joint.b)];
            if (joint.kind == JointKind::prismatic) {
                const dJointID slider = dJointCreateSlider(world_, nullptr);
                dJointAttach(slider, b, a);
                dJointSetSliderAxis(slider, joint.axis.x(), joint.axis.y(), 0);
                continue;
            }
            const Vec2 p = point_of(scene.bodies.x, joint.b, joint.at_b);
            const dJointID hinge = dJointCreateHinge(world_, nullptr);
            dJointAttach(hinge, b, a);
            dJointSetHingeAnchor(hinge, p.x(), p.y(), 0);
            dJointSetHingeAxis(hinge, 0, 0, 1);
            if (!is_limited(joint)) continue;
            const Real now = coordinate(scene.bodies.x, joint);  // its zero
            dJointSetHingeParam(hinge, dParamLoStop, joint.lower - now);
            dJointSetHingeParam(hinge, dParamHiStop, joint.upper - now);
        }
    }
    ~OdeWays()
    {
        dJointGroupDestroy(contacts_);
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
        dCloseODE();
    }
    OdeWays(const OdeWays&) = delete;
    OdeWays& operator=(const OdeWays&) = delete;

    static bool can_take(const WayScene&) { return true; }
    void step(Real h)
    {
        dSpaceCollide(space_, this, &OdeWays::near);
        dWorldStep(world_, h);
        dJointGroupEmpty(contacts_);
    }
    void read(JointedScene& scene) const
    {
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const dBodyID body = bodies_[static_cast<std::size_t>(k)];
            const dReal* const p = dBodyGetPosition(body);
            const dReal* const q = dBodyGetQuaternion(body);
            const dReal* const v = dBodyGetLinearVel(body);
            scene.bodies.position(k) << p[0], p[1],
                std::remainder(2 * atan2(q[3], q[0]), 2 * pi);
            scene.bodies.velocity(k) << v[0], v[1], dBodyGetAngularVel(body)[2];
        }
    }

private:
    dGeomID geometry_of(const Polygon& shape) const
    {
        if (is_disc(shape)) return dCreateSphere(space_, shape.radius);
        if (is_capsule(shape))
            return dCreateCapsule(space_, radius_of(shape), length_of(shape));
        const Vec2 half = half_sides(shape);
        return dCreateBox(space_, 2 * half.x(), 2 * half.y(), 1);
    }
    static void near(void* data, dGeomID a, dGeomID b)
    {
        auto& self = *static_cast<OdeWays*>(data);
        const int bodies = (dGeomGetBody(a) ? 1 : 0) + (dGeomGetBody(b) ? 1 : 0);
        if (bodies == 0 || (bodies == 2 && !meet_each_other(self.given_))) return;
        std::array<dContactGeom, 8> points;
        const int count = dCollide(a, b, 8, points.data(), sizeof(dContactGeom));
        const Surface& surface = self.given_.surfaces.front();
        for (int i = 0; i < count; ++i) {
            dContact contact = {};
            contact.surface.mode = dContactApprox1;  // μ times the normal force
            contact.surface.mu = surface.friction;
            if (surface.restitution > 0) {
                contact.surface.mode |= dContactBounce;
                contact.surface.bounce = surface.restitution;
            }
            contact.geom = points[static_cast<std::size_t>(i)];
            dJointAttach(dJointCreateContact(self.world_, self.contacts_, &contact),
                         dGeomGetBody(a), dGeomGetBody(b));
        }
    }

    JointedScene given_;
    dWorldID world_{};
    dSpaceID space_{};
    dJointGroupID contacts_{};
    std::vector<dBodyID> bodies_;
};

}  // namespace rigid
