/// \file space_text.hpp
/// A scene of solids as JSON: all that another engine needs to build the same one, as peer_jolt.hpp tells it natively.
///
///     {"bodies": [{"kind": "ball" | "capsule" | "box", "size": [edges; a capsule: its length along x], "radius": r,
///                  "friction": μ, "at": […], "turn": [x, y, z, w], "v": […], "spin": […] in the world's axes,
///                  "mass": m or null, "inertia": […] about its own axes}, …],
///      "walls": [boxes of 40 × 20 × 40 m whose upper sides are the walls, in the same form],
///      "joints": [{"a": −1 or a body, "b": a body, "at_a": […], "at_b": […], "frame_a": [x, y, z, w], "frame_b": […],
///                  "hinge": true, "twist": [lo, hi] or null, "cone": angle}, …],
///      "gravity": […]}
#pragma once

#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "chapters/25_world_in_space/benchmark/peer_shapes.hpp"
#include "docs/race/texts.hpp"

namespace rigid::race {

inline std::string text_of(const Vec3& v) { return list({v.x(), v.y(), v.z()}); }
inline std::string text_of(const Quaternion& q) { return list({q.v.x(), q.v.y(), q.v.z(), q.w}); }

inline std::string body_text(const SpaceScene& scene, Index k)
{
    const auto i = static_cast<std::size_t>(k);
    const char* const kinds[] = {"ball", "capsule", "box"};
    const SimpleSolid solid = simple_solid(scene.shapes[i]);
    const Bodies<6>& bodies = scene.bodies;
    std::string text = "{\"kind\":" + json(kinds[solid.kind]) + ",\"size\":" + text_of(solid.size) +
                       ",\"radius\":" + number(solid.radius) + ",\"friction\":" + number(scene.friction[i]) +
                       ",\"at\":" + text_of(Vec3(centre_of(bodies.x, k))) +
                       ",\"turn\":" + text_of(quaternion_of(Vec3(bodies.x.segment<3>(6 * k + 3))));
    if (!bodies.can_move(k)) return text + ",\"mass\":null}";
    return text + ",\"v\":" + text_of(Vec3(bodies.u.segment<3>(6 * k))) +
           ",\"spin\":" + text_of(Vec3(world_spin(bodies, k))) +
           ",\"mass\":" + number(1 / bodies.inverse_mass[6 * k]) +
           ",\"inertia\":" + text_of(Vec3(bodies.inverse_mass.segment<3>(6 * k + 3).cwiseInverse())) + '}';
}

inline std::string space_text(const SpaceScene& scene)
{
    Listed bodies, walls, joints;
    for (Index k = 0; k < scene.bodies.count(); ++k) bodies.add(body_text(scene, k));
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
        const Vec3 n = scene.walls[w].normal;
        walls.add("{\"kind\":\"box\",\"size\":[40,20,40],\"radius\":0,\"friction\":" +
                  number(scene.wall_friction[w]) +
                  ",\"at\":" + text_of(Vec3((scene.walls[w].offset - 10) * n)) +
                  ",\"turn\":" + text_of(quaternion_of(frame_along(n)) * quaternion_of(Vec3(0, 0, -pi / 2))) +
                  ",\"mass\":null}");
    }
    for (const SpaceJoint& joint : scene.joints) {
        const bool bounded = std::isfinite(joint.hi[twist]) || std::isfinite(joint.hi[cone]);
        joints.add("{\"a\":" + std::to_string(joint.a) + ",\"b\":" + std::to_string(joint.b) +
                   ",\"at_a\":" + text_of(joint.at_a) + ",\"at_b\":" + text_of(joint.at_b) +
                   ",\"frame_a\":" + text_of(quaternion_of(joint.frame_a)) +
                   ",\"frame_b\":" + text_of(quaternion_of(joint.frame_b)) +
                   ",\"hinge\":" + (joint.locked(swing_y) ? "true" : "false") +
                   ",\"twist\":" + (bounded ? list({joint.lo[twist], joint.hi[twist]}) : "null") +
                   ",\"cone\":" + number(joint.hi[cone]) + '}');
    }
    return "{\"bodies\":" + bodies.text() + ",\"walls\":" + walls.text() + ",\"joints\":" + joints.text() +
           ",\"gravity\":" + text_of(scene.gravity) + '}';
}

}  // namespace rigid::race
