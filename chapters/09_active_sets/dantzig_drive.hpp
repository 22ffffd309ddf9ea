/// \file dantzig_drive.hpp
/// One row at a time: those before it stay right all along, and each is driven until it is right too.
///
///     λ_d grows by t, λ_F by t Δ_F with A_FF Δ_F = −A_Fd        so w_F stays zero (9.16)
///
/// until w_d = 0 or λ_d is at its bound; on the way rows come to their bounds and leave F, others' w comes to
/// zero and they join it (9.17). Principal pivoting after Dantzig, as physics engines have it from
/// \cite baraff1994; \cite cottle1992, §4.3
#pragma once

#include "chapters/03_mlcp_formulation/direct.hpp"
#include "chapters/09_active_sets/first_guess.hpp"
#include "chapters/09_active_sets/incremental_ldlt.hpp"

namespace rigid {

class DantzigDrive {
public:
    VecX lambda, w;
    std::vector<BoundState> cases;
    int pivots = 0;

    enum class Place { right, ray, limit };

    DantzigDrive(const Mlcp& mlcp, int limit);

    /// Drives all rows.
    Place run();

    /// λ_F again from what is left of w_F. Where a row of F nearly depends on the
    /// others this moves λ far for the sake of rounding, out of its bounds even.
    void refine();

    /// The direction of the last step: at a ray it may prove that there is no answer.
    const VecX& direction() const { return direction_; }

    /// Moves λ_d, and λ_F with it, until row d is right.
    Place drive(Index d);

private:
    static std::size_t index(Index i) { return static_cast<std::size_t>(i); }
    Real diagonal(Index i) const { return A_(i, i) > 0 ? A_(i, i) : 1; }

    /// What rounding can do to a w.
    Real noise(Index i) const
    {
        return 1e-14 *
               (std::abs(mlcp_.q[i]) + A_.col(i).cwiseAbs().dot(lambda.cwiseAbs()));
    }

    /// A row that is right where it is.
    Place set_case(Index d);

    bool join(Index i)
    {
        VecX couplings(factor_.size());
        for (Index k = 0; k < factor_.size(); ++k)
            couplings[k] = A_(i, factor_.rows[index(k)]);
        return factor_.append(i, couplings, A_(i, i), 1e-11 * diagonal(i));
    }

    Index place_of(Index row) const
    {
        return std::find(factor_.rows.begin(), factor_.rows.end(), row) -
               factor_.rows.begin();
    }

    /// (9.16): how λ_F answers when λ_d grows, so that w_F stays zero, and what
    /// that does to all w.
    void find_direction(Index d, Real sign);

    const Mlcp& mlcp_;
    MatX A_;
    IncrementalLdlt factor_;
    int limit_;
    /// rows that are right; rows that F would not take in
    std::vector<bool> is_done_, depends_;
    std::vector<Index> order_;
    /// rows between their bounds that depend on F: in, once a row is removed from F
    std::vector<Index> waiting_;
    VecX direction_, w_slope_;
};

}  // namespace rigid
