/// \file awake_bodies.hpp
/// The contacts stage of the step without what needs nothing: bodies that sleep are not looked at, and pairs that are far
/// apart are not tested. What is remembered is only true while the scene is changed by the functions for it alone: see
/// scene_edits.hpp.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/10_skipping_work/broad_phase.hpp"
#include "chapters/10_skipping_work/fall_asleep.hpp"
#include "chapters/10_skipping_work/incidence.hpp"
#include "chapters/10_skipping_work/kept_contacts.hpp"
#include "chapters/10_skipping_work/rest_conditions.hpp"
#include "chapters/10_skipping_work/sleepers.hpp"
#include "common/text.hpp"

#include <vector>

namespace rigid {

//! [awake_bodies]
struct AwakeBodies : Sleepers<2> {
    /// contacts keep their normal while their discs have moved by less [ℓ]
    Real row_slack = 0;

    BroadPhase broad;
    Incidence links_on, bends_on, joints_on;  ///< by body
    RestConditions conditions;                ///< of the last step

    // What the last step found on its way.
    std::vector<int> links, bends, joints;  ///< of the bodies that are awake
    std::vector<Bend> active_bends;
    KeptContacts kept;  ///< used where row_slack > 0
    //! [awake_bodies]

    /// Puts a scene in: all that can move is awake.
    /// \throws std::invalid_argument  for a disc with two different masses
    void reset(const DiscScene& scene, CollisionFilter filter);

    /// Disc k = K − 1 is new in the scene, without links, bends or joints.
    void add(const DiscScene& scene, Index k);

    void require_valid() const
    {
        rigid::require_valid(rest);
        require_row_slack(row_slack);
    }

    /// Which bodies, which contacts, which constraints this step looks at.
    template <class Method>
    void begin(const DiscScene& scene, const StepSettings& settings, Method& method,
               StepData<2>& now);

    /// Islands that have been at rest for long enough fall asleep.
    template <class Method>
    void end(DiscScene& scene, const StepSettings& settings, Method& method,
             const StepData<2>& now);

private:
    void wake_by_changes(const DiscScene& scene, const StepSettings& settings,
                         const RestConditions& present);
    void change_margin(const DiscScene& scene, Real margin);
    void collect_active(const DiscScene& scene);
    void list_sources(const DiscScene& scene, const StepSettings& settings,
                      StepData<2>& now);
};

/// What has changed since the last step wakes the bodies that it concerns. Costs the same however many sleep.
inline void AwakeBodies::wake_by_changes(const DiscScene& scene,
                                         const StepSettings& settings,
                                         const RestConditions& present)
{
    if (static_cast<Index>(rests.size()) != scene.bodies.count())
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.bodies.count()) +
            " discs; reset() was called with " + std::to_string(rests.size()));
    woken = fell_asleep = 0;
    if (!same_rest(present, conditions))
        for (Index k = 0; k < scene.bodies.count(); ++k) set.wake(k);  // this once
    conditions = present;
    if (settings.pulled == world) return;
    set.wake(settings.pulled);
    rests[static_cast<std::size_t>(settings.pulled)] = {};
}

/// Another margin makes other pairs: all wake and are looked for again.
inline void AwakeBodies::change_margin(const DiscScene& scene, Real margin)
{
    broad.margin = margin;
    broad.reset(scene, CollisionFilter(broad.filter));
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        if (set.activity[static_cast<std::size_t>(k)] == Activity::gone)
            broad.grid.remove(static_cast<int>(k));
        set.wake(k);
    }
}

/// The links, bends and joints of the bodies that are awake: listed again when that has changed.
inline void AwakeBodies::collect_active(const DiscScene& scene)
{
    if (!changed) return;
    const auto counts = [&](Index k) {
        return k == world ||
               set.activity[static_cast<std::size_t>(k)] != Activity::gone;
    };
    const auto moves = [&](Index k) { return scene.bodies.can_move(k); };
    const auto is_row = [&](Index a, Index b) {
        return counts(a) && counts(b) && (moves(a) || moves(b));
    };
    collect(links_on, set.awake, links);
    std::erase_if(links, [&](int i) {
        const Link& link = scene.links[static_cast<std::size_t>(i)];
        return !is_row(link.a, link.b);
    });
    collect(joints_on, set.awake, joints);
    std::erase_if(joints, [&](int i) {
        const Joint& joint = scene.joints[static_cast<std::size_t>(i)];
        return !is_row(joint.a, joint.b);
    });
    collect(bends_on, set.awake, bends);
    active_bends.clear();
    for (const int i : bends) {
        const Bend& bend = scene.bends[static_cast<std::size_t>(i)];
        if (counts(bend.left) && counts(bend.middle) && counts(bend.right))
            active_bends.push_back(bend);
    }
    changed = false;
}

/// The contacts of the bodies that are awake, and where the constraints come from.
inline void AwakeBodies::list_sources(const DiscScene& scene,
                                      const StepSettings& settings,
                                      StepData<2>& now)
{
    now.same_bodies = !changed;
    collect_active(scene);
    if (row_slack > 0) {
        keep_contacts(scene, set, broad, row_slack * length, kept, now.contacts);
    } else {
        awake_contacts(scene, set, broad, now.contacts);
        kept = {};
    }
    now.sources.clear();
    for (const int i : links) now.sources.push_back({Source::Of::link, i});
    for (std::size_t i = 0; i < now.contacts.size(); ++i)
        now.sources.push_back({Source::Of::contact, static_cast<int>(i)});
    for (const int i : joints) now.sources.push_back({Source::Of::joint, i});

    // A contact that has kept its normal keeps its row, where the rows are those of the step before, one for one.
    now.kept.clear();
    if (!kept.same || !now.same_bodies || settings.substeps > 1 ||
        now.rows.size() != now.sources.size())
        return;
    now.kept.resize(links.size(), 0);
    now.kept.insert(now.kept.end(), kept.kept.begin(), kept.kept.end());
    now.kept.resize(now.sources.size(), 0);
}

template <class Method>
void AwakeBodies::begin(const DiscScene& scene, const StepSettings& settings,
                        Method& method, StepData<2>& now)
{
    RestConditions present{
        scene.gravity, settings.stiffness, settings.damping, rest, {}, sleep};
    if constexpr (requires { method.correction.beta; })
        present.correction = method.correction;
    wake_by_changes(scene, settings, present);
    now.active.clear();
    now.length = length;
    if (settings.margin * length != broad.margin)
        change_margin(scene, settings.margin * length);
    if (set.awake.empty()) return;
    // Which discs may touch which; a disc that is touched wakes.
    update_pairs(scene, set, broad);
    if (!set.woken.empty()) take_in_the_woken(method);
    list_sources(scene, settings, now);
    now.active.assign(set.awake.begin(), set.awake.end());
    now.bends = active_bends;
    begin_from(scene.bodies, now);
}

/// Islands that have been at rest for long enough fall asleep.
template <class Method>
void AwakeBodies::end(DiscScene& scene, const StepSettings& settings,
                      Method& method, const StepData<2>& now)
{
    fall_asleep(scene, settings, method, now);
}

}  // namespace rigid
