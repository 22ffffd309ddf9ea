/// \file world_scenes.hpp
/// Worlds to look at and to measure: what stands and what hangs.
#pragma once

#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/houses.hpp"
#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/18_islands/island_scenes.hpp"
#include "chapters/19_engine/from_scene.hpp"

namespace rigid {

/// A body of a shape at a place.
inline BodyDefinition body_of(const Polygon& shape, const Vec2& at, Real angle = 0,
                              Real density = 1)
{
    BodyDefinition body;
    body.shape = shape;
    body.position = at;
    body.angle = angle;
    body.density = density;
    return body;
}

inline constexpr Filter meets_no_twin{1, 0xffff'ffff, -1};

/// A scene of chapter 12 with one surface for all.
inline World world_of(const RigidScene& smooth, Real mu = 0.6,
                      const WorldSettings& settings = {})
{
    World made(settings);
    put_in(made, rough_scene(smooth, mu));
    return made;
}

inline World pyramid_world(int base) { return world_of(box_pyramid(base)); }

/// The same of boxes of another size, with the length of the world that goes with it.
inline World sized_pyramid_world(int base, Real size)
{
    RigidScene scene = box_pyramid(base);
    scene.bodies.x.reshaped(3, scene.bodies.count()).topRows(2) *= size;
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        scene.shapes[static_cast<std::size_t>(k)] = box(size, size);
        scene.bodies.inverse_mass.segment<3>(3 * k) /= size * size;
        scene.bodies.inverse_mass[3 * k + 2] /= size * size;
    }
    WorldSettings settings;
    settings.length = size;
    return world_of(scene, 0.6, settings);
}

inline World house_world(int storeys)
{
    World made;
    put_in(made, card_house(storeys, 0.6));
    return made;
}

/// Boxes of 1 m on a floor, and one of so many times their mass on top.
inline World column_world(int boxes, Real ratio = 1)
{
    return world_of(loaded_column(boxes, ratio));
}

/// A chain of thin rods that swings, with a weight of so many rods at its end.
inline World chain_world(int links, Real ratio)
{
    World made;
    put_in(made, chain_scene({links, 0.1, 0.1, ratio, 0.3}), meets_no_twin);
    return made;
}

/// A bridge of planks with balls that fall on it.
inline World bridge_world(int planks)
{
    World made;
    JointedScene scene = bridge_scene(planks);
    cover(scene, {0.6, 0, 0, 0});
    put_in(made, scene, {1, 0xffff'ffff, -1});
    for (int i = 0; i < 5; ++i)
        made.add_body(body_of(disc(0.3), {-2.0 + i, 1.5 + 0.7 * i}, 0, 20));
    return made;
}

/// Bodies on a net of pins, held by its upper corners.
inline World grid_world(int side)
{
    World made;
    std::vector<BodyId> ids;
    for (int row = 0; row < side; ++row)
        for (int i = 0; i < side; ++i) {
            BodyDefinition body =
                body_of(disc(0.2), {0.5 * i, -0.5 * row}, 0,
                        row == 0 && (i == 0 || i + 1 == side) ? 0 : 1);
            body.filter = meets_no_twin;
            ids.push_back(made.add_body(body));
            const auto join = [&](std::size_t other, const Vec2& place) {
                if (made.mass(ids[other]) == infinity &&
                    made.mass(ids.back()) == infinity)
                    return;
                made.add_joint(ids[other], ids.back(),
                               made.joint_at(JointKind::revolute, ids[other],
                                             ids.back(), place));
            };
            if (i > 0) join(ids.size() - 2, {0.5 * i - 0.25, -0.5 * row});
            if (row > 0)
                join(ids.size() - 1 - static_cast<std::size_t>(side),
                     {0.5 * i, -0.5 * row + 0.25});
        }
    return made;
}

}  // namespace rigid
