/// \file wide.hpp
/// Numbers that are wider than those of the solvers, so that a judge does not share the rounding of the judged.
#pragma once

#include "common/math.hpp"

namespace rigid::properties {

#if defined(__SIZEOF_FLOAT128__)
__extension__ typedef __float128 Wide;  ///< 113 bits
inline constexpr bool wide_is_exact = true;
#else
using Wide = long double;
inline constexpr bool wide_is_exact = false;  ///< too narrow to tell a near miss from an answer
#endif

inline Wide magnitude(Wide x) { return x < 0 ? -x : x; }

}  // namespace rigid::properties
