/// \file tossed.hpp
/// The scenes of this chapter: what is tossed, and a plate that spins.
#pragma once

#include "chapters/20_turning_in_space/solid_scene.hpp"

namespace rigid {

/// A book of 0.7 kg, 16 × 24 × 4 cm, that turns about its middle axis, and a hair
/// about the others. No gravity: we fly with it.
/// \param tilt  spin about the other two axes, as a part of ω
SolidScene tossed_book(Real omega, Real tilt);

/// A handle with a bar across its end, of steel, that spins about the handle: its middle axis.
SolidScene t_handle(Real omega, Real tilt);

/// A thin plate with the moments 1, 2 and 3 kg m², which starts with ω = (½, 0, 1): beside it there is (20.24).
SolidScene spinning_plate();

}  // namespace rigid
