/// \file mesh_touch.hpp
/// Where a solid touches a mesh: triangle by triangle, but as one surface.
///
///     m pushes at p   ⟺   m·d ≤ 0 for all directions d in which the mesh goes on from p                  (25.2)
///
/// Each triangle answers as a flat solid with one face, collide(). An answer that (25.2) forbids is that of its face alone,
/// for as much of the solid as lies over it, (25.3). What has one normal is one manifold, of four points.
#pragma once

#include "chapters/23_faces_that_touch/solid_touch.hpp"
#include "chapters/25_world_in_space/triangle_mesh.hpp"

#include <cstdint>
#include <limits>

namespace rigid {

/// What becomes of an answer of a triangle.
enum class Answer : unsigned char { stays, of_its_face, of_a_neighbour };

/// (25.2) for a normal m of triangle t: at its corners that lie farthest along m,
/// one, two or all three. A triangle that may not push along m answers with its own
/// normal, unless a neighbour's is nearer to m, (25.3).
Answer answer_of(const TriangleMesh& mesh, int t, const Vec3& m);

/// Points with one normal, before four are chosen.
struct MeshManifold {
    Vec3 normal = {0, 1, 0};
    std::vector<TouchPoint> points;
};

/// What is kept from call to call, and what is counted.
struct MeshMemory {
    /// false: each triangle answers for itself, and what slides stumbles
    bool as_one = true;
    // What the last step counted.
    int boxes = 0;      ///< of trees, looked at
    int triangles = 0;  ///< near a solid

    SolidForm form;
    PlacedSolid placed;
    std::vector<int> stack, near;
    std::vector<MeshManifold> manifolds;
    std::size_t count = 0;  ///< of the manifolds

    MeshMemory()
    {
        form.hull = {std::vector<Vec3>(3, {0, 0, 0}), {{0, 1, 2}}, 0};
        form.normals.resize(1), form.directions.resize(3);
        form.edges = {{0, 1}, {1, 2}, {0, 2}};
        form.face_edges = {{0, 1, 2}};
    }
    /// A triangle as a flat solid that has one face.
    const PlacedSolid& take(const TriangleMesh& mesh, int t);
};

/// Whether the middle of a solid is behind a triangle, which has one side.
inline bool behind(const TriangleMesh& mesh, int t, const PlacedSolid& solid)
{
    Vec3 middle(0, 0, 0);
    for (const Vec3& p : solid.vertices) middle += p - mesh.corner(t, 0);
    return mesh.normal(t).dot(middle) < 0;
}

/// The box around a solid where it is.
inline SolidBox box_of(const PlacedSolid& solid)
{
    SolidBox box;
    for (const Vec3& p : solid.vertices) box = joined(box, {p, p});
    return grown(box, solid.radius());
}

/// The names of all points that a solid and a mesh could have end where `first` was, and begin where it is then.
/// \return  how many of them belong to one triangle
/// Throws std::invalid_argument if a key of chapter 8 has no room for them.
int take_names(const TriangleMesh& mesh, const SolidForm& form,
               const MeshMemory& memory, Index& first);

/// Adds the points of a triangle to those of the same normal.
void add_to_manifolds(const SolidTouch& touch, int first_name, Real slack,
                      MeshMemory& memory);

/// Points inside of a side are on no corner, and choose_four() begins with the first of the deep ones: the point that is
/// farthest from the middle is a corner for certain.
void farthest_first(std::vector<TouchPoint>& points);

/// All points where a solid touches a mesh, in memory.manifolds. Only triangles
/// whose boxes are near are looked at.
/// \param names  of one triangle and this solid: their points are named from this
///               times the number of the triangle
void collide(const TriangleMesh& mesh, const PlacedSolid& b, int names,
             const TouchSettings& how, ClipRoom& room, SolidTouch& touch,
             MeshMemory& memory);

}  // namespace rigid
