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

//! [answer]
/// (25.2) for a normal m of triangle t: at its corners that lie farthest along m,
/// one, two or all three. A triangle that may not push along m answers with its own
/// normal, unless a neighbour's is nearer to m, (25.3).
inline Answer answer_of(const TriangleMesh& mesh, int t, const Vec3& m)
{
    const Real same = 1e-6;  // a sine: what the nearest points of two cores leave
    const Vec3& n = mesh.normal(t);
    if (n.dot(m) < -same) return Answer::of_a_neighbour;  // it has one side
    const auto slope = [&](const Vec3& from, const Vec3& to) {
        return m.dot(to - from) / (to - from).norm();
    };
    int top = 0;
    for (int k = 1; k < 3; ++k)
        if (m.dot(mesh.corner(t, k) - mesh.corner(t, top)) > 0) top = k;
    const int next = (top + 1) % 3, last = (top + 2) % 3;
    const Vec3& p = mesh.corner(t, top);
    const bool along_next = slope(p, mesh.corner(t, next)) >= -same,
               along_last = slope(p, mesh.corner(t, last)) >= -same;
    if (along_next && along_last) return Answer::of_its_face;
    bool may_push = true;
    Real nearest = n.dot(m);
    if (along_next || along_last) {
        // an edge: the mesh goes on beyond it
        const int edge = along_next ? top : last;
        const int g = mesh.beyond[static_cast<std::size_t>(t)]
                                 [static_cast<std::size_t>(edge)];
        if (g == TriangleMesh::nobody) return Answer::stays;
        const Vec3 e =
            (mesh.corner(t, (edge + 1) % 3) - mesh.corner(t, edge)).normalized();
        may_push = m.dot(cross(e, mesh.normal(g))) <= same;
        nearest = std::max(nearest, mesh.normal(g).dot(m));
    } else {
        // a corner: along the edges of all triangles there
        const int v = mesh.triangle(t)[static_cast<std::size_t>(top)];
        for (int k = mesh.first[static_cast<std::size_t>(v)];
             k < mesh.first[static_cast<std::size_t>(v) + 1]; ++k) {
            const int g = mesh.at[static_cast<std::size_t>(k)];
            for (const int i : mesh.triangle(g))
                if (i != v) may_push = may_push && slope(p, mesh.vertex(i)) <= same;
            nearest = std::max(nearest, mesh.normal(g).dot(m));
        }
    }
    if (may_push) return Answer::stays;
    return nearest > n.dot(m) + 1e-9 ? Answer::of_a_neighbour : Answer::of_its_face;
}
//! [answer]

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
