/// \file space_picture.hpp
/// What the picture of chapter 20 has besides hulls: grounds of triangles.
#pragma once

#include "chapters/20_turning_in_space/program/solid_picture.hpp"
#include "chapters/25_world_in_space/space_scene.hpp"

namespace rigid {

/// A ground of triangles. It is put away a little, so that what stands on it is before it.
inline void draw_mesh(SolidPicture& picture, const TriangleMesh& mesh)
{
    for (int t = 0; t < mesh.count(); ++t)
        picture.facet({mesh.corner(t, 0), mesh.corner(t, 1), mesh.corner(t, 2)},
                      Colour::faint, (mesh.corner(t, 1) - mesh.corner(t, 0)).norm(),
                      t % 2 != 0 ? 0.8 : 1);
}

}  // namespace rigid
