/// Chapter 28: all methods on a ball, how they grow, and what self-contact and sleep cost.
///
///     ball/METHOD/SUBSTEPS    as in chapter 27's benchmark
///     grow/METHOD/SQUARES     a sheet on a ball: the median of the time of a step [µs], stretch of its threads
///                             [%], mean and largest; bytes for each particle; of projective dynamics the entries of the factor for each particle
///     front/METHOD/SUBSTEPS   the same of 10,000 particles, by which way a largest stretch of 1 % is met; `_limit` has a
///                             limit of strain of 1 %
///     self/THICKNESS/SQUARES  a sheet that falls on its edge and folds: the mean time of a step [µs], without and with
///                             rows of its own
///     sleep/AWAKE/SQUARES     a sheet that rests on a ball: the time of a step, without and with sleep
///
/// `bt_soft` and `bt_deformable` are Bullet's, where that is installed; the latter with one iteration of Newton's method, which
/// is its own number, without damping and with 0.1 N s/m in each spring.

#include "chapters/27_particles_and_cloth/benchmark/cloth_compare.hpp"
#include "chapters/28_cloth_that_touches/cloth_sleep.hpp"
#include "chapters/28_cloth_that_touches/touching_scenes.hpp"
#include "tests/peers/bullet_cloth.hpp"

#include <vector>

using namespace rigid;
using namespace rigid::cloth_compare;

namespace {

TouchingCloth on_ball() { return sheet_on_ball(16, 1.2, 500, 0.3); }

/// Explicit steps of 4 µs: half as long ones are 0.1 mm from them, the midpoint's of
/// 10 µs 0.7 mm. Where a contact begins and ends, order two is none.
const TouchingCloth& exact()
{
    static const TouchingCloth known = [] {
        ClothSettings how;
        how.method = ClothMethod::explicit_euler;
        how.h = 1.0 / 60 / 4096;
        return run<TouchingMemory>(on_ball(), how, 4096 * steps).cloth;
    }();
    return known;
}

/// Steps of a sheet of 2 m that falls on a ball.
void fall_on_ball(benchmark::State& state, const std::string& method, int squares,
                  int substeps)
{
    const Real k = 1000;
    Real largest = 0, mean = 0, entries = 0, bytes = 0;
    std::vector<Real> times;  // of the second half
    int particles = 1;
    for (auto _ : state) {
        const Real before = bytes_held();
        TouchingCloth cloth = sheet_on_ball(squares, 2, k, 0.3);
        particles = cloth.count();
        TouchingMemory memory;
        const ClothSettings how = settings_of(method, substeps);
        const int count = particles > 50000 ? 20 : 120;
        for (int n = 0; n < count; ++n) {
            const std::clock_t start = std::clock();
            step(cloth, how, memory);
            const auto time = static_cast<Real>(std::clock() - start);
            if (n < count / 2) continue;
            times.push_back(time / CLOCKS_PER_SEC);
            largest = std::max(largest, largest_stretch(cloth, k));
            mean = std::max(mean, mean_stretch(cloth, k));
        }
        bytes = (bytes_held() - before) / particles;
        if (method == "projective")
            entries = static_cast<Real>(memory.projective.entries()) / particles;
    }
    std::sort(times.begin(), times.end());
    report(state, {.us = 1e6 * times[times.size() / 2],
                   .particles = static_cast<Real>(particles),
                   .largest = 100 * largest,
                   .mean = 100 * mean,
                   .entries = entries,
                   .bytes = bytes});
}

void grow(benchmark::State& state, const std::string& method)
{
    fall_on_ball(state, method, static_cast<int>(state.range(0)),
                 method == "small" || method == "threads" ? 8 : 1);
}
void front(benchmark::State& state, const std::string& method)
{
    fall_on_ball(state, method, 99, static_cast<int>(state.range(0)));
}

void fold(benchmark::State& state, bool with_rows)
{
    const int squares = static_cast<int>(state.range(0));
    Real time = 0;
    int particles = 1;
    const int count = 60;
    for (auto _ : state) {
        TouchingCloth cloth =
            folding_sheet(squares, 500, with_rows ? 0.2 / squares : 0);
        particles = cloth.count();
        TouchingMemory memory;
        const std::clock_t before = std::clock();
        for (int n = 0; n < count; ++n)
            step(cloth, settings_of("threads", 8), memory);
        time = static_cast<Real>(std::clock() - before) / CLOCKS_PER_SEC;
    }
    report(state,
           {.us = 1e6 * time / count, .particles = static_cast<Real>(particles)});
}

void rest(benchmark::State& state, bool sleeps)
{
    Real time = 0;
    int particles = 1;
    const int count = 200;
    for (auto _ : state) {
        TouchingCloth cloth =
            sheet_on_ball(static_cast<int>(state.range(0)), 1.2, 500, 0.5);
        cloth.drag = 4;
        particles = cloth.count();
        SleepingCloth sleeping;
        if (!sleeps) sleeping.time = infinity;
        const ClothSettings how = settings_of("threads", 8);
        for (int n = 0; n < 400; ++n) sleeping.step(cloth, how);
        const std::clock_t before = std::clock();
        for (int n = 0; n < count; ++n) sleeping.step(cloth, how);
        time = static_cast<Real>(std::clock() - before) / CLOCKS_PER_SEC;
    }
    report(state,
           {.us = 1e6 * time / count, .particles = static_cast<Real>(particles)});
}

const bool registered = [] {
    for (const std::string method : methods)
        add("ball", method, [method](benchmark::State& state) {
            Found<TouchingCloth> found;
            const int substeps = static_cast<int>(state.range(0));
            for (auto _ : state)
                found = run<TouchingMemory>(on_ball(),
                                            settings_of(method, substeps), steps);
            report(state, found, exact());
        });
    for (const char* method :
         {"small", "threads", "particles", "projective", "implicit"}) {
        auto* const one = benchmark::RegisterBenchmark(
            (std::string("grow/") + method).c_str(),
            [method](benchmark::State& state) { grow(state, method); });
        for (const int squares : {10, 31, 99, 315}) one->Args({squares});
        one->Iterations(1);
    }
    for (const char* method : {"small", "small_limit", "threads", "threads_limit",
                               "particles", "projective", "implicit"}) {
        auto* const one = benchmark::RegisterBenchmark(
            (std::string("front/") + method).c_str(),
            [method](benchmark::State& state) { front(state, method); });
        const bool sweeps = std::string(method).starts_with("small") ||
                            std::string(method).starts_with("threads");
        for (const int substeps : {1, 2, 4, 8, 10, 12, 20, 40})
            if (sweeps ? substeps >= 4 : substeps <= 4) one->Args({substeps});
        one->Iterations(1);
    }
    for (const bool with : {false, true}) {
        auto* const fold_ = benchmark::RegisterBenchmark(
            with ? "self/with" : "self/without",
            [with](benchmark::State& state) { fold(state, with); });
        for (const int squares : {20, 40}) fold_->Args({squares});
        fold_->Iterations(1);
        auto* const rest_ = benchmark::RegisterBenchmark(
            with ? "sleep/with" : "sleep/without",
            [with](benchmark::State& state) { rest(state, with); });
        rest_->Args({40})->Iterations(1);
    }
#ifdef RIGID_HAS_BULLET
    const auto peer = [](const std::string& name, auto make) {
        add("ball", name, [make](benchmark::State& state) {
            Found<TouchingCloth> found;
            const int substeps = static_cast<int>(state.range(0));
            for (auto _ : state)
                found = run_peer(on_ball(), [&](const TouchingCloth& cloth) {
                    return make(cloth, substeps,
                                std::vector<BulletBall>{{{0, 0, 0}, 0.5, 0.3}});
                });
            report(state, found, exact());
        });
    };
    peer("bt_soft",
         [](const TouchingCloth& cloth, int substeps, const auto& balls) {
             return std::make_unique<BulletCloth>(cloth, balls, cloth.thickness,
                                                  substeps, 10);
         });
    for (const Real damping : {0.0, 0.1})
        peer(
            damping > 0 ? "bt_deformable_damped" : "bt_deformable",
            [damping](const TouchingCloth& cloth, int substeps, const auto& balls) {
                return std::make_unique<BulletDeformableCloth>(
                    cloth, substeps, 1, balls, cloth.thickness, damping);
            });
#endif
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
