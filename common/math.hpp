/// \file math.hpp
/// The few mathematical names that every chapter uses.
#pragma once

#include <Eigen/Core>
#include <limits>

#ifdef RIGID_ALIGN_BYTES  // as rigid::physics was compiled
static_assert(
    EIGEN_MAX_ALIGN_BYTES == RIGID_ALIGN_BYTES,
    "Eigen aligns memory otherwise here than where rigid::physics was compiled, and each would free what the "
    "other allocated: compile both for the same instruction set (-march=native for both or for none)");
#endif

namespace rigid {

using Real = double;
using Index = Eigen::Index;

template <int N>
using Vec = Eigen::Matrix<Real, N, 1>;  ///< a column of N numbers
template <int N>
using RowVec = Eigen::Matrix<Real, 1, N>;  ///< a line of N numbers, such as a block of J

using Vec2 = Vec<2>;
using VecX = Vec<Eigen::Dynamic>;
using MatX = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

inline constexpr Real infinity = std::numeric_limits<Real>::infinity();
/// A coordinate or a coefficient beyond it is refused, and a length below its inverse (chapters 11 to 25): the fourth power,
/// which an inertia has, must be a number.
inline constexpr Real largest_number = 1e75;
inline constexpr Real pi = 3.14159265358979323846;

/// d over its length, a unit vector; `otherwise` for what is shorter than 10⁻⁷⁵: the squares of a length of 10⁻¹⁵⁰ have lost
/// their digits.
inline Vec2 direction_of(const Vec2& d, Real length, const Vec2& otherwise)
{
    return length > 1 / largest_number ? Vec2(d / length) : otherwise;
}

/// The third component of the cross product of two plane vectors: a.x b.y - a.y b.x.
inline Real cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// The vector turned by a quarter turn counterclockwise: (x, y) becomes (-y, x).
inline Vec2 perpendicular(const Vec2& a) { return {-a.y(), a.x()}; }

}  // namespace rigid
