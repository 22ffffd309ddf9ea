/// \file convex_hull.hpp
/// The hull of some points in space, with its faces: for scenes, so it is plain and not fast.
///
///     a plane through three of the points is a face if all others lie on one side of it
///
/// Each of the N³/6 planes is tried, and what lies in it is the face: N⁴/6 dot products, two million for 60 points. Where
/// rounding makes these contradict each other, points that hardly stand out are left out.
#pragma once

#include "chapters/22_distance_of_solids/solid_form.hpp"

namespace rigid {

/// The points that lie in a plane, counterclockwise as seen from the side that n points to, without those that are
/// on the line between two others.
std::vector<int> around(const std::vector<Vec3>& points, std::vector<int> face,
                        const Vec3& n, Real flat);

/// The convex hull of these points, as a solid with sharp corners. Of points that are
/// nearer to each other than 4e-10 of their spread the first is taken. Where its faces
/// would not close so, what lies within 1e-5 of the spread of the others' hull is left
/// out. form_of() takes what is returned.
/// \throws std::invalid_argument  if they lie in a plane, if there are fewer than four
///                                of them, if one is not finite, or if the spread is
///                                not between 1e-65 and 1e75 m
Hull solid_hull(const std::vector<Vec3>& points);

}  // namespace rigid
