/// \file friction_cases.hpp
/// The cases of a guess: those to begin with, the rows that its λ shows to be wrong, and what these become.
#pragma once

#include "chapters/13_friction/friction_guess.hpp"

namespace rigid {

/// The rows whose natural residual is more than rounding and the tolerance explain, into guess.wrong.
void find_wrong(FrictionProblem& problem, Real left, FrictionGuess& guess);

/// The cases to begin with. A row keeps the one that it had in the last answer as long
/// as its λ and w do not clearly speak against it: a row on the edge of two cases,
/// such as a contact that carries nothing, points here and there by rounding alone,
/// and by what the last answer left.
void first_cases(FrictionProblem& problem, FrictionGuess& guess);

/// Gives each wrong row the case that (13.9) points at. A friction row whose normal
/// opens slides, to the side where it points: if the contact closes again, it does
/// not come back to the guess that has just been wrong.
void flip(const FrictionProblem& problem, FrictionGuess& guess);

}  // namespace rigid
