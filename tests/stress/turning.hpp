/// \file turning.hpp
/// The second stability matrix: bodies that turn, under the methods of chapters 11 to 13.
///
/// Machinery, judge and levels are those of the first. What a method does not know, a stress does not ask for: contacts
/// between bodies from chapter 12 on, friction from chapter 13 on.
#pragma once

#include "chapters/13_friction/surfaces.hpp"
#include "tests/stress/stresses.hpp"

namespace rigid::stress {

using TurningMethod = MethodOf<RoughScene>;
using TurningStress = StressOf<RoughScene>;

/// What the methods may spend: 10 sweeps a step, small steps, or an exact answer.
std::vector<TurningMethod> turning_methods();
std::vector<TurningStress> turning_stresses();

/// The last of them but one.
TurningStress turning_bad_input();

/// What one seed changes: masses by up to this share, velocities by up to 1 mm/s of a body of `size` 1 m.
void perturb(RoughScene& scene, std::uint64_t seed, Real size = 1, Real masses = 0.05);

/// Ten rods of 1 m in a chain of pins, let go at 30°.
RoughScene slanted_rods(int count, Real end_mass, int copies = 1);

}  // namespace rigid::stress
