/// \file mesh_scenes.hpp
/// Grounds of triangles: a strip, hills, a bowl; and what falls and rolls on them.
#pragma once

#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"
#include "chapters/25_world_in_space/car.hpp"
#include "chapters/25_world_in_space/space_scene.hpp"

namespace rigid {

//! [height_field]
/// A ground over a rectangle of the plane x, z around the origin: its corners are
/// `height(x, z)` high, and each of its cells is two triangles.
template <class Height>
std::shared_ptr<const TriangleMesh> height_field(int cells_x, int cells_z,
                                                 Real cell, const Height& height)
{
    std::vector<Vec3> vertices;
    std::vector<TriangleMesh::Triangle> triangles;
    for (int i = 0; i <= cells_x; ++i)
        for (int k = 0; k <= cells_z; ++k) {
            const Real x = (i - cells_x / 2.0) * cell,
                       z = (k - cells_z / 2.0) * cell;
            vertices.push_back({x, height(x, z), z});
        }
    for (int i = 0; i < cells_x; ++i)
        for (int k = 0; k < cells_z; ++k) {
            const int here = i * (cells_z + 1) + k, right = here + cells_z + 1;
            triangles.push_back({here, here + 1, right});
            triangles.push_back({right, here + 1, right + 1});
        }
    return triangle_mesh(std::move(vertices), std::move(triangles));
}
//! [height_field]

/// The mesh is the only ground of the scene, with the same μ as all bodies that there are.
inline void add_ground(SpaceScene& scene, std::shared_ptr<const TriangleMesh> mesh,
                       Real mu)
{
    scene.walls.clear(), scene.wall_friction.clear();
    scene.meshes = {std::move(mesh)};
    scene.mesh_friction = {mu};
    scene.friction.assign(scene.shapes.size(), mu);
}

inline std::shared_ptr<const TriangleMesh> flat_mesh(int cells_x, int cells_z,
                                                     Real cell)
{
    return height_field(cells_x, cells_z, cell, [](Real, Real) { return 0.0; });
}

/// A bowl, y = (x² + z²)/2r: r is the radius of its curve at the bottom.
inline std::shared_ptr<const TriangleMesh> bowl(int cells, Real cell, Real r)
{
    return height_field(cells, cells, cell,
                        [r](Real x, Real z) { return (x * x + z * z) / (2 * r); });
}

/// A heap that falls on a mesh in place of its pit.
inline SpaceScene heap_on(std::shared_ptr<const TriangleMesh> mesh, int bodies,
                          Real mu, std::uint64_t seed)
{
    SpaceScene scene = mixed_heap(bodies, mu, seed);
    add_ground(scene, std::move(mesh), mu);
    return scene;
}

/// A car before a track of hills, and balls that lie on it.
SpaceScene car_on_hills(const Car& car, Real height, Real mu, int balls);

}  // namespace rigid
