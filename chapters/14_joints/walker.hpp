/// \file walker.hpp
/// A machine that walks: six of Jansen's legs on one crank, three to each side, a third of a turn apart.
///
///     38 bodies, 55 pins, 18 loops: 36 rows that close loops, one motor
///
/// At any moment a leg or more of each side stands on the ground. \cite jansen2007
#pragma once

#include "chapters/14_joints/bar_linkages.hpp"

namespace rigid {

struct Walker {
    Index chassis = 0, crank = 0;
    std::size_t motor = 0;        ///< the joint that turns the crank
    std::array<Index, 6> feet{};  ///< the triangles that touch the ground
};

/// Adds a walker whose lowest foot is at a height.
/// \param x, ground  of its axle, of the lowest foot [m]
/// \param motor      of the crank: positive, and it walks to the left
Walker add_walker(JointedScene& scene, Real x, Real ground, const Drive& motor);

}  // namespace rigid
