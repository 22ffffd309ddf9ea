#include "common/program/playback.hpp"

#include "common/text.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace rigid {

Playback::Playback(const Demo& scene, const Settings& settings, const std::vector<std::string>& methods)
    : scene_(&scene), settings_(settings)
{
    for (const std::string& method : methods) {
        Track& track = tracks_.emplace_back();
        track.method = method;
        own_settings_.push_back(settings);
        own_settings_.back().method = method;
        try {
            track.run = scene.start(own_settings_.back());
            if (!track.run) throw StepFailure("scene " + scene.name + " did not start");
            measure(track);
        } catch (const StepFailure& failure) {
            track.failure = failure.what();
        }
    }
}

void Playback::set_tunable(const std::string& name, Real value)
{
    settings_.tunables[name] = value;
    for (Settings& one : own_settings_) one.tunables[name] = value;
}

void Playback::step(const Input& input)
{
    if (!can_go_on()) return;
    ++steps_;
    for (std::size_t k = 0; k < tracks_.size(); ++k) {
        Track& track = tracks_[k];
        if (!track.can_go_on()) continue;
        try {
            track.run->step(own_settings_[k], input);
            measure(track);
            track.steps = steps_;
            track.time = time();
        } catch (const std::exception& failure) {
            // StepFailure, or bad input found within the run: neither can be put right by going on.
            track.failure = sentence_of(failure);
        }
    }
}

void Playback::measure(Track& track) const
{
    const std::vector<Column>& columns = scene_->columns;
    std::vector<Real> row = track.run->measure();
    if (row.size() != columns.size())
        throw StepFailure("measure() gave " + std::to_string(row.size()) + " numbers; scene " + scene_->name +
                          " has " + std::to_string(columns.size()) + " columns");
    for (std::size_t i = 0; i < row.size(); ++i)
        if (!std::isfinite(row[i]))
            throw StepFailure(columns[i].name + " is " + with_unit(readable(row[i]), columns[i].unit) +
                              "; it must be finite");
    track.measured = std::move(row);
}

void Playback::set_h(Real h)
{
    time_at_h_ = time();
    steps_at_h_ = steps_;
    settings_.h = h;
    for (Settings& one : own_settings_) one.h = h;
}

Real Playback::time() const { return time_at_h_ + static_cast<Real>(steps_ - steps_at_h_) * settings_.h; }

bool Playback::can_go_on() const
{
    return std::any_of(tracks_.begin(), tracks_.end(), [](const Track& track) { return track.can_go_on(); });
}

std::vector<std::string> Playback::failures() const
{
    std::vector<std::string> sentences;
    for (const Track& track : tracks_) {
        if (track.can_go_on()) continue;
        const long step = track.measured.empty() ? 0 : track.steps + 1;
        sentences.push_back("step " + std::to_string(step) + ": " +
                            (tracks_.size() > 1 ? "method " + track.method + ": " : "") + track.failure);
    }
    return sentences;
}

void Playback::look(const Input& input)
{
    for (std::size_t k = 0; k < tracks_.size(); ++k)
        if (tracks_[k].run) tracks_[k].run->look(own_settings_[k], input);
}

std::vector<Pane> Playback::draw() const
{
    std::vector<Pane> panes;
    for (const Track& track : tracks_) {
        Pane& pane = panes.emplace_back(Pane{track.method, scene_->view, {}});
        if (track.run) track.run->draw(pane.canvas);
    }
    return panes;
}

}  // namespace rigid
