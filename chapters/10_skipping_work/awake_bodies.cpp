// The functions of awake_bodies.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/10_skipping_work/awake_bodies.hpp"

namespace rigid {

void AwakeBodies::wake_by_changes(const DiscScene& scene,
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
    rests[static_cast<std::size_t>(settings.pulled)] = disturbed;
}

void AwakeBodies::change_margin(const DiscScene& scene, Real margin)
{
    broad.margin = margin;
    broad.reset(scene, CollisionFilter(broad.filter));
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        if (set.activity[static_cast<std::size_t>(k)] == Activity::gone)
            broad.grid.remove(static_cast<int>(k));
        set.wake(k);
    }
}

void AwakeBodies::collect_active(const DiscScene& scene)
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

void AwakeBodies::list_sources(const DiscScene& scene, const StepSettings& settings,
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

}  // namespace rigid
