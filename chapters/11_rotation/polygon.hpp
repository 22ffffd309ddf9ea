/// \file polygon.hpp
/// The one shape of bodies that turn: a convex polygon with a radius, and its mass, centroid and moment of inertia.
///
/// Everything within the radius ρ of the polygon belongs to the body. One vertex is a disc, two are a capsule, four
/// and no radius a box. The area falls into pieces whose integrals are known in closed form:
///
///     the polygon      triangles from one vertex     area ½ e × f,  e, f the two sides from there
///     on each edge     a rectangle l × ρ             polar moment about its middle  l ρ (l² + ρ²) / 12
///     at each vertex   a sector of the half-angle α  area α ρ²,  centroid at 2 ρ sin α / 3α,  polar moment about its tip α ρ⁴ / 2
///
/// and each piece is moved to the common centroid by the theorem of parallel axes (11.11).
#pragma once

#include "common/elementary.hpp"
#include "common/math.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

struct Polygon {
    /// counterclockwise, convex; one or two are allowed [m]
    std::vector<Vec2> vertices;
    Real radius = 0;  ///< [m]
};

/// How the mass of a body is spread.
struct Mass {
    Real mass = 0;           ///< [kg]
    Vec2 centroid = {0, 0};  ///< [m]
    Real inertia = 0;        ///< about the centroid [kg m²]
};

/// The box of the given width and height about the origin.
inline Polygon box(Real width, Real height, Real radius = 0)
{
    const Real x = width / 2, y = height / 2;
    return {{{-x, -y}, {x, -y}, {x, y}, {-x, y}}, radius};
}

/// The capsule along x about the origin; `length` is the distance of its two centres.
inline Polygon capsule(Real length, Real radius)
{
    return {{{-length / 2, 0}, {length / 2, 0}}, radius};
}

inline Polygon disc(Real radius) { return {{{0, 0}}, radius}; }

/// The same shape turned about the origin, then moved.
inline Polygon shifted(Polygon shape, const Vec2& by, Real turn = 0)
{
    const auto [s, c] = sine_and_cosine(turn);
    for (Vec2& v : shape.vertices)
        v = by + Vec2(c * v.x() - s * v.y(), s * v.x() + c * v.y());
    return shape;
}

/// Throws std::invalid_argument, naming the vertex or the value, unless the vertices are finite, distinct and go
/// counterclockwise around a convex polygon, and the radius is zero or positive.
void require_valid(const Polygon& shape);

//! [pieces]
/// Calls visit(area, centroid, polar moment about that centroid) for each piece of
/// the shape, (11.12).
template <class Visit>
void for_each_piece(const Polygon& shape, const Visit& visit)
{
    const std::vector<Vec2>& v = shape.vertices;
    const std::size_t n = v.size();
    const Real rho = shape.radius;
    for (std::size_t i = 1; i + 1 < n; ++i) {  // triangles
        const Vec2 e = v[i] - v[0], f = v[i + 1] - v[0];
        const Real area = cross2(e, f) / 2;
        visit(area, Vec2(v[0] + (e + f) / 3),
              area * (e.dot(e) + f.dot(f) - e.dot(f)) / 18);
    }
    if (rho == 0) return;
    // rectangles on the edges, sectors between them
    for (std::size_t i = 0; i < n && n > 1; ++i) {
        const Vec2 edge = v[(i + 1) % n] - v[i],
                   next = v[(i + 2) % n] - v[(i + 1) % n];
        const Real l = edge.norm(),
                   alpha = std::abs(atan2(cross2(edge, next), edge.dot(next))) / 2;
        const Vec2 out = -perpendicular(edge) / l;
        visit(l * rho, Vec2(v[i] + edge / 2 + out * (rho / 2)),
              l * rho * (l * l + rho * rho) / 12);
        const Vec2 middle = cos(alpha) * out + sin(alpha) * Vec2(edge / l);
        const Real area = alpha * rho * rho,
                   far = 2 * rho * sin(alpha) / (3 * alpha);
        visit(area, Vec2(v[(i + 1) % n] + far * middle),
              area * (rho * rho / 2 - far * far));
    }
    if (n == 1) visit(pi * rho * rho, v[0], pi * rho * rho * rho * rho / 2);
}
//! [pieces]

//! [mass]
/// Mass, centroid and moment of inertia of a uniform body.
/// \param density  [kg/m²]
/// Throws std::invalid_argument for a polygon that is not convex, one without area,
/// or a density that is not positive.
inline Mass mass_of(const Polygon& shape, Real density)
{
    require_valid(shape);
    if (!(density > 0) || !std::isfinite(density))
        throw std::invalid_argument("the density is " + shortest(density) +
                                    " kg/m²; it must be positive and finite");
    Mass all;
    Real area = 0;
    for_each_piece(shape, [&](Real piece, const Vec2& centroid, Real) {
        area += piece;
        all.centroid += piece * (centroid - shape.vertices[0]);
    });
    if (!(area > 0))
        throw std::invalid_argument(
            "the polygon has the area " + shortest(area) +
            " m²; it must be positive: three vertices, or a radius");
    all.centroid = shape.vertices[0] + all.centroid / area;
    // (11.11)
    for_each_piece(shape, [&](Real piece, const Vec2& centroid, Real moment) {
        all.inertia +=
            density * (moment + piece * (centroid - all.centroid).squaredNorm());
    });
    all.mass = density * area;
    return all;
}
//! [mass]

/// A rod so thin that its thickness does not count: m L²/12, the limit of box and capsule.
inline Mass thin_rod(Real length, Real mass)
{
    return {mass, {0, 0}, mass * length * length / 12};
}

}  // namespace rigid
