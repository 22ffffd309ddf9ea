/// \file look_ahead.hpp
/// Solids that could close a gap within this step: how far from each of them a row is looked for.
#pragma once

#include "chapters/23_faces_that_touch/solid_pairs.hpp"

namespace rigid {

/// (12.14), of the bodies that are looked at.
/// \param most  how far at most [inner radii]; not to walls: they have no corner
void look_ahead(const SolidScene& scene, Real margin, Real h, Real most,
                SolidPairs& near);

}  // namespace rigid
