/// \file skipping_setup.hpp
/// What the scenes of this program share: this chapter's step from the reader's settings, and what is measured. A pressed
/// button pulls the disc under the pointer, and so wakes its island.
#pragma once

#include "chapters/03_mlcp_formulation/program/scene_run.hpp"
#include "chapters/04_pgs/program/tunables.hpp"
#include "chapters/10_skipping_work/program/skipping_picture.hpp"
#include "chapters/10_skipping_work/scene_edits.hpp"
#include "common/elementary.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

using SkippingSetup = SceneSetup<SkippingMethod>;

/// What the reader has set.
inline void tune(const Settings& settings, Real margin, SkippingState& state)
{
    state.scene.gravity = {0, -settings["gravity"]};
    SkippingSettings skipping;
    skipping.sweeps.max_sweeps = static_cast<int>(settings["max_sweeps"]);
    skipping.sweeps.tolerance = pow(10, -settings["digits"]);
    skipping.exact_rows = static_cast<int>(settings["exact_rows"]);
    skipping.rest.speed = settings["rest_speed"];
    skipping.rest.time = settings["rest_time"];
    skipping.sleep = settings.method != "no_sleep";
    skipping.islands = settings.method != "one_island";
    skipping.stabilizer.slop = 5e-4;
    skipping.stabilizer.max_correction_speed = 1;
    // the sweeps go on until the residual is small
    skipping.start = Start::previous;
    skipping.pulled = state.step.pulled;
    state.step = configure(state.method, skipping, margin);
}

/// The last disc that the grid finds within 2 cm of a point and that can move; `world` if none can.
inline Index disc_in_grid(SkippingState& state, const Vec2& point)
{
    Index found = world;
    state.method.contacts.broad.grid.near(point, 0.02, ~std::uint64_t{0},
                                          [&](int b) {
                                              if (state.scene.bodies.can_move(b))
                                                  found = b;
                                          });
    return found;
}

/// Scene edits are made in a world: the state becomes one for as long as that takes.
template <class Edit>
void edit(SkippingState& state, const Edit& change)
{
    SkippingWorld borrowed;
    borrowed.margin = state.step.margin;
    std::swap(borrowed.scene, state.scene);
    std::swap(borrowed.method, state.method);
    std::swap(borrowed.found, state.now);
    change(borrowed);
    std::swap(borrowed.scene, state.scene);
    std::swap(borrowed.method, state.method);
    std::swap(borrowed.found, state.now);
}

/// A scene that is stepped by this chapter's method, from the reader's settings.
/// \param margin, skin  as in make_world()
inline SkippingSetup skipping(DiscScene scene, CollisionFilter filter, Real margin,
                              Real skin)
{
    SkippingWorld made =
        make_world(std::move(scene), std::move(filter), margin, skin);
    SkippingSetup setup;
    setup.scene = std::move(made.scene);
    setup.method = std::move(made.method);
    setup.tune = [margin](const Settings& settings, SkippingState& state) {
        tune(settings, margin, state);
    };
    setup.pick = disc_in_grid;
    const auto island_of = std::make_shared<IslandOf>(
        static_cast<std::size_t>(setup.scene.bodies.count()), -1);
    setup.after = [island_of](const SkippingState& state) {
        note_islands(state, *island_of);
    };
    setup.draw = [island_of](Canvas& canvas, const SkippingState& state) {
        draw_skipping(canvas, state, *island_of);
    };
    return setup;
}

/// One of the counters of a step.
template <class Number>
Measured<SkippingState> counted(const std::string& name, const std::string& help,
                                Plot plot, Number SkippingCounters::*counter)
{
    return {{name, "", help, plot}, [counter](const SkippingState& s) {
                return s.steps > 0 ? static_cast<Real>(
                                         counters_of(s.method, s.now).*counter)
                                   : 0;
            }};
}

/// Of the bodies that are awake.
inline Measured<SkippingState> awake_energy()
{
    return {
        {"kinetic", "J", "kinetic energy of those that are awake", Plot::linear},
        [](const SkippingState& s) {
            Real energy = 0;
            for (const int k : s.method.contacts.set.awake)
                if (const Real inverse = s.scene.bodies.inverse_mass[2 * k];
                    inverse > 0)
                    energy +=
                        s.scene.bodies.velocity(k).squaredNorm() / (2 * inverse);
            return energy;
        }};
}

inline std::vector<Measured<SkippingState>> skipping_columns()
{
    using C = SkippingCounters;
    return {
        counted("awake", "bodies that the step looked at", Plot::linear, &C::awake),
        counted("islands", "islands of those, single bodies included", Plot::linear,
                &C::islands),
        counted("contacts", "contacts of those", Plot::none, &C::contacts),
        counted("rows", "rows built and solved", Plot::linear, &C::rows),
        counted("sweeps", "sweeps of the island that needed the most", Plot::linear,
                &C::sweeps),
        counted("visits", "rows visited", Plot::linear, &C::visits),
        counted("tested", "pairs of discs whose distance was computed",
                Plot::linear, &C::tested),
        counted("asked", "discs that queried the grid", Plot::none, &C::queries),
        counted("woken", "bodies that were woken", Plot::none, &C::woken),
        counted("fell_asleep", "bodies that fell asleep", Plot::none,
                &C::fell_asleep),
        counted("unsolved", "islands whose residual did not meet the tolerance",
                Plot::none, &C::unsolved),
        awake_energy()};
}

/// What all scenes have in common.
/// \param own  what the reader may change in this one alone
inline Demo
skipping_demo(const std::string& name, const std::string& summary, const View& view,
              Real h, int max_sweeps, const Tunable& own,
              const std::function<SkippingSetup(const Settings&)>& set_up)
{
    Demo demo;
    demo.name = name;
    demo.summary = summary;
    demo.view = view;
    demo.h = h;
    demo.methods = {"skipping", "no_sleep", "one_island"};
    demo.tunables = {
        tunables::gravity("size of gravity; changing it wakes all"),
        tunables::whole("max_sweeps",
                        "after so many sweeps an island makes do with what it has",
                        max_sweeps, 1, 500),
        tunables::whole("exact_rows",
                        "islands of up to so many rows are solved exactly", 8, 0,
                        32),
        tunables::number("digits", "",
                         "the residual of an island is to be below 10^-digits m/s",
                         5, 2, 12),
        tunables::number("rest_speed", "m/s",
                         "a body that is slower for rest_time is at rest", 1e-3,
                         1e-6, 0.1),
        tunables::number("rest_time", "s",
                         "how long a body must rest before it sleeps, at most", 0.5,
                         0.01, 10),
        tunables::at_start(
            "skin", "m", "how far a disc may move before it queries the grid again",
            0.01, 0, 1),
        own};
    demo.h_high = 1.0 / 60;
    run_scene<SkippingMethod>(demo, skipping_columns(), set_up);
    return demo;
}

}  // namespace rigid
