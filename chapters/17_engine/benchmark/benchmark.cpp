/// Chapter 17: the engine beside two others, on the same worlds: run time and error.
///
///     SCENE/WHO   four seconds at 60 steps a second:
///                 us_step  time of a step, the median over the steps [µs]      us_last  the mean of the last second [µs]
///                 overlap  the deepest of two bodies or a wall at the end of any step after the first second [m]
///                 gap      the largest error of a joint in any step [m]
///                 crept    how far the body that moved most in the last two seconds moved in them [m]
///                 sunk     how far the body that moved most is from where it began [m]
///
/// overlap, gap, crept and sunk are measured by one function for all engines, on poses in doubles. Each by its own
/// defaults, sleep included; WHO/4 has four sub-steps. A world that is at rest asleep moves no more: that is what sleep is.

#include "chapters/17_engine/benchmark/peer_poses.hpp"
#include "chapters/17_engine/moving_worlds.hpp"

#ifdef RIGID_HAS_BOX2D
#include "chapters/17_engine/benchmark/peer_box2d.hpp"
#endif
#ifdef RIGID_HAS_CHIPMUNK
#include "chapters/17_engine/benchmark/peer_chipmunk.hpp"
#endif

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>

using namespace rigid;

namespace {

/// Errors of poses, by the shapes and joints of the world that they began as.
class Judge {
public:
    explicit Judge(const World& world) : world_(&world), ids_(world.bodies())
    {
        for (std::size_t k = 0; k < ids_.size(); ++k)
            place_.resize(std::max<std::size_t>(place_.size(), ids_[k].place + 1u)),
                place_[ids_[k].place] = k;
        for (const JointId joint : world.joints())
            joined_.push_back(
                pair_key(number(world.body_a(joint)), number(world.body_b(joint))));
        std::sort(joined_.begin(), joined_.end());
    }

    Real overlap(const Poses& poses)
    {
        shapes_.resize(ids_.size());
        boxes_.resize(ids_.size());
        for (std::size_t k = 0; k < ids_.size(); ++k) {
            shapes_[k].move(world_->shape(ids_[k]), poses[k]);
            boxes_[k] = box_of(shapes_[k].view());
        }
        Real deepest = 0;
        overlapping_pairs(boxes_, sweep_, [&](int a, int b) {
            const auto i = static_cast<std::size_t>(a),
                       j = static_cast<std::size_t>(b);
            if (world_->mass(ids_[i]) == infinity &&
                world_->mass(ids_[j]) == infinity)
                return;
            if (!lets_meet(world_->filter(ids_[i]), world_->filter(ids_[j])))
                return;
            if (std::binary_search(joined_.begin(), joined_.end(), pair_key(a, b)))
                return;
            const Manifold m =
                collide(shapes_[i].view(), shapes_[j].view(), {0, 0, nullptr});
            for (int p = 0; p < m.count; ++p)
                deepest =
                    std::max(deepest, -m.points[static_cast<std::size_t>(p)].gap);
        });
        for (const WallId wall : world_->walls())
            for (std::size_t k = 0; k < ids_.size(); ++k) {
                if (world_->mass(ids_[k]) == infinity) continue;
                const Manifold m =
                    collide(world_->wall(wall), shapes_[k].view(), 0);
                for (int p = 0; p < m.count; ++p)
                    deepest = std::max(deepest,
                                       -m.points[static_cast<std::size_t>(p)].gap);
            }
        return deepest;
    }

    Real gap(const Poses& poses) const
    {
        Real largest = 0;
        for (const JointId id : world_->joints()) {
            const RigidJoint& joint = world_->joint(id);
            const Vec2
                a = world_->body_a(id) ? at(poses[static_cast<std::size_t>(
                                                number(world_->body_a(id)))],
                                            joint.at_a)
                                       : joint.at_a,
                b = at(poses[static_cast<std::size_t>(number(world_->body_b(id)))],
                       joint.at_b);
            largest = std::max(largest, (b - a).norm());
        }
        return largest;
    }

    Real moved(const Poses& from, const Poses& to) const
    {
        Real most = 0;
        for (std::size_t k = 0; k < to.size(); ++k)
            most = std::max(most, (to[k] - from[k]).head<2>().norm());
        return most;
    }

private:
    int number(BodyId id) const
    {
        return id ? static_cast<int>(place_[id.place]) : -1;
    }
    static Vec2 at(const Vec<3>& pose, const Vec2& own)
    {
        const Real c = std::cos(pose[2]), s = std::sin(pose[2]);
        return {pose[0] + c * own.x() - s * own.y(),
                pose[1] + s * own.x() + c * own.y()};
    }

    const World* world_;
    std::vector<BodyId> ids_;
    std::vector<std::size_t> place_;
    std::vector<std::uint64_t> joined_;
    std::vector<PlacedShape> shapes_;
    std::vector<Box> boxes_;
    BoxSweep sweep_;
};

/// \param step  one step of 1/60 s
/// \param read  where the bodies are
void follow(benchmark::State& state, const World& start,
            const std::function<void()>& step,
            const std::function<void(Poses&)>& read)
{
    Judge judge(start);
    Poses first, before, now;
    read(first);
    Real overlap = 0, gap = 0;
    std::vector<Real> times;
    for (auto _ : state)
        for (int i = 0; i < 240; ++i) {
            const auto begin = std::chrono::steady_clock::now();
            step();
            times.push_back(std::chrono::duration<Real, std::micro>(
                                std::chrono::steady_clock::now() - begin)
                                .count());
            read(now);
            if (i == 120) before = now;
            bool finite = true;
            for (const Vec<3>& pose : now) finite = finite && pose.allFinite();
            if (!finite) {
                overlap = gap = infinity;
                break;
            }
            if (i >= 60) overlap = std::max(overlap, judge.overlap(now));
            gap = std::max(gap, judge.gap(now));
        }
    Real last = 0;
    for (std::size_t i = times.size() - std::min<std::size_t>(60, times.size());
         i < times.size(); ++i)
        last += times[i] / 60;
    std::sort(times.begin(), times.end());
    state.counters["us_step"] = times[times.size() / 2];
    state.counters["us_last"] = last;
    state.counters["overlap"] = overlap;
    state.counters["gap"] = gap;
    state.counters["crept"] = before.empty() ? infinity : judge.moved(before, now);
    state.counters["sunk"] = judge.moved(first, now);
}

void by_book(benchmark::State& state, World world, int substeps, Solving solving)
{
    WorldSettings settings = world.settings();
    settings.substeps = substeps;
    settings.solving = solving;
    world.change(settings);
    const World start = World::load(world.save());
    const std::vector<BodyId> ids = world.bodies();
    follow(
        state, start, [&] { world.step(1.0 / 60); },
        [&](Poses& poses) {
            poses.clear();
            for (const BodyId id : ids)
                poses.push_back({world.position(id).x(), world.position(id).y(),
                                 world.angle(id)});
        });
}

template <class Engine>
void by_engine(benchmark::State& state, const World& start, int substeps)
{
    Engine engine(start, true, substeps);
    follow(
        state, start, [&] { engine.step(1.0 / 60); },
        [&](Poses& poses) { engine.read(poses); });
}

void register_scene(const std::string& name, const std::function<World()>& make)
{
    const auto add = [&](const std::string& who,
                         const std::function<void(benchmark::State&)>& run) {
        benchmark::RegisterBenchmark((name + "/" + who).c_str(), run)
            ->Iterations(1);
    };
    for (const int substeps : {1, 4}) {
        const std::string behind = substeps == 1 ? "" : "/4";
        add("book" + behind, [=](benchmark::State& s) {
            by_book(s, make(), substeps, Solving::by_island);
        });
        add("book_sweeps" + behind, [=](benchmark::State& s) {
            by_book(s, make(), substeps, Solving::sweeps);
        });
#ifdef RIGID_HAS_BOX2D
        add("box2d" + behind, [=](benchmark::State& s) {
            by_engine<Box2dWorld>(s, make(), substeps);
        });
#endif
#ifdef RIGID_HAS_CHIPMUNK
        add("chipmunk" + behind, [=](benchmark::State& s) {
            by_engine<ChipmunkWorld>(s, make(), substeps);
        });
#endif
    }
}

const bool registered = [] {
    for (const int base : {10, 20, 40})
        register_scene("pyramid_" + std::to_string(base),
                       [=] { return pyramid_world(base); });
    register_scene("house_4", [] { return house_world(4); });
    register_scene("column_20", [] { return column_world(19); });
    register_scene("heavy_1000_on_10", [] { return column_world(10, 1000); });
    register_scene("chain_50_1000", [] { return chain_world(50, 1000); });
    register_scene("grid_20", [] { return grid_world(20); });
    register_scene("poured_300", [] { return poured_world(300); });
    register_scene("dolls_10", [] { return dolls_world(10); });
    register_scene("piles_200", [] { return piles_world(200); });
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
