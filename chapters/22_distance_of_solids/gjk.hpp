/// \file gjk.hpp
/// The distance of two convex solids by corners alone, after Gilbert, Johnson and Keerthi.
///
///     d = min ‖p_b − p_a‖ over p_a in A, p_b in B = the distance of the origin to B − A                    (22.1)
///     1  v = a point of B − A
///     2  y = the corner of B − A that lies farthest towards the origin: v·y is least
///     3  v·y ≥ v·v: no point is nearer than v, done
///     4  v = the point of the simplex of the y's that is nearest to the origin, those without weight leave; go to 2
///
/// The simplex has at most four corners, and its nearest point lies inside exactly one of its faces, edges, corners, or
/// itself, (22.2). Parts without the newest corner were there in the round before, and had nothing nearer: try the others. \cite gilbert1988
#pragma once

#include "chapters/22_distance_of_solids/solid_form.hpp"

#include <array>

namespace rigid {

/// Where two cores are nearest to each other.
struct Nearest {
    Vec3 on_a = {0, 0, 0}, on_b = {0, 0, 0};
    Real distance = 0;  ///< of the cores, without their radii [m]; 0: they overlap
};

/// Up to four corners of B − A, each with the corners that it comes from.
struct Simplex {
    std::array<Vec3, 4> y, a, b;
    std::array<Real, 4> weight{};
    int size = 0;
};

//! [nearest_of]
/// (22.2) of some corners of a simplex: v = y₀ + D t at right angles to D, with
/// D = Q R by (22.5). \return the weights of the corners; zeros if they lie on one
/// line or in one plane: a smaller part has that point
inline std::array<Real, 4> weights_of(const std::array<Vec3, 4>& y, int n, Vec3& v)
{
    Mat3 Q = Mat3::Zero(), R = Mat3::Identity();
    Vec3 t(0, 0, 0);
    v = y[0];
    for (int j = 0; j < n - 1; ++j) {
        Vec3 d = y[static_cast<std::size_t>(j + 1)] - y[0];
        const Real length = d.norm();
        for (int i = 0; i < j; ++i) {
            R(i, j) = Q.col(i).dot(d);
            d -= R(i, j) * Q.col(i);
        }
        R(j, j) = d.norm();
        if (!(R(j, j) > 1e-12 * length)) return {};
        Q.col(j) = d / R(j, j);
        t[j] = -Q.col(j).dot(v);
        v += t[j] * Q.col(j);
    }
    for (int j = 2; j >= 0; --j) {  // R t = −Qᵀ y₀
        for (int i = j + 1; i < 3; ++i) t[j] -= R(j, i) * t[i];
        t[j] /= R(j, j);
    }
    return {1 - t.sum(), t[0], t[1], t[2]};
}

/// The point of the simplex that is nearest to the origin, as weights of its
/// corners. Only those with a weight are kept.
inline Vec3 nearest_of(Simplex& s)
{
    Vec3 best(0, 0, 0);
    Real least = infinity;
    Simplex kept;
    // the others were there before the newest corner came
    const unsigned newest = 1u << (s.size - 1);
    for (unsigned part = newest; part < 2 * newest; ++part) {
        Simplex some;
        for (std::size_t i = 0; i < 4; ++i) {
            if (!(part & (1u << i))) continue;
            const auto n = static_cast<std::size_t>(some.size++);
            some.y[n] = s.y[i], some.a[n] = s.a[i], some.b[n] = s.b[i];
        }
        Vec3 v;
        some.weight = weights_of(some.y, some.size, v);
        bool inside = true;
        for (int j = 0; j < some.size; ++j)
            inside = inside && some.weight[static_cast<std::size_t>(j)] > 0;
        if (!inside || !(v.squaredNorm() < least)) continue;
        least = v.squaredNorm(), best = v, kept = some;
    }
    s = kept;
    return best;
}
//! [nearest_of]

//! [gjk]
/// (22.1): the nearest points of two cores.
inline Nearest nearest_points(const PlacedSolid& a, const PlacedSolid& b)
{
    Simplex s;
    const auto add = [&](int i, int j) {
        const auto n = static_cast<std::size_t>(s.size++);
        s.a[n] = a.corner(i), s.b[n] = b.corner(j), s.y[n] = s.b[n] - s.a[n];
    };
    add(0, 0);
    Vec3 v = nearest_of(s);
    Real largest = v.squaredNorm();
    // Each round is strictly nearer, so it ends; the bound is for rounding alone.
    for (int round = 0; round < 128; ++round) {
        const int i = a.support(v), j = b.support(-v);
        const Vec3 y = b.corner(j) - a.corner(i);
        largest = std::max(largest, y.squaredNorm());
        const Real before = v.squaredNorm();
        if (!(v.dot(y) < before * (1 - 1e-15))) break;  // none is nearer
        const Simplex old = s;
        add(i, j);
        const Vec3 next = nearest_of(s);
        if (!(next.squaredNorm() < before)) {  // rounding: the one before was it
            s = old;
            break;
        }
        v = next;
        // the origin is inside, or as near as the corners are exact
        if (s.size == 4 || !(v.squaredNorm() > 1e-28 * largest)) {
            v.setZero();
            break;
        }
    }
    Nearest found;
    for (std::size_t k = 0; k < static_cast<std::size_t>(s.size); ++k) {
        found.on_a += s.weight[k] * s.a[k];
        found.on_b += s.weight[k] * s.b[k];
    }
    found.distance = v.norm();
    return found;
}
//! [gjk]

}  // namespace rigid
