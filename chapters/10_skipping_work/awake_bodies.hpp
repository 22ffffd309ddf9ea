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
    /// What has changed since the last step wakes the bodies that it concerns. Costs the same however many sleep.
    void wake_by_changes(const DiscScene& scene, const StepSettings& settings,
                         const RestConditions& present);

    /// Another margin makes other pairs: all wake and are looked for again.
    void change_margin(const DiscScene& scene, Real margin);

    /// The links, bends and joints of the bodies that are awake: listed again when that has changed.
    void collect_active(const DiscScene& scene);

    /// The contacts of the bodies that are awake, and where the constraints come from.
    void list_sources(const DiscScene& scene, const StepSettings& settings,
                      StepData<2>& now);
};

template <class Method>
void AwakeBodies::begin(const DiscScene& scene, const StepSettings& settings,
                        Method& method, StepData<2>& now)
{
    RestConditions present{
        scene.gravity, settings.stiffness, settings.damping, rest, {}, sleep};
    method.correction.describe(present.correction);
    wake_by_changes(scene, settings, present);
    now.active.clear();
    now.length = length;
    if (settings.margin * length != broad.margin)
        change_margin(scene, settings.margin * length);
    if (set.awake.empty()) {
        set.tidy();  // fixed discs that were changed would be listed again and again
        return;
    }
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
