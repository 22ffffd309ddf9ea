/// \file impact_laws.hpp
/// What e means where there is friction: three laws of impact, and their energy.
///
///     Newton    v_n⁺ = −e v_n⁻                               the bounce is a speed: can make energy (13.26)
///     Poisson   λ_n of the second half ≥ e times the first    the bounce is an impulse
///     common    λ = (1 + e) λ_c, friction included            never makes energy (13.27)
///
/// λ_c is the impulse of the impact with e = 0, after which the contact moves no closer. \cite moreau1988
#pragma once

#include "chapters/13_friction/friction_solver.hpp"

namespace rigid {

enum class ImpactLaw { newton, poisson, common };

//! [impact]
/// The impact of rows that touch, from u⁻ to u⁺, without forces.
/// \param rows  with b = 0; those that only push bounce
/// \param u     in: u⁻; out: u⁺ [m/s]
/// \return      all impulses together, and the status: that of the first problem
///              without an answer, after which nothing more is done
/// Throws std::invalid_argument unless e is from 0 to 1.
inline Solution impact(std::vector<Row<3>> rows, Real e, ImpactLaw law,
                       FindFriction& find, VecX& u)
{
    if (!(e >= 0 && e <= 1))
        throw std::invalid_argument("the restitution of an impact is " +
                                    shortest(e) + "; it must be from 0 to 1");
    std::vector<FrictionBox> boxes;
    boxes_of(rows, boxes);
    const auto bounces = [](const Row<3>& row) {
        return row.bounded_by < 0 && row.lo == 0 && row.hi == infinity;
    };
    const auto solve = [&] {
        Mlcp mlcp = assemble(rows, u);
        Solution solution;
        find(mlcp, boxes, 0, solution);
        apply(rows, solution.lambda, u);
        return solution;
    };
    if (law == ImpactLaw::newton)
        for (Row<3>& row : rows)
            if (bounces(row)) row.bias = e * std::min(Real{0}, row.velocity(u));
    Solution compression = solve();
    if (law == ImpactLaw::newton || e == 0 || compression.status != Status::solved)
        return compression;
    if (law == ImpactLaw::common) {
        apply(rows, VecX(e * compression.lambda), u);
        compression.lambda *= 1 + e;
        return compression;
    }
    for (std::size_t i = 0; i < rows.size(); ++i)
        if (bounces(rows[i]))
            rows[i].lo = e * compression.lambda[static_cast<Index>(i)];
    Solution restitution = solve();
    restitution.lambda += compression.lambda;
    return restitution;
}
//! [impact]

/// ½ uᵀ M u of the bodies that can move [J].
inline Real kinetic_energy(const VecX& u, const VecX& inverse_mass)
{
    Real sum = 0;
    for (Index i = 0; i < u.size(); ++i)
        if (inverse_mass[i] > 0) sum += u[i] * u[i] / inverse_mass[i] / 2;
    return sum;
}

}  // namespace rigid
