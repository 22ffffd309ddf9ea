/// Chapter 10: what is left out, and what that saves.
///
///     broad/METHOD/SCENE/N     contacts of N discs: all pairs, sort and sweep, the grid anew, the pairs kept; the
///                              discs take a small step each time
///     sleepers/K               a step when K discs sleep and nobody is awake
///     beside/K                 a step of one pendulum beside K sleepers
///     plain/K                  chapter 8's step for the same K discs and the pendulum
///     pile/SLACK               a pile at rest and awake, one sweep; contacts keep their normal for so many micrometres
///     small/EXACT/HIT          a hundred islands of seven rows, at rest or hit, swept or solved exactly

#include "chapters/08_warm_starting/warm_step.hpp"
#include "chapters/10_skipping_work/skipping_scenes.hpp"
#include "chapters/10_skipping_work/skipping_step.hpp"
#include "chapters/10_skipping_work/sort_and_sweep.hpp"

#include <benchmark/benchmark.h>

#include <functional>
#include <map>
#include <string>

using namespace rigid;

namespace {

constexpr Real margin = 0.02;

DiscScene scene_of(const std::string& name, Index N)
{
    if (name == "sparse") return scattered(N, 0.1, 1, 1);
    if (name == "dense") return scattered(N, 0.7, 1, 1);
    if (name == "sizes") return scattered(N, 0.3, 100, 1);
    return scattered(N, 0.3, 1, 1, std::sqrt(0.3 * static_cast<Real>(N)));  // line: one disc high
}

/// A breath of wind: sixteen places of every disc on a small circle, 2 mm from one to the next.
std::vector<VecX> breath(const DiscScene& scene)
{
    std::vector<VecX> places(16, scene.bodies.x);
    for (std::size_t step = 0; step < places.size(); ++step)
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Real phase = 0.7 * static_cast<Real>(k) + pi / 8 * static_cast<Real>(step);
            places[step].segment<2>(2 * k) += 0.005 * Vec2(std::cos(phase), std::sin(phase));
        }
    return places;
}

void broad(benchmark::State& state, const std::string& method, const std::string& name)
{
    const auto N = static_cast<Index>(state.range(0));
    DiscScene scene = scene_of(name, N);
    AwakeSet set = everybody_awake(scene.bodies);
    BroadPhase phase;
    phase.margin = margin;
    phase.skin = method == "kept" ? 0.01 : 0;
    phase.reset(scene, {});
    SortAndSweep memory;
    std::vector<Contact> contacts;
    std::vector<std::uint64_t> pairs;
    std::int64_t tested = 0, found = 0, rounds = 0;
    std::size_t step = 0;
    const auto one_round = [&] {
        if (method == "all") {
            find_contacts(scene.bodies.x, scene.radius, scene.walls, {}, margin, contacts);
            tested += N * (N - 1) / 2;
        } else if (method == "sweep") {
            pairs.clear();
            sort_and_sweep(scene.bodies.x, scene.radius, margin, 0, memory,
                           [&](int a, int b) { pairs.push_back(pair_code(a, b)); });
            std::sort(pairs.begin(), pairs.end());
            contacts.clear();
            Contact contact;
            for (const std::uint64_t pair : pairs)
                if (disc_contact(scene.bodies.x, scene.radius, first_of(pair), second_of(pair), margin,
                                 contact))
                    contacts.push_back(contact);
            tested += memory.tested;
        } else {
            if (method == "grid") phase.reset(scene, {});

            update_pairs(scene, set, phase);
            awake_contacts(scene, set, phase, contacts);
            tested += phase.tested;
        }
        found += static_cast<std::int64_t>(contacts.size());
        ++rounds;
    };
    one_round();
    tested = found = rounds = 0;
    const std::vector<VecX> places = breath(scene);
    for (auto _ : state) {
        scene.bodies.x = places[step++ % places.size()];
        one_round();
    }
    state.counters["tested_per_disc"] = static_cast<Real>(tested) / static_cast<Real>(rounds * N);
    state.counters["contacts_per_disc"] = static_cast<Real>(found) / static_cast<Real>(rounds * N);
    state.counters["us"] = 0;
}

/// A field whose discs have all fallen asleep, with or without its pendulum.
SkippingWorld asleep(Index sleepers, bool pendulum, const SkippingSettings& settings)
{
    DiscScene scene = field(sleepers);
    if (!pendulum) scene.bodies.inverse_mass.segment<2>(2).setZero();
    CollisionFilter filter = filter_of_links(scene.bodies.count(), scene.links);
    SkippingWorld now = make_world(std::move(scene), std::move(filter));
    for (int i = 0; i < 200; ++i) skipping_step(now, settings);
    return now;
}

SkippingSettings early_out()
{
    SkippingSettings settings;
    settings.sweeps.max_sweeps = 30;
    settings.sweeps.tolerance = 1e-6;
    return settings;
}

void sleepers(benchmark::State& state, bool pendulum)
{
    const SkippingSettings settings = early_out();
    SkippingWorld now = asleep(static_cast<Index>(state.range(0)), pendulum, settings);
    for (auto _ : state) skipping_step(now, settings);
    state.counters["tested_per_disc"] = 0;
    state.counters["contacts_per_disc"] = 0;
    state.counters["us"] = 0;
    if (now.counters.awake != (pendulum ? 1 : 0)) state.SkipWithError("somebody is awake");
}

void plain(benchmark::State& state)
{
    DiscScene scene = field(static_cast<Index>(state.range(0)));
    link_neighbours(scene);
    WarmStepSettings settings;
    settings.sweeps = early_out().sweeps;
    settings.order = Order::coloured;
    WarmStep now;
    for (auto _ : state) warm_step(scene, settings, now);
    state.counters["tested_per_disc"] = 0;
    state.counters["contacts_per_disc"] = 0;
    state.counters["us"] = 0;
}

void small(benchmark::State& state)
{
    const DiscScene scene = pockets(100);
    SkippingSettings settings = early_out();
    settings.sleep = false;
    settings.sweeps.tolerance = 1e-8;
    settings.sweeps.max_sweeps = 1000;
    settings.exact_rows = static_cast<int>(state.range(0));
    SkippingWorld now = make_world(scene, {});
    for (int i = 0; i < 10; ++i) skipping_step(now, settings);
    Real round = 0;
    for (auto _ : state) {
        if (state.range(1) != 0) {
            now.scene.bodies.x = scene.bodies.x;
            for (Index i = 0; i < 100; ++i)
                now.scene.bodies.velocity(5 * i + 4) =
                    Vec2(std::sin(static_cast<Real>(i) + round), -2 + std::cos(1.7 * round));
        }
        skipping_step(now, settings);
        ++round;
    }
    state.counters["tested_per_disc"] = now.counters.sweeps;
    state.counters["contacts_per_disc"] = now.counters.exact;
    state.counters["us"] = static_cast<Real>(now.counters.visits);
}

/// The rain of 2,000 discs, come to rest and kept awake.
void pile(benchmark::State& state)
{
    SkippingSettings settings = early_out();
    settings.h = 1.0 / 120;
    settings.sleep = false;
    settings.stabilizer.slop = 5e-4;
    settings.stabilizer.fastest = 1;
    settings.sweeps.tolerance = 1e-5;
    SkippingWorld now = make_world(rain_on_hills(2000, 1), {}, 0.03);
    for (int i = 0; i < 2400; ++i) skipping_step(now, settings);
    settings.row_slack = 1e-6 * static_cast<Real>(state.range(0));
    settings.sweeps.max_sweeps = 1;
    for (int i = 0; i < 20; ++i) skipping_step(now, settings);
    for (auto _ : state) skipping_step(now, settings);
    state.counters["tested_per_disc"] = now.counters.rows;
    state.counters["contacts_per_disc"] = now.counters.kept_rows;
    state.counters["us"] = now.counters.sweeps;
}

void add_all()
{
    for (const std::string name : {"sparse", "dense", "sizes", "line"})
        for (const std::string method : {"all", "sweep", "grid", "kept"}) {
            auto* const one = benchmark::RegisterBenchmark(
                ("broad/" + method + "/" + name).c_str(),
                [method, name](benchmark::State& state) { broad(state, method, name); });
            one->Unit(benchmark::kMicrosecond)->MinTime(0.05);
            for (const int N : {30, 100, 300, 1000, 3000, 10000, 30000, 100000})
                if (method != "all" || N <= 10000) one->Arg(N);
        }
    for (const bool pendulum : {false, true}) {
        auto* const one =
            benchmark::RegisterBenchmark(pendulum ? "beside" : "sleepers",
                                         [pendulum](benchmark::State& state) { sleepers(state, pendulum); });
        one->Unit(benchmark::kMicrosecond)->MinTime(0.05);
        for (const int K : {0, 1, 10, 100, 1000, 10000}) one->Arg(K);
    }
    auto* const without = benchmark::RegisterBenchmark("plain", plain);
    without->Unit(benchmark::kMicrosecond)->MinTime(0.05);
    for (const int K : {0, 1, 10, 100, 1000, 5000}) without->Arg(K);
    auto* const rows = benchmark::RegisterBenchmark("pile", pile);
    rows->Unit(benchmark::kMicrosecond)->MinTime(0.1);
    for (const int micrometres : {0, 1, 10, 100, 1000}) rows->Arg(micrometres);
    auto* const few = benchmark::RegisterBenchmark("small", small);
    few->Unit(benchmark::kMicrosecond)->MinTime(0.05);
    for (const int exact : {0, 12})
        for (const int hit : {0, 1}) few->Args({exact, hit});
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
