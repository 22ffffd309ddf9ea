/// \file peer_jolt.hpp
/// A scene of solids in Jolt, where find_package(Jolt) finds it: balls, boxes and capsules on boxes for walls, ball joints
/// and hinges with limits, by its public interface alone. In floats, on one thread; no sleep, no damping.
#pragma once

#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "chapters/25_world_in_space/benchmark/jolt_world.hpp"
#include "chapters/25_world_in_space/benchmark/peer_shapes.hpp"

namespace rigid {

class JoltPeer {
public:
    JoltPeer(const SpaceScene& here, int substeps, int iterations)
        : count_(static_cast<std::size_t>(here.bodies.count())),
          world_(bodies_of(here), joints_of(here), numbers(here.gravity), substeps,
                 iterations)
    {
    }
    void step(Real h) { world_.step(h); }
    void read(VecX& x, VecX& u) const
    {
        for (std::size_t k = 0; k < count_; ++k) {
            const JoltBody b = world_.state(k);
            const Vec3 v(b.turn[0], b.turn[1], b.turn[2]);
            // in floats it is a unit quaternion to 1e-7
            const Real length = std::sqrt(v.squaredNorm() + b.turn[3] * b.turn[3]);
            const Quaternion q{b.turn[3] / length, v / length};
            const Vec3 spin = rotation_matrix(q).transpose() *
                              Vec3(b.spin[0], b.spin[1], b.spin[2]);
            const Index i = 6 * static_cast<Index>(k);
            x.segment<6>(i) << b.at[0], b.at[1], b.at[2], rotation_vector(q);
            u.segment<6>(i) << b.v[0], b.v[1], b.v[2], spin;
        }
    }

private:
    static std::array<double, 3> numbers(const Vec3& v)
    {
        return {v.x(), v.y(), v.z()};
    }
    static std::array<double, 4> numbers(const Quaternion& q)
    {
        return {q.v.x(), q.v.y(), q.v.z(), q.w};
    }
    static std::vector<JoltBody> bodies_of(const SpaceScene& here)
    {
        std::vector<JoltBody> all;
        for (Index k = 0; k < here.bodies.count(); ++k) {
            const auto i = static_cast<std::size_t>(k);
            const SimpleSolid solid = simple_solid(here.shapes[i]);
            JoltBody body;
            body.kind = solid.kind == SimpleSolid::ball      ? JoltBody::ball
                        : solid.kind == SimpleSolid::capsule ? JoltBody::capsule
                                                             : JoltBody::box;
            body.size = numbers(solid.size);
            body.radius = solid.radius;
            body.friction = here.friction[i];
            body.at = numbers(centre_of(here.bodies.x, k));
            body.turn =
                numbers(quaternion_of(Vec3(here.bodies.x.segment<3>(6 * k + 3))));
            if (here.bodies.can_move(k)) {
                body.v = numbers(Vec3(here.bodies.u.segment<3>(6 * k)));
                body.spin = numbers(world_spin(here.bodies, k));
                body.mass = 1 / here.bodies.inverse_mass[6 * k];
                body.inertia = numbers(Vec3(
                    here.bodies.inverse_mass.segment<3>(6 * k + 3).cwiseInverse()));
            }
            all.push_back(body);
        }
        for (std::size_t w = 0; w < here.walls.size(); ++w) {
            // a box of 40 × 20 × 40 m whose upper side is the wall
            const Vec3 n = here.walls[w].normal;
            JoltBody wall;
            wall.size = {40, 20, 40};
            wall.friction = here.wall_friction[w];
            wall.at = numbers(Vec3((here.walls[w].offset - 10) * n));
            wall.turn = numbers(quaternion_of(frame_along(n)) *
                                quaternion_of(Vec3(0, 0, -pi / 2)));
            all.push_back(wall);
        }
        return all;
    }
    static std::vector<JoltJoint> joints_of(const SpaceScene& here)
    {
        std::vector<JoltJoint> all;
        for (const SpaceJoint& joint : here.joints) {
            JoltJoint it;
            it.a = static_cast<int>(joint.a), it.b = static_cast<int>(joint.b);
            it.at_a = numbers(joint.at_a), it.at_b = numbers(joint.at_b);
            it.frame_a = numbers(quaternion_of(joint.frame_a));
            it.frame_b = numbers(quaternion_of(joint.frame_b));
            it.is_hinge = joint.locked(swing_y);
            it.lo = joint.lo[twist], it.hi = joint.hi[twist];
            it.cone = joint.hi[cone];
            it.is_bounded = std::isfinite(it.hi) || std::isfinite(it.cone);
            all.push_back(it);
        }
        return all;
    }

    std::size_t count_;
    JoltWorld world_;
};

}  // namespace rigid
