/// \file separating_axes.hpp
/// How far two convex cores are apart along one direction, and the direction in which that is most.
///
///     s(n) = min_{p in B} n·p − max_{p in A} n·p                                                      (22.3)
///
/// s(n) is never more than the distance. Where the cores overlap, −max s is the least way that parts them, and the best n is
/// the normal of a face of A or of B or is across an edge of each, (22.4). \cite ericson2005
#pragma once

#include "chapters/22_distance_of_solids/solid_form.hpp"

namespace rigid {

/// A direction from a to b and how far the cores are apart along it.
struct Axis {
    Vec3 normal = {0, 1, 0};
    Real separation = -infinity;  ///< s(n) [m]; negative: they overlap by that much
    int face = -1;                ///< whose face has this normal; −1: no face
    Whose whose = Whose::a;
};

//! [faces]
/// The best of the faces. One of b must be better than one of a by more than
/// `stay`, so that two that are equal do not change places.
inline Axis best_face(const PlacedSolid& a, const PlacedSolid& b, Real stay)
{
    Axis best;
    const auto look = [&best](const PlacedSolid& p, const PlacedSolid& q,
                              Whose whose, Real handicap) {
        Axis found;
        for (std::size_t f = 0; f < p.normals.size(); ++f) {
            const Vec3& n = p.normals[f];
            const Vec3& on = p.corner(p.form->hull.faces[f][0]);
            const Real s = n.dot(q.corner(q.support(-n)) - on);
            if (s > found.separation)
                found = {whose == Whose::b ? Vec3(-n) : n, s, static_cast<int>(f),
                         whose};
        }
        if (found.separation > best.separation + handicap) best = found;
    };
    look(a, b, Whose::a, 0);
    look(b, a, Whose::b, stay);
    return best;
}
//! [faces]

/// A unit vector across the first of these directions, if there is one.
inline Vec3 across(const std::vector<Vec3>& directions)
{
    return directions.empty() ? Vec3(0, 1, 0) : across(directions[0]);
}

//! [edges]
/// The best direction across an edge of each. Edges that are parallel have none of
/// their own.
inline Axis best_across_edges(const PlacedSolid& a, const PlacedSolid& b)
{
    Axis best;
    const auto along = [](const PlacedSolid& p, const Vec3& n) {
        std::pair<Real, Real> ends{infinity, -infinity};
        for (const Vec3& corner : p.vertices) {
            const Real height = n.dot(corner);
            ends.first = std::min(ends.first, height);
            ends.second = std::max(ends.second, height);
        }
        return ends;
    };
    for (const Vec3& da : a.directions)
        for (const Vec3& db : b.directions) {
            const Vec3 across = cross(da, db);
            const Real sine = across.norm();
            if (!(sine > 1e-6)) continue;
            const Vec3 n = across / sine;
            const auto [low_a, high_a] = along(a, n);
            const auto [low_b, high_b] = along(b, n);
            if (low_b - high_a > best.separation)
                best.normal = n, best.separation = low_b - high_a;
            if (low_a - high_b > best.separation)
                best.normal = -n, best.separation = low_a - high_b;
        }
    return best;
}
//! [edges]

}  // namespace rigid
