/// \file lemke.hpp
/// Lemke's algorithm: walk from vertex to vertex, and finish.
///
///     w = A λ + q,   lo ≤ λ ≤ hi,   λ_i = lo_i or λ_i = hi_i or w_i = 0
///
/// Brought to the plain form (standard_form.hpp), walked (walk.hpp), and only called solved after the
/// residual of the answer was computed. \cite lemke1965; \cite cottle1992, §4.4; \cite murty1997, ch. 2
#pragma once

#include "chapters/05_lemke/infeasibility.hpp"
#include "chapters/05_lemke/standard_form.hpp"
#include "chapters/05_lemke/walk.hpp"
#include "common/text.hpp"

#include <limits>
#include <string>

namespace rigid {

struct LemkeSettings {
    TieRule ties = TieRule::lexicographic;
    Tolerances tolerances;   ///< of pivots and ties
    int pivot_limit = 0;     ///< 0 = 10,000 + 50 n: far beyond what contacts need, soon over for the others
    Real tolerance = 1e-10;  ///< of the natural residual, as a share of the largest |q|
};

/// What rounding alone may hide when w = A λ + q is computed [m/s]: λ of 1e13 that cancel in w can look right
/// by luck. A bound that is quick to have will do where it is not above `enough`.
inline Real hidden_by_rounding(const Mlcp& mlcp, const VecX& lambda, Real enough)
{
    if (mlcp.A.nonZeros() == 0) return 0;
    constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
    const Real entry_sum = mlcp.A.coeffs().abs().maxCoeff() * lambda.lpNorm<1>();
    const Real bound = epsilon * (mlcp.q.cwiseAbs().maxCoeff() + entry_sum);
    if (bound <= enough) return bound;
    Real largest = 0;
    for (Index i = 0; i < mlcp.size(); ++i) {
        Real sum = std::abs(mlcp.q[i]);
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
            sum += std::abs(entry.value() * lambda[entry.col()]);
        if (!(sum <= largest)) largest = sum;
    }
    return epsilon * largest;
}

//! [lemke]
/// Solves an MLCP. `iterations` counts pivots, the first one (z0 enters) included.
///
/// `solved`: the natural residual is at most tolerance·max|q| (or 1e-4 of that share of what λ at large
/// bounds add to q), and rounding can't hide ten times as much. `infeasible`: a ray that proves it (5.15).
/// `ray termination`: a ray that proves nothing. `singular`: the last vertex is no answer to that many
/// digits. If not solved, lambda is the last vertex, and the residual says how wrong it is.
///
/// \throws std::invalid_argument  for a malformed problem or settings that make no sense
inline Solution lemke(const Mlcp& mlcp, const LemkeSettings& settings = {})
{
    require_valid(mlcp);
    if (!(settings.tolerance > 0) || settings.pivot_limit < 0)
        throw std::invalid_argument("the tolerance is " + shortest(settings.tolerance) +
                                    " and the pivot limit " + std::to_string(settings.pivot_limit) +
                                    "; the tolerance must be positive, the limit not negative");
    Solution solution;
    const StandardForm form(mlcp);
    const Index n = form.q.size();
    const auto report = [&](Status status, const VecX& lambda) {
        solution.status = status;
        solution.lambda = lambda;
        solution.residual = natural_residual(mlcp, lambda);
        return solution;
    };
    // How large a residual may be: a share of q, or of 1e-4 of what the bounds add to it.
    const auto largest = [](const VecX& v) { return v.size() > 0 ? v.cwiseAbs().maxCoeff() : 0; };
    const Real allowed = settings.tolerance * std::max(largest(mlcp.q), 1e-4 * largest(form.q));
    const int limit = settings.pivot_limit > 0 ? settings.pivot_limit : 10000 + 50 * static_cast<int>(n);
    // Ones first. If rounding led that walk astray, another covering vector is another way.
    for (const Real last : {1.0, 2.0}) {
        LemkeWalk walk(form.A, form.q, VecX::LinSpaced(n, 1, last), settings.ties, settings.tolerances);
        while (walk.place == LemkeWalk::Place::on_the_way && solution.iterations + walk.pivots < limit)
            walk.step();
        solution.iterations += walk.pivots;
        report(Status::singular, form.impulses(walk.z()));
        if (walk.place == LemkeWalk::Place::on_the_way)
            return report(Status::iteration_limit, solution.lambda);
        if (walk.place == LemkeWalk::Place::ray) {
            const bool proof = proves_infeasibility(mlcp, form.direction(walk.ray()));
            solution.status = proof ? Status::infeasible : Status::ray_termination;
            if (proof) return solution;
            continue;
        }
        if (!(solution.residual <= std::min(allowed, settings.tolerance))) {  // refine once
            const Solution walked = solution;
            report(Status::singular, form.impulses(solve_basis(walk.tableau, form.A, form.q)));
            if (!(solution.residual < walked.residual)) solution = walked;
        }
        if (solution.residual <= allowed &&
            hidden_by_rounding(mlcp, solution.lambda, 10 * allowed) <= 10 * allowed) {
            solution.status = Status::solved;
            return solution;
        }
    }
    return solution;
}
//! [lemke]

}  // namespace rigid
