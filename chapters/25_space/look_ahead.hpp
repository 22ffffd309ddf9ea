/// \file look_ahead.hpp
/// Solids that could close a gap within this step: how far from each of them a row is looked for.
#pragma once

#include "chapters/25_space/solid_pairs.hpp"

namespace rigid {

/// (12.14), of the bodies that are looked at.
/// \param most  how far at most [inner radii]
void look_ahead(const SpaceScene& scene, Real margin, Real h, Real most,
                SolidPairs& near);

}  // namespace rigid
