/// \file water_faces.hpp
/// What happens at a face between two columns of water, in a row (shallow_water.hpp) or on a plane (water_field.hpp).
///
/// The loops that call these have one result an entry and no branch, so that a compiler makes lanes of them; the bits are
/// the same with lanes of any width. What is divided by infinity is zero: at a face without water nothing moves.
#pragma once

#include "chapters/29_waves/positive.hpp"
#include "common/bodies.hpp"

#include <algorithm>

namespace rigid {

/// Below it there is no water that could have a velocity: a face of less is at rest [m].
inline constexpr Real dry_depth = 1e-12;

/// The largest modulus of some numbers; infinite where one is below `least` or is none. Both
/// are looked for in pieces that stay in the cache.
inline Real largest(const VecX& list, Real least)
{
    constexpr Index piece = 2048;
    Real most = 0;
    for (Index from = 0; from < list.size(); from += piece) {
        const auto part = list.segment(from, std::min(piece, list.size() - from));
        Index fine = 1;
        for (Index i = 0; i < part.size(); ++i)
            fine &= Index{part[i] >= least} & Index{part[i] < infinity};
        if (fine == 0) return infinity;
        most = std::max(most, part.cwiseAbs().maxCoeff());
    }
    return most;
}

/// Throws std::invalid_argument for a step in which a wave passes a whole cell.
/// \param longest  that no wave does it in [s]
inline void require_shorter(Real h, Real longest)
{
    if (!(h <= longest * (1 + 1e-12)))
        throw std::invalid_argument("the time step is " + shortest(h) +
                                    " s; a wave passes a whole cell in " +
                                    shortest(longest) + " s");
}

/// The part of a velocity that leaves a cell through its face.
inline Real outwards(Real u) { return u > 0 ? u : 0; }

/// q: what flows through a face, of water as deep as the cell gives it from which it comes [m²/s].
inline Real flow_through(Real u, Real given_before, Real given_behind)
{
    return u * (u >= 0 ? given_before : given_behind);
}

/// What a flow carries at the velocity of the face it comes from.
inline Real carried_by(Real flow, Real before, Real behind)
{
    return flow * (flow >= 0 ? before : behind);
}

/// A velocity from the momentum at a face and the mean depth there.
inline Real velocity_of(Real momentum, Real depth_before, Real depth_behind)
{
    const Real mean = (depth_before + depth_behind) / 2;
    return momentum / (mean > dry_depth ? mean : infinity);
}

/// Some cells that lie beside each other in memory.
struct CellRow {
    const Real *bed, *depth, *level;
};

//! [push]
/// (29.11): slopes change the velocities of `count` faces, each between a cell of `l` and
/// one of `r`. \param gain  h g / Δx \param part, damping  of each face; without `damped`
/// damping is not read
template <bool damped>
void push_faces(Index count, CellRow l, CellRow r, Real gain, const Real* part,
                Real h, const Real* damping, Real* __restrict u)
{
    for (Index f = 0; f < count; ++f) {
        Real pushed = u[f] - gain * part[f] * (r.level[f] - l.level[f]);
        if (damped) pushed /= 1 + h * damping[f];
        // water on one side, and on the other a dry bed that is higher: a shore
        Real open = 1;
        open = ((r.depth[f] <= dry_depth) & (r.bed[f] >= l.level[f])) ? 0 : open;
        open = ((l.depth[f] <= dry_depth) & (l.bed[f] >= r.level[f])) ? 0 : open;
        open = (l.depth[f] + r.depth[f]) / 2 > dry_depth ? open : 0;
        u[f] = pushed * open;
    }
}
//! [push]

}  // namespace rigid
