/// \file bias_and_bounds.hpp
/// What a bias and two bounds can already say.
///
///     bounce   b = e v⁻,  0 ≤ λ            leave as fast as e times the approach v⁻ = J u < 0
///     motor    b = −v,   −hF ≤ λ ≤ hF      run at the speed v, as far as the force F can
///     rope     C = L − distance,  0 ≤ λ    pull, never push
///     stop     C = n·(x_b − x_a) − c,  0 ≤ λ   push, never pull
///
/// (6.13), (6.14) and (6.18). λ is an impulse: a force F acts during h, so its bound is hF.
#pragma once

#include "chapters/02_velocity_constraints/joints.hpp"
#include "common/text.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace rigid {

//! [contact_bias]
/// The bias of a contact whose gap C may close in this step, (6.18).
///
/// A gap may close and no more, b = C/h. If it would close, and the bodies approach
/// faster than the threshold, they part with e times the speed instead. An overlap
/// closes if the bodies still approach after the forces.
/// \param C       gap [m]; an overlap, C < 0, is left as it is
/// \param before  v⁻ = J u before the forces of this step [m/s]
/// \param after   J u*, after them [m/s]
/// \param e       restitution, 0 … 1
/// \param slowest approaches slower than this do not bounce [m/s]
/// \param h       time step [s]
/// \return        b [m/s]
inline Real contact_bias(Real C, Real before, Real after, Real e, Real slowest,
                         Real h)
{
    const Real gap = std::max(Real{0}, C);
    const bool closes = gap + h * after < 0;
    return e > 0 && closes && before < -slowest ? e * before : gap / h;
}
//! [contact_bias]

//! [motor]
/// A motor along J: C grows at `speed`, as far as a force of ±`force` can bring it
/// there.
/// \param speed  wanted J u [m/s]
/// \param force  F ≥ 0 [N]
/// \param h      time step [s]
template <int Dof>
Row<Dof> motor(const Constraint<Dof>& constraint, const VecX& inverse_mass,
               Real speed, Real force, Real h)
{
    if (!(force >= 0))
        throw std::invalid_argument("the force of a motor is " + shortest(force) +
                                    " N; it must be zero or positive");
    return make_row(constraint, inverse_mass, -speed, -h * force, h * force);
}
//! [motor]

/// A unilateral row whose gap may close in this step and no more, b = max(0, C)/h: contacts, ropes and stops.
template <int Dof>
Row<Dof> one_sided(const Constraint<Dof>& constraint, const VecX& inverse_mass,
                   Real h)
{
    return unilateral(constraint, inverse_mass,
                      std::max(Real{0}, constraint.C) / h);
}

}  // namespace rigid
