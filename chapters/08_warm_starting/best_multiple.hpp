/// \file best_multiple.hpp
/// How much of the previous answer is worth having: the multiple s λ that lowers the merit most.
///
///     φ(s λ) = s qᵀλ + ½ s² λᵀAλ,   least at   s = −qᵀλ / λᵀAλ        (8.12)
///
/// No A is built: λᵀAλ = Σ m Δu² with Δu = M⁻¹Jᵀλ. Never worse than the previous answer nor than none, so that a
/// stale guess cannot add energy: (8.11), and where b ≥ 0 (8.15). One pass over the rows, and over the bodies that they
/// name. Bodies that no row joins
/// have each their own s. The same idea with several old answers is \cite fischer1998.
#pragma once

#include "chapters/08_warm_starting/body_groups.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

//! [rule]
/// What may be taken instead of the s of (8.12). The merit of sλ is at most zero
/// for every s between 0 and twice the best, so that none of it touches (8.15).
struct MultipleRule {
    /// a multiple is moved towards 1 by this much, and to 1 if it is no farther;
    /// see section 8.7
    Real near_one = 0;
    Real most = infinity;  ///< and it is at most this, 1 …
};

/// The s of a group.
/// \param slope      qᵀλ [J]
/// \param curvature  λᵀAλ [J]; zero = the guess moves nothing, and stays as it is
/// \param most       1 where a greater one cannot be trusted, else infinity
inline Real multiple_of(Real slope, Real curvature, const MultipleRule& rule,
                        Real most = infinity)
{
    if (!(curvature > 0)) return 1;
    const Real best =
        std::clamp(-slope / curvature, Real{0}, std::min(most, rule.most));
    if (best > 1) return std::max(Real{1}, best - rule.near_one);
    return std::min({Real{1}, best + rule.near_one, 2 * best});
}
//! [rule]

/// Throws std::invalid_argument, naming the number, unless the rule makes sense.
void require_valid(const MultipleRule& rule);

/// Numbers of each group, memory that is kept from step to step. Only entries of bodies that rows name are written.
struct MultipleScratch {
    std::vector<Index> written;  ///< those bodies, ascending
    VecX change;     ///< 2K or 3K: Δu that the remembered λ makes [m/s]
    VecX slope;      ///< qᵀλ [J]
    VecX curvature;  ///< λᵀAλ [J]
    /// Σ A_ii λ_i²: what the curvature would be if no row met another [J]
    VecX apart;
    VecX multiple;  ///< s; 1 where there is no row
    /// a row of the group has a bias that velocities at rest do not satisfy
    std::vector<char> asks;
    /// 1 or more: of a group with rows that take their bounds from others; else ∞
    VecX most;
    VecX own_change, own_slope, own_curvature;  ///< of the rows that do not
};

//! [trusted]
/// Where λᵀAλ is below this part of Σ A_ii λ_i², its digits are rounding: those of
/// Δu are 1e-16 of what is summed up. A thousand equal discs in a column have 1e-6,
/// 1e8 kg on four discs 1e-9.
inline constexpr Real rounding_alone = 1e-20;
/// And where the bias of some row requires a velocity against its error (b < 0, or
/// b ≠ 0 of a bilateral one), rows may be in conflict: their merit has no least
/// value, and below this part the multiple would let them grow forever.
inline constexpr Real cancelled = 1e-8;

/// Velocities of zero satisfy each row whose bias requires nothing, so such rows
/// are never in conflict.
template <int Dof>
bool asks(const Row<Dof>& row)
{
    return row.bias < 0 || (row.bias > 0 && row.lo < 0);
}
//! [trusted]

/// Zero for all bodies and groups of rows; what the last call wrote is undone.
template <int Dof>
void begin_multiples(const BodyGroups& groups, MultipleScratch& scratch)
{
    const auto count = static_cast<Index>(groups.of.size());
    if (scratch.multiple.size() != count) {
        for (VecX* const sums :
             {&scratch.slope, &scratch.curvature, &scratch.apart})
            sums->setZero(count);
        scratch.change.setZero(Dof * count);
        scratch.multiple.setOnes(count);
        scratch.most.setConstant(count, infinity);
        scratch.asks.assign(groups.of.size(), 0);
        scratch.written.clear();
    }
    for (const Index k : scratch.written)
        scratch.multiple[k] = 1, scratch.most[k] = infinity;
    scratch.written = groups.bodies;
    for (const Index k : scratch.written) {
        scratch.change.template segment<Dof>(Dof * k).setZero();
        scratch.slope[k] = scratch.curvature[k] = scratch.apart[k] = 0;
        scratch.asks[static_cast<std::size_t>(k)] = 0;
    }
}

//! [followed]
/// Friction brakes more the more the group is pressed down, so its merit falls with
/// an s that is too large. Above 1 such a group gets no more than its rows with
/// bounds of their own would get by themselves.
template <int Dof>
void limit_followed(std::span<const Row<Dof>> rows, const VecX& inverse_mass,
                    const VecX& u_star, const BodyGroups& groups,
                    MultipleScratch& scratch, const VecX& lambda)
{
    const auto follows = [](const Row<Dof>& row) { return row.bounded_by >= 0; };
    if (std::none_of(rows.begin(), rows.end(), follows)) return;
    for (VecX* const sums : {&scratch.own_slope, &scratch.own_curvature})
        sums->setZero(scratch.most.size());
    scratch.own_change.setZero(inverse_mass.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Index group = groups.of_row[i];
        if (follows(rows[i])) {
            scratch.most[group] = 1;
            continue;
        }
        const Real impulse = lambda[static_cast<Index>(i)];
        rows[i].apply(impulse, scratch.own_change);
        scratch.own_slope[group] += rows[i].velocity(u_star) * impulse;
        scratch.own_curvature[group] += rows[i].softness * impulse * impulse;
    }
    for (const Index k : scratch.written)
        for (Index i = Dof * k; i < Dof * (k + 1); ++i)
            if (inverse_mass[i] > 0)
                scratch.own_curvature[groups.of[static_cast<std::size_t>(k)]] +=
                    scratch.own_change[i] * scratch.own_change[i] / inverse_mass[i];
    for (const Index g : scratch.written)
        if (scratch.most[g] == 1 && scratch.own_curvature[g] > 0)
            scratch.most[g] =
                std::max(Real{1}, -scratch.own_slope[g] / scratch.own_curvature[g]);
}
//! [followed]

//! [bounded]
/// What is over a bound of its own is cut off there, and the others are not: the
/// merit is that of sλ only as long as sλ is within all bounds.
/// \param impulse  within the bounds of its row [N s]
template <int Dof>
void limit_bounded(const Row<Dof>& row, Real impulse, Real& most)
{
    if (row.bounded_by >= 0 || impulse == 0) return;
    const Real bound = impulse > 0 ? row.hi : row.lo;
    most = std::min(most, std::max(Real{1}, bound / impulse));
}
//! [bounded]

//! [best_multiple]
/// (8.12): scales the impulses of each group by the multiple that lowers the merit
/// most, at least zero.
/// \param rows          m valid rows
/// \param inverse_mass  [1/kg]
/// \param u_star        velocities before all impulses [m/s]
/// \param groups        of these rows
/// \param scratch       what was found
/// \param lambda        m: the remembered impulses [N s], each within its bounds;
///                      scaled
/// \param rule          what may be taken instead of the best
template <int Dof>
void best_multiple(std::span<const Row<Dof>> rows, const VecX& inverse_mass,
                   const VecX& u_star, const BodyGroups& groups,
                   MultipleScratch& scratch, VecX& lambda,
                   const MultipleRule& rule = {})
{
    begin_multiples<Dof>(groups, scratch);
    limit_followed(rows, inverse_mass, u_star, groups, scratch, lambda);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const Real impulse = lambda[static_cast<Index>(i)];
        limit_bounded(rows[i], impulse, scratch.most[groups.of_row[i]]);
        rows[i].apply(impulse, scratch.change);
        scratch.slope[groups.of_row[i]] += rows[i].velocity(u_star) * impulse;
        scratch.apart[groups.of_row[i]] += rows[i].diagonal() * impulse * impulse;
        scratch.curvature[groups.of_row[i]] += rows[i].softness * impulse * impulse;
        if (asks(rows[i]))
            scratch.asks[static_cast<std::size_t>(groups.of_row[i])] = 1;
    }
    for (const Index k : scratch.written)
        for (Index i = Dof * k; i < Dof * (k + 1); ++i)
            if (inverse_mass[i] > 0)
                scratch.curvature[groups.of[static_cast<std::size_t>(k)]] +=
                    scratch.change[i] * scratch.change[i] / inverse_mass[i];
    for (const Index g : scratch.written) {
        if (groups.of[static_cast<std::size_t>(g)] != g)
            continue;  // not the body that the group is named after
        const Real part =
            scratch.asks[static_cast<std::size_t>(g)] ? cancelled : rounding_alone;
        const Real most =
            scratch.curvature[g] < part * scratch.apart[g] ? 1 : scratch.most[g];
        scratch.multiple[g] =
            multiple_of(scratch.slope[g], scratch.curvature[g], rule, most);
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        lambda[static_cast<Index>(i)] *= scratch.multiple[groups.of_row[i]];
}
//! [best_multiple]

// Compiled once, in best_multiple.cpp.
#define RIGID_BEST_MULTIPLE(TEMPLATE, Dof)                                         \
    TEMPLATE void begin_multiples<Dof>(const BodyGroups&, MultipleScratch&);       \
    TEMPLATE void limit_followed(std::span<const Row<Dof>>, const VecX&,           \
                                 const VecX&, const BodyGroups&, MultipleScratch&, \
                                 const VecX&);                                     \
    TEMPLATE void best_multiple(std::span<const Row<Dof>>, const VecX&,            \
                                const VecX&, const BodyGroups&, MultipleScratch&,  \
                                VecX&, const MultipleRule&);
RIGID_BEST_MULTIPLE(extern template, 2)
RIGID_BEST_MULTIPLE(extern template, 3)
RIGID_BEST_MULTIPLE(extern template, 6)

}  // namespace rigid
