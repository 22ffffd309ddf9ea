/// \file membrane.hpp
/// A membrane, or the height field of water a little out of level: masses on a grid, each pulled by its four neighbours.
///
///     dv/dt = c² (y_left + y_right + y_below + y_above − 4 y) / Δx²,   leapfrog as on the string, stable up to C = 1/√2
///
/// Each step reads and writes y and v once: a row's places are moved when the row above it has its velocities, while both
/// are still in the cache. So a step costs 32 bytes of memory a cell, and hardly anything else.
#pragma once

#include "common/bodies.hpp"

namespace rigid {

struct Membrane {
    Index nx = 0, ny = 0;  ///< intervals
    Real dx = 1;           ///< [m], both ways
    Real c = 1;            ///< speed of waves [m/s]
    /// fixed: a drum's rim; else free, as water at a wall, where the edge has half a mass
    bool fixed_edges = true;
    Real damping = 0;  ///< [1/s]
    VecX y,
        v;  ///< (nx + 1)(ny + 1), row after row [m, m/s]; v is half a step before y

    /// At rest. Throws std::invalid_argument for fewer than two intervals, a width or a speed that is not positive.
    Membrane(Index nx, Index ny, Real interval, Real speed, bool fixed);

    Index at(Index i, Index j) const { return j * (nx + 1) + i; }
};

/// Throws std::invalid_argument, naming what is wrong, unless all is finite and of its size.
void require_valid(const Membrane& membrane);

/// v ← v − (h/2) a, which leapfrog begins with. Throws std::invalid_argument for a membrane that is not valid; steps look
/// at its sizes and constants alone.
void start_leapfrog(Membrane& membrane, Real h);

/// One step. Throws std::invalid_argument for a step that is not positive or beyond C = 1/√2.
void leapfrog(Membrane& membrane, Real h);

/// What leapfrog keeps to rounding without damping, as on the string, per mass of an area [J m²/kg].
Real leapfrog_energy(const Membrane& membrane, Real h);

/// Pushes the surface down around (x, y) by a smooth dent of this radius, whose mean over the membrane is taken off again
/// at free edges, so that no water is lost. \param depth  [m]
void touch(Membrane& membrane, Real x, Real y, Real radius, Real depth);

}  // namespace rigid
