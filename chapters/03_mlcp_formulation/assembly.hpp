/// \file assembly.hpp
/// From rows to the MLCP: \f$A = J M^{-1} J^T\f$ and \f$q = J u^* + b\f$, without ever writing down J or M.
///
///     A_ij = J_i M⁻¹ J_jᵀ,   q_i = J_i u* + b_i,   and a row that gives way has its γ on the diagonal
///
/// (3.18). Two rows meet, A_ij ≠ 0, only where both move the same body. So each pair of rows that does is
/// multiplied once, and no other: the cost grows with the number of such pairs, not with m² or m²·K.
#pragma once

#include "chapters/02_velocity_constraints/solve_rows.hpp"
#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <string>
#include <vector>

namespace rigid {

/// Memory that is kept from step to step, and what the last assembly cost.
struct AssemblyScratch {
    /// K + 1: the rows that move body k are on_body[first[k]] … on_body[first[k+1]
    /// − 1]
    std::vector<int> first;
    std::vector<int> on_body;  ///< row numbers, ascending for each body
    std::vector<int> next;     ///< where the next entry goes
    /// how often J_i M⁻¹ J_jᵀ was computed: entries on and below the diagonal
    Index pairs = 0;
};

/// True if the row's impulse changes the velocity of its body a (or b). The world and bodies that cannot move
/// have nothing to pass on.
template <int Dof>
bool moves_a(const Row<Dof>& row)
{
    return row.a != world && (row.Wa.array() != 0).any();
}
template <int Dof>
bool moves_b(const Row<Dof>& row)
{
    return (row.Wb.array() != 0).any();
}

/// Calls visit(j), ascending, for each row j ≤ i that moves a body which row i moves too.
template <int Dof, class Visit>
void for_each_partner(const Row<Dof>& row, int i, const AssemblyScratch& scratch,
                      const Visit& visit)
{
    const auto begin = [&](Index k) {
        return scratch.on_body.data() + scratch.first[static_cast<std::size_t>(k)];
    };
    const int* of_a = moves_a(row) ? begin(row.a) : nullptr;
    const int* of_b = moves_b(row) ? begin(row.b) : nullptr;
    // Both lists hold i itself, so each ends there: merge them.
    while (of_a || of_b) {
        const int j = !of_b || (of_a && *of_a < *of_b) ? *of_a : *of_b;
        visit(j);
        if (of_a && *of_a == j) of_a = j < i ? of_a + 1 : nullptr;
        if (of_b && *of_b == j) of_b = j < i ? of_b + 1 : nullptr;
    }
}

//! [assemble]
/// (3.18): A with ascending columns, q, and the bounds of the rows, in their order.
/// A is symmetric to the bit. Does not allocate when the scene has as many rows as
/// before.
/// \param rows     m rows; their bodies must exist in u_star
/// \param u_star   velocities after the forces, before the impulses [m/s]
/// \param scratch  reused memory
/// \param mlcp     out
template <int Dof>
void assemble(const std::vector<Row<Dof>>& rows, const VecX& u_star,  //
              AssemblyScratch& scratch, Mlcp& mlcp)
{
    const int m = static_cast<int>(rows.size());
    const auto at = [](auto& list, Index i) -> auto&
    {
        return list[static_cast<std::size_t>(i)];
    };

    // Which rows move body k?  Count, add up, fill in.
    scratch.first.assign(static_cast<std::size_t>(u_star.size() / Dof) + 1, 0);
    for (const Row<Dof>& row : rows) {
        if (moves_a(row)) ++at(scratch.first, row.a + 1);
        if (moves_b(row)) ++at(scratch.first, row.b + 1);
    }
    for (std::size_t k = 1; k < scratch.first.size(); ++k)
        scratch.first[k] += scratch.first[k - 1];
    scratch.on_body.resize(static_cast<std::size_t>(scratch.first.back()));
    scratch.next.assign(scratch.first.begin(), scratch.first.end());
    for (int i = 0; i < m; ++i) {
        const Row<Dof>& row = at(rows, i);
        if (moves_a(row)) at(scratch.on_body, at(scratch.next, row.a)++) = i;
        if (moves_b(row)) at(scratch.on_body, at(scratch.next, row.b)++) = i;
    }

    // How many entries has each line of A?  A pair gives one to both of its lines.
    mlcp.A.resize(m, m);
    int* const begin = mlcp.A.outerIndexPtr();
    scratch.pairs = 0;
    for (int i = 0; i < m; ++i)
        for_each_partner(at(rows, i), i, scratch, [&](int j) {
            ++scratch.pairs;
            ++begin[i + 1];
            if (j != i) ++begin[j + 1];
        });
    for (int i = 0; i < m; ++i) begin[i + 1] += begin[i];
    mlcp.A.resizeNonZeros(begin[m]);

    // Multiply each pair once and write it twice. Line j gets its entries right of
    // the diagonal from the later lines i, in their order: the columns ascend by
    // themselves.
    mlcp.q.resize(m);
    mlcp.lo.resize(m);
    mlcp.hi.resize(m);
    scratch.next.assign(begin, begin + m);
    const auto append = [&](int line, int column, Real value) {
        const int place = at(scratch.next, line)++;
        mlcp.A.innerIndexPtr()[place] = column;
        mlcp.A.valuePtr()[place] = value;
    };
    for (int i = 0; i < m; ++i) {
        const Row<Dof>& row = at(rows, i);
        for_each_partner(row, i, scratch, [&](int j) {
            const Real value =
                coupling(row, at(rows, j)) + (j == i ? row.softness : 0);
            append(i, j, value);
            if (j != i) append(j, i, value);
        });
        mlcp.q[i] = row.velocity(u_star);
        mlcp.lo[i] = row.lo;
        mlcp.hi[i] = row.hi;
    }
}
//! [assemble]

/// The same with memory of its own. Throws std::invalid_argument, naming the row, for a row that makes no
/// sense or a velocity that is not finite.
template <int Dof>
Mlcp assemble(const std::vector<Row<Dof>>& rows, const VecX& u_star)
{
    require_finite(u_star, "u*");
    for (std::size_t i = 0; i < rows.size(); ++i)
        require_valid(rows[i], "row " + std::to_string(i), u_star.size() / Dof);
    require_bounds(rows);
    AssemblyScratch scratch;
    Mlcp mlcp;
    assemble(rows, u_star, scratch, mlcp);
    return mlcp;
}

// Compiled once, in assembly.cpp.
#define RIGID_ASSEMBLY(TEMPLATE, Dof)                                              \
    TEMPLATE void assemble(const std::vector<Row<Dof>>&, const VecX&,              \
                           AssemblyScratch&, Mlcp&);                               \
    TEMPLATE Mlcp assemble(const std::vector<Row<Dof>>&, const VecX&);
RIGID_ASSEMBLY(extern template, 2)
RIGID_ASSEMBLY(extern template, 3)
RIGID_ASSEMBLY(extern template, 6)

}  // namespace rigid
