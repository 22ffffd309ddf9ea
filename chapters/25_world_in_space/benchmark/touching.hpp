/// \file touching.hpp
/// Stacks and a pour beside other engines: how far anything overlaps, creeps and leans, by one measure for all.
#pragma once

#include "chapters/25_world_in_space/benchmark/peer_shapes.hpp"
#include "chapters/25_world_in_space/doll_scenes.hpp"
#include "chapters/25_world_in_space/space_method.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <set>

namespace rigid {

/// Errors of positions, by the shapes and walls of the scene that they began as.
class SpaceJudge {
public:
    explicit SpaceJudge(const SpaceScene& scene) : scene_(&scene)
    {
        for (const std::vector<Hull>& shape : scene.shapes)
            forms_.push_back(form_of(shape[0]));
        solids_.resize(forms_.size());
        const Bodies<6>& bodies = scene.bodies;
        for (std::size_t k = 0; k < forms_.size(); ++k)
            for (std::size_t l = 0; l < k; ++l)
                if (bodies.can_move(static_cast<Index>(k)) ||
                    bodies.can_move(static_cast<Index>(l)))
                    apart_.insert({l, k});
        for (const SpaceJoint& joint : scene.joints)
            apart_.erase({static_cast<std::size_t>(std::min(joint.a, joint.b)),
                          static_cast<std::size_t>(std::max(joint.a, joint.b))});
    }

    /// The deepest of two bodies or of a body and a wall [m].
    Real overlap(const VecX& x)
    {
        Real deepest = 0;
        const auto look = [&] {
            for (int i = 0; i < touch_.count; ++i)
                deepest = std::max(deepest,
                                   -touch_.points[static_cast<std::size_t>(i)].gap);
        };
        for (std::size_t k = 0; k < forms_.size(); ++k) {
            const auto body = static_cast<Index>(k);
            solids_[k].place(forms_[k], centre_of(x, body), rotation_of(x, body));
            for (const SolidWall& wall : scene_->walls) {
                collide(wall, solids_[k], {0, 0}, room_, touch_);
                look();
            }
            for (std::size_t l = 0; l < k; ++l) {
                if (!apart_.contains({l, k})) continue;
                const Real far = (solids_[k].centre - solids_[l].centre).norm();
                if (far > forms_[k].reach + forms_[l].reach) continue;
                collide(solids_[k], solids_[l], {0, 0}, room_, touch_);
                look();
            }
        }
        return deepest;
    }

    /// How far the body that moved most has moved [m].
    static Real moved(const VecX& from, const VecX& to)
    {
        Real most = 0;
        for (Index k = 0; k < to.size() / 6; ++k)
            most = std::max(most,
                            (to.segment<3>(6 * k) - from.segment<3>(6 * k)).norm());
        return most;
    }

private:
    const SpaceScene* scene_;
    std::set<std::pair<std::size_t, std::size_t>> apart_;  ///< what should be so
    std::vector<SolidForm> forms_;
    std::vector<PlacedSolid> solids_;
    ClipRoom room_;
    SolidTouch touch_;
};

/// Four seconds at 60 steps a second.
/// \param step  void(): one step
/// \param read  void(VecX& x, VecX& u): where the bodies are, and their velocities
template <class Step, class Read>
void follow(benchmark::State& state, const SpaceScene& start, const Step& step,
            const Read& read)
{
    SpaceJudge judge(start);
    VecX now = start.bodies.x, before = now;
    SpaceScene here = start;
    Real overlap = 0, gap = 0, over = 0, gained = 0, least = energy(start);
    std::vector<Real> times;
    for (auto _ : state)
        for (int i = 0; i < 240; ++i) {
            const auto begin = std::chrono::steady_clock::now();
            step();
            times.push_back(std::chrono::duration<Real, std::micro>(
                                std::chrono::steady_clock::now() - begin)
                                .count());
            read(now, here.bodies.u);
            if (!now.allFinite()) {
                overlap = gap = over = gained = infinity;
                break;
            }
            here.bodies.x = now;
            gap = std::max(gap, largest_joint_error(here));
            over = std::max(over, largest_limit_error(here));
            gained = std::max(gained, energy(here) - least);
            least = std::min(least, energy(here));
            if (i == 120) before = now;
            if (i >= 60) overlap = std::max(overlap, judge.overlap(now));
        }
    std::sort(times.begin(), times.end());
    state.counters["us_step"] = times[times.size() / 2];
    state.counters["overlap"] = overlap;
    state.counters["gap"] = gap;
    state.counters["over"] = over;
    state.counters["gained"] = gained;
    state.counters["crept"] = SpaceJudge::moved(before, now);
    state.counters["moved"] = SpaceJudge::moved(start.bodies.x, now);
}

/// Balls, capsules and boxes of about half a metre fall into the pit of `heap`.
inline SpaceScene simple_heap(int bodies, int side = 3)
{
    SpaceScene scene = mixed_heap(2 * bodies, 0.5, 1, side), simple = scene;
    simple.shapes.clear(), simple.bodies = Bodies<6>(0);
    for (Index k = 0; k < scene.bodies.count() && simple.bodies.count() < bodies;
         ++k) {
        if (k % 4 == 3) continue;  // a hull
        const Index n = simple.bodies.count();
        simple.bodies.resize(n + 1);
        simple.bodies.position(n) = scene.bodies.position(k);
        simple.bodies.inverse_mass.segment<6>(6 * n) =
            scene.bodies.inverse_mass.segment<6>(6 * k);
        simple.shapes.push_back(scene.shapes[static_cast<std::size_t>(k)]);
    }
    simple.friction.assign(simple.shapes.size(), 0.5);
    return simple;
}

inline SpaceScene heavy_stack(int boxes, Real ratio)
{
    SpaceScene scene = box_stack(boxes, 0.05, 0.5);
    scene.bodies.inverse_mass.tail<6>() /= ratio;
    return scene;
}

}  // namespace rigid
