/// \file cone_newton.hpp
/// Disc friction solved exactly: Newton's method on the natural map, from the λ that is there.
///
///     guess the cases (18.49), solve them (18.53), accept by the residual of the Coulomb problem itself
///
/// Algorithm 18.2. Where guesses come to no end, proximal steps (18.54) \cite rockafellar1976 and sweeps bring λ nearer;
/// and what is still no answer is not called one.
#pragma once

#include "chapters/18_space/cone_guess.hpp"

namespace rigid {

struct ConeNewtonSettings {
    /// guesses of one problem, of all of a solve, and what else may be tried
    int first_guesses = 6, guesses = 14, most_guesses = 1000;
    int proximal_steps = 60, retreats = 2;

    void require_valid() const
    {
        for (const int count :
             {first_guesses, guesses, most_guesses, proximal_steps, retreats})
            if (count < 0)
                throw std::invalid_argument("a number of guesses or steps is " +
                                            std::to_string(count) +
                                            "; it must be zero or more");
    }
};

/// What is kept from step to step: room alone.
struct ConeNewton {
    ConeNewtonSettings settings;
    ConeGuess guess;
    BodyFactor factor;
    VecX best;                 ///< the λ with the least residual so far
    Real residual = infinity;  ///< its residual [m/s]
    int guesses = 0;           ///< of the last solve

    //! [cone_newton]
    /// Algorithm 18.2. The rows keep the best λ that was found, and u is theirs.
    /// \param enough  the residual of an answer [m/s]
    /// \param u       velocities of all bodies, with the impulses of the rows
    /// \return        whether the best is an answer
    bool solve(const ConeRows& p, Real enough, VecX& u)
    {
        guesses = 0;
        residual = infinity;
        begin_guess(p, u, guess);
        best = guess.lambda;
        if (accept(p, enough, u))
            return true;  // last step's answer may be this one's
        factor.analyse(static_cast<int>(p.bodies.size()), guess.pairs);
        bool found = guess_on(p, enough, enough, settings.first_guesses, u);
        for (int time = 0, sweeps = 10; time < settings.retreats && !found;
             ++time, sweeps *= 3)
            found = proximal(p, enough, u) || sweep_on(p, sweeps, enough, u);
        give_back(p, u);
        return found;
    }
    //! [cone_newton]

    /// The best λ into the rows, and what follows into u.
    void give_back(const ConeRows& p, VecX& u)
    {
        guess.lambda = best;
        guess.share = 0;
        cone_velocities(p, u, guess);
        for (std::size_t k = 0; k < p.rows.size(); ++k)
            p.rows[k].lambda = best[static_cast<Index>(k)];
        for (std::size_t i = 0; i < p.bodies.size(); ++i)
            u.segment<6>(6 * p.bodies[i]) =
                guess.u.segment<6>(6 * static_cast<Index>(i));
    }

private:
    /// Presses λ into its bounds and keeps it if it is the best so far.
    bool accept(const ConeRows& p, Real enough, const VecX& outside)
    {
        const Real share = std::exchange(guess.share, 0);
        from_ = guess.lambda;
        press(p);
        cone_velocities(p, outside, guess);
        const Real here = choose_cases(p, infinity, guess);
        if (here < residual) residual = here, best = guess.lambda;
        guess.lambda = from_;
        guess.share = share;
        return here <= enough;
    }

    void press(const ConeRows& p)
    {
        VecX& lambda = guess.lambda;
        for (std::size_t k = 0; k < p.rows.size(); ++k)
            if (p.bound_by(k) < 0) {
                Real& x = lambda[static_cast<Index>(k)];
                x = std::clamp(x, p.rows[k].lo, p.rows[k].hi);
            }
        for (std::size_t k = 0; k < p.rows.size(); ++k) {
            const auto i = static_cast<Index>(k);
            if (p.bound_by(k) < 0) continue;
            const Real bound =
                p.feedback[k].friction * std::max(Real{0}, lambda[p.bound_by(k)]);
            if (p.disc(k)) {
                lambda.segment<2>(i) = onto_disc(lambda.segment<2>(i), bound);
                ++k;
            } else lambda[i] = std::clamp(lambda[i], -bound, bound);
        }
    }

    //! [guess_on]
    /// Guesses from guess.lambda on, until the problem of this ε is right to within
    /// `inner`, or one of them is the answer to the problem itself.
    bool guess_on(const ConeRows& p, Real enough, Real inner, int most,
                  const VecX& outside)
    {
        Real first = infinity;
        settled_ = false;
        for (int n = 0; n <= most && guesses < settings.most_guesses; ++n) {
            cone_velocities(p, outside, guess);
            const Real off = choose_cases(p, n == 0 ? -1 : inner, guess);
            if (n == 0) first = off;
            settled_ = n > 0 && off <= inner;
            // without ε what contradicts itself runs away
            const bool lost = guess.share == 0 && !(off <= 1e3 * first);
            if (settled_ || lost || n == most) break;
            ++guesses;
            solve_guess(p, outside, std::min(enough, inner), factor, guess);
            if (accept(p, enough, outside)) return true;
        }
        return false;
    }
    //! [guess_on]

    //! [proximal]
    /// (18.54): problems that a large ε holds near the last λ, then with smaller ones.
    bool proximal(const ConeRows& p, Real enough, const VecX& outside)
    {
        Real share = 0.1;
        guess.base = best;
        for (int n = 0; n < settings.proximal_steps && residual > enough &&
                        guesses < settings.most_guesses;
             ++n) {
            guess.share = share;
            guess.lambda = guess.base;
            const Real inner = std::max(0.3 * enough, 0.02 * residual);
            if (guess_on(p, enough, inner, settings.guesses, outside)) break;
            if (settled_) guess.base = guess.lambda;
            share = settled_ ? std::max(1e-7, 0.4 * share)
                             : std::min(Real{100}, 5 * share);
        }
        guess.share = 0;
        return residual <= enough;
    }
    //! [proximal]

    /// Sweeps from the best λ, and guesses from where they end.
    bool sweep_on(const ConeRows& p, int sweeps, Real enough, VecX& u)
    {
        give_back(p, u);
        for (int n = 0; n < sweeps; ++n) sweep_cones(p, 0, u);
        for (std::size_t k = 0; k < p.rows.size(); ++k)
            guess.lambda[static_cast<Index>(k)] = p.rows[k].lambda;
        return accept(p, enough, u) ||
               guess_on(p, enough, enough, settings.guesses, u);
    }

    VecX from_;
    bool settled_ = false;
};

}  // namespace rigid
