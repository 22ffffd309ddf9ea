/// \file shapes.hpp
/// The shapes of Part I. A disc is a body with a radius; a half-space is a wall of the world.
#pragma once

#include "common/math.hpp"

namespace rigid {

/// The points p with normal·p ≥ offset are free, the others are wall.
struct HalfSpace {
    Vec2 normal = {0, 1};  ///< unit vector, points out of the wall into the free space
    Real offset = 0;       ///< [m]
};

/// Two discs that a stiff massless rod of fixed length joins.
struct Link {
    Index a = 0, b = 0;
    Real length = 0;  ///< [m]
};

/// Three discs in a row; a torsional spring at the middle one wants them straight.
struct Bend {
    Index left = 0, middle = 0, right = 0;
    Real length = 0;  ///< rest length of the two links [m]
};

}  // namespace rigid
