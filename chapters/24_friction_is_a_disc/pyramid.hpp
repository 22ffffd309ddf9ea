/// \file pyramid.hpp
/// Friction in a pyramid of n corners: where a block stops in it, and its linear complementarity problem. \cite stewart1996
///
///     λ_t = D β,   β ≥ 0,   Σ β ≤ μ λ_n,   D: the unit vectors to the corners
#pragma once

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/20_turning_in_space/rotation.hpp"
#include "common/elementary.hpp"

namespace rigid {

// Each throws std::invalid_argument for fewer than three corners, and for a problem or an answer of another size.

/// (24.9): where a block stops that starts at an angle φ, ahead and to the side
/// that φ grows to.
/// \param d  v²/2μg: how far it goes on a disc [m]
Vec2 stop_in_pyramid(Real d, Real phi, int corners);

/// The problem of Stewart and Trinkle for one contact: β of each corner, λ_n, γ.
///
///     0 ≤ β ⟂ Dᵀw_t + γ ≥ 0,   0 ≤ λ_n ⟂ w_n ≥ 0,   0 ≤ γ ⟂ μ λ_n − Σβ ≥ 0
///
/// \param rows  A and q of t₁, t₂ and n
Mlcp pyramid_problem(const Mlcp& rows, Real mu, int corners);

/// λ of t₁, t₂ and n from its answer.
Vec3 pyramid_impulses(const VecX& answer, int corners);

}  // namespace rigid
