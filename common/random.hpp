/// \file random.hpp
/// Random numbers that are the same on every machine: std::mt19937_64 is fixed by the
/// standard, but its distributions are not, so the two that we need are written here.
#pragma once

#include "common/elementary.hpp"
#include "common/math.hpp"

#include <cmath>
#include <cstdint>
#include <random>
#include <stdexcept>
#include <string>

namespace rigid {

class Random {
public:
    explicit Random(std::uint64_t seed) : bits_(seed) {}

    /// Uniform in [0, 1), with 53 random bits.
    Real uniform() { return static_cast<Real>(bits_() >> 11) * 0x1.0p-53; }

    /// Uniform in [low, high]; high itself by rounding alone.
    Real uniform(Real low, Real high) { return low + (high - low) * uniform(); }

    /// One of 0 … count-1. The bias of the remainder is below count / 2^64.
    Index index(Index count)
    {
        if (count < 1)
            throw std::invalid_argument("a random number is to be one of " + std::to_string(count) +
                                        "; there must be 1 or more");
        return static_cast<Index>(bits_() % static_cast<std::uint64_t>(count));
    }

    /// Standard normal, by the method of Box and Muller.
    Real normal()
    {
        const Real radius = std::sqrt(-2 * log(1 - uniform()));
        return radius * cos(2 * pi * uniform());
    }

private:
    std::mt19937_64 bits_;
};

}  // namespace rigid
