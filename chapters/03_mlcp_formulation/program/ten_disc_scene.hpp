/// \file ten_disc_scene.hpp
/// What every program that runs the ten discs shares: the time step, what can be tuned and how far, and how
/// the pointer steers gravity. In one place, so that chapters compare methods and not settings.
///
/// Both ends of each range are stable. The highest bending mode of a long chain has ω² = 160 g k / L, its
/// damper the rate γ = 16 · damping, and symplectic Euler with such a damper needs h²ω² + 2hγ < 4 (chapter 1,
/// with γ = 0: hω < 2). At the largest h with the largest k and damping the sum is 3.8.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "common/program/program.hpp"

#include <algorithm>
#include <vector>

namespace rigid {

/// Measured over 100 runs of 600 steps with k from 0 to 3: the links are never off by more than 0.4 mm. (A
/// step along a tangent stretches a link by h²u²/2L; at 1/240 s fast turns pass the millimetre.)
inline constexpr Real ten_discs_h = 1.0 / 480, ten_discs_h_low = 1e-4,
                      ten_discs_h_high = 1.0 / 120;

inline std::vector<Tunable> ten_discs_tunables()
{
    return {{"k", "", "stiffness of the torsional springs", 1, 0, 3, Numbers::real,
             OnChange::goes_on, Keys::up_and_down},
            {"damping", "1/s", "of the bends of the chain", 1, 0, 2},
            {"gravity", "m/s²", "size of gravity when the pointer is at the edge",
             9.81, 0, 20}};
}

inline const View ten_discs_view = {{0, 0.03}, {0.8, 0.58}};  ///< the box alone

/// What a scene of the ten discs has in every chapter: its time step and the pointer.
inline void set_up_ten_discs(Demo& demo)
{
    demo.h = ten_discs_h;
    demo.h_low = ten_discs_h_low;
    demo.h_high = ten_discs_h_high;
    demo.steered = true;
}

/// Gravity towards the pointer: its place relative to the middle of the picture, in halves of the picture's
/// size, at most 1 long, times `size`. Without a pointer it points down.
inline Vec2 steered_gravity(const Input& input, const View& view, Real size)
{
    if (!input.present) return {0, -size};
    const Vec2 tilt = (input.pointer - view.centre).cwiseQuotient(view.half_size);
    return size * tilt / std::max(Real{1}, tilt.norm());
}

/// The settings of a step from what the reader has set.
inline StepSettings ten_discs_settings(const Settings& settings, const Input& input)
{
    StepSettings step;
    step.h = settings.h;
    step.stiffness = settings["k"];
    step.damping = settings["damping"];
    step.hand = input.pointer;
    return step;
}

/// The disc that lies under a point; `world` if none does.
inline Index disc_under(const DiscScene& scene, const Vec2& point)
{
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if ((scene.bodies.position(k) - point).norm() <= scene.radius[k]) return k;
    return world;
}

/// The disc that the reader's hand holds: the one that lay under it when the button went down; `world` for none.
/// \param before  what it held until now
inline Index held_disc(const DiscScene& scene, bool pressed, const Vec2& hand,
                       Index before)
{
    if (!pressed) return world;
    return before != world ? before : disc_under(scene, hand);
}

}  // namespace rigid
