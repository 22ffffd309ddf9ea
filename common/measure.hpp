/// \file measure.hpp
/// Numbers that show how good a state is: energy, momentum, and how far rods and contacts are off.
#pragma once

#include "common/contact.hpp"
#include "common/scenes.hpp"

namespace rigid {

/// Σ ½ m u² over the bodies that can move [J].
Real kinetic_energy(const Bodies<2>& bodies);

/// −Σ m g·x over the bodies that can move [J], zero at the origin.
Real potential_energy(const Bodies<2>& bodies, const Vec2& gravity);

/// Σ m u over the bodies that can move [kg m/s].
Vec2 momentum(const Bodies<2>& bodies);

/// Σ m x × u over the bodies that can move, about the origin [kg m²/s].
Real angular_momentum(const Bodies<2>& bodies);

/// The deepest overlap of any two colliding discs or of a disc and a wall [m]; 0 if none.
Real deepest_penetration(const DiscScene& scene);

/// The largest | distance − rest length | of any link [m]; 0 without links.
Real largest_link_error(const DiscScene& scene);

}  // namespace rigid
