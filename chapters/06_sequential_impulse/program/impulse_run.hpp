/// \file impulse_run.hpp
/// A scene of discs, alive: this chapter's step, by each order of the rows, by blocks, or with the wrong clamping.
#pragma once

#include "chapters/04_pgs/program/disc_run.hpp"
#include "chapters/06_sequential_impulse/block.hpp"
#include "chapters/06_sequential_impulse/impulse_step.hpp"
#include "chapters/06_sequential_impulse/wrong_clamping.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigid {

/// The names of the four orders, of pairs of rows, and of the mistake.
inline std::vector<std::string> impulse_methods()
{
    return {"given", "alternating", "shuffled", "coloured", "blocks", "correction"};
}

/// The order that a method's name says; `given` for those that name none.
inline Order order_of_method(const std::string& method)
{
    for (const Order order : {Order::alternating, Order::shuffled, Order::coloured})
        if (method == to_string(order)) return order;
    return Order::given;
}

/// Finds λ by the method of that name, in the form that impulse_step() wants.
class ImpulseSolver {
public:
    void choose(const std::string& method) { method_ = method; }

    void operator()(const std::vector<Row<2>>& rows, std::span<const int> order,
                    const ImpulseSettings& sweeps, ImpulseMemory<2>& memory, VecX& u, Solution& solution)
    {
        if (method_ == "blocks") block_impulse<2>(rows, order, sweeps, memory, blocks_, u, solution);
        else if (method_ == "correction")
            impulse_clamping_corrections<2>(rows, order, sweeps, memory, u, solution);
        else sequential_impulse<2>(rows, order, sweeps, memory, u, solution);
    }

private:
    std::string method_;
    std::vector<Block> blocks_;
};

/// What the tunables of these scenes say about the sweeps: `sweeps`, and `digits` with 0 for "always all of them".
inline ImpulseSettings sweeps_of(const Settings& settings)
{
    ImpulseSettings sweeps;
    sweeps.max_sweeps = static_cast<int>(settings["sweeps"]);
    sweeps.tolerance = settings["digits"] > 0 ? std::pow(10, -settings["digits"]) : 0;
    return sweeps;
}

inline std::vector<Tunable> sweep_tunables(int sweeps, int digits)
{
    return {
        {"sweeps", "", "at most so many in a step", static_cast<Real>(sweeps), 1, 2000, true, false, false},
        {"digits", "", "the residual is to be below 10^-digits m/s; 0 = all sweeps, and don't look",
         static_cast<Real>(digits), 0, 12, false, false, false}};
}

class ImpulseRun : public DiscRun {
public:
    ImpulseRun(const Settings& settings, DiscScene scene, Real zoom, const View& view, bool steered = false)
        : DiscRun(std::move(scene), zoom, view, steered)
    {
        step_.random = Random(settings.seed);
    }

    //! [step]
    void step(const Settings& settings, const Input& input) override
    {
        hear(settings, input);
        solver_.choose(settings.method);
        impulse_step(scene_, impulse_settings_, std::ref(solver_), step_);
        if (!scene_.bodies.x.allFinite()) throw StepFailure(first_lost_body());
        now_.rows = step_.rows;  // for the picture
        now_.solution = step_.solution;
        visits_ += step_.memory.visits;
    }
    //! [step]

    std::vector<Real> measure() const override
    {
        const Solution& solution = step_.solution;
        Vec2 centre(0, 0);
        Real mass_of_all = 0;
        for (Index k = 0; k < scene_.bodies.count(); ++k) {
            centre += mass(k) * scene_.bodies.position(k);
            mass_of_all += mass(k);
        }
        return {static_cast<Real>(solution.iterations),
                std::isfinite(solution.residual) ? solution.residual : 0,
                static_cast<Real>(visits_),
                static_cast<Real>(step_.rows.size()),
                mass_of_all > 0 ? centre.x() / mass_of_all : 0,
                mass_of_all > 0 ? centre.y() / mass_of_all : 0,
                largest_link_error(scene_),
                deepest_penetration(scene_),
                kinetic_energy(scene_.bodies),
                kinetic_energy(scene_.bodies) + potential_energy(scene_.bodies, impulse_settings_.gravity)};
    }

private:
    /// Gravity follows the pointer in the scene that it steers; a pressed button pulls the disc under it.
    void hear(const Settings& settings, const Input& input)
    {
        const Index was_pulled = disc_settings_.pulled;
        if (steered_) disc_settings_ = ten_discs_settings(settings, input, view_);
        disc_settings_.h = settings.h;
        disc_settings_.hand = input.pointer / zoom_;
        disc_settings_.pulled = held_disc(scene_, input.pressed, disc_settings_.hand, was_pulled);
        impulse_settings_.h = settings.h;
        impulse_settings_.gravity = disc_settings_.gravity;
        impulse_settings_.stiffness = disc_settings_.stiffness;
        impulse_settings_.damping = disc_settings_.damping;
        impulse_settings_.pulled = disc_settings_.pulled;
        impulse_settings_.hand = disc_settings_.hand;
        impulse_settings_.restitution = settings["restitution"];
        impulse_settings_.sweeps = sweeps_of(settings);
        impulse_settings_.order = order_of_method(settings.method);
    }

    ImpulseSolver solver_;
    ImpulseStepSettings impulse_settings_;
    ImpulseStep step_;
    std::int64_t visits_ = 0;
};

/// What all scenes of discs of this chapter have in common.
inline Scene impulse_scene(const std::string& name, const std::string& summary, int sweeps, int digits)
{
    Scene scene;
    scene.name = name;
    scene.summary = summary;
    scene.h = 1.0 / 60;
    scene.h_low = 1e-4;
    scene.h_high = 1.0 / 30;
    scene.methods = impulse_methods();
    scene.side_by_side = {"given", "coloured"};
    scene.tunables = sweep_tunables(sweeps, digits);
    scene.tunables.push_back({"restitution", "", "e of every contact", 0, 0, 1, false, false, false});
    scene.columns = {
        {"sweeps", "", "sweeps of the step", true, false},
        {"residual", "m/s", "natural residual of the step's answer; 0 = not looked at", true, true},
        {"row_visits", "", "rows visited so far, those of residuals included", false, false},
        {"rows", "", "links and contacts", false, false},
        {"centre_x", "m", "centre of mass", true, false},
        {"centre_y", "m", "centre of mass", false, false},
        {"link_error", "m", "largest difference of a link from its length", true, true},
        {"penetration", "m", "deepest overlap", true, true},
        {"kinetic", "J", "kinetic energy", true, false},
        {"energy", "J", "kinetic energy and that of the weight", false, false}};
    return scene;
}

}  // namespace rigid
