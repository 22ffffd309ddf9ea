// The functions of cone_rows.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/cone_rows.hpp"

namespace rigid {

//! [cone_sweep]
bool sweep_cones(const ConeRows& p, Real small, VecX& u)
{
    bool changed = false;
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        SolverRow<6>* const row = &p.rows[k];
        if (const DiscOfRows* disc = p.disc(k)) {
            if (!(visit_disc(*disc, row, p.radius(k), u) <= small)) changed = true;
            ++k;
            continue;
        }
        if (!p.feedback.empty()) take_bounds(row, p.feedback[k]);
        if (!(std::abs(visit(*row, u)) <= small * row->mass)) changed = true;
    }
    return changed;
}
//! [cone_sweep]

Real residual_of(const ConeRows& p, const VecX& u)
{
    Real largest = 0;
    for (std::size_t k = 0; k < p.rows.size(); ++k) {
        SolverRow<6>* const row = &p.rows[k];
        Real r = 0;
        if (const DiscOfRows* disc = p.disc(k)) {
            r = disc_residual(*disc, row, p.radius(k), u);
            ++k;
        } else if (row->mass > 0) {
            if (!p.feedback.empty()) take_bounds(row, p.feedback[k]);
            const Real w =
                velocity<6>(*row, u.segment<6>(row->a), u.segment<6>(row->b));
            r = natural_residual_row(1 / row->mass, row->lambda, w, row->lo,
                                     row->hi);
        }
        if (!(r <= largest)) largest = r;
        if (std::isnan(largest)) return largest;
    }
    return largest;
}

}  // namespace rigid
