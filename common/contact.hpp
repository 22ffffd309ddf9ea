/// \file contact.hpp
/// Which discs touch each other or a wall, or nearly do.
///
/// The normal points from a to b and the gap is positive while they are apart. Here each
/// pair is tested, N²/2 of them; chapter 10 finds out which of them it can leave out.
#pragma once

#include "common/bodies.hpp"
#include "common/shapes.hpp"

#include <vector>

namespace rigid {

struct Contact {
    Index a = world, b = 0;  ///< the bodies; a wall of the world is always a
    Vec2 normal = {0, 1};    ///< unit vector from a to b
    Real gap = 0;            ///< distance of the surfaces [m]; negative = penetration
    Index feature = 0;       ///< which of several contacts of this pair: the number of the wall
};

/// Collects the contacts of discs with each other and with walls whose gap is below the margin.
/// \param x         disc centres [m], 2K numbers
/// \param radius    [m], K numbers
/// \param linked    true at [a*K + b] for pairs that must not collide; empty = all collide
/// \param margin    [m]; a contact with a gap of up to this much is reported before it closes
/// \param contacts  is emptied and filled: pairs a < b in ascending order, then walls. Its
///                  memory is kept, so that a steady scene does not allocate.
/// \throws std::invalid_argument  if these are not the sizes of one scene, or the margin is no number
void find_contacts(const VecX& x, const VecX& radius, const std::vector<HalfSpace>& walls,
                   const std::vector<bool>& linked, Real margin, std::vector<Contact>& contacts);

}  // namespace rigid
