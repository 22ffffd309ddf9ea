/// Bits of vectors, and the step that the tests of solids take.
#pragma once

#include "common/math.hpp"

namespace rigid {

inline constexpr Real sixtieth = 1.0 / 60;

inline bool same_bits(const VecX& a, const VecX& b)
{
    return a.size() == b.size() && (a.array() == b.array()).all();
}

}  // namespace rigid
