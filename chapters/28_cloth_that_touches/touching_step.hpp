/// \file touching_step.hpp
/// The step of a cloth that touches: chapter 27's, with contacts as its stage.
///
///     before the sweeps   which particles are near which solids, which parts of the cloth near which
///     in each sweep       after the rows each contact once, (28.1) and (28.3)
///     after all           what was pushed does not part; what would meet stops, (28.4); solids move
///
/// For a method that solves all rows together contacts come once, after its solve.
#pragma once

#include "chapters/27_particles_and_cloth/cloth_step.hpp"
#include "chapters/28_cloth_that_touches/cloth_contact.hpp"
#include "chapters/28_cloth_that_touches/cloth_self.hpp"

namespace rigid {

//! [stage]
/// What `NothingTouched` leaves empty.
struct ClothTouching {
    ClothTouch touch;
    ClothSelf self;  ///< unless the thickness against itself is zero

    void prepare(const TouchingCloth& cloth, bool middle = false);
    void begin(TouchingCloth& cloth, Real h, const VecX& x0, const VecX& x);
    void find(const TouchingCloth& cloth, const VecX& x0, const VecX& x)
    {
        touch.find(cloth, x0, x);
    }
    void visit(const TouchingCloth& cloth, VecX& x)
    {
        touch.visit(cloth, x);
        self.visit(cloth, x);
    }
    void begin_limit() { touch.unlimited = touch.moved; }
    void end(TouchingCloth& cloth, Real h, Real whole, const VecX& x0,
             const VecX& u0);
    bool reached() const { return !self.lost; }

private:
    struct Key {
        std::size_t particles = 0, springs = 0, shapes = 0, ties = 0;
        Index solids = 0;
        int changes = -1;
        Real thickness = 0, self_thickness = 0, self_friction = 0;
        bool operator==(const Key&) const = default;
    } key_;
    std::vector<ClothSolid> shapes_;  ///< that have been looked at
    std::vector<ClothTie> ties_;
};
//! [stage]

/// What the methods and the contacts keep from step to step, and what they count.
struct TouchingMemory : ClothMemory, ClothTouching {};

/// One step. Throws std::invalid_argument as require_valid() of cloth and settings does.
void step(TouchingCloth& cloth, const ClothSettings& settings,
          TouchingMemory& memory);
/// A memory without contacts would let it pass through all that it touches.
void step(TouchingCloth& cloth, const ClothSettings& settings,
          ClothMemory& memory) = delete;

}  // namespace rigid
