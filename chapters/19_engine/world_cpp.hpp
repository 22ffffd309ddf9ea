/// \file world_cpp.hpp
/// The state behind a World: what world.cpp and its sisters world_….cpp share.
#pragma once

#include "chapters/19_engine/contact_lists.hpp"
#include "chapters/19_engine/recording.hpp"
#include "chapters/19_engine/saved_world.hpp"
#include "chapters/19_engine/shape_queries.hpp"
#include "chapters/19_engine/world.hpp"

#include <tuple>

namespace rigid {

struct World::State : EngineState {
    using EngineState::note;

    /// Into the recording, if there is one.
    template <class... Arguments>
    void note(Call call, const Arguments&... arguments)
    {
        if (recording) recording->note(call, arguments...);
    }

    const PlacedJoint& placed(JointId joint) const
    {
        return scene.placed[joints.require(joint, "joint")];
    }
    Reaction reaction(JointId joint) const
    {
        const std::size_t i = joints.require(joint, "joint");
        const RigidJoint& it = scene.placed[i].joint;
        for (const Index k : {it.a, it.b})
            if (is_asleep(*this, k)) return resting_reaction(*this, i, k);
        return is_answered() ? rigid::reaction(scene, now, i) : Reaction{};
    }

    /// What ended by calls between the steps is of the next one's events.
    void begin_events()
    {
        for (auto* const list : {&events.began, &events.ended}) list->clear();
        events.hits.clear();
        events.entered.clear();
        events.left.clear();
        events.broken.clear();
        events.held.clear();
        touching.walked = 0;
        events.ended.swap(meanwhile.ended);
        events.left.swap(meanwhile.left);
    }

    //! [report]
    /// Events and counters of a step that was taken.
    void report()
    {
        ToldManifolds& sleepers = awake();
        Manifolds& stage = sleepers.touching;
        const bool looked = stage.finder.tested >= 0;
        met_walls.clear();
        for (const Contact& c : now.contacts)
            met_walls.push_back(wall_id(*this, c));
        for (const int k : now.active) displace(k);
        if (now.active.empty()) {  // nothing is awake, so no touch begins
            now.sources.clear();
            now.contacts.clear();
        }
        if (looked)
            touching.update(
                scene, now, method.solver.reflections.bounced,
                metres(settings.margin), metres(settings.hit_speed),
                stage.finder.asked,
                [&](int k) {
                    return stage.finder.asks[static_cast<std::size_t>(k)] != 0;
                },
                [&](Index k) -> Vec<3> {
                    const bool active = std::binary_search(
                        now.active.begin(), now.active.end(), static_cast<int>(k));
                    if (!active) return Vec<3>::Zero();
                    return sleepers.u_before.segment<3>(3 * k);
                },
                [&](const TouchKey& key) {
                    return Touch{id(key.a), id(key.b),
                                 key.wall < 0 ? WallId{}
                                              : walls.id(static_cast<std::size_t>(
                                                    key.wall))};
                },
                events);
        std::sort(events.ended.begin(), events.ended.end());
        if (method.contacts.broken > 0 && !now.active.empty())
            for (std::size_t i = 0; i < scene.placed.size(); ++i)
                if (scene.placed[i].broken && joints.has(i) &&
                    method.contacts.was_broken[i] == 0)
                    events.broken.push_back(joints.id(i));
        if (sensors > 0) {
            place_moved(*this);
            update_sensors(*this);
        }
        for (const int k : method.correction.held) events.held.push_back(id(k));
        count();
    }
    //! [report]

    void count()
    {
        const ToldManifolds& sleepers = awake();
        work.woken = sleepers.woken;
        work.walked = sleepers.walked + touching.walked;
        work.fell_asleep = sleepers.fell_asleep;
        work.tested = std::max<std::int64_t>(0, sleepers.touching.finder.tested);
        if (now.active.empty()) return;
        IslandChoice& solver = method.solver;
        work.awake = static_cast<int>(now.active.size());
        work.islands = solver.all.islands.count();
        work.exact = solver.exact_count;
        work.answered =
            solver.exact_count > 0 && solver.answered_count == solver.exact_count;
        work.swept = solver.swept_count;
        work.rescued = solver.rescued_count;
        work.stepped = solver.stepped_count;
        work.unsolved = solver.unsolved;
        work.contacts = static_cast<int>(now.contacts.size());
        work.rows = static_cast<int>(now.rows.size());
        work.visits = now.visits;
        work.entries = solver.all_entries();
        work.sweeps = solver.most_sweeps;
        work.stopped = sleepers.touching.fast.impacts;
        work.unsolved = std::max(work.unsolved, method.correction.unmet);
        work.residual = now.solution.residual;
        // no residual of numbers that overflowed means anything
        work.held = static_cast<int>(method.correction.held.size());
        if (work.held > 0) work.unsolved = std::max(1, work.unsolved);
        if (work.held > 0 || !std::isfinite(work.residual))
            work.residual = infinity;
    }
};

}  // namespace rigid
