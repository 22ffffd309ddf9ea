/// \file space.hpp
/// The fourth stability matrix: bodies in space, with and without joints and friction, under the methods of chapter 25.
///
/// Machinery, judge and levels are those of the first; the gap of a joint is that of a locked coordinate or of a limit.
#pragma once

#include "chapters/25_world_in_space/space_scene.hpp"
#include "tests/stress/stresses.hpp"

namespace rigid::stress {

using SpaceMethod = MethodOf<SpaceScene>;
using SpaceStress = StressOf<SpaceScene>;

/// What the methods may spend: ten sweeps a step, fifty, eight small steps, or an exact answer.
std::vector<SpaceMethod> space_methods();
std::vector<SpaceStress> space_stresses();

}  // namespace rigid::stress
