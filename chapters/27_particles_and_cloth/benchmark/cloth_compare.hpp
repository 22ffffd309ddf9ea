/// \file cloth_compare.hpp
/// Runs of one scene of cloth beside a reference: the implicit midpoint with a hundredth of the step, by Newton's method to
/// 1e-11 m; of threads that do not stretch, the exact rows in such steps and in half of them, extrapolated. Of `xpbd`, `particles`, `augmented` and `projective` ten sweeps, of `small` and `threads` one. Time is that of the processor.
#pragma once

#include "chapters/27_particles_and_cloth/cloth_step.hpp"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#ifdef __GLIBC__
#include <malloc.h>
#endif
#include <functional>
#include <string>

namespace rigid::cloth_compare {

constexpr int steps = 30;

template <class Scene>
struct Found {
    Scene cloth;
    Real microseconds = infinity, visits = 0, solves = 0;
    bool lost = false;
};

/// \param steps_taken  `steps` of them three times, for the least time; another number once
template <class Memory, class Scene>
Found<Scene> run(const Scene& scene, const ClothSettings& how, int steps_taken)
{
    Found<Scene> found;
    for (int repeat = 0; repeat < (steps_taken == steps ? 3 : 1); ++repeat) {
        found.cloth = scene;
        Memory memory;
        memory.newton.tolerance = steps_taken == steps ? 1e-8 : 1e-11;
        memory.exact.tolerance = memory.newton.tolerance;
        const std::clock_t before = std::clock();
        for (int n = 0; n < steps_taken && !found.lost; ++n) {
            step(found.cloth, how, memory);
            found.lost = !(found.cloth.bodies.x.cwiseAbs().maxCoeff() < 100);
        }
        const Real time = static_cast<Real>(std::clock() - before) / CLOCKS_PER_SEC;
        found.microseconds = std::min(found.microseconds, 1e6 * time / steps_taken);
        found.visits = static_cast<Real>(memory.visits) / steps_taken;
        found.solves = static_cast<Real>(memory.solves) / steps_taken;
    }
    return found;
}

/// The same by another engine. \param make  its world of the scene
template <class Make, class Scene>
Found<Scene> run_peer(const Scene& scene, const Make& make)
{
    Found<Scene> found;
    for (int repeat = 0; repeat < 3; ++repeat) {
        found.cloth = scene;
        const auto world = make(found.cloth);
        const std::clock_t before = std::clock();
        for (int n = 0; n < steps; ++n) world->step(1.0 / 60);
        const Real time = static_cast<Real>(std::clock() - before) / CLOCKS_PER_SEC;
        found.microseconds = std::min(found.microseconds, 1e6 * time / steps);
        world->read(found.cloth);
        found.lost = !(found.cloth.bodies.x.cwiseAbs().maxCoeff() < 100);
    }
    return found;
}

template <class Memory, class Scene>
Scene reference(const Scene& scene)
{
    ClothSettings how;
    how.h = 1.0 / 6000, how.method = ClothMethod::midpoint;
    return run<Memory>(scene, how, 100 * steps).cloth;
}

/// Of threads that do not stretch, which the midpoint does not take: first order, extrapolated.
template <class Memory, class Scene>
Scene hard_reference(const Scene& scene)
{
    ClothSettings how;
    how.method = ClothMethod::exact;
    how.h = 1.0 / 6000;
    const Scene coarse = run<Memory>(scene, how, 100 * steps).cloth;
    how.h = 1.0 / 12000;
    Scene fine = run<Memory>(scene, how, 200 * steps).cloth;
    fine.bodies.x = 2 * fine.bodies.x - coarse.bodies.x;
    fine.bodies.u = 2 * fine.bodies.u - coarse.bodies.u;
    return fine;
}

/// The named methods are those of the step, and `small`: XPBD with one sweep.
inline ClothSettings settings_of(const std::string& method, int substeps)
{
    ClothSettings how;
    const std::string name = method.substr(0, method.find("_limit"));
    how.method = cloth_method(name == "small" ? "xpbd" : name);
    how.substeps = substeps;
    how.sweeps = name == "small" || name == "threads" ? 1 : 10;
    if (name != method) how.strain_limit = 0.01, how.limit_stiffness = 500;
    return how;
}

/// Bytes that the program holds of what it asked for; 0 where the C library does not say.
inline Real bytes_held()
{
#ifdef __GLIBC__
    const struct mallinfo2 now = mallinfo2();
    return static_cast<Real>(now.uordblks + now.hblkhd);
#else
    return 0;
#endif
}

/// What a run has found. The table of a file has all columns in each line.
struct Line {
    Real us = 0, position = 0, stretch = 0, energy = 0, visits = 0, solves = 0;
    Real particles = 0, largest = 0, mean = 0, entries = 0, bytes = 0;
    Real height = 0, as_stiff = 0;  // of a strip: over its width; EI that it shows
};

inline void report(benchmark::State& state, const Line& line)
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
    state.counters["solves"] = line.solves;
    state.counters["bytes"] = line.bytes;
    state.counters["height"] = line.height;
    state.counters["as_stiff"] = line.as_stiff;
}

template <class Scene>
void report(benchmark::State& state, const Found<Scene>& found, const Scene& exact)
{
    const Real way = (found.cloth.bodies.x - exact.bodies.x).norm() /
                     std::sqrt(static_cast<Real>(exact.count()));
    Real E = 0;  // kinetic, of the reference
    for (Index k = 0; k < exact.bodies.count(); ++k)
        if (const Real w = exact.bodies.inverse_mass[3 * k]; w > 0)
            E += exact.bodies.velocity(k).squaredNorm() / (2 * w);
    const auto or_lost = [&found](Real value) {
        return found.lost ? infinity : value;
    };
    report(state,
           {.us = found.microseconds,
            .position = or_lost(way),
            .stretch = or_lost(
                std::abs(mean_stretch(found.cloth) / mean_stretch(exact) - 1)),
            .energy = or_lost(std::abs(energy(found.cloth) - energy(exact)) / E),
            .visits = found.visits,
            .solves = found.solves,
            .particles = static_cast<Real>(exact.count())});
}

/// One line for each number of sub-steps; explicit steps take sixteen times as many.
inline void add(const std::string& name, const std::string& method,
                std::function<void(benchmark::State&)> what, int most = 32)
{
    auto* const one = benchmark::RegisterBenchmark((name + "/" + method).c_str(),
                                                   std::move(what));
    for (const int substeps : {1, 2, 4, 8, 16, 32})
        if (substeps <= most)
            one->Args({method == "explicit" ? 16 * substeps : substeps});
    one->Iterations(1);
}

inline const std::initializer_list<const char*> methods{
    "explicit",   "small",    "xpbd",   "threads",  "particles", "augmented",
    "projective", "implicit", "newton", "midpoint", "exact"};

}  // namespace rigid::cloth_compare
