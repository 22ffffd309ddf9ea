/// What the tests of chapter 25 share: the step that they take, directions drawn by lot, and whether bits are the same.
#pragma once

#include "common/math.hpp"
#include "common/random.hpp"

namespace rigid {

inline constexpr Real sixtieth = 1.0 / 60;

inline Vec3 any_vector(Random& random, Real size)
{
    const Real x = random.uniform(-size, size), y = random.uniform(-size, size),
               z = random.uniform(-size, size);
    return {x, y, z};
}

inline bool same_bits(const VecX& a, const VecX& b)
{
    return a.size() == b.size() && (a.array() == b.array()).all();
}

}  // namespace rigid
