/// \file row_checks.hpp
/// Rows that make sense: what solvers of rows require of their input.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "common/text.hpp"

#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

/// Throws std::invalid_argument, naming the row, unless each row joins two of the bodies 0 … count − 1, or the world and
/// one of them. One pass, before the sweeps: they look at no index.
template <int Dof, class Rows>
void require_bodies(const Rows& rows, Index count)
{
    std::size_t i = 0;
    for (const Row<Dof>& row : rows) {
        if (row.b < 0 || row.b >= count || row.a < world || row.a >= count)
            throw std::invalid_argument(
                "row " + std::to_string(i) + " joins bodies " +
                std::to_string(row.a) + " and " + std::to_string(row.b) +
                "; there are bodies 0 to " + std::to_string(count - 1) +
                ", and -1 as first body is the world");
        ++i;
    }
}

/// Throws std::invalid_argument, naming row and value, unless the row's numbers are finite, its
/// bodies are two of 0 … count-1 (or the world and one), and lo ≤ hi.
/// \param row    the row to look at
/// \param name   what to call it, such as "row 3"
/// \param count  number of bodies K
template <int Dof>
void require_valid(const Row<Dof>& row, const std::string& name, Index count)
{
    const auto refuse = [&name](const std::string& what) {
        throw std::invalid_argument(name + " " + what);
    };
    if (row.b < 0 || row.b >= count || row.a < world || row.a >= count)
        refuse("joins bodies " + std::to_string(row.a) + " and " +
               std::to_string(row.b) + "; there are bodies 0 to " +
               std::to_string(count - 1) + ", and -1 as first body is the world");
    if (row.a == row.b)
        refuse("joins body " + std::to_string(row.a) + " to itself");
    if (!row.Ja.allFinite() || !row.Jb.allFinite())
        refuse("has an entry of J that is not finite");
    if (!row.Wa.allFinite() || !row.Wb.allFinite())
        refuse("has an entry of the inverse mass times J that is not finite");
    if (const Real A = row.inverse_effective_mass(); !std::isfinite(A))
        refuse("has J M⁻¹ Jᵀ = " + shortest(A) +
               " 1/kg; it must be finite: give C and J in a larger unit");
    if (!std::isfinite(row.bias))
        refuse("has the bias " + shortest(row.bias) + " m/s; it must be finite");
    if (!(row.lo <= row.hi))
        refuse("has the bounds lo = " + shortest(row.lo) +
               " and hi = " + shortest(row.hi) + " N s; lo must not be above hi");
    if (!(row.softness >= 0) || !std::isfinite(row.softness))
        refuse("has the softness " + shortest(row.softness) +
               " 1/kg; it must be zero or positive and finite");
    if (!(row.friction >= 0) || !std::isfinite(row.friction))
        refuse("has the friction coefficient " + shortest(row.friction) +
               "; it must be zero or positive and finite");
}

/// Throws std::invalid_argument, naming the row, unless each row that another one bounds names a row that there is,
/// that has its own bounds, and that only pushes.
template <int Dof>
void require_bounds(const std::vector<Row<Dof>>& rows)
{
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const int n = rows[i].bounded_by;
        if (n < 0) continue;
        const auto refuse = [&](const std::string& why) {
            throw std::invalid_argument("row " + std::to_string(i) +
                                        " is bounded by row " + std::to_string(n) +
                                        why);
        };
        if (static_cast<std::size_t>(n) >= rows.size())
            refuse("; there are " + std::to_string(rows.size()) + " rows");
        const Row<Dof>& other = rows[static_cast<std::size_t>(n)];
        if (other.bounded_by >= 0) refuse(", which another row bounds itself");
        if (!(other.lo >= 0))
            refuse(", which may pull; a row that bounds others must only push");
    }
}

// Compiled once, in row_checks.cpp.
#define RIGID_ROW_CHECKS(TEMPLATE, Dof)                                            \
    TEMPLATE void require_bodies<Dof>(const std::vector<Row<Dof>>&, Index);        \
    TEMPLATE void require_bodies<Dof>(const std::span<const Row<Dof>>&, Index);    \
    TEMPLATE void require_valid(const Row<Dof>&, const std::string&, Index);       \
    TEMPLATE void require_bounds(const std::vector<Row<Dof>>&);
RIGID_ROW_CHECKS(extern template, 2)
RIGID_ROW_CHECKS(extern template, 3)
RIGID_ROW_CHECKS(extern template, 6)

}  // namespace rigid
