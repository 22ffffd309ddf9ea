/// \file friction_problems.hpp
/// Problems for solvers, without scenes: the rod that jams, and random rubble of any size.
#pragma once

#include "chapters/05_lemke/stewart_trinkle.hpp"
#include "chapters/13_friction/slopes.hpp"
#include "common/elementary.hpp"
#include "common/random.hpp"

namespace rigid {

//! [rod]
/// A of the end of a uniform rod (1 m, 1 kg) that leans at an angle to the floor,
/// for its normal and for the tangent to the right [1/kg].
struct RodEnd {
    Real nn, nt, tt;
};
inline RodEnd rod_end(Real angle)
{
    const Real c = cos(angle), s = sin(angle);
    return {1 + 3 * c * c, -3 * s * c, 1 + 3 * s * s};
}

/// (13.7): what one newton of normal force makes of the end's upward acceleration
/// while it slides to the left (−1) or to the right (+1) [1/kg].
inline Real sliding_mobility(Real angle, Real mu, int direction)
{
    const RodEnd A = rod_end(angle);
    return A.nn - direction * mu * A.nt;
}
//! [rod]

/// Rows of bodies in contact, and the velocities before the impulses.
struct FrictionRows {
    std::vector<Row<3>> rows;  ///< each normal, then its friction
    VecX u_star, inverse_mass;
};

void add_contact(FrictionRows& problem, Index a, Index b, const Vec2& n,
                 const Vec2& arm_a, const Vec2& arm_b, Real mu);

/// Rubble: bodies of 0.5 to 5 kg in layers, each on the two below it or on the ground, by one contact or by two, with
/// random arms, normals, and μ from 0 to `most_mu`; it falls for a sixtieth of a second, and is jostled.
FrictionRows random_rubble(Random& random, int contacts, Real most_mu, Real jostle);

}  // namespace rigid
