/// \file world_state.hpp
/// What a world is made of: a scene of chapter 14, the stages of the step, and what the engine knows besides.
#pragma once

#include "chapters/14_joints/placed_joints.hpp"
#include "chapters/15_trees/tree_method.hpp"
#include "chapters/18_islands/island_choice.hpp"
#include "chapters/19_engine/held_bodies.hpp"
#include "chapters/19_engine/known_bodies.hpp"
#include "chapters/19_engine/told_changes.hpp"
#include "chapters/19_engine/touching.hpp"

#include <cmath>

namespace rigid {

//! [method]
/// The method of the engine: chapter 18's, where calls report what they change, and
/// what overflows is held.
struct EngineMethod {
    WithLoadedLines<WithFriction<ToldManifolds>> contacts;
    HeldBodies correction;
    WarmStart start = last_impulses();
    IslandChoice solver;
};
//! [method]

class Recording;

//! [state]
struct EngineState : KnownBodies {
    WorldSettings settings;
    EngineMethod method;
    StepData<3> now;  ///< found by the last step, on its way

    Places<JointTag> joints;  ///< of scene.placed
    Places<WallTag> walls;    ///< of scene.walls
    std::vector<JointNotes> joint_notes;
    int sensors = 0;      ///< shapes
    int more_shapes = 0;  ///< that bodies have besides the first

    Touching touching;
    std::vector<Seen> seen, seen_then;  ///< by sensors, ascending; before this step
    std::vector<WallId> met_walls;      ///< by contacts of the last step; or none
    Events events;                      ///< of the last step
    Events meanwhile;                   ///< what ended by calls since then
    StepWork work;
    Real time = 0;
    std::int64_t steps = 0;
    Index pulled = world;
    Vec2 pulled_to = {0, 0};
    bool changed = true;         ///< by a call since the last step
    std::vector<int> taken_out;  ///< bodies, since the last step
    ContactFilter contact_filter;
    PreSolve pre_solve;
    Recording* recording = nullptr;

    /// bodies that have moved since the shapes were placed; queries place them
    mutable std::vector<int> unplaced;
    mutable std::vector<char> is_unplaced;  ///< of each body, 1: it is in the list
    //! [state]

    ToldManifolds& awake() { return method.contacts; }
    const ToldManifolds& awake() const { return method.contacts; }
    CollisionFilter& filter() { return awake().touching.finder.filter; }
    Real metres(Real lengths) const { return lengths * settings.length; }

    /// Whether rows and λ of the last step belong to what it found.
    bool is_answered() const
    {
        return now.rows.size() == now.sources.size() &&
               now.solution.lambda.size() == static_cast<Index>(now.rows.size()) &&
               !now.active.empty();
    }
    /// Whether body k is that of the last step, and no other one in its place.
    bool was_there(Index k) const
    {
        return k == world || std::find(taken_out.begin(), taken_out.end(),
                                       static_cast<int>(k)) == taken_out.end();
    }

    //! [disturb]
    /// Body k counts as changed: it wakes, and what touches it or hangs on it, when
    /// the next step begins, and has to rest for all of t_rest.
    void disturb(Index shape)
    {
        const Index k = scene.carrier(shape);
        changed = true;
        awake().watch.tell(k);
        if (auto& rests = awake().rests; k < static_cast<Index>(rests.size()))
            rests[static_cast<std::size_t>(k)] = disturbed;
        displace(k);
    }
    //! [disturb]

    /// Body k had no velocity in the step before, and no rest: it was not there.
    void forget_motion(Index k)
    {
        if (3 * k >= awake().u_before.size()) return;
        awake().u_before.segment<3>(3 * k).setConstant(Real(NAN));
        awake().rests[static_cast<std::size_t>(k)] = {};
    }

    /// The inverse mass of body k, and what hangs on it.
    void write_mass(Index k)
    {
        write_inverse_mass(k);
        if (pulled == k && !scene.bodies.can_move(k)) pulled = world;
        list_slop(scene.carrier(k));
    }

    /// What meets nothing: a sensor, a body that is switched off, a free place.
    static constexpr Filter nothing{0, 0, 0};

    void write_filter(Index k)
    {
        std::vector<Filter>& all = filter().filters;
        all.resize(notes.size(), nothing);
        const BodyNotes& it = note(k);
        const bool meets =
            bodies.has(static_cast<std::size_t>(k)) && !it.sensor && !it.disabled;
        all[static_cast<std::size_t>(k)] = meets ? it.filter : nothing;
    }

    //! [list_driven]
    /// Which bodies a caller has driven since the last step, and with what velocity
    /// they were in it.
    void list_driven()
    {
        ToldManifolds& sleepers = awake();
        driven_ = sleepers.watch.told;
        std::sort(driven_.begin(), driven_.end());
        driven_.erase(std::unique(driven_.begin(), driven_.end()), driven_.end());
        std::vector<DrivenBody>& list = method.correction.driven.list;
        list.clear();
        for (const int k : driven_) {
            if (scene.bodies.can_move(k)) continue;
            auto u = scene.bodies.velocity(k);
            list.push_back({k, sleepers.u_before.segment<3>(3 * k), u});
            DrivenBody& it = list.back();
            it.aims = std::exchange(note(k).aims, false);
            if (settings.substeps == 1 || !it.then.allFinite()) it.then = it.now;
            // it stands from the end of this step on
            if (it.now.isZero(0)) u = it.then;
        }
    }
    /// What stands from now on is told to the next step.
    void end_driven()
    {
        for (const DrivenBody& it : method.correction.driven.list) {
            const bool stops = it.now.isZero(0) && !it.then.isZero(0);
            if (stops) scene.bodies.velocity(it.body).setZero();
            else if (it.aims) scene.bodies.velocity(it.body) = it.now;
            awake().u_before.segment<3>(3 * it.body) =
                scene.bodies.velocity(it.body);
            if (stops) disturb(it.body);
        }
    }
    //! [list_driven]

    /// Body k is elsewhere than its shapes were placed.
    void displace(Index k)
    {
        is_unplaced.resize(std::max(is_unplaced.size(), bodies.size()), 0);
        carry(scene, k);
        scene.for_each_shape(k, [this](Index shape) {
            char& listed = is_unplaced[static_cast<std::size_t>(shape)];
            if (!listed) unplaced.push_back(static_cast<int>(shape));
            listed = 1;
        });
    }

    /// Whether body k goes on however fast it is.
    void list_unstopped(Index k)
    {
        std::vector<char>& goes_on = awake().touching.fast.goes_on;
        goes_on.resize(notes.size(), 0);
        const bool on =
            !note(k).bullet && (!settings.stop_fast || note(k).joints > 0);
        scene.for_each_shape(k, [&](Index shape) {
            goes_on[static_cast<std::size_t>(shape)] = on || !scene.pushes(shape);
        });
    }

    //! [slop]
    /// What is thin is not left to overlap by what suits a box: at most by a
    /// two-hundredth of its inner radius; what has no inside not at all. (A line that
    /// stands, as an edge of a chain, leaves it to what touches it.)
    void list_slop(Index k)
    {
        Real inner = infinity;
        scene.for_each_shape(k, [&](Index i) {
            const Vec2 middle =
                scene.carried.empty()
                    ? Vec2(0, 0)
                    : scene.carried[static_cast<std::size_t>(i)].middle;
            inner = std::min(
                inner,
                inner_radius(PlacedShape(shape(i), Vec<3>::Zero()).view(), middle));
        });
        for (std::vector<Real>* slops :
             {&method.correction.slops, &method.solver.heaps.slops}) {
            slops->resize(notes.size(), infinity);
            (*slops)[static_cast<std::size_t>(k)] =
                inner > 0 || scene.bodies.can_move(k) ? inner / 200 : infinity;
        }
    }
    //! [slop]

    /// The settings, written into the stages.
    void configure()
    {
        scene.gravity = settings.gravity;
        scene.length = settings.length;
        ToldManifolds& sleepers = awake();
        sleepers.sleep = settings.sleep;
        sleepers.rest = settings.rest;
        sleepers.touching.ahead = 1;
        sleepers.touching.seams.look = true;
        sleepers.touching.acting = &scene.acting;
        method.correction.slop = settings.slop;
        method.correction.push_sweeps = settings.sweeps;
        IslandChoice& solver = method.solver;
        solver.heaps.substeps = settings.substeps;
        solver.heaps.slop = settings.slop;
        solver.solving = settings.solving;
        solver.tolerance = settings.tolerance;
        solver.rule.at_most = settings.most_exact;
        solver.rule.always = std::min(ChoiceRule{}.always, settings.most_exact);
        solver.most_exact = settings.most_exact;
        solver.slow = 10 * settings.rest.speed;
        solver.sweeps.max_sweeps = settings.sweeps;
        solver.sweeps.tolerance = settings.tolerance;
        solver.all.anew = true;
        for (std::size_t k = 0; k < notes.size(); ++k)
            if (const auto body = static_cast<Index>(k);
                scene.carrier(body) == body)
                list_unstopped(body), list_slop(body);
    }

private:
    std::vector<int> driven_;  ///< bodies that were told, ascending
};

}  // namespace rigid
