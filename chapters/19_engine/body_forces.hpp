/// \file body_forces.hpp
/// What acts on single bodies besides the weight that all have: a share of gravity, a lasting force and torque, and drag.
///
///     f = m s g + F,   τ = T,      u* = (u + h M⁻¹ f) / (1 + h d)                                  (19.3)
///
/// of each freedom with its own d. The drag is implicit, so it stops a body at no step length and turns it around at none: u goes
/// to zero as 1/(1 + h d)ⁿ, and a body that falls to g/d, exactly. A world without such bodies has an empty list, and does
/// nothing here.
#pragma once

#include "chapters/12_contact_manifolds/manifold_stage.hpp"
#include "chapters/14_joints/joint.hpp"

namespace rigid {

//! [acting]
/// What acts on a body besides the weight that all have.
struct BodyForces {
    Real gravity = 1;          ///< s: its weight is s m g
    Vec2 force = {0, 0};       ///< F, at the centroid [N]
    Real torque = 0;           ///< T [N m]
    Real damping = 0;          ///< d of the velocity [1/s]
    Real turning_damping = 0;  ///< d of the spin [1/s]

    bool operator==(const BodyForces&) const = default;
    bool is_dragged() const { return damping > 0 || turning_damping > 0; }
    /// What a velocity is divided by in a time.
    Vec<3> slowed(Real h) const
    {
        const Real on = 1 + h * damping;
        return {on, on, 1 + h * turning_damping};
    }
};

struct WorldScene : JointedScene {
    /// of each body; empty = weight alone
    std::vector<BodyForces> acting;
};

/// (19.3), of the bodies that the step looks at.
inline void free_velocities(WorldScene& scene, const StepSettings& settings,
                            StepData<3>& now)
{
    free_velocities(static_cast<RigidScene&>(scene), settings, now);
    if (scene.acting.empty()) return;
    Bodies<3>& bodies = scene.bodies;
    const Real h = settings.part();
    for (const int k : now.active) {
        const BodyForces& own = scene.acting[static_cast<std::size_t>(k)];
        const Real inverse_mass = bodies.inverse_mass[3 * k];
        if (!(inverse_mass > 0) || own == BodyForces{}) continue;
        auto f = bodies.force(k);
        f.head<2>() += (own.gravity - 1) * scene.gravity / inverse_mass + own.force;
        f[2] += own.torque;
        const Vec<3> there =
            bodies.velocity(k) + h * bodies.apply_inverse_mass(k, f);
        now.u_star.segment<3>(3 * k) = there.cwiseQuotient(own.slowed(h));
        // drag is a force too: rest is measured by what acts
        if (!own.is_dragged()) continue;
        const Vec<3> drag(own.damping, own.damping, own.turning_damping);
        for (int d = 0; d < 3; ++d)
            if (const Real W = bodies.inverse_mass[3 * k + d]; W > 0)
                f[d] -= drag[d] / W * now.u_star[3 * k + d];
    }
}
//! [acting]

//! [carry]
/// The shapes of body k are where it is.
inline void carry(RigidScene& scene, Index k)
{
    if (scene.carried.empty()) return;
    const Vec<3> pose = scene.bodies.position(k);
    scene.for_each_shape(k,
                         [&](Index shape) { scene.bodies.position(shape) = pose; });
}
//! [carry]

//! [dragged]
/// Chapter 12's stage, where what acts on single bodies counts: how far ahead they
/// look, and whether they come to rest.
struct ActedManifolds : Manifolds {
    const std::vector<BodyForces>* acting = nullptr;  ///< of the scene

    void begin_with(const RigidScene& scene, Real margin, Real h,
                    std::span<const int> bodies, StepData<3>& now)
    {
        falls.resize(acting->size());
        if (!acting->empty()) list_falls(scene, bodies);
        Manifolds::begin_with(scene, margin, h, shapes_of(scene, bodies), now);
    }
    /// All shapes of these bodies look, ascending.
    std::span<const int> shapes_of(const RigidScene& scene,
                                   std::span<const int> bodies)
    {
        if (scene.carried.empty()) return bodies;
        looking_.clear();
        for (const int body : bodies)
            if (scene.carrier(body) == body)  // others come with theirs
                scene.for_each_shape(body, [this](Index k) {
                    looking_.push_back(static_cast<int>(k));
                });
        std::sort(looking_.begin(), looking_.end());
        return looking_;
    }
    void list_falls(const RigidScene& scene, std::span<const int> bodies)
    {
        for (const int k : bodies) {
            const auto at = static_cast<std::size_t>(k);
            const BodyForces& own = (*acting)[at];
            falls[at] = (own.gravity * scene.gravity +
                         scene.bodies.inverse_mass[3 * k] * own.force)
                            .norm();
        }
    }
    /// A velocity that drag alone has changed is steady.
    template <class Scene, class Method>
    void end(Scene& scene, const StepSettings& settings, Method& method,
             const StepData<3>& now)
    {
        for (const int k : now.active) carry(scene, k);
        Manifolds::end(scene, settings, method, now);
        if (acting->empty()) return;
        for (const int k : now.active) {
            const BodyForces& own = (*acting)[static_cast<std::size_t>(k)];
            auto then = method.contacts.u_before.template segment<3>(3 * k);
            if (own.is_dragged() && scene.bodies.can_move(k))
                for (int n = 0; n < settings.substeps; ++n)
                    then = then.cwiseQuotient(own.slowed(settings.part())).eval();
        }
    }

private:
    std::vector<int> looking_;
};
//! [dragged]

}  // namespace rigid
