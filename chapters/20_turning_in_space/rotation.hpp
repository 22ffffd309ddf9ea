/// \file rotation.hpp
/// Rotations in space: how one is stored, how the next is added, how it acts on a vector.
///
///     θ = α a                 the rotation vector: the axis a times the angle α, |θ| ≤ π          three numbers
///     exp θ = (cos α/2, a sin α/2)     a unit quaternion                                           (20.12)
///     exp θ ∘ exp δ           first δ in the body's own axes, then θ; its rotation vector is θ ⊕ δ (20.4)
///     R r = r + 2 w (v × r) + 2 v × (v × r)                                                        (20.13)
///
/// Three numbers to a rotation, so a body has 3 + 3 of them and `Bodies<6>` is made as `Bodies<3>` is. A vector of
/// |θ| > π is the same rotation as a shorter one; rotation_vector() gives the shorter one.
#pragma once

#include "common/elementary.hpp"

#include <cmath>

namespace rigid {

using Vec3 = Vec<3>;
using Mat3 = Eigen::Matrix<Real, 3, 3>;

//! [cross]
inline Vec3 cross(const Vec3& a, const Vec3& b)
{
    return {a.y() * b.z() - a.z() * b.y(), a.z() * b.x() - a.x() * b.z(),
            a.x() * b.y() - a.y() * b.x()};
}

/// (20.2): the matrix of r ↦ a × r.
inline Mat3 cross_matrix(const Vec3& a)
{
    Mat3 A;
    A << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
    return A;
}
//! [cross]

/// A unit vector across n: from the axis that n leans to least.
inline Vec3 across(const Vec3& n)
{
    Index least = 0;
    for (Index i = 1; i < 3; ++i)
        if (std::abs(n[i]) < std::abs(n[least])) least = i;
    Vec3 e(0, 0, 0);
    e[least] = 1;
    return (e - n * n[least]).normalized();
}

/// A quaternion w + x i + y j + z k, with v = (x, y, z).
struct Quaternion {
    Real w = 1;
    Vec3 v = {0, 0, 0};
};

//! [product]
/// (20.11): the rotation of p after that of q.
inline Quaternion operator*(const Quaternion& p, const Quaternion& q)
{
    return {p.w * q.w - p.v.dot(q.v), p.w * q.v + q.w * p.v + cross(p.v, q.v)};
}
//! [product]

//! [exp]
/// (20.12): the unit quaternion of a rotation vector.
inline Quaternion quaternion_of(const Vec3& theta)
{
    const Real angle = theta.norm();
    const Real sine_over_angle = angle > 0 ? sin(angle / 2) / angle : 0.5;
    return {cos(angle / 2), sine_over_angle * theta};
}

/// Back: the rotation vector of a quaternion, no longer than π. Its length does not
/// matter, nor its sign: q and −q turn alike.
inline Vec3 rotation_vector(const Quaternion& q)
{
    const Real sine = q.v.norm(), sign = q.w < 0 ? -1 : 1;
    if (!(sine > 0)) return {0, 0, 0};
    return (sign * 2 * atan2(sine, sign * q.w) / sine) * q.v;
}
//! [exp]

//! [matrix]
/// (20.13): R of a unit quaternion.
inline Mat3 rotation_matrix(const Quaternion& q)
{
    const Mat3 V = cross_matrix(q.v);
    return Mat3::Identity() + 2 * q.w * V + 2 * V * V;
}
inline Mat3 rotation_matrix(const Vec3& theta)
{
    return rotation_matrix(quaternion_of(theta));
}
//! [matrix]

//! [add]
/// (20.4): θ ⊕ δ, the body's rotation after it has turned by δ in its own axes.
inline Vec3 add_rotation(const Vec3& theta, const Vec3& delta)
{
    return rotation_vector(quaternion_of(theta) * quaternion_of(delta));
}
//! [add]

inline Real determinant(const Mat3& A)
{
    return A.col(0).dot(cross(A.col(1), A.col(2)));
}

/// x of A x = r for 3×3, by Cramer's rule. The caller knows that A is regular.
inline Vec3 solve3(const Mat3& A, const Vec3& r)
{
    const Vec3 a = A.col(0), b = A.col(1), c = A.col(2), bc = cross(b, c);
    return Vec3(r.dot(bc), a.dot(cross(r, c)), a.dot(cross(b, r))) / a.dot(bc);
}

}  // namespace rigid
