/// \file lemke.hpp
/// Lemke's algorithm: walk from vertex to vertex, and finish.
///
///     w = A z + q,   0 ≤ z ⟂ w ≥ 0
///
/// The artificial variable z0 lifts all rows until q + d z0 ≥ 0 (5.5). From then on one pair (z_i, w_i) is
/// missing at each vertex; the variable that left brings in its complement (5.10), until z0 is back at zero.
/// An answer is only called solved after its residual was computed.
/// \cite lemke1965; \cite cottle1992, §4.4; \cite murty1997, ch. 2
#pragma once

#include "chapters/05_lemke/standard_form.hpp"
#include "chapters/05_lemke/tableau.hpp"

#include <Eigen/LU>
#include <string>
#include <vector>

namespace rigid {

struct LemkeSettings {
    TieRule ties = TieRule::lexicographic;
    int pivot_limit = 0;     ///< 0 = 10,000 + 50 n: far beyond what contacts need, soon over for the others
    Real tolerance = 1e-10;  ///< of the natural residual, as a share of the largest |q|
};

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
    /// \param ties_ who leaves in a tie
    LemkeWalk(const MatX& A, const VecX& q, const VecX& d, TieRule ties_) : tableau(A, q, d), ties(ties_)
    {
        entering = tableau.artificial();
        if (q.size() == 0 || q.minCoeff() >= 0) place = Place::solution;  // z = 0 will do
    }
    //! [start]

    //! [step]
    /// One pivot.
    void step()
    {
        const Index c = tableau.column_of(entering);
        const Index p = entering == tableau.artificial() ? most_negative_row() : tableau.ratio_test(c, ties);
        if (p < 0) {
            place = Place::ray;
            return;
        }
        const Index leaving = tableau.basic[static_cast<std::size_t>(p)];
        tableau.pivot(p, c);
        ++pivots;
        if (leaving == tableau.artificial()) place = Place::solution;
        else entering = tableau.complement(leaving);  // (5.10)
    }
    //! [step]

    /// (5.6): the row that needs the largest z0; ties by the rule, where ε^k is least for the last row.
    Index most_negative_row() const
    {
        const VecX need = -tableau.values().cwiseQuotient(tableau.T.col(tableau.n));
        const Real enough = need.maxCoeff() - Tableau::tie_tolerance * need.cwiseAbs().maxCoeff();
        Index best = 0;
        while (need[best] < enough) ++best;
        for (Index i = best + 1; i < tableau.n && ties != TieRule::first_row; ++i)
            if (need[i] >= enough) best = i;
        return best;
    }

    VecX z() const
    {
        VecX answer(tableau.n);
        for (Index i = 0; i < tableau.n; ++i) answer[i] = std::max(Real{0}, tableau.value(i));
        return answer;
    }

    //! [ray]
    /// At a ray: does its direction y ≥ 0 prove that there is no answer (5.18)? For every z ≥ 0 with
    /// A z + q ≥ 0 we have 0 ≤ yᵀ(A z + q) = (Aᵀy)ᵀz + qᵀy. If Aᵀy ≤ 0 and qᵀy < 0, there is none.
    /// Rounding leaves Aᵀy ≤ δ: then an answer would have Σz ≥ -qᵀy/δ, and we want that to be absurd.
    bool proves_infeasibility(const MatX& A, const VecX& q) const
    {
        const Index c = tableau.column_of(entering);
        VecX y = VecX::Zero(tableau.n);
        for (Index i = 0; i < tableau.n; ++i)
            if (tableau.is_basic(i)) y[i] = std::max(Real{0}, tableau.T(tableau.row_of(i), c));
        if (entering < tableau.n) y[entering] = 1;
        const Real delta = std::max(Real{0}, (A.transpose() * y).maxCoeff());
        return -q.dot(y) * A.cwiseAbs().maxCoeff() > 1e13 * delta * q.cwiseAbs().maxCoeff();
    }
    //! [ray]
};

//! [refine]
/// The answer anew from its basis alone: where z_i is basic w_i = 0, and that is a linear system (5.16).
/// No error of the walk is left in it.
inline VecX solve_basis(const Tableau& tableau, const MatX& A, const VecX& q)
{
    std::vector<Index> active;
    for (Index i = 0; i < tableau.n; ++i)
        if (tableau.is_basic(i)) active.push_back(i);
    VecX z = VecX::Zero(tableau.n);
    if (active.empty()) return z;
    const Eigen::PartialPivLU<MatX> factors(A(active, active));
    const VecX b = -q(active);
    VecX x = factors.solve(b);
    x += factors.solve(b - A(active, active) * x);
    for (std::size_t k = 0; k < active.size(); ++k)
        z[active[k]] = std::max(Real{0}, x[static_cast<Index>(k)]);
    return z;
}
//! [refine]

/// What rounding alone may hide when w = A λ + q is computed [m/s]. λ of 1e13 that cancel in w can look
/// right by luck.
inline Real hidden_by_rounding(const Mlcp& mlcp, const VecX& lambda)
{
    Real largest = 0;
    for (Index i = 0; i < mlcp.size(); ++i) {
        Real sum = std::abs(mlcp.q[i]);
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry)
            sum += std::abs(entry.value() * lambda[entry.col()]);
        if (!(sum <= largest)) largest = sum;
    }
    return std::numeric_limits<Real>::epsilon() * largest;
}

//! [lemke]
/// Solves an MLCP. `iterations` counts pivots, the first one (z0 enters) included.
///
/// `solved`: the natural residual is at most tolerance·max|q| (or 1e-4 of that share of what λ at large
/// bounds add to q), and rounding can't hide ten times as much. `infeasible`: a ray that proves it (5.17).
/// `ray termination`: a ray that proves nothing. `singular`: the last vertex is no answer to that many
/// digits. If not solved, lambda is the last vertex, and the residual says how wrong it is.
///
/// \throws std::invalid_argument  for a malformed problem or settings that make no sense
inline Solution lemke(const Mlcp& mlcp, const LemkeSettings& settings = {})
{
    require_valid(mlcp);
    if (!(settings.tolerance > 0) || settings.pivot_limit < 0)
        throw std::invalid_argument("the tolerance is " + std::to_string(settings.tolerance) +
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
    // How large a residual may be: a share of q, or of 1e-4 of what the λ at their bounds add to it.
    const auto allowed = [&](Real share) {
        const Real q = mlcp.size() > 0 ? mlcp.q.cwiseAbs().maxCoeff() : 0;
        return settings.tolerance * share * std::max(q, 1e-4 * size_of_numbers(mlcp, solution.lambda));
    };
    const int limit = settings.pivot_limit > 0 ? settings.pivot_limit : 10000 + 50 * static_cast<int>(n);
    // Ones first. If rounding led that walk astray, another covering vector is another way.
    for (const Real last : {1.0, 2.0}) {
        LemkeWalk walk(form.A, form.q, VecX::LinSpaced(n, 1, last), settings.ties);
        while (walk.place == LemkeWalk::Place::on_the_way && solution.iterations + walk.pivots < limit)
            walk.step();
        solution.iterations += walk.pivots;
        report(Status::singular, form.impulses(walk.z()));
        if (walk.place == LemkeWalk::Place::on_the_way)
            return report(Status::iteration_limit, solution.lambda);
        if (walk.place == LemkeWalk::Place::ray) {
            const bool proof = walk.proves_infeasibility(form.A, form.q);
            solution.status = proof ? Status::infeasible : Status::ray_termination;
            if (proof) return solution;
            continue;
        }
        if (!(solution.residual <= std::min(allowed(1), settings.tolerance))) {  // refine once
            const Solution walked = solution;
            report(Status::singular, form.impulses(solve_basis(walk.tableau, form.A, form.q)));
            if (!(solution.residual < walked.residual)) solution = walked;
        }
        if (solution.residual <= allowed(1) && hidden_by_rounding(mlcp, solution.lambda) <= allowed(10)) {
            solution.status = Status::solved;
            return solution;
        }
    }
    return solution;
}
//! [lemke]

}  // namespace rigid
