/// \file cone_newton.hpp
/// Disc friction solved exactly: Newton's method on the natural map, from the λ that is there.
///
///     guess the cases (24.14), solve them (24.18), accept by the residual of the Coulomb problem itself
///
/// Algorithm 24.2. Where guesses come to no end, proximal steps (24.19) \cite rockafellar1976 and sweeps bring λ nearer;
/// and what is still no answer is not called one.
#pragma once

#include "chapters/24_friction_is_a_disc/cone_guess.hpp"

namespace rigid {

struct ConeNewtonSettings {
    /// guesses of one problem, of all of a solve, and what else may be tried
    int first_guesses = 6, guesses = 14, most_guesses = 1000;
    int proximal_steps = 60, retreats = 2;

    void require_valid() const;
};

/// What is kept from step to step: room alone.
struct ConeNewton {
    ConeNewtonSettings settings;
    ConeGuess guess;
    BodyFactor factor;
    VecX best;                 ///< the λ with the least residual so far
    Real residual = infinity;  ///< its residual [m/s]
    int guesses = 0;           ///< of the last solve

    /// Algorithm 24.2. The rows keep the best λ that was found, and u is theirs.
    /// \param enough  the residual of an answer [m/s]
    /// \param u       velocities of all bodies, with the impulses of the rows
    /// \return        whether the best is an answer
    bool solve(const ConeRows& p, Real enough, VecX& u);

    /// The best λ into the rows, and what follows into u.
    void give_back(const ConeRows& p, VecX& u);

private:
    /// Presses λ into its bounds and keeps it if it is the best so far.
    bool accept(const ConeRows& p, Real enough, const VecX& outside);

    void press(const ConeRows& p);

    /// Guesses from guess.lambda on, until the problem of this ε is right to within
    /// `inner`, or one of them is the answer to the problem itself.
    bool guess_on(const ConeRows& p, Real enough, Real inner, int most,
                  const VecX& outside);

    /// (24.19): problems that a large ε holds near the last λ, then with smaller ones.
    bool proximal(const ConeRows& p, Real enough, const VecX& outside);

    /// Sweeps from the best λ, and guesses from where they end.
    bool sweep_on(const ConeRows& p, int sweeps, Real enough, VecX& u);

    VecX from_;
    bool settled_ = false;
};

}  // namespace rigid
