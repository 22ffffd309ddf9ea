/// \file stacks.hpp
/// The scenes of this chapter, with the closed forms that they are measured against.
#pragma once

#include "chapters/12_contact_manifolds/manifold_method.hpp"
#include "common/elementary.hpp"

namespace rigid {

/// A box that lies across the end of another, as in Figure 12.1: 3 kg, a third of its weight on its own corner.
RigidScene box_over_an_end();

/// Boxes of 1 kg and 1 m, one on another on a floor.
RigidScene box_stack(int boxes, Real width = 1);

/// A pyramid with so many boxes of 1 m at its foot, 0.05 m apart.
RigidScene box_pyramid(int base);

/// N blocks of 1 m by 0.25 m over the end of a table at x = 0, each as far out as it may be, times `part`: the block
/// k from the top lies 1/(2k) m farther out than the one below it, (12.6).
RigidScene overhang(int blocks, Real part);

/// A block on a floor without friction, tilted about its lower left corner. If `held`, a rail keeps the middle of its foot
/// over x = 0, so that its corners do not slide when they strike, as friction would.
RigidScene block_on_floor(Real half_width, Real half_height, Real tilt, bool held);

/// ω after an impact of the other corner divided by ω before it: what is left of the angular momentum about that corner,
/// (12.7) \cite housner1963.
inline Real housner_ratio(Real half_width, Real half_height)
{
    const Real w = half_width * half_width, h = half_height * half_height;
    return 1 - 1.5 * w / (w + h);
}

/// ω about its corner, on a floor without friction, with which a block that stands upright just goes over, (12.16)
/// [rad/s].
inline Real tipping_speed(Real half_width, Real half_height, Real g)
{
    const Real w = half_width * half_width, h = half_height * half_height;
    return std::sqrt(2 * g * (std::sqrt(w + h) - half_height) / (w + (w + h) / 3));
}

/// A regular polygon of 1 m from the centre to each corner that a motor turns on a floor without friction.
RigidScene roller(int corners, Real speed);

/// A bullet of 1 cm at 300 m/s, 3 m before a wall of 1 cm; no gravity.
/// \param angle  of its way to the wall's normal [rad]
/// \param shape  of the bullet
RigidScene bullet(const Polygon& shape, Real angle, Real spin);

/// Shapes of all kinds that fall into a trough of three fixed boxes.
RigidScene pile(int bodies);

}  // namespace rigid
