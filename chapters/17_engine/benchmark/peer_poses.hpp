/// \file peer_poses.hpp
/// What the worlds of two other engines have in common: a World to begin with, and where its bodies are.
#pragma once

#include "chapters/17_engine/world.hpp"

#include <vector>

namespace rigid {

/// Where a body is: x, y, θ.
using Poses = std::vector<Vec<3>>;

inline constexpr Real wall_reach = 2000;  ///< to each side [m]

}  // namespace rigid
