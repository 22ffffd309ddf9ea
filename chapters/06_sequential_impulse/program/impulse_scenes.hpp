/// \file impulse_scenes.hpp
/// What the scenes of this program share: this chapter's step by each order of the rows, by blocks, or with the wrong
/// clamping; what the reader may change; what is measured.
#pragma once

#include "chapters/03_mlcp_formulation/program/scene_run.hpp"
#include "chapters/04_pgs/program/scene_picture.hpp"
#include "chapters/04_pgs/program/tunables.hpp"
#include "chapters/06_sequential_impulse/wrong_clamping.hpp"
#include "common/elementary.hpp"

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
    sweeps.tolerance = settings["digits"] > 0 ? pow(10, -settings["digits"]) : 0;
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
    return {tunables::whole("sweeps", "at most so many in a step", sweeps, 1, 2000),
            tunables::number("digits", "",
                             "the residual is to be below 10^-digits m/s; 0 = all "
                             "sweeps, and don't look",
                             digits, 0, 12)};
}

using ImpulseState = RunState<WrongClampingMethod>;
using ImpulseSetup = SceneSetup<WrongClampingMethod>;

/// A scene that is stepped by this chapter's method, from the reader's settings.
inline ImpulseSetup by_impulses(DiscScene scene, Real zoom = 1,
                                Pointer pointer = Pointer::pulls)
{
    ImpulseSetup setup;
    setup.scene = std::move(scene);
    setup.zoom = zoom;
    setup.pointer = pointer;
    setup.tune = [](const Settings& settings, ImpulseState& state) {
        if (state.steps == 0) state.method.solver.random = Random(settings.seed);
        choose_solver(settings, state.method.solver);
    };
    setup.draw = [](Canvas& canvas, const SceneState& state) {
        paint::draw_scene(canvas, state);
    };
    return setup;
}

/// A coordinate of the centre of mass.
inline Measured<SceneState> centre_of_mass(const std::string& name, Index axis)
{
    return {{name, "m", "centre of mass", axis == 0 ? Plot::linear : Plot::none},
            [axis](const SceneState& s) {
                Real centre = 0, mass = 0;
                for (Index k = 0; k < s.scene.bodies.count(); ++k) {
                    centre +=
                        paint::mass_of(s, k) * s.scene.bodies.position(k)[axis];
                    mass += paint::mass_of(s, k);
                }
                return mass > 0 ? centre / mass : 0;
            }};
}

/// What all scenes of discs of this chapter have in common.
/// \param own  what the reader may change in this one alone
inline Demo impulse_demo(const std::string& name, const std::string& summary,
                         const View& view, const std::vector<Tunable>& own,
                         int sweeps, int digits,
                         const std::function<ImpulseSetup(const Settings&)>& set_up)
{
    Demo demo;
    demo.name = name;
    demo.summary = summary;
    demo.view = view;
    demo.h_high = 1.0 / 30;
    demo.methods = impulse_methods();
    demo.side_by_side = {"given", "coloured"};
    demo.tunables = with(own, sweep_tunables(sweeps, digits));
    demo.tunables.push_back(tunables::restitution(0));
    const Measured<SceneState> visits_so_far = {
        {"row_visits", "", "rows visited so far, those of residuals included"},
        [](const SceneState& s) { return static_cast<Real>(s.visits); }};
    const auto bouncing = [set_up](const Settings& at_start) {
        ImpulseSetup setup = set_up(at_start);
        setup.before = [](const Settings& settings, const Input&,
                          ImpulseState& state) {
            state.method.correction.restitution = settings["restitution"];
        };
        return setup;
    };
    run_scene<WrongClampingMethod>(
        demo,
        {columns::iterations("sweeps", "sweeps of the step"), columns::residual(),
         visits_so_far, columns::rows(), centre_of_mass("centre_x", 0),
         centre_of_mass("centre_y", 1), columns::link_error(),
         columns::penetration(), columns::kinetic(), columns::energy()},
        bouncing);
    return demo;
}

}  // namespace rigid
