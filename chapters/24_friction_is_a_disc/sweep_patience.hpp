/// \file sweep_patience.hpp
/// How many sweeps an island gets: as many as are set, and more where the rest of them would do harm.
///
///     swept on while  h r > 0.05 ℓ  after the sweeps that are set                                              (24.20)
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"
#include "chapters/06_sequential_impulse/sequential_impulse.hpp"
#include "common/text.hpp"

#include <stdexcept>
#include <string>

namespace rigid {

//! [patience]
/// Bodies that are wrong by r move by h r where they should not, and beyond a margin
/// they meet others than those that were looked at. Such an island is swept until it is
/// solved.
struct SweepPatience {
    int times = 20;  ///< as many sweeps as are set, at most; 1: no more than those
    Real margin = 0.05;  ///< [ℓ]

    /// Whether n sweeps are all that an island gets.
    /// \param residual  r of the island now [m/s]
    bool is_last(int n, const ImpulseSettings& sweeps, Real residual,
                 const StepData<6>& now) const
    {
        const int set = sweeps.max_sweeps;
        if (n < set) return false;
        const bool harm =
            sweeps.tolerance > 0 && residual * now.h > margin * now.length;
        const auto most = static_cast<std::int64_t>(times) * set;
        return (n == set && !harm) || n >= most;
    }

    void require_valid() const
    {
        if (times < 1 || !(margin >= 0))
            throw std::invalid_argument(
                "sweeps may go on to " + std::to_string(times) +
                " times as many, beyond a margin of " + shortest(margin) +
                "; these must be 1 or more, and zero or positive");
    }
};
//! [patience]

}  // namespace rigid
