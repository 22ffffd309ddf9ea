/// \file shapes.hpp
/// The shapes of Part I. A disc is a body with a radius; half-spaces and segments are walls of the world.
#pragma once

#include "common/math.hpp"

namespace rigid {

/// The points p with normal·p ≥ offset are free, the others are wall.
struct HalfSpace {
    Vec2 normal = {0, 1};  ///< unit vector, points out of the wall into the free space
    Real offset = 0;       ///< [m]
};

/// A wall from p to q, as thick as its radius to both sides and round at its ends; with the radius 0 it is a line. It is
/// solid from both sides, and only as deep as it is thick: what moves farther than that in a step may pass through.
struct Segment {
    Vec2 p = {0, 0}, q = {1, 0};  ///< [m]
    Real radius = 0;              ///< [m]
};

/// Two discs that a stiff massless rod of fixed length joins.
struct Link {
    Index a = 0, b = 0;
    Real length = 0;  ///< [m]
};

/// What else two bodies, or the world and a body, must keep to; chapter 2 has C and J of each kind.
struct Joint {
    enum class Kind : unsigned char {
        rail,   ///< the distance along `direction` is `length`
        stop,   ///< it is at least `length`
        rope,   ///< the distance is at most `length`, in any direction
        motor,  ///< the distance along `direction` grows at `speed`, as far as ±`force` can bring it there
    };
    Kind kind = Kind::rail;
    Index a = -1;  ///< −1: the world
    Index b = 0;
    Vec2 direction = {0, 1};  ///< unit vector, from a to b; not of a rope
    Real length = 0;          ///< [m]
    Real speed = 0;           ///< of a motor [m/s]
    Real force = 0;           ///< of a motor, zero or positive [N]
};

/// Three discs in a row; a torsional spring at the middle one pulls them straight.
struct Bend {
    Index left = 0, middle = 0, right = 0;
    Real length = 0;  ///< rest length of the two links [m]
};

}  // namespace rigid
