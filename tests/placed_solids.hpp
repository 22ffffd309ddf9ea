/// What the tests of chapters 22 and 23 share: hulls drawn by lot, and where they are.
#pragma once

#include "chapters/22_distance_of_solids/convex_hull.hpp"
#include "tests/solids.hpp"

namespace rigid {

inline Hull any_hull(Random& random, int points)
{
    std::vector<Vec3> cloud;
    for (int i = 0; i < points; ++i) cloud.push_back(any_vector(random, 1));
    return solid_hull(cloud);
}

inline PlacedSolid placed(const SolidForm& form, const Vec3& at, const Vec3& theta = {0, 0, 0})
{
    PlacedSolid solid;
    solid.place(form, at, rotation_matrix(theta));
    return solid;
}

}  // namespace rigid
