/// \file inertia.hpp
/// Mass, centroid and inertia of solids: one integral over a tetrahedron, and what is round in closed form.
///
///     tetrahedron (0, a, b, c)    V = a·(b × c)/6,  ∫ r rᵀ = V/20 (a aᵀ + b bᵀ + c cᵀ + s sᵀ),  s = a + b + c   (20.15)
///     any body                    I = tr(S) 1 − S,  S = ∫ r rᵀ dm about the centroid                           (20.6)
///     principal axes              A with Aᵀ I A diagonal, by Jacobi's rotations                                (20.16)
#pragma once

#include "chapters/20_turning_in_space/rotation.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

/// A convex body: everything within `radius` of a convex polyhedron, as in the plane. One vertex is a ball, two are a
/// capsule; a polyhedron has faces, each a list of its vertices counterclockwise as seen from outside.
struct Hull {
    std::vector<Vec3> vertices;
    std::vector<std::vector<int>> faces;
    Real radius = 0;  ///< [m]

    bool operator==(const Hull&) const = default;
};

struct SolidMass {
    Real mass = 0;                ///< [kg]
    Vec3 centroid = {0, 0, 0};    ///< [m]
    Mat3 inertia = Mat3::Zero();  ///< about the centroid [kg m²]
};

inline Hull solid_ball(Real radius) { return {{Vec3(0, 0, 0)}, {}, radius}; }

/// A capsule along x; its round ends reach `radius` beyond the length.
inline Hull solid_capsule(Real length, Real radius)
{
    return {{Vec3(-length / 2, 0, 0), Vec3(length / 2, 0, 0)}, {}, radius};
}

/// A box of these edges.
/// \param at  its centre
Hull solid_box(const Vec3& size, const Vec3& at = {0, 0, 0});

/// I from the second moments, (20.6).
inline Mat3 inertia_of(const Mat3& S) { return S.trace() * Mat3::Identity() - S; }

//! [tetrahedra]
/// The integrals of 1, r and r rᵀ over a polyhedron, tetrahedron by tetrahedron:
/// each triangle of its surface with the origin, (20.15).
struct Moments {
    Real volume = 0;
    Vec3 first = {0, 0, 0};
    Mat3 second = Mat3::Zero();
};

inline Moments moments_of(const Hull& hull)
{
    Moments all;
    for (const std::vector<int>& face : hull.faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            const auto corner = [&](std::size_t k) -> const Vec3& {
                return hull.vertices[static_cast<std::size_t>(face[k])];
            };
            const Vec3 &a = corner(0), &b = corner(i), &c = corner(i + 1);
            const Vec3 s = a + b + c;
            const Real volume = a.dot(cross(b, c)) / 6;
            all.volume += volume;
            all.first += volume / 4 * s;
            all.second += volume / 20 *
                          (a * a.transpose() + b * b.transpose() +
                           c * c.transpose() + s * s.transpose());
        }
    return all;
}
//! [tetrahedra]

/// Throws std::invalid_argument for a face that names a vertex that is not there.
void require_vertices(const Hull& hull);

/// A ball and a capsule along any line, of unit density, in closed form (20.17).
SolidMass round_mass(const Hull& hull);

/// Mass, centroid and inertia of a uniform body.
/// \param density  [kg/m³]
/// Throws std::invalid_argument for a density that is not positive, for a negative
/// radius, for a body without volume, for faces that do not close or that name a
/// vertex that is not there, and for a polyhedron with a radius: only its core has a
/// closed form here.
SolidMass mass_of(const Hull& hull, Real density);

/// A body of several hulls that do not overlap: masses add, and each inertia is
/// moved to the common centroid, (20.18).
/// Throws std::invalid_argument for what mass_of() of one hull refuses, and for none.
SolidMass mass_of(const std::vector<Hull>& hulls, Real density);

/// Principal moments, and the axes that they belong to as the columns of a rotation matrix.
struct PrincipalAxes {
    Vec3 moments;
    Mat3 axes = Mat3::Identity();
};

//! [jacobi]
/// (20.16): Jacobi's method. Each rotation, in the plane of two axes, makes one
/// entry beside the diagonal zero; six rounds leave nothing of a 3×3 matrix.
inline PrincipalAxes principal_axes(Mat3 I)
{
    PrincipalAxes result;
    for (int round = 0; round < 6; ++round)
        for (int i = 0; i < 3; ++i) {
            const int p = i, q = (i + 1) % 3;
            if (!(std::abs(I(p, q)) > 1e-16 * I.trace())) continue;
            const Real cot = (I(q, q) - I(p, p)) / (2 * I(p, q));
            const Real t =
                (cot < 0 ? -1 : 1) / (std::abs(cot) + std::sqrt(cot * cot + 1));
            const Real c = 1 / std::sqrt(t * t + 1), s = t * c;
            Mat3 turn = Mat3::Identity();
            turn(p, p) = turn(q, q) = c;
            turn(p, q) = s, turn(q, p) = -s;
            I = turn.transpose() * I * turn;
            result.axes = result.axes * turn;
        }
    result.moments = I.diagonal();
    return result;
}
//! [jacobi]

/// Throws std::invalid_argument unless these can be the principal moments of a body: positive, and none larger than
/// the sum of the other two (I₁ + I₂ − I₃ is twice an integral of a square).
void require_moments(const Vec3& moments);

/// The rotation vector of a rotation matrix.
inline Vec3 rotation_vector(const Mat3& R)
{
    // One of 4w², 4x², 4y², 4z² is at least 1: a quotient by it loses nothing.
    const Real four_w2 = 1 + R.trace();
    Quaternion q{four_w2,
                 {R(2, 1) - R(1, 2), R(0, 2) - R(2, 0), R(1, 0) - R(0, 1)}};
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const Real four_v2 = 1 + R(i, i) - R(j, j) - R(k, k);
        if (!(four_v2 > 1)) continue;
        q.w = R(k, j) - R(j, k);
        q.v[i] = four_v2;
        q.v[j] = R(i, j) + R(j, i);
        q.v[k] = R(i, k) + R(k, i);
        break;
    }
    return rotation_vector(q);
}

}  // namespace rigid
