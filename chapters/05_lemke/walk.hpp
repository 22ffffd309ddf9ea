/// \file walk.hpp
/// The walk from vertex to vertex, one pivot at a time, and what its two ends mean.
///
/// The artificial variable z0 lifts all rows until q + d z0 ≥ 0 (5.5). From then on one pair (z_i, w_i) is
/// missing at each vertex; the variable that left brings in its complement (5.9), until z0 is back at zero
/// or nothing stops the variable that enters: a ray.
/// \cite lemke1965; \cite cottle1992, §4.4
#pragma once

#include "chapters/03_mlcp_formulation/verification.hpp"
#include "chapters/05_lemke/ratio_test.hpp"

#include <Eigen/LU>
#include <vector>

namespace rigid {

/// One walk, pivot by pivot, so that a program can show each of them.
struct LemkeWalk {
    enum class Place { on_the_way, solution, ray };

    Tableau tableau;
    TieRule ties;
    Index entering = 0;  ///< the variable that enters next
    int pivots = 0;
    Place place = Place::on_the_way;

    //! [start]
    /// \param A     n×n
    /// \param q     n
    /// \param d     the covering vector, n positive numbers
    /// \param ties_ which row leaves in a tie
    /// \param tolerances what counts as zero
    LemkeWalk(const MatX& A, const VecX& q, const VecX& d, TieRule ties_,
              const Tolerances& tolerances = {})
        : tableau(A, q, d, tolerances), ties(ties_)
    {
        entering = tableau.artificial();
        // z = 0 will do
        if (q.size() == 0 || q.minCoeff() >= 0) place = Place::solution;
    }
    //! [start]

    //! [step]
    /// The row whose variable leaves next; -1 = a ray.
    Index leaving_row() const
    {
        if (entering == tableau.artificial()) return most_negative_row();
        return ratio_test(tableau, tableau.column_of(entering), ties);
    }

    /// One pivot.
    void step()
    {
        const Index p = leaving_row();
        if (p < 0) {
            place = Place::ray;
            return;
        }
        const Index leaving = tableau.basic[static_cast<std::size_t>(p)];
        tableau.pivot(p, tableau.column_of(entering));
        ++pivots;
        if (leaving == tableau.artificial()) place = Place::solution;
        else entering = tableau.complement(leaving);  // (5.9)
    }
    //! [step]

    /// (5.6): the row that needs the largest z0; ties by the rule, where ε^k is least for the last row.
    Index most_negative_row() const;

    VecX z() const
    {
        VecX answer(tableau.n);
        for (Index i = 0; i < tableau.n; ++i)
            answer[i] = std::max(Real{0}, tableau.value(i));
        return answer;
    }

    /// At a ray: its direction, how fast each z grows along it. It may prove that
    /// there is no answer (5.15).
    VecX ray() const;
};

/// λ computed again from the bound states alone (5.19): at its bound, or between,
/// where w = 0 is a linear system in the original A and q. No error of the walk is
/// left in it, and no large bound.
/// \param lambda   the λ at their bounds; zero where it is between
/// \param between  these rows
VecX solve_between(const Mlcp& mlcp, VecX lambda,
                   const std::vector<Index>& between);

}  // namespace rigid
