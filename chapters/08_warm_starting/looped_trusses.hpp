/// \file looped_trusses.hpp
/// Trusses whose rods form loops: what a warm start was not made for.
///
/// A rod couples its row to those of all rods at its two ends. Where they close a circle, sweeps have complex
/// eigenvalues, and (8.7) does not hold.
#pragma once

#include "common/elementary.hpp"
#include "common/random.hpp"
#include "common/scenes.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace rigid {

/// Discs at these places, joined by rods and otherwise alone: nothing collides, nothing weighs.
DiscScene truss(const std::vector<Vec2>& places,
                const std::vector<std::array<Index, 2>>& rods);

/// Five discs of 1 kg and seven rods; as many as make it rigid. Disc 0 moves at a millionth of a metre a second.
DiscScene five_discs_in_loops();

/// Do the segments ab and cd cross?
inline bool rods_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) {
        return cross2(q - p, r - p);
    };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// A random truss in the plane: 4 to 12 discs in a square of 2 m, masses up to a hundredfold apart, rods that do not
/// cross, at least as many as discs where the square has room: so there are loops. Each disc has a random
/// velocity of up to 1 m/s along x and y.
DiscScene looped_truss(Random& random);

}  // namespace rigid
