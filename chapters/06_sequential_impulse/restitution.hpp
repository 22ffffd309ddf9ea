/// \file restitution.hpp
/// The correction stage of the step where a position error is left alone: a gap may close, and a contact may bounce.
#pragma once

#include "chapters/03_mlcp_formulation/disc_constraints.hpp"
#include "chapters/06_sequential_impulse/bias_and_bounds.hpp"
#include "common/text.hpp"

#include <utility>

namespace rigid {

struct Restitution {
    Real restitution = 0;  ///< e of every contact, 0 … 1
    /// contacts that approach slower than threshold · |gravity| · h do not bounce
    Real threshold = 2;
};

/// Throws std::invalid_argument, naming the setting and its value, unless both make sense.
inline void require_valid(const Restitution& settings)
{
    if (!(settings.restitution >= 0 && settings.restitution <= 1))
        throw std::invalid_argument("the restitution is " +
                                    shortest(settings.restitution) +
                                    "; it must be from 0 to 1");
    if (!(settings.threshold >= 0))
        throw std::invalid_argument("the threshold of bounces is " +
                                    shortest(settings.threshold) +
                                    "; it must be zero or positive");
}

/// e of a contact of discs, besides that of the method: discs have none of their own. Each kind of scene has such a
/// function; one without it is a fault that the compiler finds.
inline Real own_restitution(const DiscScene&, const StepData<2>&, std::size_t)
{
    return 0;
}

//! [restitution]
/// Contacts that bounce, (6.18): a bounce that is faster than what the row has as
/// its bias takes the bias' place.
template <class Scene>
void add_bounces(const Scene& scene, const Restitution& bounce,
                 const StepSettings& settings, StepData<Scene::dof>& now)
{
    const Real slowest = bounce.threshold * scene.gravity.norm() * settings.part();
    for (std::size_t i = 0; i < now.constraints.size(); ++i) {
        if (!now.constraints[i].bounces) continue;
        const Real e = std::max(bounce.restitution, own_restitution(scene, now, i));
        if (!(e > 0)) continue;
        auto& row = now.rows[i];
        const Real correcting = std::exchange(row.bias, 0);
        const Real b =
            contact_bias(now.constraints[i].C, row.velocity(scene.bodies.u),
                         row.velocity(now.u_star), e, slowest, settings.part());
        row.bias = b < 0 ? std::min(b, correcting) : correcting;
    }
}
//! [restitution]

//! [leave_errors]
/// b of a row whose error is left as it is: a gap may close and no more, a motor
/// runs at its speed.
template <int Dof>
Real gap_bias(const Constraint<Dof>& c, Real h)
{
    if (!has_error(c.kind)) return own_bias(c, h);
    return c.kind == ConstraintKind::unilateral ? std::max(Real{0}, c.C) / h : 0;
}

struct LeaveErrors : Restitution, PlainCorrection {
    void require_valid() const
    {
        rigid::require_valid(static_cast<const Restitution&>(*this));
    }

    template <class Scene>
    void rows(const Scene& scene, const StepSettings& settings,
              StepData<Scene::dof>& now) const
    {
        const Real h = settings.part();
        write_rows(scene.bodies, h, now,
                   [h](const auto& c) { return gap_bias(c, h); });
        add_bounces(scene, *this, settings, now);
    }
    template <class Scene, class Solver>
    void move(Scene& scene, const StepSettings& settings, Solver&,
              StepData<Scene::dof>& now) const
    {
        advance_positions(scene.bodies, settings.part(), now);
    }
};
//! [leave_errors]

}  // namespace rigid
