/// \file order_four.hpp
/// One step of order four in places and velocities, by accelerations that may not be found.
///
///     a₁ … a₄ at the start, twice in the middle and at the end,   x += h/6 (u₁ + 2 u₂ + 2 u₃ + u₄),  u likewise     (1.29)
#pragma once

#include "common/math.hpp"

#include "chapters/03_mlcp_formulation/mlcp.hpp"

namespace rigid {

//! [four]
/// \param at  (x, u, a) finds the accelerations a there [m/s²]; its status ends the step
///            unless it is `solved`, and then nothing has moved.
template <class Accelerations>
Status order_four(Real h, VecX& x, VecX& u, const Accelerations& at)
{
    VecX a1, a2, a3, a4;
    Status status = at(x, u, a1);
    if (status != Status::solved) return status;
    const VecX u2 = u + h / 2 * a1, x2 = x + h / 2 * u;
    if ((status = at(x2, u2, a2)) != Status::solved) return status;
    const VecX u3 = u + h / 2 * a2, x3 = x + h / 2 * u2;
    if ((status = at(x3, u3, a3)) != Status::solved) return status;
    const VecX u4 = u + h * a3, x4 = x + h * u3;
    if ((status = at(x4, u4, a4)) != Status::solved) return status;
    x += h / 6 * (u + 2 * u2 + 2 * u3 + u4);
    u += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    return Status::solved;
}
//! [four]

}  // namespace rigid
