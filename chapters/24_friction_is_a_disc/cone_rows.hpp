/// \file cone_rows.hpp
/// The rows of an island with the discs in them: one sweep over them, and their residual.
///
///     a row: its λ into its bounds, (3.15)        a disc: its two rows at once, (24.3)
#pragma once

#include "chapters/24_friction_is_a_disc/friction_cone.hpp"

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

/// One visit of each row and each disc.
/// \param small  a change of a row's velocity by less is none [m/s]
/// \return       whether any was changed by more
bool sweep_cones(const ConeRows& p, Real small, VecX& u);

/// The largest natural residual of a row or a disc [m/s].
Real residual_of(const ConeRows& p, const VecX& u);

}  // namespace rigid
