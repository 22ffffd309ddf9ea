// The functions of space_checks.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_space/space_checks.hpp"

namespace rigid {

void require_valid(const StepSettings& settings, const Vec3& gravity, Index bodies)
{
    if (!gravity.allFinite()) throw std::invalid_argument("gravity is not finite");
    require_valid(settings, Vec2(0, 0), bodies);
    if (settings.pulled != world)
        throw std::invalid_argument(
            "a hand in the plane of the picture pulls no body in space");
}

void require_bodies(const SpaceScene& scene)
{
    require_valid(scene.bodies);
    const Index count = scene.bodies.count();
    if (static_cast<Index>(scene.shapes.size()) != count)
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.shapes.size()) +
            " shapes and " + std::to_string(count) + " bodies; each needs its own");
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        const SpaceJoint& joint = scene.joints[i];
        const auto refuse = [i](const std::string& what) {
            throw std::invalid_argument("joint " + std::to_string(i) + " " + what);
        };
        if (joint.a < world || joint.a >= count || joint.b < 0 ||
            joint.b >= count || joint.a == joint.b)
            refuse("joins bodies " + std::to_string(joint.a) + " and " +
                   std::to_string(joint.b) + " among " + std::to_string(count));
        for (std::size_t c = 0; c < coordinates; ++c)
            if (!(joint.lo[c] <= joint.hi[c]) || joint.lo[c] == infinity ||
                joint.hi[c] == -infinity)
                refuse("has the limits " + shortest(joint.lo[c]) + " and " +
                       shortest(joint.hi[c]) + " of coordinate " +
                       std::to_string(c) +
                       "; a finite value must lie between them");
        for (const Vec3& v : {joint.at_a, joint.at_b, joint.frame_a, joint.frame_b})
            if (!v.allFinite()) refuse("has a point or a frame that is not finite");
        if (joint.motor >= coordinates ||
            !(joint.force >= 0 && std::isfinite(joint.speed)))
            refuse("has a motor on coordinate " + std::to_string(joint.motor) +
                   " of the force " + shortest(joint.force) + " and the speed " +
                   shortest(joint.speed));
    }
}

void require_touching(const SpaceScene& scene)
{
    require_meshes(scene);
    for (std::size_t w = 0; w < scene.walls.size(); ++w)
        if (!(std::abs(scene.walls[w].normal.norm() - 1) <= 1e-9) ||
            !std::isfinite(scene.walls[w].offset))
            throw std::invalid_argument(
                "wall " + std::to_string(w) + " has a normal of the length " +
                shortest(scene.walls[w].normal.norm()) + " and the offset " +
                shortest(scene.walls[w].offset) +
                " m; the length must be 1, the offset finite");
    // no strings: what is fine asks for no memory
    const auto check = [](const std::vector<Real>& list, std::size_t count,
                          const char* thing, const char* what) {
        if (!list.empty() && list.size() != count)
            throw std::invalid_argument(
                "the scene has " + std::to_string(list.size()) + " " + what +
                "s for " + std::to_string(count) + " " + thing +
                "; each needs its own, or none has one");
        for (std::size_t i = 0; i < list.size(); ++i)
            if (!(list[i] >= 0) || !std::isfinite(list[i]))
                throw std::invalid_argument(
                    "number " + std::to_string(i) + " of the " + thing +
                    " has the " + what + " " + shortest(list[i]) +
                    "; it must be zero or positive and finite");
    };
    check(scene.friction, scene.shapes.size(), "bodies", "friction coefficient");
    check(scene.wall_friction, scene.walls.size(), "walls", "friction coefficient");
    check(scene.mesh_friction, scene.meshes.size(), "meshes",
          "friction coefficient");
    check(scene.rolling, scene.shapes.size(), "bodies", "rolling arm");
    check(scene.spinning, scene.shapes.size(), "bodies", "spinning arm");
    for (std::size_t i = 0; i < scene.ellipsoids.size(); ++i) {
        const SolidEllipsoid& e = scene.ellipsoids[i];
        if (e.body < 0 || e.body >= scene.bodies.count())
            throw std::invalid_argument("ellipsoid " + std::to_string(i) +
                                        " belongs to body " +
                                        std::to_string(e.body) + " among " +
                                        std::to_string(scene.bodies.count()));
        const Real volume = determinant(e.stretch);
        if (!e.at.allFinite() || !(std::abs(volume) > 0) || !std::isfinite(volume))
            throw std::invalid_argument("ellipsoid " + std::to_string(i) +
                                        " is flat, or not finite");
    }
}

}  // namespace rigid
