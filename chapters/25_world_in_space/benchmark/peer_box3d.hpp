/// \file peer_box3d.hpp
/// A scene of solids in Box3D, where find_package(box3d) finds it: balls, boxes and capsules on boxes for walls, ball
/// joints and hinges with limits, by its public interface alone. Its own defaults and sub-steps, in floats, on one thread;
/// no sleep.
#pragma once

#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "chapters/25_world_in_space/benchmark/peer_shapes.hpp"

#include <box3d/box3d.h>

#include <vector>

namespace rigid {

class Box3dWorld {
public:
    Box3dWorld(const SpaceScene& here, int substeps, int /*iterations*/)
        : substeps_(substeps)
    {
        b3WorldDef def = b3DefaultWorldDef();
        def.gravity = vector(here.gravity);
        def.enableSleep = false;
        def.workerCount = 1;
        world_ = b3CreateWorld(&def);
        for (std::size_t w = 0; w < here.walls.size(); ++w) {
            const Vec3 n = here.walls[w].normal;
            // a box of 40 × 20 × 40 m whose upper side is the wall
            const Quaternion q =
                quaternion_of(frame_along(n)) * quaternion_of(Vec3(0, 0, -pi / 2));
            add(b3_staticBody, (here.walls[w].offset - 10) * n, q,
                {SimpleSolid::box, {40, 20, 40}, 0}, here.wall_friction[w]);
        }
        for (Index k = 0; k < here.bodies.count(); ++k) {
            const bool moves = here.bodies.can_move(k);
            const b3BodyId body = add(
                moves ? b3_dynamicBody : b3_staticBody, centre_of(here.bodies.x, k),
                quaternion_of(Vec3(here.bodies.x.segment<3>(6 * k + 3))),
                simple_solid(here.shapes[static_cast<std::size_t>(k)]),
                here.friction[static_cast<std::size_t>(k)]);
            bodies_.push_back(body);
            if (!moves) continue;
            const Vec3 I =
                here.bodies.inverse_mass.segment<3>(6 * k + 3).cwiseInverse();
            b3MassData mass = {};
            mass.mass = static_cast<float>(1 / here.bodies.inverse_mass[6 * k]);
            mass.inertia.cx = vector({I.x(), 0, 0});
            mass.inertia.cy = vector({0, I.y(), 0});
            mass.inertia.cz = vector({0, 0, I.z()});
            b3Body_SetMassData(body, mass);
            b3Body_SetLinearVelocity(body, vector(here.bodies.u.segment<3>(6 * k)));
            b3Body_SetAngularVelocity(body, vector(world_spin(here.bodies, k)));
        }
        for (const SpaceJoint& joint : here.joints) add_joint(joint);
    }
    ~Box3dWorld() { b3DestroyWorld(world_); }
    Box3dWorld(const Box3dWorld&) = delete;
    Box3dWorld& operator=(const Box3dWorld&) = delete;

    void step(Real h) { b3World_Step(world_, static_cast<float>(h), substeps_); }
    void read(VecX& x, VecX& u) const
    {
        for (std::size_t k = 0; k < bodies_.size(); ++k) {
            const b3Pos p = b3Body_GetPosition(bodies_[k]);
            const b3Quat r = b3Body_GetRotation(bodies_[k]);
            const b3Vec3 v = b3Body_GetLinearVelocity(bodies_[k]),
                         w = b3Body_GetAngularVelocity(bodies_[k]);
            // in floats it is a unit quaternion to 1e-7
            const Real length =
                std::sqrt(Real{r.s} * r.s + Real{r.v.x} * r.v.x +
                          Real{r.v.y} * r.v.y + Real{r.v.z} * r.v.z);
            const Quaternion q{r.s / length, Vec3(r.v.x, r.v.y, r.v.z) / length};
            const Vec3 spin = rotation_matrix(q).transpose() * Vec3(w.x, w.y, w.z);
            const Index i = 6 * static_cast<Index>(k);
            x.segment<6>(i) << p.x, p.y, p.z, rotation_vector(q);
            u.segment<6>(i) << v.x, v.y, v.z, spin;
        }
    }

private:
    static b3Vec3 vector(const Vec3& v)
    {
        return {static_cast<float>(v.x()), static_cast<float>(v.y()),
                static_cast<float>(v.z())};
    }
    static b3Quat quaternion(const Quaternion& q)
    {
        return {vector(q.v), static_cast<float>(q.w)};
    }
    b3BodyId add(b3BodyType type, const Vec3& at, const Quaternion& q,
                 const SimpleSolid& solid, Real friction)
    {
        b3BodyDef def = b3DefaultBodyDef();
        def.type = type;
        def.position = b3ToPos(vector(at));
        def.rotation = quaternion(q);
        const b3BodyId body = b3CreateBody(world_, &def);
        b3ShapeDef shape = b3DefaultShapeDef();
        shape.baseMaterial.friction = static_cast<float>(friction);
        const auto radius = static_cast<float>(solid.radius);
        const Vec3 half = solid.size / 2;
        if (solid.kind == SimpleSolid::ball) {
            const b3Sphere ball = {{0, 0, 0}, radius};
            b3CreateSphereShape(body, &shape, &ball);
        } else if (solid.kind == SimpleSolid::capsule) {
            const b3Capsule capsule = {vector({-half.x(), 0, 0}),
                                       vector({half.x(), 0, 0}), radius};
            b3CreateCapsuleShape(body, &shape, &capsule);
        } else {
            const b3Vec3 size = vector(half);
            const b3BoxHull box = b3MakeBoxHull(size.x, size.y, size.z);
            b3CreateHullShape(body, &shape, &box.base);
        }
        return body;
    }
    /// Its joints turn about z, those of the book about x.
    static b3Transform frame(const Vec3& at, const Vec3& theta)
    {
        return {vector(at), quaternion(quaternion_of(theta) *
                                       quaternion_of(Vec3(0, pi / 2, 0)))};
    }
    void add_joint(const SpaceJoint& joint)
    {
        const bool turns = joint.locked(swing_y);
        b3RevoluteJointDef hinge_def = b3DefaultRevoluteJointDef();
        b3SphericalJointDef ball = b3DefaultSphericalJointDef();
        b3JointDef base = turns ? hinge_def.base : ball.base;
        base.bodyIdB = bodies_[static_cast<std::size_t>(joint.b)];
        if (joint.a == world) {
            b3BodyDef def = b3DefaultBodyDef();
            base.bodyIdA = b3CreateBody(world_, &def);
        } else {
            base.bodyIdA = bodies_[static_cast<std::size_t>(joint.a)];
        }
        base.localFrameA = frame(joint.at_a, joint.frame_a);
        base.localFrameB = frame(joint.at_b, joint.frame_b);
        const auto lo = static_cast<float>(joint.lo[twist]),
                   hi = static_cast<float>(joint.hi[twist]);
        if (turns) {
            hinge_def.base = base;
            hinge_def.enableLimit = std::isfinite(hi);
            if (hinge_def.enableLimit)
                hinge_def.lowerAngle = lo, hinge_def.upperAngle = hi;
            b3CreateRevoluteJoint(world_, &hinge_def);
            return;
        }
        ball.base = base;
        ball.enableConeLimit = std::isfinite(joint.hi[cone]);
        if (ball.enableConeLimit)
            ball.coneAngle = static_cast<float>(joint.hi[cone]);
        ball.enableTwistLimit = std::isfinite(hi);
        if (ball.enableTwistLimit)
            ball.lowerTwistAngle = lo, ball.upperTwistAngle = hi;
        b3CreateSphericalJoint(world_, &ball);
    }

    b3WorldId world_{};
    int substeps_;
    std::vector<b3BodyId> bodies_;
};

}  // namespace rigid
