/// \file body_groups.hpp
/// Which bodies hang together by rows: each group gets a multiple of its own (best_multiple.hpp).
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"
#include "chapters/02_velocity_constraints/row_checks.hpp"
#include "common/union_find.hpp"

#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace rigid {

/// Which bodies hang together, by rows between bodies that can move. Memory is kept.
struct BodyGroups {
    /// K: the lowest number of a body of the same group; of a body without a row
    /// its own
    std::vector<Index> of;
    std::vector<Index> bodies;  ///< those that some row names, ascending
    std::vector<Index> of_row;  ///< m: the group of the row's bodies
};

//! [groups]
/// Union and find: each body points to one of its group with a lower number, in the
/// end to the lowest. Only bodies that rows name are looked at, so that this costs
/// nothing where all others sleep.
/// \param rows          m valid rows
/// \param inverse_mass  [1/kg]; a body that cannot move joins no others
/// \param groups        overwritten
template <int Dof>
void find_groups(std::span<const Row<Dof>> rows, const VecX& inverse_mass,
                 BodyGroups& groups)
{
    std::vector<Index>&of = groups.of, &bodies = groups.bodies;
    const auto count = static_cast<std::size_t>(inverse_mass.size() / Dof);
    require_bodies<Dof>(rows, static_cast<Index>(count));
    const auto above = [&of](Index k) -> Index& {
        return of[static_cast<std::size_t>(k)];
    };
    if (of.size() != count) {
        of.resize(count);
        std::iota(of.begin(), of.end(), Index{0});
    } else {
        for (const Index k : bodies) above(k) = k;
    }
    bodies.clear();
    for (const Row<Dof>& row : rows)
        for (const Index k : {row.a, row.b})
            if (k != world) bodies.push_back(k);
    if (!std::is_sorted(bodies.begin(), bodies.end()))
        std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());

    const auto moves = [&inverse_mass](Index k) {
        return k != world && !inverse_mass.template segment<Dof>(Dof * k).isZero(0);
    };
    for (const Row<Dof>& row : rows)
        if (moves(row.a) && moves(row.b)) unite(of, row.a, row.b);
    for (const Index k : bodies) above(k) = lowest_of(of, k);
    groups.of_row.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        groups.of_row[i] = above(moves(rows[i].a) ? rows[i].a : rows[i].b);
}
//! [groups]

// Compiled once, in body_groups.cpp.
#define RIGID_BODY_GROUPS(TEMPLATE, Dof)                                           \
    TEMPLATE void find_groups(std::span<const Row<Dof>>, const VecX&, BodyGroups&);
RIGID_BODY_GROUPS(extern template, 2)
RIGID_BODY_GROUPS(extern template, 3)
RIGID_BODY_GROUPS(extern template, 6)

}  // namespace rigid
