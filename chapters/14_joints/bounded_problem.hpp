/// \file bounded_problem.hpp
/// The small Coulomb problem of one island above joints: its bounds, and how it is swept where it is too large for guesses.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,   of friction −μ λ_n ≤ λ ≤ μ λ_n                                           (14.16)
///
/// A row that joints hold whatever it does has A_ii = 0: its λ moves nothing, and stands at the bound to which its w points.
#pragma once

#include "chapters/13_friction/friction_solver.hpp"
#include "chapters/14_joints/bounded_islands.hpp"

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
               Real enough, const VecX& lambda)
    {
        const auto m = static_cast<Index>(here.size());
        mlcp.q.resize(m), mlcp.lo.resize(m), mlcp.hi.resize(m);
        solution.lambda.resize(m);
        boxes.clear();
        for (Index i = 0; i < m; ++i) {
            const int number = here[static_cast<std::size_t>(i)];
            const Row<3>& row = rows[static_cast<std::size_t>(number)];
            mlcp.q[i] = speed_along(row, u) + b[number];
            bound(islands, row, i, enough);
            solution.lambda[i] = lambda[number];
        }
    }

    bool is_finite() const
    {
        const Eigen::Map<const VecX> values(mlcp.A.valuePtr(), mlcp.A.nonZeros());
        return mlcp.q.allFinite() && values.allFinite();
    }

    //! [sweep]
    /// Sweeps over A, each row by what the joints leave of its impulse.
    /// \return  how many
    int sweep(const FrictionSettings& settings, int sweeps, Real enough)
    {
        FrictionMemory& memory = find.memory;
        memory.problem.mlcp = &mlcp;
        memory.problem.boxes = boxes;
        std::vector<int>& box_of = memory.guess.box_of;
        box_of.assign(static_cast<std::size_t>(mlcp.size()), -1);
        for (std::size_t i = 0; i < boxes.size(); ++i)
            box_of[static_cast<std::size_t>(boxes[i].row)] = static_cast<int>(i);
        memory.guess.lambda = solution.lambda;
        const int made =
            sweep_changes(memory.problem, sweeps, enough / 10, memory.guess);
        memory.candidate = memory.guess.lambda;
        solution.status = Status::iteration_limit;
        solution.residual = infinity;
        accept_coulomb(mlcp, boxes, {settings.tolerance, enough}, memory.candidate,
                       solution);
        return made;
    }
    //! [sweep]

    /// Friction that moves nothing still slides where its w says so.
    void slide_held(const BoundedIslands& islands, const std::vector<int>& here,
                    const std::vector<Row<3>>& rows, Real enough)
    {
        for (Index i = 0; i < mlcp.size(); ++i) {
            const Row<3>& row =
                rows[static_cast<std::size_t>(here[static_cast<std::size_t>(i)])];
            if (row.bounded_by < 0 || mlcp.A.coeff(i, i) > 0) continue;
            const int normal =
                islands.number[static_cast<std::size_t>(row.bounded_by)];
            const Real w = mlcp.q[i];
            if (normal < 0 || !(std::abs(w) > enough)) continue;
            const Real most =
                row.friction * std::max(Real{0}, solution.lambda[normal]);
            solution.lambda[i] = w > 0 ? -most : most;
        }
    }

private:
    /// The bounds of a row. One that nothing moves is at the bound to which its w points.
    void bound(const BoundedIslands& islands, const Row<3>& row, Index i,
               Real enough)
    {
        Real &lo = mlcp.lo[i], &hi = mlcp.hi[i];
        lo = row.lo, hi = row.hi;
        if (row.bounded_by >= 0) {
            const int normal =
                islands.number[static_cast<std::size_t>(row.bounded_by)];
            lo = hi = 0;
            if (normal >= 0 && mlcp.A.coeff(i, i) > 0)
                boxes.push_back({i, normal, row.friction});
            return;
        }
        if (mlcp.A.coeff(i, i) > 0) return;
        const Real w = mlcp.q[i];
        const Real there = w > enough    ? lo
                           : w < -enough ? hi
                                         : std::clamp(Real{0}, lo, hi);
        lo = hi = std::isfinite(there) ? there : 0;
    }
};

}  // namespace rigid
