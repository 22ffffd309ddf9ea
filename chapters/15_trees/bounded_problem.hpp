/// \file bounded_problem.hpp
/// The small Coulomb problem of one island above joints: its bounds, and how it is swept where it is too large for guesses.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,   of friction −μ λ_n ≤ λ ≤ μ λ_n                                           (15.10)
///
/// A row that joints hold whatever it does has A_ii = 0: its λ moves nothing, and stands at the bound to which its w points.
#pragma once

#include "chapters/13_friction/friction_solver.hpp"
#include "chapters/15_trees/bounded_islands.hpp"

namespace rigid {

struct BoundedProblem {
    Mlcp mlcp;
    std::vector<FrictionBox> boxes;
    FindFriction find;
    Solution solution;

    /// q, bounds, boxes, and the λ to begin with.
    /// \param here    the rows of the island
    /// \param u       û, what the joints alone make of u* [m/s]
    /// \param b       of all rows
    /// \param enough  a residual below this is none [m/s]
    void begin(const BoundedIslands& islands, const std::vector<int>& here,
               const std::vector<Row<3>>& rows, const VecX& u, const VecX& b,
               Real enough, const VecX& lambda);

    bool is_finite() const
    {
        const Eigen::Map<const VecX> values(mlcp.A.valuePtr(), mlcp.A.nonZeros());
        return mlcp.q.allFinite() && values.allFinite();
    }

    /// Sweeps over A, each row by what the joints leave of its impulse.
    /// \return  how many
    int sweep(const FrictionSettings& settings, int sweeps, Real enough);

    /// Friction that moves nothing still slides where its w says so.
    void slide_held(const BoundedIslands& islands, const std::vector<int>& here,
                    const std::vector<Row<3>>& rows, Real enough);

private:
    /// The bounds of a row. One that nothing moves is at the bound to which its w points.
    void bound(const BoundedIslands& islands, const Row<3>& row, Index i,
               Real enough);
};

}  // namespace rigid
