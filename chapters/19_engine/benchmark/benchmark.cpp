/// Chapter 19: the engine beside three others, on the same worlds: run time and error.
///
///     SCENE/WHO   four seconds at 60 steps a second, of large worlds fewer (`steps`):
///                 us_step  time of a step, the median over the steps [µs]
///                 us_last  the mean of the last quarter [µs]      ms_all  all steps together [ms]
///                 overlap  the deepest of two bodies or a wall at the end of a step after the first quarter [m]
///                 gap      the largest error of a joint in any step [m]
///                 crept    how far the body that moved most in the second half moved in it [m]
///                 sunk     how far the body that moved most is from where it began [m]
///                 gained   the largest rise of energy, as a height of all bodies [m]
///     kept/SCENE/WHO/SUBSTEPS   what has to be kept where things move (kept_scenes.hpp), with 1, 4 and 16 sub-steps; the
///                 label says what it is:
///                 right    the value that it must have      kept   what the engine has of it
///                 error    |kept − right|, and gap and ms_all as above
///     asleep_N/book, awake_N/book   what a step costs of N bodies, of which 100 or all are discs that roll,
///                 the others sleep in piles:
///                 us_step, and the counters awake, contacts, rows, visits and tested of the last step
///
/// overlap, gap, crept, sunk and gained are measured by one function for all engines, on poses in doubles. Each by its own
/// defaults, sleep included; WHO/4 has four sub-steps, which are the default of box2d3. A world that is at rest asleep moves
/// no more: that is what sleep is. Where `unsettled` says so, each body begins up to 0.1 mm (of 1 m) beside its place, so
/// that no engine is at rest to the last bit from the beginning. What is measured are engines, and not how a system hands out
/// its pages: before it is measured each engine makes one step of a world of its own like it, and the memory stays with the
/// process.

#include "chapters/19_engine/benchmark/kept_scenes.hpp"
#include "chapters/19_engine/benchmark/world_judge.hpp"
#include "chapters/19_engine/moving_worlds.hpp"

#ifdef RIGID_HAS_BOX2D
#include "tests/peers/box2d_world.hpp"
#endif
#ifdef RIGID_HAS_BOX2D3
#include "tests/peers/box2d3_world.hpp"
#endif
#ifdef RIGID_HAS_CHIPMUNK
#include "tests/peers/chipmunk_world.hpp"
#endif

#include <benchmark/benchmark.h>

#include <chrono>
#include <functional>
#include <string>

#ifdef __GLIBC__
#include <malloc.h>
#endif

using namespace rigid;

namespace {

using kept::frame;

struct Scene {
    std::string name;
    std::function<World()> make;
    int steps = 240;
    Real spin =
        0;  ///< of the drum of a tumbler, whose walls are the first four bodies [rad/s]
};

/// What an engine is to the judge.
struct Engine {
    std::function<void()> step;
    std::function<void(Poses&)> read, read_velocities;
    std::function<void(std::size_t, const Vec2&, Real)> drive;
};

/// Steps an engine that has been given a world, and writes counters.
using Run = std::function<void(benchmark::State&, World start, const Engine&)>;

/// The same columns for all: a table has one heading.
void begin_counters(benchmark::State& state)
{
    for (const char* const name :
         {"steps", "us_step", "us_last", "ms_all", "overlap", "gap", "crept",
          "sunk", "gained", "right", "kept", "error", "awake", "contacts", "rows",
          "visits", "tested"})
        state.counters[name] = 0;
}

Real since(std::chrono::steady_clock::time_point begin)
{
    return std::chrono::duration<Real, std::micro>(
               std::chrono::steady_clock::now() - begin)
        .count();
}

/// The walls of a drum go on along a circle.
void turn(const Poses& now, Real spin, const Engine& engine)
{
    const Real c = rigid::cos(spin * frame), s = rigid::sin(spin * frame);
    for (std::size_t k = 0; k < 4; ++k) {
        const Vec2 p = now[k].head<2>(),
                   next(c * p.x() - s * p.y(), s * p.x() + c * p.y());
        engine.drive(k, (next - p) / frame, spin);
    }
}

void follow(benchmark::State& state, const World& start, const Scene& scene,
            const Engine& engine)
{
    begin_counters(state);
    WorldJudge judge(start);
    Poses first, half, before, now;
    engine.read(first);
    now = first;
    Real overlap = 0, gap = 0, gained = 0, lowest = infinity;
    std::vector<Real> times;
    const int every =
        first.size() > 2000 ? 10 : 1;  // the judge is slower than what it judges
    for (auto _ : state)
        for (int i = 0; i < scene.steps; ++i) {
            if (scene.spin != 0) turn(now, scene.spin, engine);
            before.swap(now);
            const auto begin = std::chrono::steady_clock::now();
            engine.step();
            times.push_back(since(begin));
            engine.read(now);
            if (i == scene.steps / 2) half = now;
            bool finite = true;
            for (const Vec<3>& pose : now) finite = finite && pose.allFinite();
            if (!finite) {
                overlap = gap = infinity;
                break;
            }
            if (4 * i >= scene.steps && i % every == 0)
                overlap = std::max(overlap, judge.overlap(now));
            gap = std::max(gap, judge.gap(now));
            const Real height = judge.height(before, now, frame);
            lowest = std::min(lowest, height);
            gained = std::max(gained, height - lowest);
        }
    Real last = 0, all = 0;
    const std::size_t quarter = std::max<std::size_t>(times.size() / 4, 1);
    for (std::size_t i = 0; i < times.size(); ++i) {
        all += times[i];
        if (i + quarter >= times.size())
            last += times[i] / static_cast<Real>(quarter);
    }
    std::sort(times.begin(), times.end());
    state.counters["steps"] = static_cast<Real>(times.size());
    state.counters["us_step"] = times[times.size() / 2];
    state.counters["us_last"] = last;
    state.counters["ms_all"] = all / 1000;
    state.counters["overlap"] = overlap;
    state.counters["gap"] = gap;
    state.counters["crept"] = half.empty() ? infinity : judge.moved(half, now);
    state.counters["sunk"] = judge.moved(first, now);
    state.counters["gained"] = gained;
}

/// What is kept of a motion, and the time of its steps.
void keep(benchmark::State& state, World start, const kept::Scene& scene,
          const Engine& engine)
{
    begin_counters(state);
    const auto steps = static_cast<int>(std::lround(scene.seconds / frame));
    kept::Motion motion{std::move(start), {}, {}};
    const auto note = [&] {
        engine.read(motion.x.emplace_back());
        engine.read_velocities(motion.u.emplace_back());
    };
    note();
    Real all = 0;
    for (auto _ : state)
        for (int n = 1; n <= steps; ++n) {
            if (scene.driven != 0)
                engine.drive(0, {scene.driven * n * frame, 0}, 0);
            const auto begin = std::chrono::steady_clock::now();
            engine.step();
            all += since(begin);
            note();
        }
    const WorldJudge judge(motion.start);
    Real gap = 0;
    for (const Poses& x : motion.x) gap = std::max(gap, judge.gap(x));
    const Real value = scene.read(motion), error = std::abs(value - scene.right);
    state.SetLabel(scene.what);
    state.counters["steps"] = steps;
    state.counters["ms_all"] = all / 1000;
    state.counters["gap"] = gap;
    state.counters["right"] = scene.right;
    state.counters["kept"] = value;
    state.counters["error"] = error <= infinity ? error : infinity;
}

template <Solving solving>
void by_book(benchmark::State& state, World world, int substeps, const Run& run)
{
    WorldSettings settings = world.settings();
    settings.substeps = substeps;
    settings.solving = solving;
    world.change(settings);
    World start = World::load(world.save());
    World::load(world.save()).step(frame);  // warms up
    const std::vector<BodyId> ids = world.bodies();
    run(state, std::move(start),
        {[&] { world.step(frame); },
         [&](Poses& poses) {
             poses.clear();
             for (const BodyId id : ids)
                 poses.push_back({world.position(id).x(), world.position(id).y(),
                                  world.angle(id)});
         },
         [&](Poses& velocities) {
             velocities.clear();
             for (const BodyId id : ids)
                 velocities.push_back({world.velocity(id).x(),
                                       world.velocity(id).y(), world.spin(id)});
         },
         [&](std::size_t k, const Vec2& velocity, Real spin) {
             world.set_velocity(ids[k], velocity, spin);
         }});
}

template <class Peer>
void by_peer(benchmark::State& state, World start, int substeps, const Run& run)
{
    Peer(start, true, substeps).step(frame);  // warms up
    Peer peer(start, true, substeps);
    run(state, std::move(start),
        {[&] { peer.step(frame); }, [&](Poses& poses) { peer.read(poses); },
         [&](Poses& velocities) { peer.read_velocities(velocities); },
         [&](std::size_t k, const Vec2& velocity, Real spin) {
             peer.drive(k, velocity, spin);
         }});
}

/// The same run by every engine that is there, each by its own defaults.
void by_all(const std::string& name, const std::string& behind,
            const std::function<World()>& make, int substeps, const Run& run)
{
    const auto add = [&](const std::string& who, const auto& by) {
        benchmark::RegisterBenchmark(
            (name + "/" + who + behind).c_str(),
            [=](benchmark::State& state) { by(state, make(), substeps, run); })
            ->Iterations(1);
    };
    add("book", by_book<Solving::by_island>);
    add("book_sweeps", by_book<Solving::sweeps>);
#ifdef RIGID_HAS_BOX2D
    add("box2d", by_peer<Box2dPeer>);
#endif
#ifdef RIGID_HAS_BOX2D3
    add("box2d3", by_peer<Box2d3World>);
#endif
#ifdef RIGID_HAS_CHIPMUNK
    add("chipmunk", by_peer<ChipmunkWorld>);
#endif
}

void measure(const Scene& scene)
{
    for (const int substeps : {1, 4})
        by_all(scene.name, substeps == 1 ? "" : "/4", scene.make, substeps,
               [=](benchmark::State& state, World start, const Engine& engine) {
                   follow(state, start, scene, engine);
               });
}

void measure(const kept::Scene& scene)
{
    for (const int substeps : {1, 4, 16})
        by_all("kept/" + scene.name, "/" + std::to_string(substeps), scene.make,
               substeps,
               [=](benchmark::State& state, World start, const Engine& engine) {
                   keep(state, std::move(start), scene, engine);
               });
}

/// Each body that can move begins a little beside its place.
World unsettled(World world)
{
    Random random(1);
    const Real most = 1e-4 * world.settings().length;
    for (const BodyId id : world.bodies()) {
        const Real by = random.uniform(-most, most);
        if (world.mass(id) < infinity)
            world.move(id, world.position(id) + Vec2(by, 0), world.angle(id));
    }
    return world;
}

/// N bodies: some discs that roll on and on, and piles of five that sleep.
void cost_of(benchmark::State& state, int bodies, int rolling)
{
    begin_counters(state);
    World world = piles_world((bodies - rolling) / 5);
    for (int i = 0; i < rolling; ++i) {
        BodyDefinition disc_of = body_of(disc(0.25), {-2.0 - i, 0.25});
        disc_of.velocity = {-0.5, 0};
        disc_of.spin = 2;
        world.add_body(disc_of);
    }
    for (int i = 0; i < 60; ++i) world.step(frame);  // by then piles sleep
    std::vector<Real> times;
    for (auto _ : state)
        for (int i = 0; i < 20; ++i) {
            const auto begin = std::chrono::steady_clock::now();
            world.step(frame);
            times.push_back(since(begin));
        }
    std::sort(times.begin(), times.end());
    const StepWork& work = world.work();
    state.counters["us_step"] = times[times.size() / 2];
    state.counters["awake"] = work.awake;
    state.counters["contacts"] = work.contacts;
    state.counters["rows"] = work.rows;
    state.counters["visits"] = static_cast<Real>(work.visits);
    state.counters["tested"] = static_cast<Real>(work.tested);
}

const bool registered = [] {
#ifdef __GLIBC__
    mallopt(M_MMAP_THRESHOLD, 32 << 20);  // the most that it takes
    mallopt(M_TRIM_THRESHOLD, 1 << 30);
#endif
    const auto number = [](auto n) { return std::to_string(n); };
    for (const int base : {10, 20, 40, 100})
        measure({"pyramid_" + number(base),
                 [=] { return unsettled(pyramid_world(base)); },
                 base == 100 ? 60 : 240});
    measure({"house_4", [] { return house_world(4); }});
    for (const int boxes : {20, 40, 80})
        measure({"column_" + number(boxes),
                 [=] { return unsettled(column_world(boxes - 1)); }});
    measure({"heavy_1000_on_10", [] { return unsettled(column_world(10, 1000)); }});
    measure({"chain_50_1000", [] { return chain_world(50, 1000); }});
    measure({"bridge_30", [] { return bridge_world(30); }});
    measure({"grid_20", [] { return grid_world(20); }});
    measure({"grid_100", [] { return grid_world(100); }, 30});
    measure({"rubble_40", [] { return rubble_world(40, 1); }});
    measure({"poured_300", [] { return poured_world(300); }});
    measure({"poured_10000", [] { return poured_world(10000); }, 120});
    measure({"dolls_10", [] { return dolls_world(10); }});
    measure({"tumbler_40", [] { return tumbler_world(40, 0.5); }, 240, 0.5});
    measure({"piles_200", [] { return unsettled(piles_world(200)); }});
    measure({"piles_1000", [] { return unsettled(piles_world(1000)); }});
    measure({"boxes_1mm", [] { return unsettled(sized_pyramid_world(10, 1e-3)); }});
    measure({"boxes_100m", [] { return unsettled(sized_pyramid_world(10, 100)); }});
    for (const kept::Scene& scene : kept::scenes()) measure(scene);
    for (const int bodies : {100, 1000, 10000, 100000})
        for (const bool all : {false, true})
            benchmark::RegisterBenchmark(
                ((all ? "awake_" : "asleep_") + number(bodies) + "/book").c_str(),
                [=](benchmark::State& s) {
                    cost_of(s, bodies, all ? bodies : 100);
                })
                ->Iterations(1);
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
