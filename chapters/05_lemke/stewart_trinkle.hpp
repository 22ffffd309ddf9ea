/// \file stewart_trinkle.hpp
/// Friction as a linear complementarity problem whose matrix is not symmetric, and the stack of
/// boxes that shows it.
///
/// In the plane a contact has a normal impulse λ_n, two tangential ones β₊, β₋ ≥ 0 along t and -t,
/// and the sliding speed γ ≥ 0 (13.28):
///
///     0 ≤ λ_n ⟂ w_n ≥ 0,   0 ≤ β± ⟂ γ ± v_t ≥ 0,   0 ≤ γ ⟂ μ λ_n - β₊ - β₋ ≥ 0
///
/// \cite stewart1996
#pragma once

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "common/random.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace rigid {

/// Boxes on the ground, one on the other, each touching the one below at two points.
struct BoxStack {
    Index boxes = 5;
    Real side = 1;      ///< of the square boxes [m]
    Real mass = 1;      ///< of each [kg]
    Real top_mass = 1;  ///< of the topmost [kg]
    /// each box is moved sideways against the one below by up to this share of its
    /// side
    Real offset = 0.1;
    Real friction = 0.5;    ///< μ
    Real fall = 9.81 / 60;  ///< downward speed that gravity gives in one step [m/s]
    Real jostle = 0.1;      ///< size of the random speeds of the boxes [m/s, rad/s]
    std::uint64_t seed = 1;
};

/// Contact rows of a planar scene and the velocities before the impulses.
struct ContactRows {
    std::vector<Row<3>> rows;  ///< m normal rows, then m tangential ones
    VecX u_star;               ///< [m/s, rad/s]
};

/// The rows with lever arms: ra and rb [m] lead from the centres of mass of a and b to the point, n is the normal.
///
///     C' = n·(u_b + ω_b × r_b) - n·(u_a + ω_a × r_a)
Row<3> contact_row(Index a, Index b, const Vec2& n, const Vec2& ra, const Vec2& rb,
                   const VecX& inverse_mass);

/// Throws std::invalid_argument for a stack that cannot be built.
ContactRows contact_rows(const BoxStack& stack);

/// (13.29): the LCP of m contacts with friction, in the order λ_n, β₊, β₋, γ: n =
/// 4m.
/// \param rows  A and q of the m normal rows followed by the m tangential ones
/// \param mu    coefficient of friction
Mlcp stewart_trinkle(const Mlcp& rows, Real mu);

/// The problem of a box stack: 8 rows for each box.
inline Mlcp stewart_trinkle(const BoxStack& stack)
{
    const ContactRows scene = contact_rows(stack);
    return stewart_trinkle(assemble(scene.rows, scene.u_star), stack.friction);
}

}  // namespace rigid
