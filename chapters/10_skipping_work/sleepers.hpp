/// \file sleepers.hpp
/// Which bodies are awake, how long each has been at rest, and the forces that sleepers wake with: what a contacts stage
/// that lets bodies sleep keeps from step to step, whatever their shapes are.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/08_warm_starting/warm_start.hpp"
#include "chapters/10_skipping_work/islands.hpp"
#include "chapters/10_skipping_work/sleeping.hpp"

#include <vector>

namespace rigid {

//! [sleepers]
template <int Dof>
struct Sleepers : PlainContacts {
    RestSettings rest;
    bool sleep = true;  ///< false: no body falls asleep
    Real length = 1;    ///< ℓ, of the scene [m]

    AwakeSet set;
    /// K: how long each body has been at rest
    std::vector<Rest> rests;
    SleepingForces forces;  ///< of the bodies that sleep
    /// of the bodies that are awake, where the solver has none
    Islands islands;
    /// velocities before the step, of the bodies that are awake [m/s]
    VecX u_before;
    /// the set of awake bodies has changed since what hangs on it was listed
    bool changed = true;
    int woken = 0, fell_asleep = 0;  ///< bodies, in the last step
    //! [sleepers]

    /// All that can move is awake.
    void wake_all(const Bodies<Dof>& bodies)
    {
        const auto K = static_cast<std::size_t>(bodies.count());
        set = everybody_awake(bodies);
        rests.assign(K, {});
        forces = {};
        forces.head.assign(K, -1);
        u_before = bodies.u;
        changed = true;
    }

    /// For changes that the stage does not see by itself. What it does not know yet
    /// will be awake.
    void wake(Index k)
    {
        if (k < static_cast<Index>(set.activity.size())) set.wake(k);
    }
    void wake_everybody()
    {
        for (std::size_t k = 0; k < set.activity.size(); ++k)
            set.wake(static_cast<Index>(k));
    }
    bool is_asleep(Index k) const { return set.is_asleep(k); }

    /// Body k = K − 1 is new.
    void add(const Bodies<Dof>& bodies, Index k)
    {
        set.add(bodies, k);
        rests.emplace_back();
        forces.head.push_back(-1);
        u_before.conservativeResize(bodies.u.size());
        u_before.template segment<Dof>(Dof * k) = bodies.velocity(k);
        changed = true;
    }

    /// A body that was woken starts from the forces that it fell asleep with, and has to rest again for all of t_rest.
    template <class Method>
    void take_in_the_woken(Method& method)
    {
        set.tidy();
        ImpulseCache nowhere;
        ImpulseCache* const kept = method.start.impulses();
        remember_woken(forces, set.woken, kept ? *kept : nowhere);
        woken += static_cast<int>(set.woken.size());
        set.woken.clear();
        changed = true;
    }

    /// Where the step begins: a body that falls asleep goes back there.
    void begin_from(const Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        now.x_found.resize(bodies.x.size());
        for (const int k : now.active) {
            now.x_found.template segment<Dof>(Dof * k) = bodies.position(k);
            u_before.template segment<Dof>(Dof * k) = bodies.velocity(k);
        }
    }

    /// Islands that have been at rest for long enough fall asleep.
    template <class Scene, class Method>
    void fall_asleep(Scene& scene, const StepSettings& settings, Method& method,
                     const StepData<Dof>& now);

private:
    template <class Scene>
    void watch_rest(const Scene& scene, const StepSettings& settings,
                    const StepData<Dof>& now);
    template <class Scene>
    bool acts_on(const Scene& scene, Index k, Real a, const StepData<Dof>& now);
    void stay_with_kinematic(const Bodies<Dof>& bodies, const StepData<Dof>& now);

    VecX borne_;  ///< of each body: by its rows, the sum of sizes [m/s²]
    bool is_summed_ = false;  ///< in this step
};

}  // namespace rigid
