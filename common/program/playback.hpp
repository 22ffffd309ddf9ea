/// \file playback.hpp
/// A scene alive under one or several methods at once: the one place that calls step(), for the
/// window and for runs without one.
#pragma once

#include "common/picture.hpp"
#include "common/program/program.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rigid {

/// The scene under one method. The steps are counted from the start.
struct Track {
    std::string method;
    std::unique_ptr<Run> run;  ///< null if it could not be started
    long steps = 0;
    Real time = 0;               ///< [s]
    std::vector<Real> measured;  ///< one number for each column
    std::string failure;         ///< not empty: why it stands still

    bool can_go_on() const { return failure.empty(); }
};

class Playback {
public:
    /// Starts the scene under each of the methods. Throws std::invalid_argument if a start refuses the
    /// settings; a state that is not finite from the beginning becomes the track's failure.
    Playback(const Demo& scene, const Settings& settings, const std::vector<std::string>& methods);

    /// One step of every track that can go on. A track whose step fails keeps its last row.
    void step(const Input& input);

    /// Takes effect with the next step. The time goes on from where it is.
    void set_h(Real h);
    void set_tunable(const std::string& name, Real value);

    const Demo& scene() const { return *scene_; }
    const Settings& settings() const { return settings_; }
    const std::vector<Track>& tracks() const { return tracks_; }
    long steps() const { return steps_; }  ///< since the start
    Real time() const;                     ///< since the start [s]
    bool can_go_on() const;                ///< at least one track does

    /// "step 12: the energy is inf J; it must be finite", for each track that stands still.
    std::vector<std::string> failures() const;

    /// What every track draws now, labelled by its method.
    std::vector<Pane> draw() const;
    /// Before a picture: where the reader's hand is.
    void look(const Input& input);

private:
    void measure(Track& track) const;

    const Demo* scene_;
    Settings settings_;
    std::vector<Track> tracks_;
    std::vector<Settings>
        own_settings_;  ///< of each track: the same, but for the method; no step copies them
    long steps_ = 0;
    long steps_at_h_ = 0;  ///< when h was set last, and the time then:
    Real time_at_h_ = 0;   ///< t = time_at_h + (steps - steps_at_h) h does not gather rounding errors
};

}  // namespace rigid
