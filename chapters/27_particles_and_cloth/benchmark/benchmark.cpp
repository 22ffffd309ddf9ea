/// Chapter 27: all methods on three scenes, run time against error.
///
///     SCENE/METHOD/SUBSTEPS   time of a step of 1/60 s [µs]; after half a second: the root of the mean square of the way to
///                             the reference [m], the error of the mean stretch, as a part of it, and that of the energy, as a
///                             part of the kinetic energy of the reference; rows visited in a step
///
///     net/METHOD/SUBSTEPS     the same of a net of threads that do not stretch, by methods of rows; stretch is the largest
///
///     threads/factor/SQUARES  a step of such a net with exact rows: its median time [µs], systems in a step, numbers of the
///                             factor for each row, bytes for each particle
///
///     weight/MODEL/100 Γ      a strip that is clamped level under its weight, and `end/…` under a load at its end: height over
///                             width, and which part of its EI it shows. No times: the numbers of each run are the same
///
/// `bt_soft` and `bt_deformable` are Bullet's two kinds of cloth, where that is installed; of the second one and ten of its
/// iterations of Newton's method. What the reference is and how many sweeps a method has: cloth_compare.hpp.

#include "chapters/27_particles_and_cloth/benchmark/cloth_compare.hpp"
#include "chapters/27_particles_and_cloth/cloth_scenes.hpp"
#include "chapters/27_particles_and_cloth/program/strips.hpp"
#include "tests/peers/bullet_cloth.hpp"

#include <map>
#include <utility>
#include <vector>

using namespace rigid;
using namespace rigid::cloth_compare;

namespace {

ClothScene given(const std::string& name)
{
    if (name == "sheet") return hung_sheet(12, 500);
    if (name == "flag") return flag(12, 500, 6);
    ClothScene strip = clamped_strip(16, 2, Bending::quadratic, true);
    for (ClothSpring& s : strip.springs) s.stiffness = 1e4;
    strip.gravity = {0, -5, 0};
    return strip;
}

const ClothScene& exact(const std::string& scene)
{
    static std::map<std::string, ClothScene> known;
    if (!known.contains(scene))
        known.emplace(scene, reference<ClothMemory>(given(scene)));
    return known.at(scene);
}

const ClothScene& exact_net()
{
    static const ClothScene known = hard_reference<ClothMemory>(hung_net(12));
    return known;
}

void net(benchmark::State& state, const std::string& method)
{
    Found<ClothScene> found;
    const int substeps = static_cast<int>(state.range(0));
    for (auto _ : state)
        found =
            run<ClothMemory>(hung_net(12), settings_of(method, substeps), steps);
    report(state, found, exact_net());
    const Real largest = largest_stretch(found.cloth);
    state.counters["largest"] = found.lost ? infinity : 100 * largest;
    state.counters["stretch"] = found.lost ? infinity : largest;
}

void threads(benchmark::State& state)
{
    const int squares = static_cast<int>(state.range(0));
    std::vector<Real> times;
    Real systems = 0, entries = 0, bytes = 0;
    for (auto _ : state) {
        ClothScene cloth = hung_net(squares);
        const Real rows = static_cast<Real>(cloth.springs.size());
        const Real before = bytes_held();
        ClothMemory memory;
        memory.exact.tolerance = 1e-8;
        const ClothSettings how = settings_of("exact", 1);
        const int count = squares > 50 ? 5 : 20;
        for (int n = 0; n < count; ++n) {
            const std::clock_t start = std::clock();
            step(cloth, how, memory);
            times.push_back(static_cast<Real>(std::clock() - start) /
                            CLOCKS_PER_SEC);
        }
        systems = static_cast<Real>(memory.solves) / count;
        entries = static_cast<Real>(memory.exact.entries()) / rows;
        bytes = (bytes_held() - before) / cloth.count();
    }
    std::sort(times.begin(), times.end());
    report(state, {.us = 1e6 * times[times.size() / 2],
                   .solves = systems,
                   .particles = static_cast<Real>((squares + 1) * (squares + 1)),
                   .entries = entries,
                   .bytes = bytes});
}

/// The models of bending of Figure 27.5, and the elastica itself.
const std::vector<std::pair<const char*, StripSpec>> models{
    {"elastica", {}},
    {"lines", {.model = 0}},
    {"edges", {.model = 2}},
    {"edges_rise", {.model = 2, .alternate = false}},
    {"edges_stiff_diagonals", {.model = 2, .diagonals = 1e4}},
    {"angles", {.model = 1}},
    {"angles_rise", {.model = 1, .alternate = false}},
    {"angles_stiff_diagonals", {.model = 1, .diagonals = 1e4}},
    {"across", {.model = 3, .segments = 8}}};

void bend(benchmark::State& state, int model, bool at_the_end)
{
    const auto& [name, spec] = models[static_cast<std::size_t>(model)];
    const Real load = static_cast<Real>(state.range(0)) / 100;
    Real ratio = 0;
    for (auto _ : state)
        ratio = model == 0 ? elastica(load, at_the_end).height_over_width()
                           : height_over_width(spec, load, at_the_end);
    report(state, {.height = ratio, .as_stiff = as_stiff(ratio, load, at_the_end)});
}

const bool registered = [] {
    for (const bool at_the_end : {false, true})
        for (int model = 0; model < static_cast<int>(models.size()); ++model) {
            auto* const one = benchmark::RegisterBenchmark(
                (std::string(at_the_end ? "end/" : "weight/") +
                 models[static_cast<std::size_t>(model)].first)
                    .c_str(),
                [=](benchmark::State& state) { bend(state, model, at_the_end); });
            for (const int load : {10, 20, 50, 100, 200, 500, 1000})
                one->Args({load});
            one->Iterations(1);
        }
    for (const std::string scene : {"sheet", "strip", "flag"})
        for (const std::string method : methods)
            add(
                scene, method,
                [=](benchmark::State& state) {
                    Found<ClothScene> found;
                    const int substeps = static_cast<int>(state.range(0));
                    for (auto _ : state)
                        found = run<ClothMemory>(
                            given(scene), settings_of(method, substeps), steps);
                    report(state, found, exact(scene));
                },
                method == "exact" ? 16 : 32);
    for (const char* method : {"small", "xpbd", "threads", "augmented", "exact"})
        add("net", method,
            [method](benchmark::State& state) { net(state, method); });
    auto* const grows = benchmark::RegisterBenchmark("threads/factor", threads);
    for (const int squares : {10, 31, 99}) grows->Args({squares});
    grows->Iterations(1);
#ifdef RIGID_HAS_BULLET
    // its cloth has no bends by a slope and no wind like ours: the sheet
    const auto peer = [](const std::string& name, auto make) {
        add("sheet", name, [make](benchmark::State& state) {
            Found<ClothScene> found;
            const int substeps = static_cast<int>(state.range(0));
            for (auto _ : state)
                found = run_peer(given("sheet"), [&](const ClothScene& cloth) {
                    return make(cloth, substeps);
                });
            report(state, found, exact("sheet"));
        });
    };
    peer("bt_soft", [](const ClothScene& cloth, int substeps) {
        return std::make_unique<BulletCloth>(cloth, std::vector<BulletBall>{}, 0,
                                             substeps, 10);
    });
    for (const int newton : {1, 10})
        peer("bt_deformable_" + std::to_string(newton),
             [newton](const ClothScene& cloth, int substeps) {
                 return std::make_unique<BulletDeformableCloth>(cloth, substeps,
                                                                newton);
             });
#endif
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
