/// Chapter 8: run time against error, beside other engines.
///
///     engines/SCENE/WHO   each of engine_scenes() under two presets of small_steps(), the quick one without its long
///                         first step, step() by WarmMethod with the same settings, Box2D and Chipmunk, and these
///                         two with as many small steps: in turns, 1000 steps of 1/60 s from the beginning, the
///                         fastest of several runs; and the errors of the positions, by the same code for all
///     visit/…             nanoseconds for a visit of a row, in scene order and coloured, against the rows
///
/// At the end a table says for each scene which preset is no slower than the faster of the peers at no larger an
/// error than the more accurate one. Times are of this process's CPU.

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

#include <array>
#include <cstdio>
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

/// A world of another program.
template <class World>
struct Peer : Engine {
    World world;
    int substeps;
    Peer(const EngineScene& from, int count) : world(from), substeps(count) {}
    void step() override { world.step(h, substeps); }
    void poses(DiscScene& scene) const override { world.poses(scene); }
};

struct SmallSteps : Engine {
    DiscScene scene;
    SmallStepSettings settings;
    SmallStep now;
    SmallSteps(const EngineScene& from, SmallStepSettings preset) : scene(from.scene), settings(preset)
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
    WarmSteps(const EngineScene& from, const SmallStepSettings& preset) : scene(from.scene)
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
    Real sweeps() const override { return settings.substeps * method.solver.sweeps.max_sweeps; }
};

SmallStepSettings without_first(SmallStepSettings preset)
{
    preset.first_sweeps = 0;
    return preset;
}

struct Contestant {
    std::string name;
    std::function<std::unique_ptr<Engine>(const EngineScene&)> make;
    bool peer = false, preset = false;
};

template <class World>
void add_peer(std::vector<Contestant>& all, const std::string& name, int substeps)
{
    all.push_back(
        {name, [substeps](const EngineScene& from) { return std::make_unique<Peer<World>>(from, substeps); },
         substeps == 1});
}

std::vector<Contestant> all_contestants()
{
    std::vector<Contestant> all;
    const auto add_ours = [&](const std::string& name, const SmallStepSettings& settings, bool preset) {
        all.push_back(
            {name,
             [settings](const EngineScene& from) { return std::make_unique<SmallSteps>(from, settings); },
             false, preset});
    };
    add_ours("quick", quick_steps(), true);
    add_ours("careful", careful_steps(), true);
    add_ours("quick_cold", without_first(quick_steps()), false);
    all.push_back({"warm_step",
                   [](const EngineScene& from) { return std::make_unique<WarmSteps>(from, quick_steps()); }});
    // As they are used, which is what the table compares with; and with as many small steps as quick_steps().
    const int small = quick_steps().substeps;
#ifdef RIGID_HAS_BOX2D
    add_peer<Box2dWorld>(all, "box2d", 1);
    add_peer<Box2dWorld>(all, "box2d_small", small);
#endif
#ifdef RIGID_HAS_CHIPMUNK
    add_peer<ChipmunkSpace>(all, "chipmunk", 1);
    add_peer<ChipmunkSpace>(all, "chipmunk_small", small);
#endif
    (void)small;
    return all;
}

// ---- measuring ----------------------------------------------------------------------------------

struct Measured {
    Real us = infinity;  ///< a step, the fastest run
    Real sweeps = 0;     ///< a step, the mean
    PoseErrors errors;
};

/// All contestants on one scene. Errors from a run of their own; times in turns, so that none has the quiet minute.
std::map<std::string, Measured> measure(const EngineScene& scene, const std::vector<Contestant>& contestants)
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
    for (int round = 0; round < 15 && (round < 3 || cpu_seconds() - begin < 0.5); ++round)
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
        const int repeats = static_cast<int>(1 + 4000000 / (s.bodies.count() * s.bodies.count() + 1000));
        const Real start = cpu_seconds();
        for (int k = 0; k < repeats; ++k) find_contacts(s, SmallStepSettings{}.margin, contacts);
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
    for (const char* name : {"pairs_us", "sweeps", "link_mm", "overlap_mm", "late_mm", "drift_mm",
                             "speed_mm_s", "in_order", "rows", "ns_per_visit"})
        state.counters[name] = 0;
    for (const auto& [name, value] : counters) state.counters[name] = std::min<Real>(value, 1e300);
}

void engines(benchmark::State& state, const EngineScene& scene, const std::string& who)
{
    for (auto _ : state) {
        if (results.count(scene.name) == 0)
            results[scene.name] = {measure(scene, all_contestants()), pairs_us(scene)};
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

/// A hanging chain without the table of pairs, which has K² entries.
DiscScene long_chain(Index count)
{
    DiscScene scene;
    scene.bodies = Bodies<2>(count + 1);
    scene.bodies.inverse_mass.head<2>().setZero();
    for (Index k = 0; k <= count; ++k) scene.bodies.position(k) << 0, -0.1 * static_cast<Real>(k);
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
        refresh(scene.bodies.x, scene.bodies.inverse_mass, now.rest[k], now.rows[k]);
        now.rows[k].bias = -1e-3;  // something to do
    }
    for (auto _ : state) {
        for (SolverRow<2>& row : now.rows) visit(row, now.u);
        benchmark::ClobberMemory();
    }
    count(state, {{"rows", static_cast<Real>(now.rows.size())}});
    state.counters["ns_per_visit"] =
        benchmark::Counter(static_cast<Real>(now.rows.size()) * 1e-9,
                           benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

// ---- the table ----------------------------------------------------------------------------------

/// What is measured of the positions, in mm and mm/s. What is right to 0.001 mm counts as right: floats of metres
/// hold no more.
std::array<Real, 4> judged(const EngineScene& scene, const PoseErrors& e)
{
    std::array<Real, 4> errors = {1e3 * e.position(), 1e3 * e.late, 1e3 * e.drift,
                                  scene.rests ? 1e3 * e.speed : 0};
    for (Real& error : errors) error = std::max(error, Real{1e-3});
    return errors;
}

struct Verdict {
    std::string preset;  ///< the fastest that wins; if none does, the fastest that keeps the order
    bool wins = false;   ///< it is no slower than the fastest peer, and no error is larger than any peer's
};

Verdict judge(const EngineScene& scene, const std::map<std::string, Measured>& all)
{
    Real fastest = infinity;
    std::array<Real, 4> least;
    least.fill(infinity);
    for (const Contestant& peer : all_contestants()) {
        if (!peer.peer) continue;
        fastest = std::min(fastest, all.at(peer.name).us);
        const auto errors = judged(scene, all.at(peer.name).errors);
        for (std::size_t i = 0; i < errors.size(); ++i) least[i] = std::min(least[i], errors[i]);
    }
    Verdict verdict;
    for (const Contestant& ours : all_contestants()) {  // the presets come from fast to slow
        if (!ours.preset) continue;
        const Measured& m = all.at(ours.name);
        const auto errors = judged(scene, m.errors);
        bool wins = m.errors.in_order && m.us <= fastest;
        for (std::size_t i = 0; i < errors.size(); ++i) wins = wins && errors[i] <= least[i];
        if (verdict.wins || (!wins && !verdict.preset.empty() && !m.errors.in_order)) continue;
        if (wins || verdict.preset.empty() || !all.at(verdict.preset).errors.in_order)
            verdict = {ours.name, wins};
    }
    return verdict;
}

/// A number of three digits, with a mark if discs changed places.
std::string cell(const std::map<std::string, Measured>& all, const std::string& who, Real PoseErrors::*which)
{
    const auto found = all.find(who);
    if (found == all.end()) return "–";
    const PoseErrors& e = found->second.errors;
    const Real value = 1e3 * (which ? e.*which : e.position());
    char text[40];
    if (!(value < 1e6)) std::snprintf(text, sizeof text, "> 1 km");
    else if (value < 1e-3) std::snprintf(text, sizeof text, "< 0.001");
    else std::snprintf(text, sizeof text, value < 1000 ? "%.3g" : "%.0f", value);
    return text + std::string(e.in_order ? "" : " ✗");
}

void print_table()
{
    int won = 0, scenes = 0;
    std::printf("\n| scene | preset | µs a step | Box2D | Chipmunk | error, mm | Box2D | Chipmunk | drift, "
                "mm | Box2D "
                "| Chipmunk | wins |\n|---|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const EngineScene& scene : engine_scenes()) {
        const auto found = results.find(scene.name);
        if (found == results.end()) continue;
        const std::map<std::string, Measured>& all = found->second.measured;
        const Verdict verdict = judge(scene, all);
        ++scenes;
        won += verdict.wins ? 1 : 0;
        const std::array<std::string, 3> who = {verdict.preset, "box2d", "chipmunk"};
        std::printf("| %s | %s |", scene.name.c_str(), verdict.preset.c_str());
        for (const std::string& one : who)
            if (all.count(one)) std::printf(" %.*f |", all.at(one).us < 100 ? 2 : 0, all.at(one).us);
            else std::printf(" – |");
        for (const std::string& one : who) std::printf(" %s |", cell(all, one, nullptr).c_str());
        for (const std::string& one : who) std::printf(" %s |", cell(all, one, &PoseErrors::drift).c_str());
        std::printf(" %s |\n", verdict.wins ? "yes" : "no");
    }
    std::printf("\nA preset wins in %d of %d scenes: no slower than the faster peer, and no less exact than "
                "the more exact "
                "one in the largest error\nof a length or a gap, the same in the second half of the steps, "
                "the drift of the "
                "centre of mass, and the speed at rest.\n✗: discs changed places or flew away. quick: %d "
                "substeps, careful: "
                "%d, one sweep in each; the first may make %d and %d.\n",
                won, scenes, quick_steps().substeps, careful_steps().substeps, quick_steps().first_sweeps,
                careful_steps().first_sweeps);
    if (results.count("triangle_40"))
        std::printf("Our times hold a test of all pairs of discs: %.0f µs of those of triangle_40. Chapter "
                    "10 saves it.\n",
                    results["triangle_40"].pairs);
}

void add_all()
{
    static const std::vector<EngineScene> scenes = engine_scenes();
    for (const EngineScene& scene : scenes)
        for (const Contestant& contestant : all_contestants())
            benchmark::RegisterBenchmark(
                ("engines/" + scene.name + "/" + contestant.name).c_str(),
                [&scene, who = contestant.name](benchmark::State& state) { engines(state, scene, who); })
                ->UseManualTime()
                ->Iterations(1)
                ->Unit(benchmark::kMicrosecond);
    for (const bool pile : {false, true})
        for (const bool coloured : {false, true}) {
            const std::string name =
                std::string("visit/") + (pile ? "triangle/" : "chain/") + (coloured ? "coloured" : "given");
            auto* const one = benchmark::RegisterBenchmark(name.c_str(), visits, pile, coloured);
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
    if (!results.empty()) print_table();
    benchmark::Shutdown();
}
