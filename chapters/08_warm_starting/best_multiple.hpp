/// \file best_multiple.hpp
/// How much of yesterday's answer is worth having: the multiple s λ that lowers the merit most.
///
///     φ(s λ) = s qᵀλ + ½ s² λᵀAλ,   least at   s = −qᵀλ / λᵀAλ        (8.14)
///
/// No A is built: λᵀAλ = Σ m Δu² with Δu = M⁻¹Jᵀλ. Never worse than yesterday's answer nor than none, so that a
/// stale guess cannot add energy (8.13); one pass over the rows. Bodies that no row joins have each their own s.
/// The same idea with several old answers is \cite fischer1998.
#pragma once

#include "chapters/02_velocity_constraints/constraints.hpp"

#include <numeric>
#include <span>
#include <vector>

namespace rigid {

/// Which bodies hang together, by rows between bodies that can move. Memory is kept.
struct BodyGroups {
    std::vector<Index> of;      ///< K: the lowest number of a body of the same group
    std::vector<Index> of_row;  ///< m: the group of the row's bodies
};

//! [groups]
/// Union and find: each body points to one of its group with a lower number, in the end to the lowest.
/// \param rows          m valid rows
/// \param inverse_mass  [1/kg]; a body that cannot move joins nobody
/// \param groups        overwritten
template <int Dof>
void find_groups(std::span<const Row<Dof>> rows, const VecX& inverse_mass, BodyGroups& groups)
{
    std::vector<Index>& of = groups.of;
    of.resize(static_cast<std::size_t>(inverse_mass.size() / Dof));
    std::iota(of.begin(), of.end(), Index{0});
    const auto above = [&of](Index k) -> Index& { return of[static_cast<std::size_t>(k)]; };
    const auto lowest = [&above](Index k) {
        while (above(k) != k) k = above(k) = above(above(k));  // shorten the way for those who come after
        return k;
    };
    const auto moves = [&inverse_mass](Index k) {
        return k != world && !inverse_mass.template segment<Dof>(Dof * k).isZero(0);
    };
    for (const Row<Dof>& row : rows) {
        if (!moves(row.a) || !moves(row.b)) continue;
        const Index a = lowest(row.a), b = lowest(row.b);
        above(std::max(a, b)) = std::min(a, b);
    }
    for (Index k = 0; k < static_cast<Index>(of.size()); ++k) above(k) = lowest(k);
    groups.of_row.resize(rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
        groups.of_row[i] = above(moves(rows[i].a) ? rows[i].a : rows[i].b);
}
//! [groups]

/// Numbers of each group, memory that is kept from step to step.
struct MultipleScratch {
    VecX change;     ///< 2K or 3K: Δu that yesterday's λ makes [m/s]
    VecX slope;      ///< qᵀλ [J]
    VecX curvature;  ///< λᵀAλ [J]
    VecX apart;      ///< Σ A_ii λ_i²: what the curvature would be if no row met another [J]
    VecX multiple;   ///< s
};

/// Where λᵀAλ is below this part of Σ A_ii λ_i², nearly all impulses cancel: rows in conflict, which would like to
/// grow for ever. A thousand equal discs in a column have 1e-6, 1e6 kg on four discs 1e-7.
inline constexpr Real cancelled = 1e-8;

//! [best_multiple]
/// (8.14): scales the impulses of each group by the multiple that lowers the merit most, at least zero.
/// \param rows          m valid rows
/// \param inverse_mass  [1/kg]
/// \param u_star        velocities before all impulses [m/s]
/// \param groups        of these rows
/// \param scratch       what was found
/// \param lambda        m: yesterday's impulses [N s]; scaled
template <int Dof>
void best_multiple(std::span<const Row<Dof>> rows, const VecX& inverse_mass, const VecX& u_star,
                   const BodyGroups& groups, MultipleScratch& scratch, VecX& lambda)
{
    const auto count = static_cast<Index>(groups.of.size());
    scratch.change.setZero(u_star.size());
    scratch.slope.setZero(count);
    scratch.curvature.setZero(count);
    scratch.apart.setZero(count);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Real impulse = lambda[static_cast<Index>(i)];
        rows[i].apply(impulse, scratch.change);
        scratch.slope[groups.of_row[i]] += rows[i].velocity(u_star) * impulse;
        scratch.apart[groups.of_row[i]] += rows[i].compliance() * impulse * impulse;
    }
    for (Index i = 0; i < u_star.size(); ++i)
        if (inverse_mass[i] > 0)
            scratch.curvature[groups.of[static_cast<std::size_t>(i / Dof)]] +=
                scratch.change[i] * scratch.change[i] / inverse_mass[i];
    scratch.multiple.setOnes(count);
    for (Index g = 0; g < count; ++g) {
        if (!(scratch.curvature[g] > 0)) continue;
        const Real most = scratch.curvature[g] < cancelled * scratch.apart[g] ? 1 : infinity;
        scratch.multiple[g] = std::clamp(-scratch.slope[g] / scratch.curvature[g], Real{0}, most);
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        lambda[static_cast<Index>(i)] *= scratch.multiple[groups.of_row[i]];
}
//! [best_multiple]

}  // namespace rigid
