/// \file solid_form.hpp
/// What the search for contacts needs to know of a hull: its faces with their normals, its edges, each direction of an
/// edge once; and all of that where the body is.
///
///     p = x + R p̄,  n = R n̄            (18.1) for each corner, each normal, each direction
#pragma once

#include "chapters/18_space/inertia.hpp"
#include "chapters/18_space/space_bodies.hpp"

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
/// flat: no corner lies outside of a face, and each edge is one of two faces.
inline void require_valid(const SolidForm& form)
{
    const Hull& hull = form.hull;
    const auto refuse = [](const std::string& what) {
        throw std::invalid_argument("a hull " + what);
    };
    if (hull.vertices.empty()) refuse("has no vertices");
    if (!(hull.radius >= 0 && hull.radius <= largest_number))
        refuse("has the radius " + shortest(hull.radius) +
               " m; it must be between 0 and 1e75");
    if (hull.vertices.size() <= 2) return;
    if (hull.faces.size() < 4)
        refuse("of " + std::to_string(hull.vertices.size()) + " vertices has " +
               std::to_string(hull.faces.size()) +
               " faces; it needs at least four");
    // what rounding leaves of a corner that lies in the plane of a face
    const Real flat = 1e-9 * form.reach;
    for (std::size_t f = 0; f < hull.faces.size(); ++f) {
        const Vec3& on = hull.vertices[static_cast<std::size_t>(hull.faces[f][0])];
        Real deepest = 0;
        for (const Vec3& p : hull.vertices) {
            const Real out = form.normals[f].dot(p - on);
            if (!(out <= flat))
                refuse("is not convex: a vertex is " + shortest(out) +
                       " m outside of face " + std::to_string(f));
            deepest = std::min(deepest, out);
        }
        if (!(deepest < -flat)) refuse("is flat");
    }
    std::vector<int> faces_of(form.edges.size(), 0);
    for (const std::vector<int>& face : form.face_edges)
        for (const int e : face) ++faces_of[static_cast<std::size_t>(e)];
    for (const int count : faces_of)
        if (count != 2)
            refuse("is not closed: an edge is one of " + std::to_string(count) +
                   " faces");
}

/// \throws std::invalid_argument  for a hull that is not convex, not closed or flat
inline SolidForm form_of(const Hull& hull)
{
    SolidForm form;
    form.hull = hull;
    const auto corner = [&hull](int i) -> const Vec3& {
        return hull.vertices.at(static_cast<std::size_t>(i));
    };
    for (const Vec3& p : hull.vertices) {
        if (!(p.array().abs() <= largest_number).all())
            throw std::invalid_argument(
                "a hull has a vertex at (" + shortest(p.x()) + ", " +
                shortest(p.y()) + ", " + shortest(p.z()) +
                "); all three must be finite, and none beyond 1e75");
        form.reach = std::max(form.reach, p.norm() + hull.radius);
    }
    if (hull.vertices.size() == 2) form.edges.push_back({0, 1});
    for (const std::vector<int>& face : hull.faces) {
        if (face.size() < 3)
            throw std::invalid_argument("a face has " +
                                        std::to_string(face.size()) +
                                        " vertices; it needs at least three");
        // twice its area times its normal: the sum of the triangles from one corner
        Vec3 area(0, 0, 0);
        std::vector<int> edges;
        for (std::size_t k = 0; k < face.size(); ++k) {
            const int i = face[k], j = face[(k + 1) % face.size()];
            area += cross(corner(i) - corner(face[0]), corner(j) - corner(face[0]));
            const SolidEdge edge{std::min(i, j), std::max(i, j)};
            const auto at = std::find(form.edges.begin(), form.edges.end(), edge);
            edges.push_back(static_cast<int>(at - form.edges.begin()));
            if (at == form.edges.end()) form.edges.push_back(edge);
        }
        // less has a square that is none, and so no normal
        if (!(area.norm() >= 1 / (largest_number * largest_number)))
            throw std::invalid_argument("a face has no area");
        form.normals.push_back(area.normalized());
        form.face_edges.push_back(std::move(edges));
    }
    for (const SolidEdge& edge : form.edges) {
        const Vec3 way = corner(edge.to) - corner(edge.from);
        if (!(way.norm() >= 1 / largest_number))
            throw std::invalid_argument("an edge has no length");
        const Vec3 d = way.normalized();
        const auto parallel = [&d](const Vec3& other) {
            return cross(d, other).squaredNorm() < 1e-20;  // a few roundings
        };
        if (std::none_of(form.directions.begin(), form.directions.end(), parallel))
            form.directions.push_back(d);
    }
    require_valid(form);
    return form;
}

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
inline Real inner_radius(const std::vector<SolidForm>& forms)
{
    if (forms.empty()) return 0;
    Real least = infinity;
    for (const SolidForm& form : forms) {
        Vec3 middle(0, 0, 0);
        for (const Vec3& p : form.hull.vertices) middle += p;
        middle /= static_cast<Real>(form.hull.vertices.size());
        Real nearest = form.normals.empty() ? 0 : infinity;
        for (std::size_t f = 0; f < form.normals.size(); ++f) {
            const auto on = static_cast<std::size_t>(form.hull.faces[f][0]);
            nearest = std::min(
                nearest, form.normals[f].dot(form.hull.vertices[on] - middle));
        }
        least = std::min(least, nearest + form.hull.radius);
    }
    return least;
}

}  // namespace rigid
