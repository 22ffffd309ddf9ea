/// \file from_scene.hpp
/// A scene of the chapters before as a part of a world.
#pragma once

#include "chapters/19_engine/world.hpp"

#include <string>
#include <vector>

namespace rigid {

//! [put_in]
/// Adds bodies, walls, surfaces and joints of a scene to a world; its gravity, its length and its chains are not looked at.
/// \param filter  of all its bodies
/// \return        the ids of its bodies, in their order
/// Throws std::invalid_argument for a scene with rows in scene.joints that are no joint's of chapter 14.
inline std::vector<BodyId> put_in(World& into, const JointedScene& scene,
                                  const Filter& filter = {})
{
    std::size_t rows = 0;
    for (const PlacedJoint& placed : scene.placed)
        rows += static_cast<std::size_t>(placed.count);
    if (rows != scene.joints.size())
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.joints.size()) + " rows, and " +
            std::to_string(rows) + " of them are of joints; all must be");
    std::vector<BodyId> ids;
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const auto i = static_cast<std::size_t>(k);
        BodyDefinition body;
        body.shape = scene.shapes[i];
        body.position = scene.bodies.position(k).head<2>();
        body.angle = scene.bodies.position(k)[2];
        body.velocity = scene.bodies.velocity(k).head<2>();
        body.spin = scene.bodies.velocity(k)[2];
        const Vec<3> W = scene.bodies.inverse_mass.segment<3>(3 * k);
        body.mass =
            scene.bodies.can_move(k) ? Mass{1 / W[0], {0, 0}, 1 / W[2]} : Mass{};
        body.surface =
            scene.surfaces.empty() ? Surface{0, 0, 0, 0} : scene.surfaces[i];
        body.filter = filter;
        ids.push_back(into.add_body(body));
    }
    for (std::size_t i = 0; i < scene.walls.size(); ++i)
        into.add_wall(scene.walls[i], i < scene.wall_surfaces.size()
                                          ? scene.wall_surfaces[i]
                                          : Surface{0, 0, 0, 0});
    for (const PlacedJoint& placed : scene.placed) {
        const Index a = placed.joint.a;
        into.add_joint(a == rigid::world ? BodyId{}
                                         : ids[static_cast<std::size_t>(a)],
                       ids[static_cast<std::size_t>(placed.joint.b)], placed.joint);
    }
    return ids;
}
//! [put_in]

/// The same of a scene without joints.
inline std::vector<BodyId> put_in(World& into, const RoughScene& scene,
                                  const Filter& filter = {})
{
    JointedScene jointed;
    static_cast<RoughScene&>(jointed) = scene;
    return put_in(into, jointed, filter);
}

}  // namespace rigid
