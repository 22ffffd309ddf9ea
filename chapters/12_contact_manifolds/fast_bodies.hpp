/// \file fast_bodies.hpp
/// Bodies that move so far in a step that they could be on the other side of something before anybody has looked.
///
/// A body that moves by no more than half its inner radius, from its centroid to its nearest side, is still on the side it
/// came from, and its contact pushes it back there. Any other is fast: at the end of the step it goes back along its way to
/// its first impact (time_of_impact.hpp). It loses the rest of the step's time, and what its weight did in it (12.10); the
/// next step finds the contact. Two that are close already, or have a row and go no farther than they are long, are held by
/// it; they are only stopped when one gets half its inner radius deep into the other, or by an eighth deeper than it was. A
/// thin body whose foot stands there and turns goes deeper, as a step is straight: the foot of a rod of length L by
/// L (ωh)²/4. If it were stopped, it would lose time in each step. Nothing comes out behind a half-space, nor behind an edge
/// of a chain while its centroid is in front, so there it may go in by half the margin and is held by its row (in a
/// half-space: where rows look ahead). What stops early stands in the way of others: fast bodies are looked at in pairs again
/// until none of them stops any earlier. A body that nothing can move is never stopped; others are stopped at it.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/12_contact_manifolds/chains.hpp"
#include "chapters/12_contact_manifolds/flush_faces.hpp"
#include "chapters/12_contact_manifolds/pair_finder.hpp"
#include "chapters/12_contact_manifolds/stop_each_other.hpp"
#include "chapters/12_contact_manifolds/touching_pair.hpp"
#include "common/elementary.hpp"

namespace rigid {

struct FastBodies {
    bool stop = true;  ///< false: nothing is looked for
    /// of each body, 1: it is never stopped; empty = all may be
    std::vector<char> goes_on;
    /// what comes near to a half-space in the step has its row (look_ahead.hpp)
    bool have_rows = false;
    bool seams = false;  ///< nothing catches on flush faces (flush_faces.hpp)
    // What the last step found.
    std::vector<int> bodies;  ///< that were fast
    int impacts = 0;          ///< of those, stopped on their way
    int rounds = 0;           ///< distances computed
    std::vector<Real> part;   ///< of the way that each body goes
    std::vector<Box> swept;   ///< of each of them: all that it can reach
    std::vector<char> is_fast;
    std::vector<char> is_held;  ///< 1: a row of the step acts on the body
    std::vector<Real> inner;    ///< their inner radii [m]
    std::vector<std::pair<int, int>> pairs;  ///< of fast bodies that may meet
    BoxSweep sweep;
    ImpactMemory memory;
};

//! [lost_time]
/// (12.10): what the force on body k did in the time that it has lost. With nothing
/// else at work that is a velocity. Where rows were at work they may have borne it:
/// then only the energy of the way that it did not go is taken back.
/// \param lost  time [s]
/// \param free  no row of the step acts on it
inline void take_back(Bodies<3>& bodies, Index k, Real lost, bool free)
{
    auto u = bodies.velocity(k);
    const Vec<3> gained = lost * bodies.apply_inverse_mass(k, bodies.force(k));
    if (free) u -= gained;
    else if (const Real work = gained.head<2>().dot(u.head<2>()); work > 0)
        u.head<2>() *=
            std::sqrt(std::max(Real{0}, 1 - 2 * work / u.head<2>().squaredNorm()));
}

/// Puts the fast bodies that were stopped where they stop.
/// \param motion  MovingShape(int): the way of a body in this step
template <class Motion>
void put_back(RigidScene& scene, Real h, const std::vector<Row<3>>& rows,
              const Motion& motion, FastBodies& fast)
{
    Index last = world;
    for (const int shape : fast.bodies) {
        const Index k = scene.carrier(shape);
        const Real part = fast.part[static_cast<std::size_t>(k)];
        // the shapes of a body are neighbours
        if (part >= 1 || std::exchange(last, k) == k) continue;
        if (fast.impacts++ == 0) {
            fast.is_held.assign(fast.is_fast.size(), 0);
            for (const Row<3>& row : rows)
                for (const Index body : {row.a, row.b})
                    if (body != world)
                        fast.is_held[static_cast<std::size_t>(body)] = 1;
        }
        scene.bodies.position(k) = motion(k).at(part);
        take_back(scene.bodies, k, (1 - part) * h,
                  fast.is_held[static_cast<std::size_t>(k)] == 0);
    }
}
//! [lost_time]

/// \param now        of the step that has just been taken
/// \param settings   of it: bodies are stopped at a quarter to a half of the margin
/// \param placed     the shapes at now.x_found
/// \param edges      of chains: what slides over them is close to the next one when
///                   it gets there, and goes on until it is too deep
/// \param finder     of the pairs at now.x_found
/// \param touching   those that have rows in the step, ascending
void stop_fast_bodies(RigidScene& scene, const StepSettings& settings,
                      const StepData<3>& now, const PlacedShapes& placed,
                      const ChainEdges& edges, const PairFinder& finder,
                      const std::vector<TouchingPair>& touching, FastBodies& fast);

}  // namespace rigid
