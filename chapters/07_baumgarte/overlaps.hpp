/// \file overlaps.hpp
/// Scenes that begin with an overlap, which is to be undone.
#pragma once

#include "common/scenes.hpp"
#include "common/text.hpp"

#include <stdexcept>
#include <string>

namespace rigid {

/// A disc of 1 kg and radius 0.5 m that lies `depth` deep in the floor.
DiscScene sunken_disc(Real depth);

/// N discs of 1 kg and radius 0.25 m in a column between walls, each overlapping the next, and the lowest the
/// floor, by `depth`. Throws std::invalid_argument unless that is less than a radius, so that none overlaps the
/// next but one.
DiscScene crowd(Index count, Real depth);

}  // namespace rigid
