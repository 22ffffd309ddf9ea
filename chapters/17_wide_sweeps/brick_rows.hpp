/// \file brick_rows.hpp
/// A problem for sweeps without a scene: the rows of a pyramid of bricks, each on two others, two points a contact, each of
/// them with friction. Its bodies fall onto each other with what gravity has given them in a step.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"

#include <vector>

namespace rigid {

struct BrickRows {
    std::vector<Row<3>> rows;  ///< all friction rows, then all normals
    Index bodies = 0;
    VecX inverse_mass;  ///< [1/kg, 1/(kg m²)]
    VecX u;             ///< u* [m/s]
};

/// \param base  bricks of 1 m and 1 kg in the lowest row; there are 4 base² rows
BrickRows brick_rows(int base);

}  // namespace rigid
