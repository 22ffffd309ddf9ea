/// \file judge.hpp
/// What a solver said of a problem, held against the problem as it was given and against nothing else.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,   w ≥ 0 at lo,   w ≤ 0 at hi,   w = 0 between
///
/// Written a second time, in wider numbers: no function of the solvers is used here.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "tests/properties/wide.hpp"

#include <optional>
#include <vector>

namespace rigid::properties {

inline constexpr Wide underflow = 1e-300;  ///< below that doubles lose digits
inline constexpr Wide certain = 1e-20;     ///< a share: no rounding of a double is that small

/// A problem in wide numbers, each row in a unit of its own, so that units can't hide an error: d_i = √A_ii, and in a
/// row without a diagonal what its neighbours make of it.
struct WideProblem {
    const Mlcp& mlcp;
    std::vector<Wide> unit;
    Wide given = 0;  ///< the largest N_i / d_i: q, and what the λ that the bounds force does to it
    Wide speed = 0;  ///< the largest |q_i| [m/s], for rows that no λ moves: they have no unit

    explicit WideProblem(const Mlcp& problem) : mlcp(problem)
    {
        for (Index i = 0; i < mlcp.size(); ++i) {
            Real own = 0, neighbours = 0, largest = 0;
            Wide N = std::abs(mlcp.q[i]);
            for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
                const Index j = entry.col();
                const Real size = std::abs(entry.value()), across = mlcp.A.coeff(j, j);
                if (i == j && entry.value() > 0) own = std::sqrt(entry.value());
                if (i != j && across > 0) neighbours = std::max(neighbours, size / std::sqrt(across));
                largest = std::max(largest, size);
                const Real nearest = std::max({mlcp.lo[j], -mlcp.hi[j], Real{0}});
                N += static_cast<Wide>(size) * static_cast<Wide>(nearest);
            }
            unit.push_back(own > 0          ? own
                           : neighbours > 0 ? neighbours
                           : largest > 0    ? std::sqrt(largest)
                                            : 1);
            speed = std::max(speed, static_cast<Wide>(std::abs(mlcp.q[i])));
            if (largest == 0) unit.back() = 0;
            if (largest > 0) given = std::max(given, N / unit.back());
        }
    }

    struct Row {
        Wide residual = 0;  ///< the natural residual (3.15); without a diagonal λ is at a bound or not
        Wide sum = 0;       ///< |q_i| + Σ |A_ij λ_j|
    };

    Row row(Index i, const std::vector<Wide>& lambda) const
    {
        const auto k = static_cast<std::size_t>(i);
        Wide r = mlcp.q[i], a = 0, sum = magnitude(r);
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            const Wide term =
                static_cast<Wide>(entry.value()) * lambda[static_cast<std::size_t>(entry.col())];
            r += term;
            sum += magnitude(term);
            if (entry.col() == i && entry.value() > 0) a = entry.value();
        }
        const auto room = [&](Real bound) {  // a (λ − bound); without a diagonal nothing or everything
            const Wide distance = lambda[k] - static_cast<Wide>(bound);
            if (a > 0) return a * distance;
            const Wide rounding = 1e-14 * (magnitude(lambda[k]) + std::abs(bound));
            return magnitude(distance) <= rounding ? Wide{0} : distance * static_cast<Wide>(1e300) * 1e300;
        };
        if (mlcp.lo[i] > -infinity) r = std::min(r, room(mlcp.lo[i]));
        if (mlcp.hi[i] < infinity) r = std::max(r, room(mlcp.hi[i]));
        return {r, sum};
    }

    /// The residual of each row as a share of what the problem is given, the largest one.
    /// \param enough  [m/s] that much in a row is nothing
    Wide error(const std::vector<Wide>& lambda, Wide enough = 0) const
    {
        Wide largest = 0;
        for (Index i = 0; i < mlcp.size(); ++i) {
            const auto k = static_cast<std::size_t>(i);
            const auto [r, sum] = row(i, lambda);
            if (magnitude(r) <= std::max(enough, underflow)) continue;
            const Wide size = unit[k] > 0 ? unit[k] * given : speed;
            Wide share = size > 0 ? magnitude(r) / size : static_cast<Wide>(infinity);
            if (!(given > 0) && magnitude(r) <= 3e-14 * sum)
                share = 0;  // nothing is given: only rounding is nothing
            if (!(share <= largest)) largest = share;
        }
        return largest;
    }

    /// Whether no residual is seen, beside what is given and beside each row's own numbers: a bound of 1e30 N s
    /// elsewhere hides nothing.
    bool is_certain(const std::vector<Wide>& lambda) const
    {
        for (Index i = 0; i < mlcp.size(); ++i) {
            const auto [r, sum] = row(i, lambda);
            if (!(magnitude(r) <= std::max(certain * sum, underflow))) return false;
        }
        return error(lambda) <= certain;
    }

    /// Whether impulses are of a size that the problem can speak of: no λ that doubles lose in a sum.
    bool is_moderate(const std::vector<Wide>& lambda) const
    {
        for (std::size_t k = 0; k < lambda.size(); ++k)
            if (!(magnitude(lambda[k]) * unit[k] <= 1e11 * given)) return false;
        return true;
    }
};

inline std::vector<Wide> widened(const VecX& v) { return {v.begin(), v.end()}; }

/// Solves the active rows of a set in wide numbers, from λ on: full pivoting; a pivot below `nothing` of the first
/// leaves its unknown where it is. Returns false if an equation is left over that no λ can fulfil.
inline bool wide_solve(const WideProblem& problem, const std::vector<std::size_t>& active, Wide nothing,
                       std::vector<Wide>& lambda)
{
    const Mlcp& mlcp = problem.mlcp;
    const std::vector<Wide>& unit = problem.unit;
    const std::size_t f = active.size();
    std::vector<std::vector<Wide>> T(f, std::vector<Wide>(f + 1, 0));
    std::vector<std::size_t> column(f), place(lambda.size(), f);
    for (std::size_t k = 0; k < f; ++k) place[active[k]] = column[k] = k;
    for (std::size_t k = 0; k < f; ++k) {
        const auto i = static_cast<Index>(active[k]);
        Wide w = mlcp.q[i];
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            const auto j = static_cast<std::size_t>(entry.col());
            w += static_cast<Wide>(entry.value()) * lambda[j];
            if (place[j] < f) T[k][place[j]] = static_cast<Wide>(entry.value()) / (unit[j] * unit[active[k]]);
        }
        T[k][f] = unit[active[k]] > 0 ? -w / unit[active[k]] : -w / problem.speed * problem.given;
    }
    Wide first = 0;
    std::size_t rank = 0;
    for (; rank < f; ++rank) {
        std::size_t p = rank, c = rank;
        for (std::size_t r = rank; r < f; ++r)
            for (std::size_t s = rank; s < f; ++s)
                if (magnitude(T[r][s]) > magnitude(T[p][c])) p = r, c = s;
        if (rank == 0) first = magnitude(T[p][c]);
        if (!(magnitude(T[p][c]) > nothing * first)) break;
        std::swap(T[p], T[rank]);
        for (auto& line : T) std::swap(line[c], line[rank]);
        std::swap(column[c], column[rank]);
        for (std::size_t r = rank + 1; r < f; ++r) {
            const Wide factor = T[r][rank] / T[rank][rank];
            if (factor != 0)
                for (std::size_t s = rank; s <= f; ++s) T[r][s] -= factor * T[rank][s];
        }
    }
    for (std::size_t r = rank; r < f; ++r)
        if (magnitude(T[r][f]) > nothing * problem.given) return false;
    for (std::size_t r = rank; r-- > 0;) {
        for (std::size_t s = r + 1; s < rank; ++s) T[r][f] -= T[r][s] * T[s][f];
        T[r][f] /= T[r][r];
        lambda[active[column[r]]] += T[r][f] / unit[active[column[r]]];
    }
    return true;
}

inline constexpr Wide dependent = 1e-25;  ///< a pivot of that share is none

/// Is there an answer so near to λ that only rounding lies between? Its active rows are solved in wide numbers; what
/// is left must be below all that a double can tell apart, and λ must not be absurd beside the problem.
inline std::optional<std::vector<Wide>> certain_answer(const WideProblem& problem, const VecX& near)
{
    const Mlcp& mlcp = problem.mlcp;
    if (!wide_is_exact || near.size() != mlcp.size() || !near.allFinite()) return std::nullopt;
    std::vector<Wide> lambda = widened(near);
    std::vector<std::size_t> active;
    for (Index i = 0; i < mlcp.size(); ++i)
        if (near[i] > mlcp.lo[i] && near[i] < mlcp.hi[i]) active.push_back(static_cast<std::size_t>(i));
    if (!wide_solve(problem, active, dependent, lambda)) return std::nullopt;
    if (!problem.is_certain(lambda) || !problem.is_moderate(lambda)) return std::nullopt;
    return lambda;
}

/// Some certain answer among all sets of cases whose active rows are independent; for a few rows only.
inline std::optional<std::vector<Wide>> search_answer(const WideProblem& problem)
{
    const Mlcp& mlcp = problem.mlcp;
    const auto n = static_cast<std::size_t>(mlcp.size());
    std::vector<int> set(n, 0);  // 0 between, 1 at lo, 2 at hi
    for (;;) {
        bool possible = wide_is_exact;
        std::vector<std::size_t> active;
        std::vector<Wide> lambda(n, 0);
        for (std::size_t k = 0; k < n && possible; ++k) {
            const auto i = static_cast<Index>(k);
            const Real bound = set[k] == 1 ? mlcp.lo[i] : mlcp.hi[i];
            if (set[k] == 0) active.push_back(k);
            else if (std::abs(bound) < infinity) lambda[k] = bound;
            else possible = false;
        }
        if (possible && wide_solve(problem, active, dependent, lambda) && problem.is_certain(lambda) &&
            problem.is_moderate(lambda))
            return lambda;
        std::size_t k = 0;
        while (k < n && ++set[k] > 2) set[k++] = 0;
        if (k == n) return std::nullopt;
    }
}

}  // namespace rigid::properties
