/// \file awake_manifolds.hpp
/// The contacts stage for shapes that skips what needs nothing: bodies that sleep are not placed, not paired and make no
/// rows. When an island falls asleep and what wakes it is chapter 10's; what the scene's owner changes is seen by itself.
/// A template, because solids in space sleep by it too (chapter 25).
#pragma once

#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/10_skipping_work/fall_asleep.hpp"
#include "chapters/10_skipping_work/rest_conditions.hpp"
#include "chapters/12_contact_manifolds/manifold_stage.hpp"
#include "chapters/12_contact_manifolds/scene_watch.hpp"

namespace rigid {

/// A body that turns is as fast as its farthest point: |ω| r is a speed [m/s].
inline Vec<3> measured_velocity(const RigidScene& scene, Index k, const Vec<3>& u)
{
    return {u[0], u[1], u[2] * farthest_point(scene, k)};
}

//! [awake_stage]
/// \tparam Touching  the contacts stage that looks at some bodies: begin_with(),
///                   and pairs that touched: `touching`, of sleepers `resting`
/// \tparam Watch     what has been changed in a Watch::Scene: compared, or reported
template <class Touching, class Watch>
struct AwakeStage : Sleepers<Watch::Scene::dof> {
    using Scene = typename Watch::Scene;
    static constexpr int dof = Scene::dof;
    static constexpr bool is_told = Watch::is_told;
    using Base = Sleepers<dof>;
    using Base::rest, Base::sleep, Base::length, Base::set, Base::rests,
        Base::u_before, Base::changed, Base::woken, Base::fell_asleep;

    Touching touching;
    //! [awake_stage]
    Watch watch;  ///< the scene as the last step left it
    RestConditions conditions;
    Real margin = 0;  ///< of the last step [m]
    std::int64_t walked =
        0;  ///< bodies, pairs and joints that changes made it look at

    void require_valid() const
    {
        rigid::require_valid(rest);
        touching.require_valid();
    }

    //! [awake_begin]
    template <class Method>
    void begin(const Scene& scene, const StepSettings& settings, Method& method,
               StepData<dof>& now)
    {
        watch.require(scene);
        touching.require_fit(scene, method);
        woken = fell_asleep = 0;
        take_in_changes(scene, settings, method, now);
        now.length = length;
        now.active.clear();
        if (set.awake.empty() && moved_.empty()) return;

        // Whatever an awake body touches wakes, with its island, and looks too.
        do {
            if (!set.woken.empty()) this->take_in_the_woken(method);
            now.active = set.awake;
            now.active.insert(now.active.end(), moved_.begin(), moved_.end());
            std::sort(now.active.begin(), now.active.end());
            touching.begin_with(scene, margin, settings.h, now.active, now);
            for (const auto& contact : now.contacts)
                for (const Index k : {contact.a, contact.b})
                    if (k != world) set.wake(k);
        } while (!set.woken.empty());
        //! [awake_begin]
        // then the step ends here
        if (set.awake.empty()) watch.remember(scene);

        now.active = set.awake;
        now.bends = {};
        now.same_bodies = !changed;
        changed = false;
        this->begin_from(scene.bodies, now);
    }

    template <class AnyScene, class Method>
    void end(AnyScene& scene, const StepSettings& settings, Method& method,
             const StepData<dof>& now)
    {
        touching.end(scene, settings, method, now);
        this->fall_asleep(scene, settings, method, now);
        watch.remember(scene);
    }

private:
    std::vector<int> moved_;  ///< fixed bodies that are elsewhere than a step ago

    std::vector<int> changed_;  ///< bodies, since the last step
    std::vector<char> is_changed_;

    template <class Method>
    void take_in_changes(const Scene& scene, const StepSettings& settings,
                         const Method& method, StepData<dof>& now)
    {
        RestConditions present{Vec2(0, 0), 0, 0, rest, {}, sleep};
        // in space the watch alone compares it
        if constexpr (dof == 3) present.gravity = scene.gravity;
        method.correction.describe(present.correction);
        const Real found_within = settings.margin * length_of(scene);
        moved_.clear();
        walked = 0;
        if (watch.is_new() ||
            scene.bodies.count() < static_cast<Index>(rests.size())) {
            this->wake_all(scene.bodies);
            now.x_found.resize(0);  // nothing is known of this scene
            now.u_star.resize(0);
        } else {
            list_changed(scene);
            wake_the_changed(scene);
            if (watch.all_concerned(scene) || !same_rest(present, conditions) ||
                found_within != margin)
                this->wake_everybody();
        }
        while (static_cast<Index>(rests.size()) < scene.bodies.count())
            this->add(scene.bodies, static_cast<Index>(rests.size()));
        conditions = present;
        margin = found_within;
        if (settings.pulled != world) {
            set.wake(settings.pulled);
            rests[static_cast<std::size_t>(settings.pulled)] = disturbed;
        }
        std::sort(moved_.begin(), moved_.end());
        moved_.erase(std::unique(moved_.begin(), moved_.end()), moved_.end());
        std::erase_if(moved_, [&](int k) { return set.is_awake(k); });
    }

    /// ℓ is the scene's, and stays what it was while bodies are added.
    Real length_of(const Scene& scene)
    {
        if (watch.is_new() || scene.length > 0) length = typical_length(scene);
        return length;
    }

    /// Each of them once.
    void list_changed(const Scene& scene)
    {
        changed_.clear();
        is_changed_.resize(static_cast<std::size_t>(scene.bodies.count()), 0);
        walked += watch.compare(scene, [this](Index k) {
            char& listed = is_changed_[static_cast<std::size_t>(k)];
            if (!std::exchange(listed, 1)) changed_.push_back(static_cast<int>(k));
        });
    }

    //! [changed]
    /// What has been changed wakes, and what touched it or hangs on it: one pass for
    /// all of them. A pair of two sleepers concerns no body that was awake.
    void wake_the_changed(const Scene& scene)
    {
        if (changed_.empty()) return;
        const auto known = static_cast<Index>(rests.size());  // a new body is awake
        const auto is_in = [this](Index k) {
            return k != world && is_changed_[static_cast<std::size_t>(k)] != 0;
        };
        const auto wake_of = [&](const auto& pairs) {
            walked += static_cast<std::int64_t>(pairs.size());
            for (const auto& pair : pairs) {
                const Index a = scene.carrier(pair.a), b = scene.carrier(pair.b);
                if (is_in(a) || is_in(b))
                    for (const Index k : {a, b})
                        if (k != world && k < known) set.wake(k);
            }
        };
        const bool all_awake =
            std::all_of(changed_.begin(), changed_.end(),
                        [this](int k) { return set.is_awake(k); });
        for (const int k : changed_) {
            set.wake(k);
            if (k >= known) continue;
            Rest& so_far = rests[static_cast<std::size_t>(k)];
            // one that is new in an old place has no velocity before
            if (u_before.template segment<dof>(dof * k).allFinite())
                so_far = disturbed;
        }
        wake_of(touching.touching);
        if (!all_awake) wake_of(touching.resting);
        wake_of(scene.joints);
        //! [changed]
        for (const int k : changed_) take_in(scene.bodies, k);
        set.tidy();
        changed = true;
    }

    /// Body k has other numbers: it may have begun to move, or may move no more.
    void take_in(const Bodies<dof>& bodies, int k)
    {
        const auto at = static_cast<std::size_t>(k);
        is_changed_[at] = 0;
        Activity& activity = set.activity[at];
        const bool moves = bodies.can_move(k) || !bodies.velocity(k).isZero(0);
        if (moves && activity == Activity::fixed) {
            activity = Activity::awake;
            set.awake.push_back(k);
            set.woken.push_back(k);
        }
        if (!moves) {
            activity = Activity::fixed;
            moved_.push_back(k);
        }
    }
};

//! [awake_manifolds]
using AwakeManifolds = AwakeStage<Manifolds, SceneWatch>;
//! [awake_manifolds]

}  // namespace rigid
