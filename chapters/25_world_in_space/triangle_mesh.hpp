/// \file triangle_mesh.hpp
/// A ground of triangles: what it is made of, which of them have an edge in common, and a tree of boxes around them.
///
///     two triangles are neighbours if one goes from i to j and the other from j to i
///
/// A triangle has one side: the one from which its vertices run counterclockwise. The mesh belongs to the world. It can't move,
/// so it needs no mass; and it never changes, so that scenes share it and a pointer says whether it is the same.
#pragma once

#include "chapters/12_contact_manifolds/box_tree.hpp"
#include "chapters/20_turning_in_space/rotation.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <array>
#include <memory>
#include <numeric>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

/// A box along the axes, in space.
struct SolidBox {
    Vec3 low = {infinity, infinity, infinity},
         high = {-infinity, -infinity, -infinity};  ///< [m]
};

inline bool overlap(const SolidBox& a, const SolidBox& b)
{
    return (a.low.array() <= b.high.array()).all() &&
           (b.low.array() <= a.high.array()).all();
}
inline bool contains(const SolidBox& outer, const SolidBox& inner)
{
    return (outer.low.array() <= inner.low.array()).all() &&
           (inner.high.array() <= outer.high.array()).all();
}
inline SolidBox joined(const SolidBox& a, const SolidBox& b)
{
    return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}
inline SolidBox grown(const SolidBox& box, Real by)
{
    return {box.low - Vec3::Constant(by), box.high + Vec3::Constant(by)};
}
/// Half its surface: what the perimeter is in the plane, a measure of how many of all lines meet it.
inline Real perimeter(const SolidBox& box)
{
    const Vec3 d = box.high - box.low;
    return d.x() * d.y() + d.y() * d.z() + d.z() * d.x();
}

struct TriangleMesh {
    using Triangle = std::array<int, 3>;
    static constexpr int nobody = -1;

    std::vector<Vec3> vertices;       ///< [m]
    std::vector<Triangle> triangles;  ///< counterclockwise as seen from the front
    std::vector<Vec3> normals;        ///< of the triangles, to the front
    /// of each triangle: its neighbour at the edge from each corner to the next
    std::vector<Triangle> beyond;
    /// the triangles at vertex v: at[k] for first[v] ≤ k < first[v + 1]
    std::vector<int> first, at;
    BoxTreeOf<SolidBox> tree;

    int count() const { return static_cast<int>(triangles.size()); }
    const Triangle& triangle(int t) const
    {
        return triangles[static_cast<std::size_t>(t)];
    }
    const Vec3& normal(int t) const { return normals[static_cast<std::size_t>(t)]; }
    const Vec3& vertex(int i) const
    {
        return vertices[static_cast<std::size_t>(i)];
    }
    const Vec3& corner(int t, int k) const
    {
        return vertex(triangle(t)[static_cast<std::size_t>(k)]);
    }

    /// The triangles whose boxes overlap a box, in ascending order.
    /// \param stack  memory
    /// \return       boxes of the tree that were looked at
    int near(const SolidBox& box, std::vector<int>& stack,
             std::vector<int>& found) const;
};

/// Fills in what is beyond each edge, among the triangles at that end of it which has fewer. Throws if two triangles run along
/// an edge in the same direction: so do two of three at one edge.
void find_neighbours(TriangleMesh& mesh);

/// A mesh of these triangles. Vertices that lie in the same place are one vertex.
/// Throws std::invalid_argument, with a sentence that names the vertex or the
/// triangle, unless all are finite, each triangle has an area, and its vertices are
/// there; and for edges as find_neighbours() says.
std::shared_ptr<const TriangleMesh>
triangle_mesh(std::vector<Vec3> vertices,
              std::vector<TriangleMesh::Triangle> triangles);

}  // namespace rigid
