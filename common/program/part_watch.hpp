/// \file part_watch.hpp
/// How long the parts of a step take, by the clock of the window: shown, never written, for no two runs of a program
/// may differ.
#pragma once

#include "common/program/playback.hpp"

#include <deque>
#include <string>
#include <string_view>
#include <vector>

namespace rigid {

/// The parts of one run, in the order in which it told them first.
class PartTimes {
public:
    struct Part {
        std::string name;
        Real seconds = 0;  ///< mean of the last steps
        Real of_this_step = 0;
    };
    static constexpr int most_steps = 60;  ///< that a mean is about

    /// At a time of a clock that never goes back [s]; "" = the step is over.
    void begin(std::string_view name, Real now);
    const std::vector<Part>& parts() const { return parts_; }

private:
    std::vector<Part> parts_;
    std::size_t present_ = none;
    static constexpr std::size_t none = static_cast<std::size_t>(-1);
    Real since_ = 0;
    int steps_ = 0;
};

/// Of the part of this name; of all for "" [s].
Real seconds_of(const std::vector<PartTimes::Part>& parts, std::string_view name = {});

/// Of all tracks of a playback.
class PartWatch {
public:
    /// The runs of a playback that has just been started; those before are not listened to any more.
    void listen(const Playback& playback);
    /// Empty for a run without parts.
    const std::vector<PartTimes::Part>& parts(std::size_t track) const { return times_.at(track).parts(); }
    std::size_t tracks() const { return times_.size(); }

private:
    std::deque<PartTimes> times_;  ///< the listeners know where they are
};

}  // namespace rigid
