#include "common/program/part_watch.hpp"

#include <algorithm>
#include <chrono>

namespace rigid {

void PartTimes::begin(std::string_view name, Real now)
{
    if (present_ != none) parts_[present_].of_this_step += now - since_;
    since_ = now;
    present_ = none;
    if (name.empty()) {
        steps_ = std::min(steps_ + 1, most_steps);
        for (Part& part : parts_) {
            part.seconds += (part.of_this_step - part.seconds) / steps_;
            part.of_this_step = 0;
        }
        return;
    }
    for (std::size_t i = 0; i < parts_.size(); ++i)
        if (parts_[i].name == name) present_ = i;
    if (present_ != none) return;
    present_ = parts_.size();
    parts_.push_back({std::string(name)});
}

Real seconds_of(const std::vector<PartTimes::Part>& parts, std::string_view name)
{
    Real sum = 0;
    for (const PartTimes::Part& part : parts)
        if (name.empty() || part.name == name) sum += part.seconds;
    return sum;
}

void PartWatch::listen(const Playback& playback)
{
    times_.clear();
    for (const Track& track : playback.tracks()) {
        PartTimes& times = times_.emplace_back();
        if (!track.run) continue;
        track.run->tell_parts([&times](std::string_view name) {
            using Seconds = std::chrono::duration<Real>;
            times.begin(name, Seconds(std::chrono::steady_clock::now().time_since_epoch()).count());
        });
    }
}

}  // namespace rigid
