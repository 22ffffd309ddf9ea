/// \file cases.hpp
/// Either/or, row by row: the cases that each row can be in, and all ways to choose one for each.
///
///     at_lo:   λ = lo, and w ≥ 0 must come out
///     between: w = 0,  and lo ≤ λ ≤ hi must come out
///     at_hi:   λ = hi, and w ≤ 0 must come out
///
/// (3.14a). A row without bounds has one case, a contact two, a row between two bounds three.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <algorithm>
#include <vector>

namespace rigid {

enum class BoundState : unsigned char { at_lo, between, at_hi };

/// Throws std::invalid_argument unless a set to begin with is empty or of all rows.
void require_all_rows(const std::vector<BoundState>& first, Index rows);

class CaseSets {
public:
    /// \param first  the set to begin with, of all rows; where it is empty, and in a row where it is impossible, q alone
    ///               says with what to begin: what pushes is at work where q is negative
    /// \throws std::invalid_argument  for a set of another number of rows
    CaseSets(const Mlcp& mlcp, const std::vector<BoundState>& first);

    Real count() const { return count_; }
    const std::vector<BoundState>& now() const { return set_; }

    //! [order]
    /// Calls try_set() once for each set until it returns true. Sets near the first
    /// one come first: it itself, then those that differ from it in one row, then
    /// in two, …
    template <class Try>
    void visit_all(const Try& try_set)
    {
        for (std::size_t distance = 0; distance <= choices_.size(); ++distance)
            if (visit(0, distance, try_set)) return;
    }

private:
    /// The sets that differ from the present one in so many of the rows
    /// choices_[from], …
    template <class Try>
    bool visit(std::size_t from, std::size_t distance, const Try& try_set)
    {
        if (distance == 0) return try_set();
        bool stop = false;
        for (std::size_t k = from; !stop && k + distance <= choices_.size(); ++k) {
            const BoundState kept = set_[choices_[k]];
            for (const BoundState other : cases_[choices_[k]])
                if (!stop && other != kept) {
                    set_[choices_[k]] = other;
                    stop = visit(k + 1, distance - 1, try_set);
                }
            set_[choices_[k]] = kept;
        }
        return stop;
    }
    //! [order]

    std::vector<std::vector<BoundState>> cases_;
    std::vector<std::size_t> choices_;  ///< rows with more than one case
    std::vector<BoundState> set_;
    Real count_ = 1;
};

}  // namespace rigid
