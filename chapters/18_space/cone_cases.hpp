/// \file cone_cases.hpp
/// What the exact solver guesses: which contacts are open, which hold, which slide and in what direction.
///
///     r = μ max(0, λ_n − w_n/A_nn),   z = λ_t − w_t/L:   r = 0 open,   ‖z‖ ≤ r holds,   else it slides along z   (18.49)
///
/// The case of a row is where its natural map points, as in chapter 13. \cite alart1991
#pragma once

#include "chapters/18_space/body_factor.hpp"
#include "chapters/18_space/cone_rows.hpp"

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
    Real share = 0;  ///< ε of a proximal step (18.54); 0: the problem itself
};

inline Real diagonal_of(const ConeRows& p, std::size_t k)
{
    const DiscOfRows* disc = p.disc(k);
    return disc ? disc->largest : p.rows[k].mass > 0 ? 1 / p.rows[k].mass : 0;
}

/// Numbers, room, and u without impulses.
inline void begin_guess(const ConeRows& p, const VecX& u, ConeGuess& g)
{
    const std::size_t m = p.rows.size();
    const auto n = static_cast<Index>(p.bodies.size());
    g.cases.assign(m, ConeCase::low);
    g.direction.assign(m, Vec2(1, 0));
    g.equation_of.assign(m, -1);
    for (VecX* x : {&g.give, &g.lambda, &g.w, &g.base})
        x->setZero(static_cast<Index>(m));
    g.number.resize(static_cast<std::size_t>(u.size() / 6), -1);
    for (const int k : g.bodies)  // of the island before
        if (static_cast<std::size_t>(k) < g.number.size())
            g.number[static_cast<std::size_t>(k)] = -1;
    g.bodies.assign(p.bodies.begin(), p.bodies.end());
    g.u0.resize(6 * n), g.u.resize(6 * n), g.v.resize(6 * n);
    for (Index i = 0; i < n; ++i) {
        const int k = p.bodies[static_cast<std::size_t>(i)];
        g.number[static_cast<std::size_t>(k)] = static_cast<int>(i);
        g.u0.segment<6>(6 * i) = u.segment<6>(6 * k);
    }
    g.pairs.clear();
    const auto add = [&](int body, const Vec<6>& W, Real lambda) {
        const int i = g.number[static_cast<std::size_t>(body / 6)];
        if (i >= 0) g.u0.segment<6>(6 * i) -= W * lambda;
        return i;
    };
    for (std::size_t k = 0; k < m; ++k) {
        const SolverRow<6>& row = p.rows[k];
        g.lambda[static_cast<Index>(k)] = row.lambda;
        const int a = row.a == row.b ? -1 : add(row.a, row.Wa, row.lambda),
                  b = add(row.b, row.Wb, row.lambda);
        if (a >= 0 && b >= 0) g.pairs.emplace_back(a, b);
    }
}

/// u = u0 + M⁻¹ Jᵀ λ, and w of each row; in a proximal step w + ε D (λ − base).
/// \param outside  velocities of bodies that are not of the island
inline void cone_velocities(const ConeRows& p, const VecX& outside, ConeGuess& g)
{
    g.u = g.u0;
    const auto number = [&](int body) {
        return g.number[static_cast<std::size_t>(body / 6)];
    };
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        const SolverRow<6>& row = p.rows[k];
        const Real lambda = g.lambda[static_cast<Index>(k)];
        if (lambda == 0) continue;
        const int a = row.a == row.b ? -1 : number(row.a), b = number(row.b);
        if (a >= 0) g.u.segment<6>(6 * a) += row.Wa * lambda;
        if (b >= 0) g.u.segment<6>(6 * b) += row.Wb * lambda;
    }
    const auto of = [&](int body) -> Vec<6> {
        const int i = number(body);
        return i >= 0 ? Vec<6>(g.u.segment<6>(6 * i))
                      : Vec<6>(outside.segment<6>(body));
    };
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        const auto i = static_cast<Index>(k);
        g.w[i] = velocity<6>(p.rows[k], of(p.rows[k].a), of(p.rows[k].b));
    }
    if (!(g.share > 0)) return;
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        const auto i = static_cast<Index>(k);
        const Real shift = g.share * diagonal_of(p, k);
        g.w[i] += shift * (g.lambda[i] - g.base[i]);
        if (!p.disc(k)) continue;
        ++k;
        g.w[i + 1] += shift * (g.lambda[i + 1] - g.base[i + 1]);
    }
}

//! [cone_cases]
/// (18.49): the case that each row and disc should have, by its natural map. What is
/// right to within `enough` keeps the one that it has.
/// \return  the largest residual, of a proximal step that of its problem [m/s]
inline Real choose_cases(const ConeRows& p, Real enough, ConeGuess& g)
{
    Real largest = 0;
    const auto points = [&](std::size_t k) {
        return g.lambda[static_cast<Index>(k)] -
               p.rows[k].mass * g.w[static_cast<Index>(k)];
    };
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        const auto i = static_cast<Index>(k);
        const int normal = p.bound_by(k);
        const DiscOfRows* disc = p.disc(k);
        Real lo = p.rows[k].lo, hi = p.rows[k].hi, bound = 0;
        if (normal >= 0) {
            const auto n = static_cast<std::size_t>(normal);
            hi = p.feedback[k].friction * std::max(Real{0}, points(n));
            bound = p.feedback[k].friction * std::max(Real{0}, g.lambda[normal]);
            lo = -hi;
        }
        ConeCase& here = g.cases[k];
        Real off = 0;
        if (disc) {
            ++k;
            if (!(disc->largest > 0)) continue;
            const Vec2 lambda = g.lambda.segment<2>(i),
                       z = lambda - g.w.segment<2>(i) / disc->largest;
            off = disc->largest * (lambda - onto_disc(z, bound)).norm();
            if (off > enough) {
                const Real length = z.norm();
                here = !(hi > 0)     ? ConeCase::low
                       : length > hi ? ConeCase::slides
                                     : ConeCase::free;
                g.direction[k - 1] = z / std::max(length, 1e-300);
                g.give[i] = disc->largest * (length - hi) / hi;  // (18.51)
            }
        } else if (p.rows[k].mass > 0) {
            const Real there = points(k);
            off = std::abs(g.lambda[i] - (normal < 0
                                              ? std::clamp(there, lo, hi)
                                              : std::clamp(there, -bound, bound))) /
                  p.rows[k].mass;
            if (off > enough)
                here = there <= lo   ? ConeCase::low
                       : there >= hi ? ConeCase::high
                                     : ConeCase::free;
        }
        if (!(off <= largest)) largest = off;
    }
    return largest;
}
//! [cone_cases]

}  // namespace rigid
