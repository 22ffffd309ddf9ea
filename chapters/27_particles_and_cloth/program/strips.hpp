/// \file strips.hpp
/// Strips that are clamped level, of unit length and EI = 1, by each model of bending, beside the elastica \cite romero2021.
#pragma once

#include "chapters/27_particles_and_cloth/cloth_scenes.hpp"
#include "chapters/27_particles_and_cloth/cloth_step.hpp"
#include "chapters/27_particles_and_cloth/program/elastica.hpp"

namespace rigid {

struct StripSpec {
    /// 0: lines and twists, 1: angles, 2: slopes about edges, 3: a rope with springs to
    /// each second particle
    int model = 0;
    int segments = 16;
    bool alternate = true;
    Real diagonals = 1;  ///< stiffness of hinges about diagonals, in that of others
    Real across = 3e5;   ///< of each spring of model 3 [N/m]
};

/// \param load  Γ = q L³/EI of its weight, or P L²/EI of a load at its end
inline ClothScene strip_under(const StripSpec& spec, Real load, bool at_the_end)
{
    const int n = spec.segments;
    const bool rope = spec.model == 3;
    const Bending how[]{Bending::quadratic, Bending::angle, Bending::edges};
    ClothScene strip =
        rope ? clamped_strip_across(n, spec.across)
             : clamped_strip(n, 2, how[spec.model], spec.alternate, spec.diagonals);
    if (!at_the_end) strip.gravity = {0, -load, 0};
    else if (rope) strip.bodies.f[3 * n + 1] = -load;
    else
        for (int j = 0; j <= 2; ++j)  // the lines at the sides bear half
            strip.bodies.f[3 * (n + 1 + (n + 2) * j) + 1] =
                -load / (j == 1 ? 2 : 4);
    return strip;
}

/// The particle at the end of a strip, in its middle.
inline int tip_of(const StripSpec& spec)
{
    return spec.model == 3 ? spec.segments : 2 * spec.segments + 3;
}

/// How far the end of a strip hangs down where all forces balance, over how far it reaches out: Newton's steps of three
/// seconds, each from rest, until nothing moves by a nanometre.
inline Real height_over_width(const StripSpec& spec, Real load, bool at_the_end)
{
    ClothScene strip = strip_under(spec, load, at_the_end);
    ClothMemory memory;
    ClothSettings how;
    how.h = 3, how.method = ClothMethod::newton;
    memory.newton.iterations = 20, memory.newton.tolerance = 1e-9;
    for (int n = 0; n < 1000; ++n) {
        const VecX before = strip.bodies.x;
        step(strip, how, memory);
        strip.bodies.u.setZero();
        if ((strip.bodies.x - before).cwiseAbs().maxCoeff() < 1e-9) break;
    }
    const Vec3 tip = strip.bodies.position(tip_of(spec));
    return -tip.y() / tip.x();
}

/// Which part of its EI a strip shows that has this height over width: the load over that under which the elastica has it.
inline Real as_stiff(Real ratio, Real load, bool at_the_end)
{
    Real low = load / 1000, high = 20 * load;
    for (int i = 0; i < 40; ++i) {
        const Real middle = std::sqrt(low * high);
        (elastica(middle, at_the_end, 200).height_over_width() < ratio ? low
                                                                       : high) =
            middle;
    }
    return load / low;
}

}  // namespace rigid
