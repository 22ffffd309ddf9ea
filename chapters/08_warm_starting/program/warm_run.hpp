/// \file warm_run.hpp
/// A scene of discs, alive: the step with any start, any order of rows, any correction. It is drawn as chapter 4
/// draws its scenes.
#pragma once

#include "chapters/04_pgs/program/disc_run.hpp"
#include "chapters/08_warm_starting/memory_rates.hpp"
#include "chapters/08_warm_starting/warm_method.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigid {

/// As the command line has them.
inline std::vector<std::string> start_names() { return {"previous", "best_multiple", "cold"}; }

inline Start start_named(const std::string& name)
{
    return name == "cold" ? Start::cold : name == "previous" ? Start::previous : Start::best_multiple;
}

/// What the reader may change in every scene.
/// \param sweeps      at most, of a step
/// \param stabilizer  as it is counted in `Stabilizer`
inline std::vector<Tunable> warm_tunables(Real sweeps, Stabilizer stabilizer, Real beta = 0.2)
{
    return {{"max_sweeps", "", "after so many sweeps a step makes do with what it has", sweeps, 1, 2000, true,
             false, true},
            {"digits", "", "early out: enough when the residual is below 10^-digits m/s", 6, 1, 12, false,
             false, false},
            {"factor", "", "σ, of the previous impulses that this step starts from", 1, 0, 1, false, false,
             false},
            {"repaid_by", "", "0 nothing, 1 Baumgarte, 2 relaxation, 3 split impulse, 4 projection",
             static_cast<Real>(stabilizer), 0, 4, true, false, false},
            {"beta", "", "part of an error that is corrected in a step", beta, 0, 2, false, false, false},
            {"slop", "m", "an overlap that is left alone", 0, 0, 0.02, false, false, false},
            {"substeps", "", "small steps in a step", 1, 1, 64, true, false, false},
            {"order", "", "of the rows: 0 given, 1 alternating, 2 shuffled, 3 coloured", 0, 0, 3, true, false,
             false},
            {"keep", "", "steps that an impulse outlives its row", 0, 0, 100, true, false, false}};
}

/// Sets the method as the reader has it; what it remembers stays.
inline void tune(WarmMethod& method, const Settings& settings)
{
    method.start.from = start_named(settings.method);
    method.start.factor = settings["factor"];
    method.start.keep = static_cast<int>(settings["keep"]);
    method.solver.ordering = static_cast<Order>(static_cast<int>(settings["order"]));
    method.solver.sweeps.max_sweeps = static_cast<int>(settings["max_sweeps"]);
    method.solver.sweeps.tolerance = std::pow(10, -settings["digits"]);
    method.correction.method = static_cast<Stabilizer>(static_cast<int>(settings["repaid_by"]));
    method.correction.beta = settings["beta"];
    method.correction.slop = settings["slop"];
    method.correction.at_the_end = method.correction.method == Stabilizer::projection;
}

inline std::vector<Column> warm_columns()
{
    return {{"sweeps", "", "sweeps of the step", true, false},
            {"residual", "m/s", "natural residual of the step's answer", true, true},
            {"row_visits", "", "rows visited: multiples, sweeps, residuals, correction", false, false},
            {"rows", "", "links and contacts", false, false},
            {"known", "", "rows that were there in the step before", false, false},
            {"multiple", "", "of the previous impulses, for the last body's group", false, false},
            {"unsolved", "", "steps so far that did not meet the tolerance", false, false},
            {"link_error", "m", "largest difference of a link from its length", true, true},
            {"penetration", "m", "deepest overlap", true, true},
            {"last_rise", "m", "how far the last body is above where it began", true, false},
            {"speed", "m/s", "greatest speed of a body", false, false},
            {"energy", "J", "kinetic energy and that of the weight, less than at the start", false, false},
            {"theory", "", "a number of the text for this scene; 0 = none", false, false}};
}

class WarmRun : public DiscRun {
public:
    using Theory = std::function<Real(const StepSettings&, const WarmMethod&)>;
    using Event = std::function<void(DiscScene&, int step)>;

    /// \param zoom     from metres to the units of the picture
    /// \param view     what the picture shows
    /// \param theory   what the column of that name shows; may be empty
    /// \param event    changes the scene before a step; may be empty
    /// \param steered  the pointer sets gravity, as for the ten discs
    WarmRun(DiscScene scene, Real zoom, const View& view, Theory theory = {}, Event event = {},
            bool steered = false)
        : DiscRun(std::move(scene), zoom, view, steered), theory_(std::move(theory)), event_(std::move(event))
    {
        start_gravity_ = scene_.gravity;
        start_energy_ = energy();
        for (Index k = 0; k < scene_.bodies.count(); ++k) began_.push_back(scene_.bodies.position(k).y());
    }

    //! [step]
    void step(const Settings& settings, const Input& input) override
    {
        if (steps_ == 0) method_.solver.random = Random(settings.seed);
        if (event_) event_(scene_, steps_);
        if (disc_settings_.pulled >= scene_.bodies.count()) disc_settings_.pulled = world;  // it is gone
        ++steps_;
        listen(settings, input);
        rigid::step(scene_, disc_settings_, method_, now_);
        if (!scene_.bodies.x.allFinite()) throw StepFailure(first_lost_body());
        unsolved_ += now_.solution.status != Status::solved;
    }
    //! [step]

    std::vector<Real> measure() const override
    {
        const Index last = scene_.bodies.count() - 1;
        Real speed = 0;
        for (Index k = 0; k <= last; ++k) speed = std::max(speed, scene_.bodies.velocity(k).norm());
        const WarmStart& start = method_.start;
        const VecX& multiple = start.multiple.multiple;
        const bool scaled = start.from == Start::best_multiple && multiple.size() > last;
        return {static_cast<Real>(now_.solution.iterations),
                std::isfinite(now_.solution.residual) ? now_.solution.residual : 0,
                static_cast<Real>(now_.visits),
                static_cast<Real>(now_.rows.size()),
                static_cast<Real>(start.cache.found),
                scaled ? multiple[start.groups.of[static_cast<std::size_t>(last)]] : 1,
                static_cast<Real>(unsolved_),
                largest_link_error(scene_),
                deepest_penetration(scene_),
                scene_.bodies.position(last).y() - began_[static_cast<std::size_t>(last)],
                speed,
                energy() - start_energy_,
                theory_ ? theory_(disc_settings_, method_) : 0};
    }

private:
    /// Settings from what the reader has set; a pressed button pulls the disc under it.
    void listen(const Settings& settings, const Input& input)
    {
        const Index was_pulled = disc_settings_.pulled;
        tune(method_, settings);
        disc_settings_.h = settings.h;
        disc_settings_.substeps = static_cast<int>(settings["substeps"]);
        if (steered_) {
            scene_.gravity = steered_gravity(input, view_, settings["gravity"]);
            disc_settings_.stiffness = settings["k"];
            disc_settings_.damping = settings["damping"];
        }
        disc_settings_.hand = input.pointer / zoom_;
        disc_settings_.pulled = held_disc(scene_, input.pressed, disc_settings_.hand, was_pulled);
    }

    Real energy() const
    {
        return kinetic_energy(scene_.bodies) + potential_energy(scene_.bodies, start_gravity_);
    }

    Theory theory_;
    Event event_;
    WarmMethod method_;
    std::vector<Real> began_;  ///< heights of the bodies at the start [m]
    Vec2 start_gravity_ = {
        0, 0};  ///< the pointer may turn the scene's; energies are compared in this one [m/s²]
    Real start_energy_ = 0;
    int steps_ = 0;
};

}  // namespace rigid
