/// \file cone_guess.hpp
/// One guess of the exact solver: the λ that follows from the cases.
///
///     open     λ_n = 0, λ_t = 0
///     holds    w_n = 0, w_t = 0
///     slides   w_n = 0, λ_t = μ λ_n d + s d′, w_t·d′ + c s = 0                                                  (24.15)
///
/// d is where λ_t points, d′ across it. Along d sliding is chapter 13's row that follows its normal; across d it is a
/// soft row, whose c (24.16) turns the direction of friction after that of the sliding.
#pragma once

#include "chapters/24_friction_is_a_disc/cone_cases.hpp"

namespace rigid {

/// Share of 1/A_ii that makes each factor possible; repeating takes it away.
inline constexpr Real cone_share = 1e-9;

/// λ of what is no unknown, by the cases; s of a disc that slides becomes zero.
void impose(const ConeRows& p, ConeGuess& g);

/// (24.15): the unknowns of these cases, and what moves with each of them.
void write_equations(const ConeRows& p, ConeGuess& g);

/// What each equation is off by, after cone_velocities(). \return the largest [m/s]
Real take_errors(ConeGuess& g);

/// (24.18): λ of these cases. The factor gives way by a share; what that leaves, the
/// next round takes away.
/// \return  what is left [m/s]
Real solve_guess(const ConeRows& p, const VecX& outside, Real enough,
                 BodyFactor& factor, ConeGuess& g);

}  // namespace rigid
