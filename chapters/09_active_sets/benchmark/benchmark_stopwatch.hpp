/// \file benchmark_stopwatch.hpp
/// Run times for benchmark.cpp: the fastest of several repetitions. Physics never reads a clock.
#pragma once

#include "common/math.hpp"

#include <algorithm>
#include <chrono>
#include <ctime>

namespace rigid {

/// The time of one call of work [µs]: of this process alone where a call takes long enough that others may
/// come between; where it is short, of the wall clock, which is quicker to read.
template <class Work>
Real microseconds(const Work& work)
{
    using Clock = std::chrono::steady_clock;
    const std::clock_t cpu = std::clock();
    const auto start = Clock::now();
    work();
    const Real wall =
        std::chrono::duration<Real, std::micro>(Clock::now() - start).count();
    if (wall < 1000) return wall;
    return std::min(wall, static_cast<Real>(std::clock() - cpu) * 1e6 /
                              static_cast<Real>(CLOCKS_PER_SEC));
}

/// The fastest so far [µs].
struct Fastest {
    Real us = infinity;
    void add(Real time) { us = std::min(us, time); }
};

}  // namespace rigid
