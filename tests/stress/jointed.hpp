/// \file jointed.hpp
/// The third stability matrix: bodies on joints, under the methods of chapters 14 to 16, the engine of chapter 19 and
/// the ways of chapter 26.
///
/// Machinery, judge and levels are those of the first; the gap of a joint is that of its frame, its rope or its limit.
#pragma once

#include "tests/stress/turning.hpp"

namespace rigid::stress {

using JointedMethod = MethodOf<JointedScene>;
using JointedStress = StressOf<JointedScene>;

/// What the methods may spend: ten sweeps a step, eight small steps, or an exact answer.
std::vector<JointedMethod> jointed_methods();
std::vector<JointedStress> jointed_stresses();

/// The ways of chapter 26 as columns of this matrix, and of the one of bodies that turn.
std::vector<JointedMethod> ways_with_joints();
std::vector<TurningMethod> ways_of_turning();

}  // namespace rigid::stress
