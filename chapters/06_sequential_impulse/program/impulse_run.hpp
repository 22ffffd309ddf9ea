/// \file impulse_run.hpp
/// A scene of discs, alive: this chapter's step, by each order of the rows, by blocks, or with the wrong clamping.
#pragma once

#include "chapters/04_pgs/program/disc_run.hpp"
#include "chapters/06_sequential_impulse/wrong_clamping.hpp"

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

/// What the tunables of these scenes say about the sweeps: `sweeps`, and `digits` with 0 for "always all of them".
inline ImpulseSettings sweeps_of(const Settings& settings)
{
    ImpulseSettings sweeps;
    sweeps.max_sweeps = static_cast<int>(settings["sweeps"]);
    sweeps.tolerance = settings["digits"] > 0 ? std::pow(10, -settings["digits"]) : 0;
    return sweeps;
}

/// The solver by the name of a method: one of the orders, blocks, or the mistake.
inline void choose_solver(const Settings& settings, WrongClampingSolver& solver)
{
    solver.ordering = order_of_method(settings.method);
    solver.in_pairs = settings.method == "blocks";
    solver.wrong = settings.method == "correction";
    solver.sweeps = sweeps_of(settings);
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
        method_.solver.random = Random(settings.seed);
    }

    //! [step]
    void step(const Settings& settings, const Input& input) override
    {
        steer(settings, input);
        method_.correction.restitution = settings["restitution"];
        choose_solver(settings, method_.solver);
        rigid::step(scene_, disc_settings_, method_, now_);
        if (!scene_.bodies.x.allFinite()) throw StepFailure(first_lost_body());
        visits_ += now_.visits;
    }
    //! [step]

    std::vector<Real> measure() const override
    {
        const Solution& solution = now_.solution;
        Vec2 centre(0, 0);
        Real mass_of_all = 0;
        for (Index k = 0; k < scene_.bodies.count(); ++k) {
            centre += mass(k) * scene_.bodies.position(k);
            mass_of_all += mass(k);
        }
        return {static_cast<Real>(solution.iterations),
                std::isfinite(solution.residual) ? solution.residual : 0,
                static_cast<Real>(visits_),
                static_cast<Real>(now_.rows.size()),
                mass_of_all > 0 ? centre.x() / mass_of_all : 0,
                mass_of_all > 0 ? centre.y() / mass_of_all : 0,
                largest_link_error(scene_),
                deepest_penetration(scene_),
                kinetic_energy(scene_.bodies),
                kinetic_energy(scene_.bodies) + potential_energy(scene_.bodies, scene_.gravity)};
    }

private:
    WrongClampingMethod method_;
    std::int64_t visits_ = 0;
};

/// What all scenes of discs of this chapter have in common.
inline Demo impulse_scene(const std::string& name, const std::string& summary, int sweeps, int digits)
{
    Demo scene;
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
