/// \file floating.hpp
/// Rigid bodies in shallow water: what each does to the other, slice by slice.
///
///     J = h ρ g A_i (−∂η/∂x, 1)   on a body, at the centroid of the slice A_i of it that is under water in cell i
///     η_i = bed_i + r_i + σ b_i,   b_i = Σ A_i / Δx,                               σ < 1, (29.15)
///
/// A hull lifts the surface where it displaces water; that is how it makes waves. σ = 1 would be a rigid lid, under which the
/// surface has no height of its own; σ less than 1 is a soft one, as in chapter 16. What the slope and the drag give to a body
/// they take from the water: the sum of both momenta along x is kept to rounding. Upwards the bed bears what floats.
#pragma once

#include "chapters/11_rotation/rigid_scene.hpp"
#include "chapters/29_waves/hydrostatics.hpp"
#include "chapters/29_waves/shallow_water.hpp"

#include <vector>

namespace rigid {

struct FloatSettings {
    Real lid = 0.5;  ///< σ, 0 … 0.95: 0 = bodies make no waves
    Real drag = 1;  ///< of an edge that goes ahead, 0 … : ½ ρ drag v_n² a metre
    Real friction = 0.01;  ///< along an edge, of the same form

    /// Throws std::invalid_argument, naming the setting and its value, unless all make sense.
    void require_valid() const;
};

/// What of a body is under water in one cell.
struct Slice {
    Index body = 0, cell = 0;
    Submerged below;
};

/// A piece of an edge under water in one cell.
struct WetEdge {
    Index body = 0, cell = 0;
    Vec2 middle = {0, 0};
    Vec2 normal = {0, 1};  ///< outwards
    Real length = 0;       ///< [m]
};

class Floating {
public:
    FloatSettings settings;
    std::vector<Slice> slices;  ///< of the last find()
    std::vector<WetEdge> edges;
    int rounds = 0;  ///< of Newton's method for the levels, in the last find()

    /// Where bodies and water meet now, and the levels of the water with it, (29.15).
    void find(const RigidScene& scene, ShallowWater& water);

    /// Takes out the water that bodies displace, so that its levels are those that it had without them.
    /// Throws std::invalid_argument, before any is taken, where a hull leaves no water below it.
    void displace(const RigidScene& scene, ShallowWater& water);

    /// Drag brakes one against the other, then slopes push the water (push_water()) and the bodies.
    void push(RigidScene& scene, ShallowWater& water, Real h);

    /// Of water and bodies: under a lid waves are 1/√(1 − σ) times as fast.
    Real stable_step(const ShallowWater& water) const;

private:
    void find_slices(const RigidScene& scene, const ShallowWater& water);
    void find_edges(const RigidScene& scene, const ShallowWater& water);
    Real solve_levels(ShallowWater& water);
    void place_outlines(const RigidScene& scene);
    void push_bodies(RigidScene& scene, const ShallowWater& water, Real h) const;
    void drag(RigidScene& scene, ShallowWater& water, Real h);
    Vec2 drag_on(const WetEdge& edge, const Bodies<3>& bodies,
                 const ShallowWater& water, Real h) const;

    std::vector<std::vector<Vec2>> own_, placed_;  ///< outlines, of each body
    std::vector<Polygon> made_of_;                 ///< the shapes that `own_` is of
    std::vector<Vec2> strip_, half_, wet_;
    Polygon memory_;
    VecX under_, width_;  ///< b and its derivative with η, of each cell
    VecX share_;          ///< of the bodies' thickness that is pushed, of each face
    VecX wet_length_;     ///< of each body [m]
    VecX wet_in_cell_;    ///< of all bodies, in each cell [m]
    std::vector<Vec2> given_;  ///< by drag, at each edge [N s]
};

}  // namespace rigid
