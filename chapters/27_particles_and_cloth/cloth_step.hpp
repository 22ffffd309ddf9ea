/// \file cloth_step.hpp
/// One step of a cloth, by any of this chapter's methods.
///
///     u* = u + h M⁻¹ f,   y = x₀ + h u*                            forces and inertia
///     x  from y and the rows                                        which of them together, and how far: the method
///     what it touches, with row sweeps between the sweeps, else after
///     u  = (x − x₀)/h
///
/// Each (sub-)step. A bad setting or cloth is refused before anything moves. What a cloth touches is a stage: nothing at all
/// (NothingTouched), or what chapter 28 has.
#pragma once

#include "chapters/27_particles_and_cloth/cloth_newton.hpp"
#include "chapters/27_particles_and_cloth/cloth_threads.hpp"
#include "chapters/27_particles_and_cloth/exact_rows.hpp"
#include "chapters/27_particles_and_cloth/particle_descent.hpp"
#include "chapters/27_particles_and_cloth/projective.hpp"
#include "chapters/27_particles_and_cloth/row_sweeps.hpp"

#include <string_view>

namespace rigid {

//! [methods]
enum class ClothMethod : unsigned char {
    explicit_euler,  ///< no row is solved: forces where the cloth is
    pbd,             ///< row by row, hard
    xpbd,            ///< row by row
    threads,         ///< thread by thread
    particles,       ///< particle by particle
    augmented,       ///< the same, with springs that grow to their stiffness
    projective,      ///< all together, with one matrix
    implicit_euler,  ///< all together, one linear solve
    newton,          ///< all together, to the end
    midpoint,        ///< the same, in the middle of the step
    exact            ///< all together, in impulses
};
//! [methods]

/// As the programs call it; throws std::invalid_argument for a name that none has.
ClothMethod cloth_method(std::string_view name);
std::string_view to_string(ClothMethod method);
/// PBD, XPBD and threads: what the cloth touches are rows between theirs.
bool sweeps_rows(ClothMethod method);
/// Also those that take a stiffness that is infinite.
bool takes_hard_rows(ClothMethod method);

struct ClothSettings {
    Real h = 1.0 / 60;  ///< of the step [s]
    int substeps = 1, sweeps = 10;
    ClothMethod method = ClothMethod::xpbd;
    Real pbd_share = 1;            ///< s of (27.9)
    bool keep_lambda = true;       ///< false: the mistake of section 27.4
    Real strain_limit = infinity;  ///< springs are drawn back to 1 + this
    Real limit_stiffness = 0;      ///< those of at least this k [N/m]
    int limit_passes = 50;     ///< at the end of a step, each with what it touches
    Real strength = infinity;  ///< springs tear beyond 1 + this

    Real part() const { return h / substeps; }
};

/// Throws std::invalid_argument for a step, a count or a strain that makes no sense.
void require_valid(const ClothSettings& settings);

/// What the methods keep from step to step, and what they count. A copy of it goes on with a copy of the cloth to the same bits.
struct ClothMemory {
    RowSweeps rows;
    ClothThreads threads;
    ParticleDescent particles;
    Projective projective;
    ClothNewton newton;
    ExactRows exact;
    StrainLimit limit;
    VecX x0, u0, y, force, drawn_back;
    // Counted since the memory was made.
    std::int64_t visits = 0;  ///< of rows
    std::int64_t solves = 0;  ///< linear systems
    int torn = 0;
    std::int64_t drawn = 0;  ///< springs that were beyond their limit, pass by pass
    /// false: an iteration of the last step met its limit first, what the cloth touches
    /// was beyond reach, or it has flown beyond all numbers
    bool solved = true;

    // The parts of step(), in this order.
    /// Refuses, and makes what does not change: factors, threads, colours.
    void prepare(const ClothScene& cloth, const ClothSettings& settings);
    /// u*, x₀ and y; x is where u* leads to in the whole (sub-)step, which is y but of the midpoint.
    void begin(ClothScene& cloth, const ClothSettings& settings);
    /// Λ = 0; then one pass of a method of rows.
    void begin_sweeps(const ClothScene& cloth, const ClothSettings& settings);
    void sweep(const ClothScene& cloth, const ClothSettings& settings, VecX& x);
    /// From y to x by any other method.
    void solve(const ClothScene& cloth, const ClothSettings& settings, VecX& x);
    /// u = (x − x₀)/h, with (27.25) and (27.15).
    void end(ClothScene& cloth, const ClothSettings& settings) const;

private:
    /// what the factor, the threads and the colours were made for
    struct Key {
        std::size_t particles = 0, springs = 0, bends = 0, hinges = 0;
        int changes = -1;
        ClothMethod method = ClothMethod::xpbd;
        Real h = 0;
        bool operator==(const Key&) const = default;
    } key_;
};

/// (27.23): the drag of the air on each triangle.
void add_wind(const ClothScene& cloth, VecX& f);

//! [nothing]
/// The stage of a cloth that touches nothing. What is not empty in another one:
struct NothingTouched {
    /// Refuses what makes no sense; once for each set of rows. Whether the step is by the midpoint.
    void prepare(const ClothScene&, bool) {}
    /// At the start of a sub-step of h, in which the cloth would go from x0 to x.
    void begin(ClothScene&, Real, const VecX&, const VecX&) {}
    /// What it touches if it comes from x0 to x.
    void find(const ClothScene&, const VecX&, const VecX&) {}
    /// One visit of each row.
    void visit(const ClothScene&, VecX&) {}
    /// What follows in this sub-step is what a limit draws back.
    void begin_limit() {}
    /// With the velocities, the sub-step and the whole step of (27.25); x0 and u0 of
    /// the sub-step, u0 with what a limit has drawn back.
    void end(ClothScene&, Real, Real, const VecX&, const VecX&) {}
    /// False: something was beyond reach in this sub-step.
    bool reached() const { return true; }
};
//! [nothing]

//! [step]
/// One step. Throws std::invalid_argument as require_valid() does.
template <class Scene, class Touch>
void step(Scene& cloth, const ClothSettings& settings, ClothMemory& now,
          Touch& touch)
{
    require_valid(settings);
    const bool with_rows = sweeps_rows(settings.method),
               middle = settings.method == ClothMethod::midpoint;
    now.prepare(cloth, settings);
    touch.prepare(cloth, middle);
    VecX& x = cloth.bodies.x;
    const Real h = settings.part();
    now.solved = true;
    for (int part = 0; part < settings.substeps; ++part) {
        now.begin(cloth, settings);
        touch.begin(cloth, h, now.x0, x);
        if (with_rows) {
            touch.find(cloth, now.x0, now.y);
            now.begin_sweeps(cloth, settings);
            for (int s = 0; s < settings.sweeps; ++s) {
                now.sweep(cloth, settings, x);
                touch.visit(cloth, x);
            }
        } else {
            now.solve(cloth, settings, x);
            if (middle) x = 2 * x - now.x0;
            touch.find(cloth, now.x0, x);
            touch.visit(cloth, x);
        }
        touch.begin_limit();
        now.drawn_back.setZero(x.size());
        if (part + 1 == settings.substeps && settings.strain_limit < infinity) {
            now.drawn_back = x;
            now.limit.strain = settings.strain_limit;
            now.limit.stiff = settings.limit_stiffness;
            for (int n = 0; n < settings.limit_passes && now.limit.find(cloth, x);
                 ++n) {  // (27.24)
                for (int s = 0; s < 3; ++s) now.limit.draw_back(cloth, x);
                touch.visit(cloth, x);
                now.drawn += static_cast<std::int64_t>(now.limit.beyond.size());
            }
            now.drawn_back = x - now.drawn_back;
        }
        now.end(cloth, settings);
        now.u0 += now.drawn_back / settings.h;
        touch.end(cloth, h, settings.h, now.x0, now.u0);
        now.solved = now.solved && touch.reached();
        if (settings.strength < infinity) {
            now.torn += tear(cloth, settings.strength);
            now.prepare(cloth, settings);
            touch.prepare(cloth, middle);
        }
    }
    now.solved = now.solved && x.allFinite() && cloth.bodies.u.allFinite();
}
//! [step]

/// A step of a cloth that touches nothing.
void step(ClothScene& cloth, const ClothSettings& settings, ClothMemory& memory);

}  // namespace rigid
