/// \file sequential_impulse.hpp
/// Sequential impulses: projected Gauss-Seidel on the bodies' velocities, without the matrix.
///
///     w = J u + b,   u = u* + M⁻¹ Jᵀ λ,   lo ≤ λ ≤ hi,   λ_i = lo_i or λ_i = hi_i or w_i = 0
///
/// The iterates are those of chapter 4, (6.6) \cite catto2005 \cite catto2006; no A is built, so memory and the
/// time of a sweep are linear in the rows whatever the rows have in common.
#pragma once

#include "chapters/02_velocity_constraints/row_checks.hpp"
#include "chapters/03_mlcp_formulation/verification.hpp"
#include "chapters/06_sequential_impulse/feedback.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>

namespace rigid {

struct ImpulseSettings {
    int max_sweeps = 10;
    /// of the natural residual [m/s]; 0 = not computed; sweeps until one changes
    /// nothing
    Real tolerance = 0;
    bool alternate = false;  ///< every second sweep runs backwards
};

/// Memory that is kept from step to step, and what has been done with it.
template <int Dof>
struct ImpulseMemory {
    /// in the order of the visits, each with its λ
    std::vector<SolverRow<Dof>> rows;
    std::vector<Feedback> feedback;  ///< of each of them; empty = none has any
    /// of each row in that order, where rows have feedback
    std::vector<int> place_of;
    /// Dof·K: the velocities that the sweeps work on [m/s]
    VecX u;
    std::vector<char> seen;  ///< rows that an order has named
    /// rows visited by the last solve, those of its residuals included
    std::int64_t visits = 0;
};

/// The natural residual of the present λ and u [m/s], (3.15), without A: the diagonal and w are all it needs.
template <int Dof>
Real natural_residual(std::span<const SolverRow<Dof>> rows, const VecX& u)
{
    Real largest = 0;
    for (const SolverRow<Dof>& row : rows) {
        const Real w = velocity<Dof>(row, u.template segment<Dof>(row.a),
                                     u.template segment<Dof>(row.b));
        const Real A = row.mass > 0 ? 1 / row.mass : 0;
        const Real r = natural_residual_row(A, row.lambda, w, row.lo, row.hi);
        if (!(r <= largest)) largest = r;  // also takes over a NaN
        if (std::isnan(largest)) return largest;
    }
    return largest;
}

/// How exact the velocities of the rows are at best [m/s]: the rounding of the largest velocity that an impulse gives
/// its own row. Where large impulses cancel each other, a smaller residual says nothing.
template <int Dof>
Real rounding_of(std::span<const SolverRow<Dof>> rows)
{
    Real largest = 0;
    for (const SolverRow<Dof>& row : rows)
        if (row.mass > 0)
            largest = std::max(largest, std::abs(row.lambda) / row.mass);
    return std::numeric_limits<Real>::epsilon() * largest;
}

/// A row whose bodies cannot move keeps its w whatever λ is: it takes the bound that is right for that w.
/// \return  true if some row would need an infinite one, and w is off by more than the tolerance
template <int Dof>
bool settle_rows_that_nothing_moves(std::vector<SolverRow<Dof>>& rows,
                                    const VecX& u, Real tolerance)
{
    bool hopeless = false;
    for (SolverRow<Dof>& row : rows) {
        if (row.mass > 0) continue;
        const Real w = velocity<Dof>(row, u.template segment<Dof>(row.a),
                                     u.template segment<Dof>(row.b));
        const Real bound = w > 0 ? row.lo : w < 0 ? row.hi : row.lambda;
        if (std::isfinite(bound)) row.lambda = bound;
        else hopeless = hopeless || std::abs(w) > tolerance;
    }
    return hopeless;
}

/// Of all rows of a solve, with the bounds that they have now.
template <int Dof>
Real natural_residual(ImpulseMemory<Dof>& memory)
{
    take_all_bounds<Dof>(memory.rows, memory.feedback);
    return natural_residual<Dof>(memory.rows, memory.u);
}

/// One sweep over all rows of a solve, see sweep().
template <int Dof>
int sweep(ImpulseMemory<Dof>& memory, Real tolerance, bool backwards = false)
{
    return sweep<Dof>(memory.rows, memory.feedback, memory.u, tolerance, backwards);
}

/// Brings each λ into its bounds; those that other rows set come last.
template <int Dof>
void clamp_start(const std::vector<Row<Dof>>& rows, VecX& lambda)
{
    bool coupled = false;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Real& start = lambda[static_cast<Index>(i)];
        start = std::clamp(start, rows[i].lo, rows[i].hi);
        coupled = coupled || rows[i].bounded_by >= 0;
    }
    for (std::size_t i = 0; coupled && i < rows.size(); ++i) {
        const auto [lo, hi] = bounds_of(rows[i], lambda);
        lambda[static_cast<Index>(i)] =
            std::clamp(lambda[static_cast<Index>(i)], lo, hi);
    }
}

/// What comes before the sweeps: the rows in order, λ within its bounds, and u = u* + M⁻¹ Jᵀ λ.
/// \return  true if a row cannot be solved
template <int Dof>
bool begin_sweeps(const std::vector<Row<Dof>>& rows, std::span<const int> order,
                  Real tolerance, ImpulseMemory<Dof>& memory, const VecX& u,
                  Solution& solution)
{
    const auto m = static_cast<Index>(rows.size());
    require_bodies<Dof>(rows, u.size() / Dof);
    require_order(order, rows.size(), memory.seen);
    require_tolerance("the sweeps", tolerance);
    if (solution.lambda.size() != m) solution.lambda.setZero(m);
    clamp_start(rows, solution.lambda);
    prepare(rows, order, solution.lambda, memory.rows);
    prepare_feedback(rows, order, memory.rows, memory.place_of, memory.feedback);
    memory.u = u;
    // b after a: a row of the world has a = b, and Wa = 0
    for (const SolverRow<Dof>& row : memory.rows) {
        memory.u.template segment<Dof>(row.a) += row.Wa * row.lambda;
        memory.u.template segment<Dof>(row.b) += row.Wb * row.lambda;
    }
    memory.visits = 0;
    return settle_rows_that_nothing_moves(memory.rows, memory.u, tolerance);
}

/// What comes after them: λ by row number.
template <int Dof>
void end_sweeps(std::span<const int> order, const ImpulseMemory<Dof>& memory,
                VecX& u, Solution& solution)
{
    for (std::size_t k = 0; k < memory.rows.size(); ++k)
        solution.lambda[order.empty() ? static_cast<Index>(k) : order[k]] =
            memory.rows[k].lambda;
    u = memory.u;
}

//! [until]
/// Sweeps of any kind, until there is nothing left to do.
/// \param one_sweep  int(int number): visits each row of memory.rows once and
///                   returns how many of them it found off by more than the
///                   tolerance
template <int Dof, class OneSweep>
void sweep_until(const ImpulseSettings& settings, bool hopeless,
                 const OneSweep& one_sweep, ImpulseMemory<Dof>& memory,
                 Solution& solution)
{
    const auto m = static_cast<std::int64_t>(memory.rows.size());
    solution.status = hopeless ? Status::infeasible : Status::iteration_limit;
    solution.residual = infinity;
    solution.iterations = 0;
    for (int off = 1; solution.iterations < settings.max_sweeps && off > 0;) {
        off = one_sweep(solution.iterations++);
        memory.visits += m;
        // The residual costs as much as a sweep: compute it when the sweep found
        // nothing, or was the last.
        if (!(settings.tolerance > 0) ||
            (off > 0 && solution.iterations < settings.max_sweeps))
            continue;
        solution.residual = natural_residual(memory);
        memory.visits += m;
        if (solution.residual <= settings.tolerance) {
            if (rounding_of<Dof>(memory.rows) <= settings.tolerance)
                solution.status = Status::solved;
            return;
        }
        off = hopeless ? 0 : 1;  // a small change is no small residual: go on
    }
}
//! [until]

/// Sweeps over the rows, starting from solution.lambda; solution.iterations counts the sweeps.
///
/// `solved` is said only when the natural residual was computed and met the tolerance, and the impulses are not so
/// large that rounding alone exceeds it; `infeasible` when a row between bodies that cannot move cannot be solved. With
/// tolerance 0 the sweeps end early at one that changed nothing: the next would do the same. Does not allocate once it
/// has seen a scene of this size.
/// \param rows      m valid rows
/// \param order     row numbers in the order of the visits; empty = as they are
/// \param u         in: u*, velocities before all impulses; out: u* + M⁻¹ Jᵀ λ [m/s]
/// \param solution  in: the λ to start from (a vector of another length means zero); out: the answer
/// \throws std::invalid_argument  for an order that does not name each row once, a row of a body that is not there, or a
///                                tolerance that is negative or infinite
template <int Dof>
void sequential_impulse(const std::vector<Row<Dof>>& rows,
                        std::span<const int> order, const ImpulseSettings& settings,
                        ImpulseMemory<Dof>& memory, VecX& u, Solution& solution)
{
    const bool hopeless =
        begin_sweeps(rows, order, settings.tolerance, memory, u, solution);
    const auto one_sweep = [&](int number) {
        return sweep(memory, settings.tolerance,
                     settings.alternate && number % 2 == 1);
    };
    sweep_until(settings, hopeless, one_sweep, memory, solution);
    end_sweeps(order, memory, u, solution);
}

// Compiled once, in sequential_impulse.cpp.
#define RIGID_SEQUENTIAL_IMPULSE(TEMPLATE, Dof)                                    \
    TEMPLATE Real natural_residual<Dof>(std::span<const SolverRow<Dof>>,           \
                                        const VecX&);                              \
    TEMPLATE bool settle_rows_that_nothing_moves(std::vector<SolverRow<Dof>>&,     \
                                                 const VecX&, Real);               \
    TEMPLATE void clamp_start(const std::vector<Row<Dof>>&, VecX&);                \
    TEMPLATE bool begin_sweeps(const std::vector<Row<Dof>>&, std::span<const int>, \
                               Real, ImpulseMemory<Dof>&, const VecX&, Solution&); \
    TEMPLATE void end_sweeps(std::span<const int>, const ImpulseMemory<Dof>&,      \
                             VecX&, Solution&);                                    \
    TEMPLATE void sequential_impulse(const std::vector<Row<Dof>>&,                 \
                                     std::span<const int>, const ImpulseSettings&, \
                                     ImpulseMemory<Dof>&, VecX&, Solution&);
RIGID_SEQUENTIAL_IMPULSE(extern template, 2)
RIGID_SEQUENTIAL_IMPULSE(extern template, 3)
RIGID_SEQUENTIAL_IMPULSE(extern template, 6)

}  // namespace rigid
