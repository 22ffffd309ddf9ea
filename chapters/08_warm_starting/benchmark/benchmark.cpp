/// Chapter 8: run time against error, beside other engines.
///
///     engines/SCENE/WHO   each of engine_scenes() under two presets of small_steps(), both with 32 small steps too, the
///                         quick one without its long first step, step() by WarmMethod with the same settings, Box2D
///                         and Chipmunk with their own numbers of iterations, and both with 8 and 32 small steps of
///                         one iteration: in turns, 1000 steps of 1/60 s from the beginning, the fastest of several
///                         runs; and the errors of the positions, by the same code for all
///     visit/…             nanoseconds for a visit of a row, in scene order and coloured, against the rows
///
/// make_table.py beside this file says of each scene which preset is no slower than the faster of the peers at no larger
/// an error than the more accurate one: with the peers as they are used, and with equal small steps on both sides. Times
/// are of this process's CPU.

#include "chapters/08_warm_starting/benchmark/pose_errors.hpp"
#include "chapters/08_warm_starting/small_steps.hpp"
#include "chapters/08_warm_starting/warm_method.hpp"
#ifdef RIGID_HAS_BOX2D
#include "chapters/08_warm_starting/benchmark/peers_box2d.hpp"
#endif
#ifdef RIGID_HAS_CHIPMUNK
#include "chapters/08_warm_starting/benchmark/peers_chipmunk.hpp"
#endif

#include <benchmark/benchmark.h>

#include <ctime>
#include <functional>
#include <map>
#include <memory>

using namespace rigid;

namespace {

constexpr int steps = 1000;
constexpr Real h = 1.0 / 60;

/// Seconds of CPU time that this process has used.
Real cpu_seconds() { return static_cast<Real>(std::clock()) / CLOCKS_PER_SEC; }

// ---- the contestants ----------------------------------------------------------------------------

struct Engine {
    virtual ~Engine() = default;
    virtual void step() = 0;
    virtual void poses(DiscScene& scene) const = 0;
    virtual Real sweeps() const { return 0; }  ///< of the last step
};

/// What the peers leave alone [m]: in piles a twentieth of a millimetre, so that it is not the slop that decides.
[[maybe_unused]] Real peer_slop(const EngineScene& scene)
{
    return scene.collides ? 5e-5 : PeerSettings{}.slop;
}

/// A world of another program.
template <class World>
struct Peer : Engine {
    World world;
    int substeps;
    Peer(const EngineScene& from, int count)
        : world(from, {.slop = peer_slop(from)}), substeps(count)
    {
    }
    void step() override { world.step(h, substeps); }
    void poses(DiscScene& scene) const override { world.poses(scene); }
};

struct SmallSteps : Engine {
    DiscScene scene;
    SmallStepSettings settings;
    SmallStep now;
    SmallSteps(const EngineScene& from, SmallStepSettings preset)
        : scene(from.scene), settings(preset)
    {
        settings.h = h;
        settings.collides = from.collides;
    }
    void step() override { small_steps(scene, settings, now); }
    void poses(DiscScene& to) const override { to.bodies.x = scene.bodies.x; }
    Real sweeps() const override { return now.sweeps; }
};

struct WarmSteps : Engine {
    DiscScene scene;
    StepSettings settings;
    WarmMethod method;
    StepData<2> now;
    WarmSteps(const EngineScene& from, const SmallStepSettings& preset)
        : scene(from.scene)
    {
        settings.h = h;
        settings.substeps = preset.substeps;
        static_cast<StabilizerSettings&>(method.correction) = preset.correction;
        method.correction.at_the_end = true;
        method.start.from = Start::best_multiple;
        method.start.rule = preset.start;
        method.solver.sweeps.max_sweeps = preset.sweeps;
        method.solver.ordering = Order::coloured;
    }
    void step() override { rigid::step(scene, settings, method, now); }
    void poses(DiscScene& to) const override { to.bodies.x = scene.bodies.x; }
    Real sweeps() const override
    {
        return settings.substeps * method.solver.sweeps.max_sweeps;
    }
};

SmallStepSettings with_substeps(SmallStepSettings preset, int substeps)
{
    preset.substeps = substeps;
    return preset;
}

SmallStepSettings without_first(SmallStepSettings preset)
{
    preset.first_sweeps = 0;
    return preset;
}

struct Contestant {
    std::string name;
    std::function<std::unique_ptr<Engine>(const EngineScene&)> make;
};

template <class World>
void add_peer(std::vector<Contestant>& all, const std::string& name, int substeps)
{
    all.push_back({name, [substeps](const EngineScene& from) {
                       return std::make_unique<Peer<World>>(from, substeps);
                   }});
}

std::vector<Contestant> all_contestants()
{
    std::vector<Contestant> all;
    const auto add_ours = [&](const std::string& name,
                              const SmallStepSettings& settings) {
        all.push_back({name, [settings](const EngineScene& from) {
                           return std::make_unique<SmallSteps>(from, settings);
                       }});
    };
    add_ours("quick", quick_steps());
    add_ours("careful", careful_steps());
    add_ours("quick_32", with_substeps(quick_steps(), 32));
    add_ours("careful_32", with_substeps(careful_steps(), 32));
    add_ours("quick_cold", without_first(quick_steps()));
    all.push_back({"warm_step", [](const EngineScene& from) {
                       return std::make_unique<WarmSteps>(from, quick_steps());
                   }});
    // As they are used, and with small steps of one iteration.
#ifdef RIGID_HAS_BOX2D
    add_peer<Box2dWorld>(all, "box2d", 1);
    add_peer<Box2dWorld>(all, "box2d_8", 8);
    add_peer<Box2dWorld>(all, "box2d_32", 32);
#endif
#ifdef RIGID_HAS_CHIPMUNK
    add_peer<ChipmunkSpace>(all, "chipmunk", 1);
    add_peer<ChipmunkSpace>(all, "chipmunk_8", 8);
    add_peer<ChipmunkSpace>(all, "chipmunk_32", 32);
#endif
    return all;
}

// ---- measuring ----------------------------------------------------------------------------------

struct Measured {
    Real us = infinity;  ///< a step, the fastest run
    Real sweeps = 0;     ///< a step, the mean
    PoseErrors errors;
};

/// All contestants on one scene. Errors from a run of their own; times in turns, so that none has the quiet minute.
std::map<std::string, Measured> measure(const EngineScene& scene,
                                        const std::vector<Contestant>& contestants)
{
    std::map<std::string, Measured> all;
    for (const Contestant& contestant : contestants) {
        const auto engine = contestant.make(scene);
        PoseWatch watch(scene, steps, h);
        DiscScene poses = scene.scene;
        Measured& measured = all[contestant.name];
        for (int k = 0; k < steps; ++k) {
            engine->step();
            engine->poses(poses);
            watch.look(poses);
            measured.sweeps += engine->sweeps() / steps;
        }
        measured.errors = watch.errors;
    }
    const Real begin = cpu_seconds();
    for (int round = 0; round < 15 && (round < 3 || cpu_seconds() - begin < 0.5);
         ++round)
        for (const Contestant& contestant : contestants) {
            const auto engine = contestant.make(scene);
            const Real start = cpu_seconds();
            for (int k = 0; k < steps; ++k) engine->step();
            Real& us = all[contestant.name].us;
            us = std::min(us, (cpu_seconds() - start) * 1e6 / steps);
        }
    return all;
}

/// How long it takes to test all pairs of this scene [µs]: what chapter 10 will save.
Real pairs_us(const EngineScene& scene)
{
    if (!scene.collides) return 0;
    std::vector<Contact> contacts;
    const DiscScene& s = scene.scene;
    Real best = infinity;
    for (int round = 0; round < 5; ++round) {
        const int repeats = static_cast<int>(
            1 + 4000000 / (s.bodies.count() * s.bodies.count() + 1000));
        const Real start = cpu_seconds();
        for (int k = 0; k < repeats; ++k)
            find_contacts(s, SmallStepSettings{}.margin, contacts);
        best = std::min(best, (cpu_seconds() - start) * 1e6 / repeats);
    }
    return best;
}

struct SceneResult {
    std::map<std::string, Measured> measured;
    Real pairs = 0;
};
std::map<std::string, SceneResult> results;

// ---- as benchmarks ------------------------------------------------------------------------------

using Counters = std::initializer_list<std::pair<const char*, Real>>;

/// A table has the same counters in each row.
void count(benchmark::State& state, Counters counters)
{
    for (const char* name :
         {"pairs_us", "sweeps", "link_mm", "overlap_mm", "late_mm", "drift_mm",
          "speed_mm_s", "in_order", "rows", "ns_per_visit"})
        state.counters[name] = 0;
    for (const auto& [name, value] : counters)
        state.counters[name] = std::min<Real>(value, 1e300);
}

void engines(benchmark::State& state, const EngineScene& scene,
             const std::string& who)
{
    for (auto _ : state) {
        if (results.count(scene.name) == 0)
            results[scene.name] = {measure(scene, all_contestants()),
                                   pairs_us(scene)};
        state.SetIterationTime(results[scene.name].measured[who].us * 1e-6);
    }
    const Measured& m = results[scene.name].measured[who];
    const PoseErrors& e = m.errors;
    count(state, {{"pairs_us", results[scene.name].pairs},
                  {"sweeps", m.sweeps},
                  {"link_mm", 1e3 * e.link},
                  {"overlap_mm", 1e3 * e.overlap},
                  {"late_mm", 1e3 * e.late},
                  {"drift_mm", 1e3 * e.drift},
                  {"speed_mm_s", 1e3 * e.speed},
                  {"in_order", e.in_order ? 1.0 : 0.0}});
}

/// A hanging chain of which nothing collides.
DiscScene long_chain(Index count)
{
    DiscScene scene;
    scene.bodies = Bodies<2>(count + 1);
    scene.bodies.inverse_mass.head<2>().setZero();
    scene.radius = VecX::Constant(count + 1, 0.05);
    for (Index k = 0; k <= count; ++k)
        scene.bodies.position(k) << 0, -0.1 * static_cast<Real>(k);
    for (Index k = 0; k < count; ++k) scene.links.push_back({k, k + 1, 0.1});
    return scene;
}

/// Sweeps over the rows of a chain or a triangle, prepared once.
void visits(benchmark::State& state, bool pile, bool coloured)
{
    const Index size = state.range(0);
    const auto base = static_cast<Index>(std::sqrt(static_cast<Real>(size) / 1.5));
    const DiscScene scene = pile ? triangle(base) : long_chain(size);
    SmallStepSettings settings;
    settings.coloured = coloured;
    settings.collides = pile;
    SmallStep now;
    begin_rows(scene, settings, now);
    now.u = VecX::Zero(scene.bodies.u.size());
    for (std::size_t k = 0; k < now.rows.size(); ++k) {
        refresh(scene.bodies.x, scene.bodies.inverse_mass, now.rest[k],
                now.rows[k]);
        now.rows[k].bias = -1e-3;  // something to do
    }
    for (auto _ : state) {
        for (SolverRow<2>& row : now.rows) visit(row, now.u);
        benchmark::ClobberMemory();
    }
    count(state, {{"rows", static_cast<Real>(now.rows.size())}});
    state.counters["ns_per_visit"] =
        benchmark::Counter(static_cast<Real>(now.rows.size()) * 1e-9,
                           benchmark::Counter::kIsIterationInvariantRate |
                               benchmark::Counter::kInvert);
}

void add_all()
{
    static const std::vector<EngineScene> scenes = engine_scenes();
    for (const EngineScene& scene : scenes)
        for (const Contestant& contestant : all_contestants())
            benchmark::RegisterBenchmark(
                ("engines/" + scene.name + "/" + contestant.name).c_str(),
                [&scene, who = contestant.name](benchmark::State& state) {
                    engines(state, scene, who);
                })
                ->UseManualTime()
                ->Iterations(1)
                ->Unit(benchmark::kMicrosecond);
    for (const bool pile : {false, true})
        for (const bool coloured : {false, true}) {
            const std::string name = std::string("visit/") +
                                     (pile ? "triangle/" : "chain/") +
                                     (coloured ? "coloured" : "given");
            auto* const one =
                benchmark::RegisterBenchmark(name.c_str(), visits, pile, coloured);
            one->Unit(benchmark::kMicrosecond)->MinTime(0.1);
            for (const Index rows : {100, 300, 1000, 3000, 10000}) one->Arg(rows);
            if (!pile) one->Arg(30000)->Arg(100000);
        }
}

}  // namespace

int main(int argc, char** argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
    add_all();
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
}
