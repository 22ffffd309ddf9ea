/// \file poses.hpp
/// What the worlds of other engines have in common: a World to begin with, and where its bodies are.
#pragma once

#include "chapters/19_engine/world.hpp"

#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

/// Of each body x, y, θ; or their rates.
using Poses = std::vector<Vec<3>>;

[[noreturn]] inline void refuse(JointKind kind, const std::string& engine)
{
    throw std::invalid_argument("the world has a " + std::string(to_string(kind)) +
                                " joint; the adapter of " + engine +
                                " makes revolute, distance, rope and weld");
}

inline constexpr Real wall_reach = 2000;  ///< to each side [m]

}  // namespace rigid
