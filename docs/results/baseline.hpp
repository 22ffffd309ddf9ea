/// \file baseline.hpp
/// The yardstick: a fixed piece of arithmetic that every time in the table is divided by.
///
/// A thousand rows, each a sum of three products and a clamp, each waiting for the one before: what one sweep
/// over a column of a thousand discs does. A time ratio of 1 is therefore about "a thousand row visits" on
/// whatever machine the table was made. It includes nothing of the book, and must never be changed: all time
/// ratios would change with it.
#pragma once

#include <array>
#include <cstddef>

namespace rigid::results {

struct Baseline {
    static constexpr std::size_t rows = 1000;
    std::array<double, rows + 2> lambda{};

    /// One sweep of a line of unit masses, the lowest of which is pushed.
    double run()
    {
        for (std::size_t k = 1; k <= rows; ++k) {
            double value = (k == 1 ? 0.5 : 0.0) + 0.5 * lambda[k + 1] + 0.5 * lambda[k - 1];
            value = value < 0 ? 0 : value;
            lambda[k] = value > 1e9 ? 1e9 : value;
        }
        return lambda[1];
    }
};

}  // namespace rigid::results
