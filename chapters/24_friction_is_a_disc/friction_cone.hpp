/// \file friction_cone.hpp
/// Friction in space: two rows with one bound, a disc; or a polygon in its place.
///
///     ‖λ_t‖ ≤ μ λ_n,   λ_t = P(λ_t − ρ w_t) for any ρ > 0,   P: the nearest point of the disc               (24.3)
///
/// That is Coulomb's law: what holds has w_t = 0, what slides is dragged by μ λ_n against w_t, in whatever direction that
/// is. Two rows that are clamped each for itself make a box of the disc, whose corners hold √2 too much. \cite moreau1988
#pragma once

#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "common/elementary.hpp"

namespace rigid {

using Mat2 = Eigen::Matrix<Real, 2, 2>;

//! [project]
/// P: the nearest point of the disc around zero, (24.2).
inline Vec2 onto_disc(const Vec2& lambda, Real radius)
{
    const Real length = lambda.norm();
    return length > radius ? Vec2(lambda * (radius / length)) : lambda;
}
//! [project]

/// The nearest point of the polygon whose corners lie on the disc's rim, the first
/// along t₁, (24.8).
/// \param corners  three or more; 0: all of the disc
Vec2 onto_pyramid(const Vec2& lambda, Real radius, int corners);

/// Two rows of one contact, one after the other, that share a disc.
struct DiscOfRows {
    std::size_t row = 0;  ///< the first of the two
    Mat2 A;               ///< their block of J M⁻¹ Jᵀ [1/kg]
    Real largest = 0;     ///< the larger eigenvalue of it
    int corners = 0;      ///< of a pyramid in place of the disc; 0: the disc

    Vec2 nearest(const Vec2& lambda, Real radius) const
    {
        return onto_pyramid(lambda, radius, corners);
    }
};

template <int Dof>
DiscOfRows disc_of_rows(const std::vector<SolverRow<Dof>>& rows, std::size_t k)
{
    const SolverRow<Dof>&p = rows[k], &q = rows[k + 1];
    const auto half = [](const SolverRow<Dof>& r, const SolverRow<Dof>& s) {
        return r.Ja.dot(s.Wa) + r.Jb.dot(s.Wb);
    };
    DiscOfRows disc;
    disc.row = k;
    const Real a = half(p, p), b = half(q, q), c = half(p, q);
    disc.A << a, c, c, b;
    disc.largest = (a + b) / 2 + std::sqrt((a - b) * (a - b) / 4 + c * c);
    return disc;
}

/// w of both rows.
template <int Dof>
Vec2 slide_of(const SolverRow<Dof>* rows, const VecX& u)
{
    const Vec<Dof> ua = u.template segment<Dof>(rows->a),
                   ub = u.template segment<Dof>(rows->b);
    return {velocity(rows[0], ua, ub), velocity(rows[1], ua, ub)};
}

//! [visit_disc]
/// One visit of both rows, (24.4): the λ that stops the sliding, if it is in the
/// disc; else a step towards it, and back onto the disc.
/// \param radius  μ λ_n as it is now [N s]
/// \return        how far the rows were off [m/s]
template <int Dof>
Real visit_disc(const DiscOfRows& disc, SolverRow<Dof>* rows, Real radius, VecX& u)
{
    const Vec2 w = slide_of(rows, u), lambda(rows[0].lambda, rows[1].lambda);
    Vec2 next = lambda;
    const Mat2& A = disc.A;
    const Real det = A(0, 0) * A(1, 1) - A(0, 1) * A(1, 0);
    const Vec2 stop(A(1, 1) * w[0] - A(0, 1) * w[1],
                    A(0, 0) * w[1] - A(1, 0) * w[0]);  // det A⁻¹ w
    if (det > 1e-12 * disc.largest * disc.largest) next -= stop / det;
    else if (disc.largest > 0) next -= w / disc.largest;
    if (disc.nearest(next, radius) != next && disc.largest > 0)
        next = disc.nearest(lambda - w / disc.largest, radius);
    const Vec2 change = next - lambda;
    for (int i = 0; i < 2; ++i) {
        rows[i].lambda = next[i];
        // b comes last: a row of the world has a = b
        u.template segment<Dof>(rows[i].a) += rows[i].Wa * change[i];
        u.template segment<Dof>(rows[i].b) += rows[i].Wb * change[i];
    }
    return disc.largest * change.norm();
}
//! [visit_disc]

//! [disc_residual]
/// How far both rows are from (24.3), as chapter 3 measures it [m/s].
template <int Dof>
Real disc_residual(const DiscOfRows& disc, const SolverRow<Dof>* rows, Real radius,
                   const VecX& u)
{
    if (!(disc.largest > 0)) return 0;
    const Vec2 lambda(rows[0].lambda, rows[1].lambda);
    const Vec2 moved = lambda - slide_of(rows, u) / disc.largest;
    return disc.largest * (lambda - disc.nearest(moved, radius)).norm();
}
//! [disc_residual]

}  // namespace rigid
