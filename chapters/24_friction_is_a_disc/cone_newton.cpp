// The functions of cone_newton.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/cone_newton.hpp"

namespace rigid {

void ConeNewtonSettings::require_valid() const
{
    for (const int count :
         {first_guesses, guesses, most_guesses, proximal_steps, retreats})
        if (count < 0)
            throw std::invalid_argument("a number of guesses or steps is " +
                                        std::to_string(count) +
                                        "; it must be zero or more");
}

//! [cone_newton]
bool ConeNewton::solve(const ConeRows& p, Real enough, VecX& u)
{
    guesses = 0;
    residual = infinity;
    begin_guess(p, u, guess);
    best = guess.lambda;
    if (accept(p, enough, u)) return true;  // last step's answer may be this one's
    factor.analyse(static_cast<int>(p.bodies.size()), guess.pairs);
    bool found = guess_on(p, enough, enough, settings.first_guesses, u);
    for (int time = 0, sweeps = 10; time < settings.retreats && !found;
         ++time, sweeps *= 3)
        found = proximal(p, enough, u) || sweep_on(p, sweeps, enough, u);
    give_back(p, u);
    return found;
}
//! [cone_newton]

void ConeNewton::give_back(const ConeRows& p, VecX& u)
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

bool ConeNewton::accept(const ConeRows& p, Real enough, const VecX& outside)
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

void ConeNewton::press(const ConeRows& p)
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
bool ConeNewton::guess_on(const ConeRows& p, Real enough, Real inner, int most,
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
bool ConeNewton::proximal(const ConeRows& p, Real enough, const VecX& outside)
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
        share =
            settled_ ? std::max(1e-7, 0.4 * share) : std::min(Real{100}, 5 * share);
    }
    guess.share = 0;
    return residual <= enough;
}
//! [proximal]

bool ConeNewton::sweep_on(const ConeRows& p, int sweeps, Real enough, VecX& u)
{
    give_back(p, u);
    for (int n = 0; n < sweeps; ++n) sweep_cones(p, 0, u);
    for (std::size_t k = 0; k < p.rows.size(); ++k)
        guess.lambda[static_cast<Index>(k)] = p.rows[k].lambda;
    return accept(p, enough, u) || guess_on(p, enough, enough, settings.guesses, u);
}

}  // namespace rigid
