/// \file scene_machines.hpp
/// Discs with joints that are rows with other bounds; the first are three lifts.
#pragma once

#include "chapters/06_sequential_impulse/lift.hpp"
#include "chapters/06_sequential_impulse/program/impulse_scenes.hpp"

namespace rigid {

/// A scene of a few discs with joints that the reader can set.
/// \param add_joints  void (const Settings&, DiscScene&): the joints as they are set
template <class AddJoints>
ImpulseSetup machine(DiscScene scene, const AddJoints& add_joints)
{
    ImpulseSetup setup = by_impulses(std::move(scene));
    setup.pointer = Pointer::ignored;
    setup.before = [add_joints](const Settings& settings, const Input&,
                                ImpulseState& state) {
        state.scene.gravity = {0, -settings["gravity"]};
        state.scene.joints.clear();
        add_joints(settings, state.scene);
    };
    return setup;
}

/// \param own  what the reader may change in this one alone
inline Demo machine_demo(const std::string& name, const std::string& summary,
                         const View& view, const std::vector<Tunable>& own)
{
    Demo demo;
    demo.name = name;
    demo.summary = summary;
    demo.view = view;
    demo.h_high = 1.0 / 30;
    demo.methods = {"given", "coloured", "blocks"};
    demo.tunables = sweep_tunables(100, 9);
    demo.tunables.push_back(tunables::gravity());
    demo.tunables.insert(demo.tunables.end(), own.begin(), own.end());
    return demo;
}

/// Three lifts of 1 kg whose motors have less force than the weight, a little more, and twice as much.
namespace lifts {

inline constexpr Real low = 0.2, high = 1.8;
inline Real shaft(Index k) { return -0.6 + 0.6 * static_cast<Real>(k); }
inline Real share(Index k) { return k == 0 ? 0.9 : k == 1 ? 1.1 : 2.0; }
/// its number among the joints
inline int motor(Index k) { return static_cast<int>(4 * k + 1); }

inline DiscScene scene()
{
    DiscScene scene;
    scene.bodies = Bodies<2>(3);
    scene.radius = VecX::Constant(3, 0.12);
    for (Index k = 0; k < 3; ++k) scene.bodies.position(k) = Vec2(shaft(k), 0.5);
    return scene;
}

inline void draw(Canvas& canvas, const SceneState& state)
{
    for (Index k = 0; k < 3; ++k) {
        const Real x = shaft(k);
        const Vec2 p = state.scene.bodies.position(k);
        canvas.segment({x, low}, {x, high}, paint::grid);
        for (const Real y : {low - 0.12, high + 0.12})
            canvas.segment({x - 0.2, y}, {x + 0.2, y}, paint::wall);
        canvas.box(p, {0.16, 0.12}, 0, paint::body);
        const Real force = state.force_of_joint(motor(k));
        if (std::abs(force) > 0.1)
            canvas.arrow(p, p + Vec2(0, 0.02 * force), paint::impulse);
        canvas.text({x, low - 0.25}, "F = " + fixed(share(k), 1) + " mg", 15,
                    paint::label, Align::centre);
        canvas.text(
            {x, low - 0.34},
            significant(p.y() < high ? state.scene.bodies.velocity(k).y() : 0, 3) +
                " m/s",
            14, paint::label, Align::centre);
    }
}

}  // namespace lifts

inline Demo lift_scene()
{
    Demo demo = machine_demo(
        "lift",
        "Three lifts with motors of 0.9, 1.1 and 2 times the weight, between stops",
        {{0, 0.9}, {1.1, 1.2}},
        {tunables::number("speed", "m/s", "that the motors aim at; negative = down",
                          0.5, -2, 2, Keys::up_and_down)});
    run_scene<WrongClampingMethod>(
        demo,
        {columns::velocity("speed_weak", "of the lift with 0.9 times the weight",
                           1),
         columns::velocity("speed_fair", "of the lift with 1.1 times", 3),
         columns::velocity("speed_strong", "of the lift with 2 times", 5),
         columns::position("height_weak", "of that lift", 1, Plot::none),
         columns::position("height_fair", "of that lift", 3, Plot::none),
         columns::position("height_strong", "of that lift", 5, Plot::none),
         columns::joint_force("force_weak", "of that lift's motor",
                              lifts::motor(0)),
         columns::joint_force("force_fair", "of that lift's motor",
                              lifts::motor(1)),
         columns::joint_force("force_strong", "of that lift's motor",
                              lifts::motor(2))},
        [](const Settings&) {
            ImpulseSetup setup = machine(
                lifts::scene(), [](const Settings& settings, DiscScene& scene) {
                    for (Index k = 0; k < 3; ++k)
                        add_lift(scene, {k, lifts::shaft(k), lifts::low,
                                         lifts::high, settings["speed"],
                                         lifts::share(k) * settings["gravity"]});
                });
            setup.draw = lifts::draw;
            return setup;
        });
    return demo;
}

}  // namespace rigid
