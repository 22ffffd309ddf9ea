/// \file disc_constraints.hpp
/// The constraints of a scene of discs at the present positions, and their rows. C and the row are kept side by
/// side, so that what to do about an error C can be decided later: it only changes the bias.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "common/scenes.hpp"

#include <vector>

namespace rigid {

/// One constraint for each link, then one for each contact.
inline void disc_constraints(const DiscScene& scene, const std::vector<Contact>& contacts,
                             std::vector<Constraint<2>>& constraints)
{
    constraints.clear();
    for (const Link& link : scene.links) constraints.push_back(distance_constraint(scene.bodies.x, link));
    for (const Contact& contact : contacts) constraints.push_back(contact_constraint(contact));
}

/// The rows of these constraints, the first `links` of them bilateral, the others unilateral. The bias lets
/// a gap close and no more, b = C/h where C > 0; an error C < 0, or of a link, is left as it is (b = 0).
/// \param h  time step [s]
template <int Dof>
void constraint_rows(const std::vector<Constraint<Dof>>& constraints, std::size_t links,
                     const VecX& inverse_mass, Real h, std::vector<Row<Dof>>& rows)
{
    rows.clear();
    for (std::size_t i = 0; i < constraints.size(); ++i) {
        const Constraint<Dof>& c = constraints[i];
        rows.push_back(i < links ? bilateral(c, inverse_mass)
                                 : unilateral(c, inverse_mass, std::max(Real{0}, c.C) / h));
    }
}

}  // namespace rigid
