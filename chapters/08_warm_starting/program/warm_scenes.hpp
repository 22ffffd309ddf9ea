/// \file warm_scenes.hpp
/// What the scenes of this program share: the step with any start, any order of rows, any correction. They are drawn as
/// chapter 4 draws its scenes.
#pragma once

#include "chapters/03_mlcp_formulation/program/scene_run.hpp"
#include "chapters/04_pgs/program/scene_picture.hpp"
#include "chapters/04_pgs/program/tunables.hpp"
#include "chapters/08_warm_starting/memory_rates.hpp"
#include "chapters/08_warm_starting/warm_method.hpp"
#include "common/elementary.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigid {

using WarmState = RunState<WarmMethod>;
using WarmSetup = SceneSetup<WarmMethod>;

/// As the command line has them.
inline std::vector<std::string> start_names()
{
    return {"previous", "best_multiple", "cold"};
}

inline Start start_named(const std::string& name)
{
    return name == "cold"       ? Start::cold
           : name == "previous" ? Start::previous
                                : Start::best_multiple;
}

/// What the reader may change in every scene.
/// \param sweeps      at most, of a step
/// \param stabilizer  as it is counted in `Stabilizer`
inline std::vector<Tunable> warm_tunables(Real sweeps, Stabilizer stabilizer,
                                          Real beta = 0.2)
{
    return {
        tunables::max_sweeps(sweeps, 1, "", Keys::up_and_down),
        tunables::digits("early out: "),
        tunables::number("factor", "",
                         "σ, of the previous impulses that this step starts from",
                         1, 0, 1),
        tunables::whole(
            "repaid_by",
            "0 nothing, 1 Baumgarte, 2 relaxation, 3 split impulse, 4 projection",
            static_cast<Real>(stabilizer), 0, 4),
        tunables::beta(beta, 2),
        tunables::slop(),
        tunables::substeps(64),
        tunables::row_order(),
        tunables::whole("keep", "steps that an impulse outlives its row", 0, 0,
                        100)};
}

/// Sets the method as the reader has it; what it remembers stays.
inline void tune(const Settings& settings, WarmState& state)
{
    WarmMethod& method = state.method;
    if (state.steps == 0) method.solver.random = Random(settings.seed);
    state.step.substeps = static_cast<int>(settings["substeps"]);
    method.start.from = start_named(settings.method);
    method.start.factor = settings["factor"];
    method.start.keep = static_cast<int>(settings["keep"]);
    method.solver.ordering =
        static_cast<Order>(static_cast<int>(settings["order"]));
    method.solver.sweeps.max_sweeps = static_cast<int>(settings["max_sweeps"]);
    method.solver.sweeps.tolerance = pow(10, -settings["digits"]);
    method.correction.method =
        static_cast<Stabilizer>(static_cast<int>(settings["repaid_by"]));
    method.correction.beta = settings["beta"];
    method.correction.slop = settings["slop"];
    method.correction.at_the_end =
        method.correction.method == Stabilizer::projection;
}

inline std::vector<Measured<WarmState>> warm_columns()
{
    const Measured<WarmState> known = {
        {"known", "", "rows that were there in the step before"},
        [](const WarmState& s) {
            return static_cast<Real>(s.method.start.cache.found);
        }};
    const Measured<WarmState> multiple = {
        {"multiple", "", "of the previous impulses, for the last body's group"},
        [](const WarmState& s) {
            const WarmStart& start = s.method.start;
            const VecX& of_groups = start.multiple.multiple;
            const Index last = s.scene.bodies.count() - 1;
            const bool scaled =
                start.from == Start::best_multiple && of_groups.size() > last;
            return scaled
                       ? of_groups[start.groups.of[static_cast<std::size_t>(last)]]
                       : 1;
        }};
    return {columns::iterations("sweeps", "sweeps of the step"),
            columns::residual(),
            columns::row_visits(),
            columns::rows(),
            known,
            multiple,
            columns::unsolved(),
            columns::link_error(),
            columns::penetration(),
            columns::last_rise(),
            columns::speed().plotted(Plot::none),
            columns::energy_gained_in_gravity_of_start().plotted(Plot::none),
            columns::theory<WarmMethod>(
                "", "a number of the text for this scene; 0 = none")};
}

/// A scene that is stepped by this chapter's method, from the reader's settings.
inline WarmSetup warm(DiscScene scene, Real zoom)
{
    WarmSetup setup;
    setup.scene = std::move(scene);
    setup.zoom = zoom;
    setup.tune = tune;
    setup.draw = [](Canvas& canvas, const SceneState& state) {
        paint::draw_scene(canvas, state);
    };
    return setup;
}

/// What all scenes have in common.
inline Demo warm_demo(const std::string& name, const std::string& summary,
                      const View& view, const std::vector<Tunable>& tunables,
                      const std::function<WarmSetup(const Settings&)>& set_up)
{
    Demo demo;
    demo.name = name;
    demo.summary = summary;
    demo.view = view;
    demo.h_low = 1e-4;
    demo.h = demo.h_high = 1.0 / 60;
    demo.methods = start_names();
    demo.side_by_side = {"cold", "previous", "best_multiple"};
    demo.tunables = tunables;
    run_scene<WarmMethod>(demo, warm_columns(), set_up);
    return demo;
}

}  // namespace rigid
