// The functions of spring_forces.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/26_four_ways/spring_forces.hpp"

namespace rigid {

void require_valid(const PenaltySprings& springs)
{
    if (!(springs.stiffness > 0) || !std::isfinite(springs.stiffness))
        throw std::invalid_argument("the stiffness of the springs is " +
                                    shortest(springs.stiffness) +
                                    " N/m; it must be positive and finite");
    require_not_negative({{"the damping ratio of joints", springs.joint_ratio},
                          {"the damping ratio of contacts", springs.contact_ratio},
                          {"the damping ratio of friction", springs.friction_ratio},
                          {"the stiffness of Hertz's law", springs.hertz}});
}

void SpringForces::rows(const JointedScene& scene, const StepSettings& settings,
                        StepData<3>& now)
{
    const Real h = settings.part();
    write_rows(scene.bodies, h, now, [h](const auto& c) { return gap_bias(c, h); });
    for (std::size_t i = 0; i < now.rows.size(); ++i) {
        Constraint<3>& c = now.constraints[i];
        Row<3>& row = now.rows[i];
        const bool drags = c.kind == ConstraintKind::friction;
        if (!has_error(c.kind) && !drags) continue;
        const Real A = row.inverse_effective_mass();
        if (!(A > 0)) continue;
        const Source& source = now.sources[i];
        Real ratio = springs.joint_ratio;
        if (c.bounces) {
            const Real e = own_restitution(scene, now, i);
            ratio = e > 0 ? damping_ratio_of(e) : springs.contact_ratio;
        }
        if (drags) {
            ratio = springs.friction_ratio;
            c.C = source.of == Source::Of::contact
                      ? stretch_of(
                            now.contacts[static_cast<std::size_t>(source.index)],
                            source.part)
                      : 0;
        }
        // an open gap has its row, so that a spring at the end of the step meets what
        // comes; it has no damper, which would push before they touch
        const bool pushes = c.kind == ConstraintKind::unilateral;
        const bool open = pushes && c.C > 0;
        const bool turns = c.Jb.head<2>().isZero(0);
        const Real unit = turns ? now.length * now.length : 1;
        c.stiffness = springs.stiffness * unit;
        Real slope = c.stiffness;  // df/dC, what the end of the step meets
        if (springs.hertz > 0 && source.of == Source::Of::contact) {
            // a spring along a contact is as stiff as the one across it
            const Real gap =
                drags ? now.constraints[static_cast<std::size_t>(row.bounded_by)].C
                      : c.C;
            const HertzSpring spring =
                hertz_spring(springs.hertz, std::max(-gap, 1e-9 * now.length));
            c.stiffness = unit * (drags ? spring.tangent : spring.secant);
            slope = unit * spring.tangent;
        }
        c.damping = open ? 0 : 2 * ratio * std::sqrt(slope / A);
        row.softness = 1 / (h * (h * slope + c.damping));
        row.bias = c.stiffness * c.C / (h * slope + c.damping);
        if (drags) row.bias -= c.damping * c.speed / (h * slope + c.damping);
        if (!open) c.kind = ConstraintKind::spring;
    }
}

Real SpringForces::stretch_of(const Contact& contact, int part) const
{
    for (const Stretch& one : stretched)
        if (one.a == contact.a && one.b == contact.b &&
            one.feature == contact.feature && one.part == part)
            return one.s;
    return 0;
}

void SpringForces::stretch(const VecX& u, Real h, const StepData<3>& now)
{
    std::swap(stretched, before);
    stretched.clear();
    for (std::size_t i = 0; i < now.rows.size(); ++i) {
        const Row<3>& row = now.rows[i];
        const Constraint<3>& c = now.constraints[i];
        if (row.bounded_by < 0 || now.sources[i].of != Source::Of::contact)
            continue;
        const Contact& contact =
            now.contacts[static_cast<std::size_t>(now.sources[i].index)];
        const Real lambda = now.solution.lambda[static_cast<Index>(i)],
                   most = row.friction *
                          std::max(Real{0}, now.solution.lambda[row.bounded_by]);
        Real s = c.C + h * (row.velocity(u) - row.bias - c.speed);
        if (!(std::abs(lambda) < most))  // it slides: as long as its force says
            s = c.stiffness > 0 ? -lambda / (h * c.stiffness) : 0;
        if (!(most > 0)) continue;
        stretched.push_back({contact.a, contact.b, contact.feature, s});
        stretched.back().part = now.sources[i].part;
    }
}

template void step(JointedScene&, const StepSettings&, ExplicitPenalty<Manifolds>&,
                   StepData<3>&);
template void step(JointedScene&, const StepSettings&, ImplicitPenalty<Manifolds>&,
                   StepData<3>&);

}  // namespace rigid
