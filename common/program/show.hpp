/// \file show.hpp
/// What the window shows and the panel changes, without window and panel: which scene runs under
/// which methods, how fast, and what was measured lately.
#pragma once

#include "common/program/command_line.hpp"
#include "common/program/playback.hpp"
#include "common/program/scripted_pointer.hpp"

#include <array>
#include <deque>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace rigid {

struct Sample {
    Real t = 0, value = 0;
};

/// What one column of one track was: the last steps one by one, and the whole run, thinned out.
class History {
public:
    static constexpr std::size_t recent_steps = 600, most_samples = 1024;

    void add(const Sample& sample);
    const std::deque<Sample>& recent() const { return recent_; }
    const std::vector<Sample>& whole() const { return whole_; }

private:
    std::deque<Sample> recent_;
    std::vector<Sample> whole_;
    long added_ = 0, stride_ = 1;  ///< each stride-th sample is kept
};

class Show {
public:
    /// Is given what was measured: of a start (`fresh`) and after each step.
    using Listener = std::function<void(const Playback&, bool fresh)>;

    /// Throws std::invalid_argument if the scene refuses what was typed.
    Show(const Program& program, const Options& options, Listener listener = {});

    const Program& program() const { return *program_; }
    const Demo& scene() const { return *scene_; }
    const Settings& settings() const { return settings_; }
    /// Null when the scene refuses the settings; refusal() says why.
    const Playback* playback() const { return playback_ ? &*playback_ : nullptr; }
    const std::string& refusal() const { return refusal_; }
    bool shows_method(std::size_t i) const { return method_on_[i] != 0; }
    std::size_t methods_on() const;
    /// History of the plotted column c of the track k.
    const History& history(std::size_t k, std::size_t c) const { return histories_[k][c]; }

    // What the reader changes. Those marked * start the scene again.
    void choose_scene(std::size_t index);                  ///< *
    void change_scene(int direction);                      ///< * the next one or the one before, in a circle
    void choose_method(std::size_t index, bool on);        ///< * the last one can't be put out
    void set_tunable(const Tunable& tunable, Real value);  ///< * only if it is flagged
    void change_by_arrow(int direction);                   ///< the tunable flagged arrow_keys
    void set_h(Real h);
    void set_seed(std::uint64_t seed);  ///< *
    void set_script(bool on) { scripted_ = on; }
    void restart();  ///< *

    bool paused = false;
    Real speed = 1;  ///< seconds of the scene per second

    bool is_scripted() const { return scripted_; }
    /// True once more steps were due than there was time for.
    bool falls_behind() const { return falls_behind_; }
    /// No step can follow: all tracks stand still, or --steps are done.
    bool is_over() const;

    /// Takes the steps that are due after so many seconds. The clock decides how many they are, never
    /// how long one is. Ends early where the step's number is a multiple of `stop_every` (0 = never).
    void advance(Real seconds, const Input& hand, long stop_every);
    void single_step(const Input& hand);
    /// Before a picture.
    void look(const Input& hand)
    {
        if (playback_) playback_->look(hand);
    }

private:
    void start();
    void step(const Input& hand);
    void remember(bool fresh);

    const Program* program_;
    Options options_;
    const Demo* scene_ = nullptr;
    Settings settings_;
    std::vector<char> method_on_;
    std::optional<Playback> playback_;
    Listener listener_;
    std::string refusal_;
    ScriptedPointer pointer_;
    bool scripted_ = false;
    Real due_ = 0;  ///< part of a step that the last frames left over
    bool falls_behind_ = false;
    std::vector<std::vector<History>> histories_;
};

}  // namespace rigid
