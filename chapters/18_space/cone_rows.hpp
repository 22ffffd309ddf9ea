/// \file cone_rows.hpp
/// The rows of an island with the discs in them: one sweep over them, and their residual.
///
///     a row: its λ into its bounds, (3.15)        a disc: its two rows at once, (18.38)
#pragma once

#include "chapters/18_space/friction_cone.hpp"

namespace rigid {

struct ConeRows {
    std::span<SolverRow<6>> rows;
    std::span<const Feedback> feedback;  ///< empty: nothing bounds another
    /// of each row: the disc that begins there, or −1
    std::span<const int> disc_at;
    /// of all islands; DiscOfRows::row counts from the first of all rows
    std::span<const DiscOfRows> discs;
    std::span<const int> bodies;

    int bound_by(std::size_t k) const
    {
        return feedback.empty() || feedback[k].bounding == 0
                   ? -1
                   : static_cast<int>(k) + feedback[k].bounding;
    }
    const DiscOfRows* disc(std::size_t k) const
    {
        return disc_at[k] < 0 ? nullptr
                              : &discs[static_cast<std::size_t>(disc_at[k])];
    }
    /// of a disc under the present λ [N s]
    Real radius(std::size_t k) const
    {
        return feedback[k].friction *
               std::max(Real{0},
                        rows[static_cast<std::size_t>(bound_by(k))].lambda);
    }
};

//! [cone_sweep]
/// One visit of each row and each disc.
/// \param small  a change of a row's velocity by less is none [m/s]
/// \return       whether any was changed by more
inline bool sweep_cones(const ConeRows& p, Real small, VecX& u)
{
    bool changed = false;
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        SolverRow<6>* const row = &p.rows[k];
        if (const DiscOfRows* disc = p.disc(k)) {
            if (!(visit_disc(*disc, row, p.radius(k), u) <= small)) changed = true;
            ++k;
            continue;
        }
        if (!p.feedback.empty()) take_bounds(row, p.feedback[k]);
        if (!(std::abs(visit(*row, u)) <= small * row->mass)) changed = true;
    }
    return changed;
}
//! [cone_sweep]

/// The largest natural residual of a row or a disc [m/s].
inline Real residual_of(const ConeRows& p, const VecX& u)
{
    Real largest = 0;
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        SolverRow<6>* const row = &p.rows[k];
        Real r = 0;
        if (const DiscOfRows* disc = p.disc(k)) {
            r = disc_residual(*disc, row, p.radius(k), u);
            ++k;
        } else if (row->mass > 0) {
            if (!p.feedback.empty()) take_bounds(row, p.feedback[k]);
            const Real w =
                velocity<6>(*row, u.segment<6>(row->a), u.segment<6>(row->b));
            r = natural_residual_row(1 / row->mass, row->lambda, w, row->lo,
                                     row->hi);
        }
        if (!(r <= largest)) largest = r;
    }
    return largest;
}

}  // namespace rigid
