/// Chapter 27: all methods on four scenes, run time against error; and how they grow.
///
///     SCENE/METHOD/SUBSTEPS   time of a step of 1/60 s [µs]; after half a second: the root of the mean square of the way to
///                             the reference [m], the error of the mean stretch, as a part of it, and that of the energy, as a
///                             part of the kinetic energy of the reference; rows visited in a step
///     grow/METHOD/SQUARES     a sheet on a ball: the median of the time of a step [µs], stretch of its threads
///                             [%], mean and largest; of projective dynamics the entries of the factor for each particle
///
/// The reference is the implicit midpoint with a hundredth of the step, by Newton's method to 1e-11 m. Of `xpbd`, `particles`
/// and `projective` ten sweeps, of `small` and `threads` one. Time is that of the processor.

#include "chapters/27_particles_and_cloth/cloth_scenes.hpp"
#include "chapters/27_particles_and_cloth/cloth_step.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <map>
#include <string>
#include <vector>

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
    how.method = cloth_method(method == "small" ? "xpbd" : method);
    how.substeps = substeps;
    how.sweeps = method == "small" || method == "threads" ? 1 : 10;
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
    for (auto _ : state)
        found = run(scene, settings_of(method, static_cast<int>(state.range(0))),
                    steps);
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

void grow(benchmark::State& state, const std::string& method)
{
    const int squares = static_cast<int>(state.range(0));
    const Real k = 1000;
    const int substeps = method == "small" || method == "threads" ? 8 : 1;
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
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
