/// \file solid_form.hpp
/// What the search for contacts needs to know of a hull: its faces with their normals, its edges, each direction of an
/// edge once; and all of that where the body is.
///
///     p = x + R p̄,  n = R n̄            (20.1) for each corner, each normal, each direction
#pragma once

#include "chapters/20_turning_in_space/inertia.hpp"
#include "chapters/20_turning_in_space/space_bodies.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

/// Of the two solids of a pair: the first or the second.
enum class Whose : unsigned char { a, b };

/// Two corners that an edge joins, the lower number first.
struct SolidEdge {
    int from = 0, to = 0;
    bool operator==(const SolidEdge&) const = default;
};

/// A hull in the axes of its body.
struct SolidForm {
    Hull hull;
    std::vector<Vec3> normals;  ///< of the faces, outward
    std::vector<SolidEdge> edges;
    /// of each face: the number of the edge from each of its corners to the next
    std::vector<std::vector<int>> face_edges;
    std::vector<Vec3> directions;  ///< of the edges; parallel ones have one
    Real reach = 0;  ///< from the origin to the farthest point of the solid [m]
};

/// Throws std::invalid_argument, with a sentence that says what is wrong, unless the hull is convex, closed and not
/// flat: no corner lies outside of a face, those of a face lie in its plane, and each edge is one of two faces.
void require_valid(const SolidForm& form);

/// \throws std::invalid_argument  for a hull that is not convex, not closed or flat, or a face that names a vertex that
///                                is not there
SolidForm form_of(const Hull& hull);

/// A hull where its body is.
struct PlacedSolid {
    const SolidForm* form = nullptr;
    std::vector<Vec3> vertices, normals, directions;  ///< seen from the world
    Vec3 centre = {0, 0, 0};                          ///< of its body

    Real radius() const { return form->hull.radius; }
    const Vec3& corner(int i) const
    {
        return vertices[static_cast<std::size_t>(i)];
    }
    const SolidEdge& edge(int i) const
    {
        return form->edges[static_cast<std::size_t>(i)];
    }
    bool has_faces() const { return !normals.empty(); }

    /// Places it; memory is kept.
    void place(const SolidForm& what, const Vec3& x, const Mat3& R)
    {
        form = &what;
        centre = x;
        const auto turn = [&R](const std::vector<Vec3>& from,
                               std::vector<Vec3>& to) {
            to.resize(from.size());
            for (std::size_t i = 0; i < from.size(); ++i) to[i] = R * from[i];
        };
        turn(what.hull.vertices, vertices);
        for (Vec3& p : vertices) p += x;
        turn(what.normals, normals);
        turn(what.directions, directions);
    }

    //! [support]
    /// The corner that lies farthest along n; of several the first.
    int support(const Vec3& n) const
    {
        int best = 0;
        Real highest = n.dot(vertices[0]);
        for (std::size_t i = 1; i < vertices.size(); ++i)
            if (const Real height = n.dot(vertices[i]); height > highest)
                highest = height, best = static_cast<int>(i);
        return best;
    }
    //! [support]
};

/// ρ of a body: from the middle of its corners to the nearest side, of its thinnest hull; 0 of none [m].
Real inner_radius(const std::vector<SolidForm>& forms);

}  // namespace rigid
