/// \file random_attack.hpp
/// Problems that are meant to go wrong, kind by kind; many have a planted answer or must have one.
#pragma once

#include "chapters/05_lemke/families.hpp"
#include "common/random.hpp"

#include <string>
#include <string_view>

namespace rigid::properties {

struct Attack {
    std::string kind;
    Mlcp mlcp;
    bool whole = false;  ///< all its numbers are small and whole: all its answers can be had exactly
};

namespace detail {

inline MatX whole_matrix(Index rows, Index columns, int most, Random& random)
{
    MatX A(rows, columns);
    for (Real& entry : A.reshaped()) entry = static_cast<Real>(random.index(2 * most + 1)) - most;
    return A;
}

inline MatX normal_matrix(Index rows, Index columns, Random& random)
{
    MatX A(rows, columns);
    for (Real& entry : A.reshaped()) entry = random.normal();
    return A;
}

inline VecX whole_vector(Index n, int most, Random& random) { return whole_matrix(n, 1, most, random); }
inline VecX normal_vector(Index n, Random& random) { return normal_matrix(n, 1, random); }

/// Bounds of every sort, whole: none, one, the other, both, and no room between.
inline void whole_bounds(Mlcp& mlcp, Random& random)
{
    for (Index i = 0; i < mlcp.size(); ++i) {
        const Index sort = random.index(8);
        mlcp.lo[i] = sort < 4 ? 0 : -static_cast<Real>(random.index(3));
        mlcp.hi[i] = sort < 3 ? infinity : mlcp.lo[i] + static_cast<Real>(random.index(4));
        if (sort == 5) mlcp.lo[i] = -infinity;
        if (sort == 6) mlcp.lo[i] = -infinity, mlcp.hi[i] = infinity;
    }
}

/// A whole problem with an answer: λ and w are chosen, many of them zero together, and q follows.
inline void plant(Mlcp& mlcp, Random& random)
{
    VecX lambda = VecX::Zero(mlcp.size()), w = lambda;
    for (Index i = 0; i < mlcp.size(); ++i) {
        const bool below = mlcp.lo[i] > -infinity, above = mlcp.hi[i] < infinity;
        const Index where = random.index(3);
        const auto some = static_cast<Real>(random.index(3));
        if (where == 0 && below) lambda[i] = mlcp.lo[i], w[i] = some;
        else if (where == 1 && above) lambda[i] = mlcp.hi[i], w[i] = -some;
        else
            lambda[i] = below   ? std::min(mlcp.lo[i] + some, mlcp.hi[i])
                        : above ? mlcp.hi[i] - some
                                : some - 1;
    }
    mlcp.q = w - mlcp.A * lambda;
}

/// The generator of the searches in tests/05_lemke.cpp and tests/09_active_sets.cpp.
inline Mlcp chapter_five(Index n, Random& random)
{
    MatX A(n, n);
    VecX q(n);
    const Index shape = random.index(8);
    for (Real& entry : A.reshaped())
        entry = shape < 2 || shape == 7 ? std::floor(random.uniform(-2, 3)) : random.normal();
    for (Real& entry : q)
        entry = random.uniform() < 0.5 ? std::floor(random.uniform(-2, 2)) : random.normal();
    if (shape == 1 || shape == 2) A = (A * A.transpose()).eval();
    if (shape == 3) A = (A * A.transpose() + 1e-9 * MatX::Identity(n, n)).eval();
    if (shape == 4) {  // nearly the same row twice
        A = (A * A.transpose()).eval();
        const Index i = random.index(n), j = random.index(n);
        const Real near = std::pow(10.0, random.uniform(-16, -6));
        A.row(j) = A.row(i) * (1 + near);
        A.col(j) = A.col(i) * (1 + near);
    }
    if (shape == 5) {
        A = (A * A.transpose() + 0.01 * MatX::Identity(n, n)).eval();
        VecX scale(n);
        for (Real& entry : scale) entry = std::pow(10.0, random.uniform(-3, 3));
        A = (scale.asDiagonal() * A * scale.asDiagonal()).eval();
    }
    if (shape == 6) A = (A - A.transpose()).eval();
    if (shape == 7) A = (A + A.transpose()).eval();  // symmetric, of any definiteness
    Mlcp mlcp = plain_lcp(A, q);
    if (random.uniform() < 0.4)
        for (Index i = 0; i < n; ++i) {
            const Real which = random.uniform();
            if (which < 0.3) mlcp.lo[i] = -infinity;
            else if (which < 0.5) mlcp.hi[i] = random.uniform();
            else if (which < 0.6) mlcp.hi[i] = mlcp.lo[i];
            else if (which < 0.7) mlcp.hi[i] = 1e-12;
        }
    return mlcp;
}

}  // namespace detail

inline constexpr std::string_view attack_kinds[] = {
    "chapter five", "any whole",  "symmetric whole", "singular whole", "degenerate",    "boxed indefinite",
    "far bounds",   "huge units", "mixed units",     "near copies",    "all bilateral", "forced"};
inline constexpr Index attack_kind_count = static_cast<Index>(std::size(attack_kinds));

/// A random problem of a kind, of up to eight rows (and of up to thirty, one in fifty).
inline Attack random_attack(Index kind, Random& random)
{
    using namespace detail;
    Attack attack;
    attack.kind = attack_kinds[kind];
    Mlcp& mlcp = attack.mlcp;
    VecX right;
    const Index n = 1 + random.index(random.index(50) == 0 ? 30 : random.index(3) == 0 ? 8 : 4);
    const auto power = [&](Real least, Real most) { return std::pow(10.0, random.uniform(least, most)); };
    switch (kind) {
    case 0:
        mlcp = chapter_five(n, random);
        break;
    case 1:
        attack.whole = true;
        right = whole_vector(n, 2, random);
        mlcp = plain_lcp(whole_matrix(n, n, 2, random), right);
        whole_bounds(mlcp, random);
        break;
    case 2: {
        attack.whole = true;
        const MatX G = whole_matrix(n, n, 1, random);
        mlcp = plain_lcp(G + G.transpose(), whole_vector(n, 2, random));
        whole_bounds(mlcp, random);
        break;
    }
    case 3: {
        attack.whole = true;
        const MatX G = whole_matrix(n, 1 + random.index(n), 1, random);
        mlcp = plain_lcp(G * G.transpose(), whole_vector(n, 2, random));
        if (random.index(2) == 0) whole_bounds(mlcp, random);
        break;
    }
    case 4: {
        attack.whole = true;
        const MatX G = whole_matrix(n, n, 1, random);
        mlcp = plain_lcp(random.index(2) == 0 ? G : MatX(G * G.transpose()), VecX::Zero(n));
        whole_bounds(mlcp, random);
        plant(mlcp, random);
        break;
    }
    case 5: {  // λ has nowhere to run: there is always an answer
        const MatX G = normal_matrix(n, n, random);
        right = normal_vector(n, random);
        mlcp = plain_lcp(random.index(2) == 0 ? G : MatX(G + G.transpose()), right);
        for (Index i = 0; i < n; ++i) mlcp.lo[i] = -random.uniform(), mlcp.hi[i] = random.uniform();
        break;
    }
    case 6: {
        const MatX G = normal_matrix(n, n, random);
        const Index shape = random.index(3);
        mlcp = plain_lcp(shape == 0   ? MatX(G * G.transpose())
                         : shape == 1 ? MatX(G + G.transpose())
                                      : G,
                         normal_vector(n, random));
        for (Index i = 0; i < n; ++i) {
            const Index sort = random.index(4);
            if (sort != 0) mlcp.lo[i] = -power(10, 20);
            if (sort != 1) mlcp.hi[i] = power(10, 20);
            if (sort == 3 && random.index(2) == 0) mlcp.lo[i] = -infinity;
        }
        break;
    }
    case 7: {  // one problem of another kind in absurd units
        attack = random_attack(random.index(6), random);
        attack.kind = attack_kinds[kind];
        attack.whole = false;
        const Real mass = std::ldexp(1, static_cast<int>(random.uniform(-500, 500)));
        const Real length = std::ldexp(1, static_cast<int>(random.uniform(-500, 500)) / (mass > 1 ? 1 : 2));
        mlcp.A /= mass;
        mlcp.q *= length;
        mlcp.lo *= mass;
        mlcp.hi *= mass;
        mlcp.lo *= length;
        mlcp.hi *= length;
        break;
    }
    case 8: {  // a unit of its own for each row
        const MatX G = normal_matrix(n, random.index(3) == 0 ? 1 + random.index(n) : n, random);
        VecX unit(n);
        const Real spread = random.index(2) == 0 ? 6 : 75;
        for (Real& entry : unit) entry = power(-spread, spread);
        mlcp = plain_lcp(unit.asDiagonal() * MatX(G * G.transpose()) * unit.asDiagonal(),
                         unit.asDiagonal() * normal_vector(n, random));
        if (random.index(2) == 0)
            for (Index i = 0; i < n; ++i) mlcp.hi[i] = random.uniform() / unit[i];
        break;
    }
    case 9: {  // rows that are nearly, or exactly, multiples of others
        const MatX G = normal_matrix(n, n, random);
        MatX A = random.index(3) == 0 ? G : MatX(G * G.transpose());
        VecX q = normal_vector(n, random);
        for (Index copies = 1 + random.index(2); copies > 0; --copies) {
            const Index i = random.index(n), j = random.index(n);
            const Real factor = random.index(2) == 0 ? 1 : 1 + power(-16, -6);
            A.row(j) = A.row(i) * factor;
            A.col(j) = A.col(i) * factor;
            if (random.index(2) == 0) q[j] = q[i] * factor;
        }
        mlcp = plain_lcp(A, q);
        if (random.index(3) == 0) whole_bounds(mlcp, random);
        break;
    }
    case 10: {
        const bool whole = random.index(2) == 0;
        const Index rank = 1 + random.index(n);
        const MatX G = whole ? whole_matrix(n, rank, 1, random) : normal_matrix(n, rank, random);
        const VecX q = random.index(2) == 0 ? VecX(G * whole_vector(rank, 2, random))
                       : whole              ? whole_vector(n, 2, random)
                                            : normal_vector(n, random);
        attack.whole = whole;
        mlcp = plain_lcp(G * G.transpose(), q);
        mlcp.lo.setConstant(-infinity);
        break;
    }
    default: {  // impulses of any size that the bounds force, beside rows that nothing moves
        MatX A = whole_matrix(n, n, 1, random);
        if (random.index(2) == 0) A = (A * A.transpose()).eval();
        if (random.index(3) == 0) A = normal_matrix(n, n, random);
        for (Index i = 0; i < n; ++i)
            if (random.index(3) == 0) A.row(i).setZero();
        mlcp = plain_lcp(A, random.index(2) == 0 ? whole_vector(n, 2, random) : normal_vector(n, random));
        for (Index i = 0; i < n; ++i) {
            const Index sort = random.index(5);
            if (sort == 0) mlcp.lo[i] = power(-30, 35);
            if (sort == 1) mlcp.lo[i] = -infinity, mlcp.hi[i] = -power(-30, 35);
            if (sort == 2) mlcp.hi[i] = mlcp.lo[i] = power(0, 20);
        }
        break;
    }
    }
    return attack;
}

}  // namespace rigid::properties
