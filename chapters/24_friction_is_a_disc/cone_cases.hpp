/// \file cone_cases.hpp
/// What the exact solver guesses: which contacts are open, which hold, which slide and in what direction.
///
///     r = μ max(0, λ_n − w_n/A_nn),   z = λ_t − w_t/L:   r = 0 open,   ‖z‖ ≤ r holds,   else it slides along z   (24.14)
///
/// The case of a row is where its natural map points, as in chapter 13. \cite alart1991
#pragma once

#include "chapters/24_friction_is_a_disc/body_factor.hpp"
#include "chapters/24_friction_is_a_disc/cone_rows.hpp"

namespace rigid {

enum class ConeCase : unsigned char { low, free, high, slides };

struct ConeGuess {
    std::vector<ConeCase> cases;  ///< of each row; a disc has that of its first
    std::vector<Vec2> direction;  ///< d of a disc that slides
    VecX give;                    ///< c of it [1/kg]
    VecX lambda, w, base;
    VecX u0, u;  ///< without the impulses, and with them; six to a body
    std::vector<ConeEquation> equations;
    std::vector<int> of_row;       ///< the row of each equation
    std::vector<int> equation_of;  ///< of each row, or −1
    std::vector<int> number;       ///< of each body in the island, or −1
    std::vector<int> bodies;       ///< of the island that number is of
    std::vector<std::pair<int, int>> pairs;
    VecX v;
    Real share = 0;  ///< ε of a proximal step (24.19); 0: the problem itself
};

inline Real diagonal_of(const ConeRows& p, std::size_t k)
{
    const DiscOfRows* disc = p.disc(k);
    return disc ? disc->largest : p.rows[k].mass > 0 ? 1 / p.rows[k].mass : 0;
}

/// Numbers, room, and u without impulses.
void begin_guess(const ConeRows& p, const VecX& u, ConeGuess& g);

/// u = u0 + M⁻¹ Jᵀ λ, and w of each row; in a proximal step w + ε D (λ − base).
/// \param outside  velocities of bodies that are not of the island
void cone_velocities(const ConeRows& p, const VecX& outside, ConeGuess& g);

/// (24.14): the case that each row and disc should have, by its natural map. What is
/// right to within `enough` keeps the one that it has.
/// \return  the largest residual, of a proximal step that of its problem [m/s]
Real choose_cases(const ConeRows& p, Real enough, ConeGuess& g);

}  // namespace rigid
