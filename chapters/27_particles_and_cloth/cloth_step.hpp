/// \file cloth_step.hpp
/// One step of a cloth, by any of this chapter's methods.
///
///     u* = u + h M⁻¹ f,   y = x₀ + h u*                            forces and inertia
///     x  from y and the rows                                        which of them together, and how far: the method
///     contacts, with row sweeps between the sweeps, else after      (27.25)
///     u  = (x − x₀)/h
///
/// Each (sub-)step. A bad setting or cloth is refused before anything moves.
#pragma once

#include "chapters/27_particles_and_cloth/cloth_contact.hpp"
#include "chapters/27_particles_and_cloth/cloth_newton.hpp"
#include "chapters/27_particles_and_cloth/cloth_self.hpp"
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
/// PBD, XPBD and threads: contacts are rows between theirs.
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
    int limit_passes = 50;         ///< at the end of a step, each with its contacts
    Real strength = infinity;      ///< springs tear beyond 1 + this
    bool reaction = true;          ///< false: solids do not feel the cloth

    Real part() const { return h / substeps; }
};

/// Throws std::invalid_argument for a step, a count or a strain that makes no sense.
void require_valid(const ClothSettings& settings);

/// What the methods keep from step to step, and what they count.
struct ClothMemory {
    RowSweeps rows;
    ClothThreads threads;
    ParticleDescent particles;
    Projective projective;
    ClothNewton newton;
    ExactRows exact;
    ClothTouch touch;
    ClothSelf self;  ///< unless the thickness against itself is zero
    StrainLimit limit;
    VecX x0, u0, y, force, drawn_back;
    // Counted since the memory was made.
    std::int64_t visits = 0;  ///< of rows
    std::int64_t solves = 0;  ///< linear systems
    int torn = 0;
    std::int64_t drawn = 0;  ///< springs that were beyond their limit, pass by pass
    bool solved =
        true;  ///< false: an iteration of the last step met its limit first

private:
    friend void step(ClothScene&, const ClothSettings&, ClothMemory&);
    void prepare(const ClothScene& cloth, const ClothSettings& settings);
    void solve(const ClothScene& cloth, const ClothSettings& settings, VecX& x);
    void draw_back(const ClothScene& cloth, const ClothSettings& settings, VecX& x);
    /// u ← 2 u − u₀, (27.15)
    void go_on_from_the_middle(Bodies<3>& bodies) const;

    /// what the factor, the threads and the colours were made for
    struct Key {
        std::size_t particles = 0, springs = 0, bends = 0, hinges = 0;
        int changes = -1;
        ClothMethod method = ClothMethod::xpbd;
        Real h = 0, self_thickness = 0;
        bool operator==(const Key&) const = default;
    } key_;
};

/// (27.23): the drag of the air on each triangle.
void add_wind(const ClothScene& cloth, VecX& f);

/// One step. Throws std::invalid_argument as require_valid() does.
void step(ClothScene& cloth, const ClothSettings& settings, ClothMemory& memory);

}  // namespace rigid
