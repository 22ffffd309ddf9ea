/// \file feedback.hpp
/// Rows that change while they are swept: bounds that another row's impulse sets, and a row that gives way.
///
///     |λ_i| ≤ μ λ_n         w_i = J_i u + b_i + γ λ_i
///
/// Before a visit the row takes its bounds from the present λ_n; after it γλ is part of the row's bias, so that `bias`
/// plus J u is w at each moment and the visit itself contains nothing of either. A scene that has no such row has no
/// list of them, and pays nothing. Chapter 13 makes friction of the first, chapter 16 springs of the second.
#pragma once

#include "chapters/06_sequential_impulse/solver_row.hpp"

namespace rigid {

/// What of one row follows an impulse.
struct Feedback {
    Real softness = 0;  ///< γ [1/kg]
    Real bias = 0;      ///< b without γλ [m/s]
    Real friction = 0;  ///< μ
    /// places from this row to the one whose λ bounds it; 0 = none does
    int bounding = 0;
};

/// The feedback of the rows in the order of the visits; empty where no row has any.
/// \param rows      m rows, as given
/// \param order     row numbers in the order of the visits; empty = as they are
/// \param prepared  those rows in that order; their biases get their γλ
/// \param place_of  memory: where each row is visited
/// \param feedback  out: m, or none
template <int Dof>
void prepare_feedback(const std::vector<Row<Dof>>& rows, std::span<const int> order,
                      std::vector<SolverRow<Dof>>& prepared,
                      std::vector<int>& place_of, std::vector<Feedback>& feedback)
{
    feedback.clear();
    const auto follows = [](const Row<Dof>& row) {
        return row.softness > 0 || row.bounded_by >= 0;
    };
    if (std::none_of(rows.begin(), rows.end(), follows)) return;
    feedback.resize(rows.size());
    place_of.resize(rows.size());
    const auto row_at = [&](std::size_t k) {
        return order.empty() ? k : static_cast<std::size_t>(order[k]);
    };
    for (std::size_t k = 0; k < rows.size(); ++k)
        place_of[row_at(k)] = static_cast<int>(k);
    for (std::size_t k = 0; k < rows.size(); ++k) {
        const Row<Dof>& row = rows[row_at(k)];
        const int n = row.bounded_by;
        feedback[k] = {row.softness, row.bias, row.friction,
                       n < 0 ? 0
                             : place_of[static_cast<std::size_t>(n)] -
                                   static_cast<int>(k)};
        prepared[k].bias += row.softness * prepared[k].lambda;
    }
}

//! [feedback]
/// The bounds of a row by the present impulse of the row that sets them.
template <int Dof>
void take_bounds(SolverRow<Dof>* row, const Feedback& feedback)
{
    if (feedback.bounding == 0) return;
    row->hi = feedback.friction * std::max(Real{0}, row[feedback.bounding].lambda);
    row->lo = -row->hi;
}

/// Its bias by its own impulse.
template <int Dof>
void give_way(SolverRow<Dof>* row, const Feedback& feedback)
{
    row->bias = feedback.bias + feedback.softness * row->lambda;
}
//! [feedback]

/// All bounds by the present impulses: before a residual is computed.
template <int Dof>
void take_all_bounds(std::span<SolverRow<Dof>> rows,
                     std::span<const Feedback> feedback)
{
    for (std::size_t k = 0; k < feedback.size(); ++k)
        take_bounds(&rows[k], feedback[k]);
}

/// Another b for the row at place k, which keeps its λ.
template <int Dof>
void change_bias(std::size_t k, Real b, std::vector<SolverRow<Dof>>& rows,
                 std::vector<Feedback>& feedback)
{
    rows[k].bias = b;
    if (feedback.empty()) return;
    feedback[k].bias = b;
    give_way(&rows[k], feedback[k]);
}

/// sweep() of rows that may have feedback.
/// \param feedback   of the rows; empty = none of them has any
template <int Dof>
int sweep(std::span<SolverRow<Dof>> rows, std::span<const Feedback> feedback,
          VecX& u, Real tolerance, bool backwards = false)
{
    if (feedback.empty()) return sweep(rows, u, tolerance, backwards);
    int changed = 0;
    const std::size_t last = rows.size() - 1;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::size_t k = backwards ? last - i : i;
        take_bounds(&rows[k], feedback[k]);
        changed += !(std::abs(visit(rows[k], u)) <= tolerance * rows[k].mass);
        give_way(&rows[k], feedback[k]);
    }
    return changed;
}

// Compiled once, in feedback.cpp.
#define RIGID_FEEDBACK(TEMPLATE, Dof)                                              \
    TEMPLATE void prepare_feedback(                                                \
        const std::vector<Row<Dof>>&, std::span<const int>,                        \
        std::vector<SolverRow<Dof>>&, std::vector<int>&, std::vector<Feedback>&);  \
    TEMPLATE int sweep(std::span<SolverRow<Dof>>, std::span<const Feedback>,       \
                       VecX&, Real, bool);
RIGID_FEEDBACK(extern template, 2)
RIGID_FEEDBACK(extern template, 3)
RIGID_FEEDBACK(extern template, 6)

}  // namespace rigid
