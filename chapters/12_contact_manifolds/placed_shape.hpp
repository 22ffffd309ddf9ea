/// \file placed_shape.hpp
/// Shapes where their bodies are: vertices and outward normals in the world, computed once a body and step.
///
///     v_i = x + R(θ) r_i,   n_i = outward normal of the edge from v_i to the next vertex,   box = [min, max] of all points
#pragma once

#include "chapters/11_rotation/rigid_scene.hpp"
#include "chapters/12_contact_manifolds/boxes.hpp"
#include "common/elementary.hpp"

#include <algorithm>
#include <span>
#include <vector>

namespace rigid {

//! [placed]
/// A convex polygon with a radius, somewhere in the world. Edge i goes from vertex i
/// to the next; a disc has one vertex and no edge, a capsule two edges, there and
/// back.
struct Placed {
    std::span<const Vec2> vertices;  ///< counterclockwise [m]
    std::span<const Vec2> normals;   ///< outward, of the edges; none of a disc
    Real radius = 0;                 ///< [m]

    int size() const { return static_cast<int>(vertices.size()); }
    int edges() const { return static_cast<int>(normals.size()); }
    const Vec2& vertex(int i) const
    {
        return vertices[static_cast<std::size_t>(i)];
    }
    const Vec2& normal(int i) const { return normals[static_cast<std::size_t>(i)]; }
    int next(int i) const { return i + 1 < size() ? i + 1 : 0; }
    int before(int i) const { return i > 0 ? i - 1 : size() - 1; }
};
//! [placed]

inline Box box_of(const Placed& shape)
{
    Box box;
    for (const Vec2& v : shape.vertices)
        box.low = box.low.cwiseMin(v), box.high = box.high.cwiseMax(v);
    return grown(box, shape.radius);
}

/// From the centroid to the nearest side [m]. The centroid of a segment is on it, whatever rounding says.
Real inner_radius(const Placed& shape, const Vec2& centroid);

/// R: the way from the origin of a shape, its centroid in a body, to its farthest vertex [m]. What is round about a
/// vertex does not move when it turns.
inline Real turning_radius(const Polygon& shape)
{
    Real farthest = 0;
    for (const Vec2& r : shape.vertices)
        farthest = std::max(farthest, r.squaredNorm());
    return std::sqrt(farthest);
}

/// Writes the vertices and normals of a shape at a pose (x, y, θ) behind those that are there.
/// \param turn  of θ
inline void place(const Polygon& shape, const Vec<3>& pose,
                  const SineAndCosine& turn, std::vector<Vec2>& vertices,
                  std::vector<Vec2>& normals)
{
    const auto [s, c] = turn;
    const std::size_t n = shape.vertices.size();
    for (const Vec2& r : shape.vertices)
        vertices.push_back(
            {pose[0] + c * r.x() - s * r.y(), pose[1] + s * r.x() + c * r.y()});
    // the vertices are where their bodies are, so that far from the origin an edge
    // of the body itself is more exact than their difference
    for (std::size_t i = 0; i < n && n > 1; ++i) {
        const Vec2 e = shape.vertices[i + 1 < n ? i + 1 : 0] - shape.vertices[i];
        const Real length = std::sqrt(e.x() * e.x() + e.y() * e.y());
        const Real x = e.y() / length, y = -e.x() / length;
        normals.push_back({c * x - s * y, s * x + c * y});
    }
}

/// One shape that is placed, with memory of its own.
struct PlacedShape {
    std::vector<Vec2> vertices, normals;
    Real radius = 0;

    PlacedShape() = default;
    PlacedShape(const Polygon& shape, const Vec<3>& pose) { move(shape, pose); }
    void move(const Polygon& shape, const Vec<3>& pose)
    {
        move(shape, pose, sine_and_cosine(pose[2]));
    }
    void move(const Polygon& shape, const Vec<3>& pose, const SineAndCosine& turn)
    {
        vertices.clear();
        normals.clear();
        place(shape, pose, turn, vertices, normals);
        radius = shape.radius;
    }
    Placed view() const { return {vertices, normals, radius}; }
};

/// The shapes of a scene. Does not allocate once it has been as large.
struct PlacedShapes {
    std::vector<Vec2> vertices, normals;
    std::vector<std::size_t> first_vertex, first_normal;  ///< K + 1
    std::vector<Real> radius;                             ///< K [m]
    std::vector<Box> boxes;                               ///< K
    std::vector<Vec2> middle;          ///< K, of each its centroid
    std::vector<Real> inner, turning;  ///< K, inner and turning radii [m]

    /// Places all of them.
    void move(const RigidScene& scene)
    {
        vertices.clear();
        normals.clear();
        first_vertex.assign(1, 0);
        first_normal.assign(1, 0);
        radius.clear();
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Polygon& shape = scene.shapes[static_cast<std::size_t>(k)];
            place(shape, scene.bodies.position(k), turn_of(scene, k), vertices,
                  normals);
            first_vertex.push_back(vertices.size());
            first_normal.push_back(normals.size());
            radius.push_back(shape.radius);
        }
        for (std::vector<Real>* const each : {&inner, &turning})
            each->resize(radius.size());
        boxes.resize(radius.size());
        middle.resize(radius.size());
        for (Index k = 0; k < scene.bodies.count(); ++k) measure(scene, k, of(k));
    }

    /// Places these again; all, if the scene has other shapes than before.
    void move(const RigidScene& scene, std::span<const int> bodies)
    {
        const auto K = static_cast<std::size_t>(scene.bodies.count());
        const auto as_before = [&](int k) {
            return scene.shapes[static_cast<std::size_t>(k)].vertices.size() ==
                   of(k).vertices.size();
        };
        if (radius.size() != K ||
            !std::all_of(bodies.begin(), bodies.end(), as_before)) {
            move(scene);
            return;
        }
        for (const int body : bodies) {
            const auto k = static_cast<std::size_t>(body);
            moved_.move(scene.shapes[k], scene.bodies.position(body),
                        turn_of(scene, body));
            std::copy(moved_.vertices.begin(), moved_.vertices.end(),
                      vertices.begin() +
                          static_cast<std::ptrdiff_t>(first_vertex[k]));
            std::copy(moved_.normals.begin(), moved_.normals.end(),
                      normals.begin() +
                          static_cast<std::ptrdiff_t>(first_normal[k]));
            radius[k] = moved_.radius;
            measure(scene, body, moved_.view());
        }
    }

    Placed of(Index body) const
    {
        const auto k = static_cast<std::size_t>(body);
        const std::size_t v = first_vertex[k], n = first_normal[k];
        return {{vertices.data() + v, first_vertex[k + 1] - v},
                {normals.data() + n, first_normal[k + 1] - n},
                radius[k]};
    }

private:
    void measure(const RigidScene& scene, Index body, const Placed& shape)
    {
        const auto k = static_cast<std::size_t>(body);
        boxes[k] = box_of(shape);
        middle[k] = middle_of(scene, scene.bodies.x, body);
        inner[k] = inner_radius(shape, middle[k]);
        turning[k] = turning_radius(scene.shapes[k]);
    }

    static SineAndCosine turn_of(const RigidScene& scene, Index k)
    {
        return scene.turns.of(k, scene.bodies.x[3 * k + 2]);
    }

    PlacedShape moved_;
};

}  // namespace rigid
