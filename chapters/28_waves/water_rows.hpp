/// \file water_rows.hpp
/// What a step of shallow water does to a row of cells and of the faces between them, for water in one and in two directions.
///
///     faces lie between a row of cells `low` and one of cells `high`: along x the same row, shifted by a cell;
///     across it two rows that lie side by side
///
/// Every loop has one result to an entry and no branch, so that a compiler makes lanes of it, and the bits are the same with
/// lanes of any width.
#pragma once

#include "common/bodies.hpp"

namespace rigid::water_rows {

/// Below it there is no water that could have a velocity: a face of less is at rest [m].
constexpr Real dry = 1e-12;

/// What a face sees of the cells on one of its sides.
struct Side {
    const Real *bed, *depth, *level;
};

//! [push_faces]
/// (28.15) for n faces. At rest is one without water, and one beyond which the bed is
/// dry and higher than the water: a shore.
inline void push_faces(Index n, Real slope_to_speed, Side low, Side high,
                       Real* __restrict u)
{
    for (Index f = 0; f < n; ++f) {
        const bool shore =
            (((high.depth[f] <= dry) & (high.bed[f] >= low.level[f])) |
             ((low.depth[f] <= dry) & (low.bed[f] >= high.level[f])));
        const bool wet = (low.depth[f] + high.depth[f]) / 2 > dry;
        const Real pushed = u[f] - slope_to_speed * (high.level[f] - low.level[f]);
        u[f] = wet & !shore ? pushed : 0;
    }
}
//! [push_faces]

inline Real outwards(Real u) { return u > 0 ? u : 0; }

/// How deep the water is that may leave a cell in a step, so that none gives more than it has.
/// \param parting  the sum of the velocities out of it times h / Δx
inline Real giving(Real depth, Real parting)
{
    return depth / (parting > 1 ? parting : 1);
}

/// (28.16): q of n faces, the depth being that of the cell from which the water comes.
inline void fluxes(Index n, const Real* __restrict u, const Real* __restrict low,
                   const Real* __restrict high, Real* __restrict q)
{
    for (Index f = 0; f < n; ++f) q[f] = u[f] * (u[f] >= 0 ? low[f] : high[f]);
}

/// (28.17): the momentum that the mean of two flows carries, at the velocity of the side it comes from.
inline Real carried(Real q, Real p, Real low, Real high)
{
    const Real mean = (q + p) / 2;
    return mean * (mean >= 0 ? low : high);
}

/// The same of n places between faces whose flows are q and p.
inline void carry(Index n, const Real* __restrict q, const Real* __restrict p,
                  const Real* __restrict low, const Real* __restrict high,
                  Real* __restrict out)
{
    for (Index i = 0; i < n; ++i) out[i] = carried(q[i], p[i], low[i], high[i]);
}

/// Momentum over depth is a velocity, where there is water.
inline Real velocity(Real momentum, Real depth)
{
    const Real u = momentum / (depth > dry ? depth : 1);
    return depth > dry ? u : 0;
}

/// max(|a|, |b|).
inline Real larger_size(Real a, Real b)
{
    const Real p = a < 0 ? -a : a, q = b < 0 ? -b : b;
    return p > q ? p : q;
}

/// The largest of n numbers that are not negative; the order of comparisons does not matter.
inline Real largest(Index n, const Real* __restrict values)
{
    constexpr Index lanes = 8;
    Real most[lanes] = {};
    Index i = 0;
    for (; i + lanes <= n; i += lanes)
        for (Index k = 0; k < lanes; ++k)
            most[k] = values[i + k] > most[k] ? values[i + k] : most[k];
    for (; i < n; ++i) most[0] = values[i] > most[0] ? values[i] : most[0];
    Real all = 0;
    for (const Real m : most) all = m > all ? m : all;
    return all;
}

}  // namespace rigid::water_rows
