/// \file warm_run.hpp
/// A scene of discs, alive: the step with any start, any order of rows, any way to repay. It is drawn as chapter 4
/// draws its scenes.
#pragma once

#include "chapters/04_pgs/program/disc_run.hpp"
#include "chapters/08_warm_starting/memory_rates.hpp"
#include "chapters/08_warm_starting/warm_step.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigid {

inline std::vector<std::string> start_names() { return {"yesterday", "best_multiple", "cold"}; }

inline Start start_named(const std::string& name)
{
    return name == to_string(Start::cold)        ? Start::cold
           : name == to_string(Start::yesterday) ? Start::yesterday
                                                 : Start::best_multiple;
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
            {"share", "", "of yesterday's impulses that today starts from", 1, 0, 1, false, false, false},
            {"repaid_by", "", "0 nothing, 1 Baumgarte, 2 relaxation, 3 split impulse, 4 projection",
             static_cast<Real>(stabilizer), 0, 4, true, false, false},
            {"beta", "", "part of an error that is repaid in a step", beta, 0, 2, false, false, false},
            {"slop", "m", "an overlap that is left alone", 0, 0, 0.02, false, false, false},
            {"substeps", "", "small steps in a step", 1, 1, 64, true, false, false},
            {"order", "", "of the rows: 0 given, 1 alternating, 2 shuffled, 3 coloured", 0, 0, 3, true, false,
             false},
            {"keep", "", "steps that an impulse outlives its row", 0, 0, 100, true, false, false}};
}

inline WarmStepSettings warm_settings(const Settings& settings)
{
    WarmStepSettings step;
    step.h = settings.h;
    step.start = start_named(settings.method);
    step.share = settings["share"];
    step.keep = static_cast<int>(settings["keep"]);
    step.substeps = static_cast<int>(settings["substeps"]);
    step.order = static_cast<Order>(static_cast<int>(settings["order"]));
    step.sweeps.max_sweeps = static_cast<int>(settings["max_sweeps"]);
    step.sweeps.tolerance = std::pow(10, -settings["digits"]);
    step.stabilizer.method = static_cast<Stabilizer>(static_cast<int>(settings["repaid_by"]));
    step.stabilizer.beta = settings["beta"];
    step.stabilizer.slop = settings["slop"];
    step.repay_once = step.stabilizer.method == Stabilizer::projection;
    return step;
}

inline std::vector<Column> warm_columns()
{
    return {{"sweeps", "", "sweeps of the step", true, false},
            {"residual", "m/s", "natural residual of the step's answer", true, true},
            {"row_visits", "", "rows visited: multiples, sweeps, residuals, repaying", false, false},
            {"rows", "", "links and contacts", false, false},
            {"known", "", "rows that were there in the step before", false, false},
            {"multiple", "", "of yesterday's impulses, for the last body's group", false, false},
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
    using Theory = std::function<Real(const WarmStepSettings&)>;
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
        start_energy_ = energy();
        for (Index k = 0; k < scene_.bodies.count(); ++k) began_.push_back(scene_.bodies.position(k).y());
    }

    //! [step]
    void step(const Settings& settings, const Input& input) override
    {
        if (steps_ == 0) warm_.random = Random(settings.seed);
        if (event_) event_(scene_, steps_);
        ++steps_;
        listen(settings, input);
        warm_step(scene_, step_, warm_);
        if (!scene_.bodies.x.allFinite()) throw StepFailure(first_lost_body());
        unsolved_ += warm_.solution.status != Status::solved;
        now_.rows = warm_.rows;  // what the pictures of chapter 4 show
        now_.solution = warm_.solution;
    }
    //! [step]

    std::vector<Real> measure() const override
    {
        const Index last = scene_.bodies.count() - 1;
        Real speed = 0;
        for (Index k = 0; k <= last; ++k) speed = std::max(speed, scene_.bodies.velocity(k).norm());
        const bool scaled = step_.start == Start::best_multiple && warm_.multiple.multiple.size() > last;
        return {static_cast<Real>(warm_.solution.iterations),
                std::isfinite(warm_.solution.residual) ? warm_.solution.residual : 0,
                static_cast<Real>(warm_.visits),
                static_cast<Real>(warm_.rows.size()),
                static_cast<Real>(warm_.cache.found),
                scaled ? warm_.multiple.multiple[warm_.groups.of[static_cast<std::size_t>(last)]] : 1,
                static_cast<Real>(unsolved_),
                largest_link_error(scene_),
                deepest_penetration(scene_),
                scene_.bodies.position(last).y() - began_[static_cast<std::size_t>(last)],
                speed,
                energy() - start_energy_,
                theory_ ? theory_(step_) : 0};
    }

private:
    /// Settings from what the reader has set; a pressed button pulls the disc under it.
    void listen(const Settings& settings, const Input& input)
    {
        const Index was_pulled = disc_settings_.pulled;
        step_ = warm_settings(settings);
        step_.gravity = scene_.gravity;
        if (steered_) {
            step_.gravity = steered_gravity(input, view_, settings["gravity"]);
            step_.stiffness = settings["k"];
            step_.damping = settings["damping"];
        }
        step_.hand = input.pointer / zoom_;
        step_.pulled = held_disc(scene_, input.pressed, step_.hand, was_pulled);
        disc_settings_ = {step_.h,      step_.gravity, step_.stiffness, step_.damping,
                          step_.margin, step_.pulled,  step_.hand};
    }

    Real energy() const
    {
        return kinetic_energy(scene_.bodies) + potential_energy(scene_.bodies, scene_.gravity);
    }

    Theory theory_;
    Event event_;
    WarmStepSettings step_;
    WarmStep warm_;
    std::vector<Real> began_;  ///< heights of the bodies at the start [m]
    Real start_energy_ = 0;
    int steps_ = 0;
};

}  // namespace rigid
