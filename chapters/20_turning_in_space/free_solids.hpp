/// \file free_solids.hpp
/// What the step of chapter 3 needs of a scene in space. The step itself, its solvers, starts and corrections are those
/// of Part I, with 6 in place of 2.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/08_warm_starting/impulse_cache.hpp"
#include "chapters/20_turning_in_space/solid_scene.hpp"

namespace rigid {

/// Throws std::invalid_argument, naming the setting, unless the settings of a step make sense in space.
void require_valid(const StepSettings& settings, const Vec3& gravity, Index bodies);

/// What a step looks at each time. Throws std::invalid_argument, with a sentence that names the thing, unless it makes
/// sense.
void require_bodies(const SolidScene& scene);

/// e of a contact, besides that of the method (chapter 6): surfaces in space have none of their own.
inline Real own_restitution(const SolidScene&, const StepData<6>&, std::size_t)
{
    return 0;
}

/// Chapter 8's name of a row.
inline ImpulseKey contact_key(const SpaceContact& contact, int part = 0)
{
    return {static_cast<std::int32_t>(contact.a),
            static_cast<std::int32_t>(contact.b),
            static_cast<std::int32_t>(contact.feature), part};
}

/// Weight acts at the centroid: it turns nothing. What a spin does to itself is in
/// integrate().
void free_velocities(SolidScene& scene, const StepSettings& settings,
                     StepData<6>& now);

/// Nothing holds these bodies yet.
inline void evaluate_constraints(const SolidScene&, StepData<6>& now)
{
    now.constraints.clear();
}

//! [free_solids]
/// The contacts stage without constraints: every body is looked at.
struct FreeSolids : PlainContacts {
    template <class Method>
    void begin(const SolidScene& scene, const StepSettings&, Method& method,
               StepData<6>& now) const
    {
        require_bodies(scene);
        refuse_unfit(method.correction);
        now.length = typical_length(scene);
        const Bodies<6>& bodies = scene.bodies;
        now.active.resize(static_cast<std::size_t>(bodies.count()));
        std::iota(now.active.begin(), now.active.end(), 0);
        now.contacts.clear();
        now.sources.clear();
        now.x_found = bodies.x;
    }
    /// Projection adds to x as if angles were numbers, and relaxation writes ω in
    /// axes that have turned since: neither is made for space.
    template <class Correction>
    static void refuse_unfit(const Correction& correction)
    {
        StabilizerSettings how;
        correction.describe(how);
        if (how.method == Stabilizer::projection ||
            how.method == Stabilizer::relaxation)
            throw std::invalid_argument(
                "bodies in space have no projection and no relaxation; choose "
                "none, baumgarte or split_impulse");
    }
};
//! [free_solids]

//! [method]
struct FreeFlight {
    FreeSolids contacts;
    WholeError correction;
    ColdStart start;
    ImpulseSolver<6> solver;
};
//! [method]

// Compiled once, in free_solids.cpp.
extern template void step(SolidScene&, const StepSettings&, FreeFlight&,
                          StepData<6>&);

}  // namespace rigid
