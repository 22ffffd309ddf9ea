/// \file scene_of.hpp
/// Discs at given places, as a scene.
#pragma once

#include "common/scenes.hpp"

#include <utility>
#include <vector>

/// \param x       [m], 2K numbers
/// \param radius  [m], K numbers
inline rigid::DiscScene scene_of(const rigid::VecX& x, const rigid::VecX& radius,
                                 std::vector<rigid::HalfSpace> walls = {})
{
    rigid::DiscScene scene;
    scene.bodies = rigid::Bodies<2>(radius.size());
    scene.bodies.x = x;
    scene.radius = radius;
    scene.walls = std::move(walls);
    return scene;
}
