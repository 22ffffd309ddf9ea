/// Chapter 27: all methods on four scenes, run time against error; and how they grow.
///
///     SCENE/METHOD/SUBSTEPS   time of a step of 1/60 s [µs]; after half a second: the root of the mean square of the way to
///                             the reference [m], the error of the mean stretch, as a part of it, and that of the energy, as a
///                             part of the kinetic energy of the reference; rows visited in a step
///     grow/METHOD/SQUARES     a sheet on a ball: the median of the time of a step [µs], stretch of its threads
///                             [%], mean and largest; of projective dynamics the entries of the factor for each particle
///     front/METHOD/SUBSTEPS   the same of 10,000 particles, by which way a largest stretch of 1 % is met; `_limit` has a
///                             limit of strain of 1 %
///     self/THICKNESS/SQUARES  a sheet that falls on its edge and folds: the mean time of a step [µs], without and with
///                             rows of its own
///     sleep/AWAKE/SQUARES     a sheet that rests on a ball: the time of a step, without and with sleep
///
/// `bt_soft` is Bullet's btSoftBody, where that is installed.
///
/// The reference is the implicit midpoint with a hundredth of the step, by Newton's method to 1e-11 m. Of `xpbd`, `particles`
/// and `projective` ten sweeps, of `small` and `threads` one. Time is that of the processor.

#include "chapters/27_particles_and_cloth/cloth_scenes.hpp"
#include "chapters/27_particles_and_cloth/cloth_sleep.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <string>
#include <vector>

#if defined(RIGID_HAS_BULLET) && __has_include(<BulletSoftBody/btSoftBody.h>)
#include "chapters/27_particles_and_cloth/benchmark/peer_soft_body.hpp"
#define RIGID_HAS_BULLET_CLOTH
#endif

using namespace rigid;

namespace {

constexpr int steps = 30;

ClothScene given(const std::string& name)
{
    if (name == "sheet") return hung_sheet(12, 500);
    if (name == "flag") return flag(12, 500, 6);
    if (name == "ball") return sheet_on_ball(16, 1.2, 500, 0.3);
    ClothScene strip = clamped_strip(16, 2, Bending::quadratic, true);
    for (ClothSpring& s : strip.springs) s.stiffness = 1e4;
    strip.gravity = {0, -5, 0};
    return strip;
}

struct Found {
    ClothScene cloth;
    Real microseconds = infinity, visits = 0;
    bool lost = false;
};

Found run(const std::string& scene, ClothSettings how, int count)
{
    Found found;
    for (int repeat = 0; repeat < (count == steps ? 3 : 1); ++repeat) {
        found.cloth = given(scene);
        ClothMemory memory;
        memory.newton.tolerance = count == steps ? 1e-8 : 1e-11;
        const std::clock_t before = std::clock();
        for (int n = 0; n < count && !found.lost; ++n) {
            step(found.cloth, how, memory);
            found.lost = !(found.cloth.bodies.x.cwiseAbs().maxCoeff() < 100);
        }
        const Real time = static_cast<Real>(std::clock() - before) / CLOCKS_PER_SEC;
        found.microseconds = std::min(found.microseconds, 1e6 * time / count);
        found.visits = static_cast<Real>(memory.visits) / count;
    }
    return found;
}

#ifdef RIGID_HAS_BULLET_CLOTH
Found run_bullet(const std::string& scene, int substeps)
{
    Found found;
    for (int repeat = 0; repeat < 3; ++repeat) {
        found.cloth = given(scene);
        BulletCloth bullet(found.cloth, substeps, 10);
        const std::clock_t before = std::clock();
        for (int n = 0; n < steps; ++n) bullet.step(1.0 / 60);
        const Real time = static_cast<Real>(std::clock() - before) / CLOCKS_PER_SEC;
        found.microseconds = std::min(found.microseconds, 1e6 * time / steps);
        bullet.read(found.cloth);
        found.lost = !(found.cloth.bodies.x.cwiseAbs().maxCoeff() < 100);
    }
    return found;
}
#endif

const ClothScene& reference(const std::string& scene)
{
    static std::map<std::string, ClothScene> known;
    if (!known.contains(scene)) {
        ClothSettings how;
        how.h = 1.0 / 6000, how.method = ClothMethod::midpoint;
        known.emplace(scene, run(scene, how, 100 * steps).cloth);
    }
    return known.at(scene);
}

/// The named methods are those of the step, and `small`: XPBD with one sweep.
ClothSettings settings_of(const std::string& method, int substeps)
{
    ClothSettings how;
    const std::string name = method.substr(0, method.find("_limit"));
    how.method = cloth_method(name == "small" ? "xpbd" : name);
    how.substeps = substeps;
    how.sweeps = name == "small" || name == "threads" ? 1 : 10;
    if (name != method) how.strain_limit = 0.01, how.limit_stiffness = 500;
    return how;
}

/// What a run has found. The table of a file has all columns in each line.
struct Line {
    Real us = 0, position = 0, stretch = 0, energy = 0, visits = 0;
    Real particles = 0, largest = 0, mean = 0, entries = 0;
};

void report(benchmark::State& state, const Line& line)
{
    state.counters["us"] = line.us;
    state.counters["position"] = line.position;
    state.counters["stretch"] = line.stretch;
    state.counters["energy"] = line.energy;
    state.counters["visits"] = line.visits;
    state.counters["particles"] = line.particles;
    state.counters["largest"] = line.largest;
    state.counters["mean"] = line.mean;
    state.counters["entries"] = line.entries;
}

void compare(benchmark::State& state, const std::string& scene,
             const std::string& method)
{
    Found found;
    const int substeps = static_cast<int>(state.range(0));
    for (auto _ : state) {
#ifdef RIGID_HAS_BULLET_CLOTH
        if (method == "bt_soft") {
            found = run_bullet(scene, substeps);
            continue;
        }
#endif
        found = run(scene, settings_of(method, substeps), steps);
    }
    const ClothScene& exact = reference(scene);
    const Real way = (found.cloth.bodies.x - exact.bodies.x).norm() /
                     std::sqrt(static_cast<Real>(exact.count()));
    Real E = 0;  // kinetic, of the reference
    for (Index k = 0; k < exact.bodies.count(); ++k)
        if (const Real w = exact.bodies.inverse_mass[3 * k]; w > 0)
            E += exact.bodies.velocity(k).squaredNorm() / (2 * w);
    report(state,
           {.us = found.microseconds,
            .position = found.lost ? infinity : way,
            .stretch =
                found.lost
                    ? infinity
                    : std::abs(mean_stretch(found.cloth) / mean_stretch(exact) - 1),
            .energy = found.lost
                          ? infinity
                          : std::abs(energy(found.cloth) - energy(exact)) / E,
            .visits = found.visits,
            .particles = static_cast<Real>(exact.count())});
}

/// Steps of a sheet of 2 m that falls on a ball.
void fall_on_ball(benchmark::State& state, const std::string& method, int squares,
                  int substeps)
{
    const Real k = 1000;
    Real largest = 0, mean = 0, entries = 0;
    std::vector<Real> times;  // of the second half
    int particles = 1;
    for (auto _ : state) {
        ClothScene cloth = sheet_on_ball(squares, 2, k, 0.3);
        particles = cloth.count();
        ClothMemory memory;
        const ClothSettings how = settings_of(method, substeps);
        const int count = particles > 50000 ? 20 : 120;
        for (int n = 0; n < count; ++n) {
            const std::clock_t before = std::clock();
            step(cloth, how, memory);
            const auto time = static_cast<Real>(std::clock() - before);
            if (n < count / 2) continue;
            times.push_back(time / CLOCKS_PER_SEC);
            largest = std::max(largest, largest_stretch(cloth, k));
            mean = std::max(mean, mean_stretch(cloth, k));
        }
        if (method == "projective")
            entries = static_cast<Real>(memory.projective.entries()) / particles;
    }
    std::sort(times.begin(), times.end());
    report(state, {.us = 1e6 * times[times.size() / 2],
                   .particles = static_cast<Real>(particles),
                   .largest = 100 * largest,
                   .mean = 100 * mean,
                   .entries = entries});
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
        ClothScene cloth =
            folding_sheet(squares, 500, with_rows ? 0.2 / squares : 0);
        particles = cloth.count();
        ClothMemory memory;
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
        ClothScene cloth =
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
    for (const char* scene : {"sheet", "strip", "flag", "ball"})
        for (const char* method :
             {"explicit", "small", "xpbd", "threads", "particles", "projective",
              "implicit", "newton", "midpoint", "exact"}) {
            // three rows a bend fill the factor of A: most of a second a step
            if (std::string(method) == "exact" && std::string(scene) != "ball")
                continue;
            auto* const one = benchmark::RegisterBenchmark(
                (std::string(scene) + "/" + method).c_str(),
                [scene, method](benchmark::State& state) {
                    compare(state, scene, method);
                });
            const bool quick = std::string(method) == "explicit";
            for (const int substeps : {1, 2, 4, 8, 16, 32})
                one->Args({quick ? 16 * substeps : substeps});
            one->Iterations(1);
        }
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
#ifdef RIGID_HAS_BULLET_CLOTH
    // its cloth has no bends by a slope and no wind like ours: sheet and ball
    for (const char* scene : {"sheet", "ball"}) {
        auto* const one = benchmark::RegisterBenchmark(
            (std::string(scene) + "/bt_soft").c_str(),
            [scene](benchmark::State& state) { compare(state, scene, "bt_soft"); });
        for (const int substeps : {1, 2, 4, 8, 16, 32}) one->Args({substeps});
        one->Iterations(1);
    }
#endif
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
