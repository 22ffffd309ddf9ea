/// \file scenes.hpp
/// What is tossed, and what spins beside its closed form.
#pragma once

#include "chapters/20_turning_in_space/exact_tumbling.hpp"
#include "chapters/20_turning_in_space/program/space_run.hpp"
#include "chapters/20_turning_in_space/tossed.hpp"

namespace rigid {

/// A free spin: how far energy and angular momentum are from what they were.
inline std::vector<Real> free_spin(const FlightState& s)
{
    const Bodies<6>& bodies = s.scene.bodies;
    const Vec3 L = momenta(bodies).tail<3>();
    return {energy(s.scene) / s.energy - 1,
            (L - s.spin_momentum).norm() / s.spin_momentum.norm(), bodies.u[3],
            bodies.u[4], bodies.u[5]};
}

inline std::vector<Column> spin_columns()
{
    return {{"energy_error", "", "energy over that of the start, minus 1",
             Plot::linear},
            {"momentum_error", "", "how far L has moved, as a part of it",
             Plot::linear},
            {"omega_1", "rad/s", "in the body's axes", Plot::linear},
            {"omega_2", "rad/s", "in the body's axes", Plot::linear},
            {"omega_3", "rad/s", "in the body's axes", Plot::linear}};
}

/// The angular momentum, which stays, and the angular velocity, which does not.
inline void draw_spin(SolidPicture& picture, const FlightState& s, Real length)
{
    const Vec3 L = momenta(s.scene.bodies).tail<3>(),
               omega = world_spin(s.scene.bodies, 0);
    if (!(L.norm() > 0 && omega.norm() > 0)) return;
    const Vec3 to_L = length * L.normalized(),
               to_omega = length * omega.normalized();
    picture.arrow({0, 0, 0}, to_L, {Colour::red, 2.5, 1});
    picture.arrow({0, 0, 0}, to_omega, {Colour::green, 2, 1});
    if ((to_L - to_omega).norm() < 0.1 * length)  // one is over the other
        picture.label(1.05 * to_L + Vec3(0, 0.1 * length, 0), "L, ω");
    else {
        picture.label(1.05 * to_L, "L", Colour::red);
        picture.label(1.05 * to_omega, "ω", Colour::green);
    }
}

inline Demo tossed_demo(const std::string& name, const std::string& summary,
                        SolidScene (*make)(Real, Real), Real omega, Real size,
                        const Vec3& traced,
                        const std::vector<std::pair<Hull, Colour>>& dress = {})
{
    Demo scene = flight_demo(
        name, summary, {{0, 0}, {1.6 * size, 1.1 * size}}, 1.0 / 240,
        ways_to_tumble, [make, size, traced, dress](const Settings& settings) {
            FlightSetup setup;
            setup.scene = make(settings["spin"], settings["tilt"]);
            setup.camera.distance = 5 * size;
            setup.traces = true;
            setup.traced = traced;
            setup.dress = dress;
            if (!dress.empty()) setup.skin = Skin::opaque;
            setup.measure = free_spin;
            setup.picture = [size](SolidPicture& picture, const FlightState& s) {
                draw_spin(picture, s, size);
            };
            return setup;
        });
    scene.tunables.push_back({"spin", "rad/s", "about the middle axis", omega, 1,
                              60, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"tilt", "", "part of it about the other axes", 0.01,
                              0.0001, 0.5, Numbers::real, OnChange::restarts});
    scene.columns = spin_columns();
    return scene;
}

/// Two halves along the axis that it spins about: one end of it is red.
inline Demo book_scene()
{
    return tossed_demo(
        "book", "A book is tossed about its middle axis: it turns over",
        tossed_book, 12, 0.2, {0, 0.12, 0},
        {{solid_box({0.08, 0.24, 0.04}, {0.04, 0, 0}), Colour::red},
         {solid_box({0.08, 0.24, 0.04}, {-0.04, 0, 0}), Colour::blue}});
}

inline Demo handle_scene()
{
    return tossed_demo("handle",
                       "A T-shaped handle spins, and turns about again and again",
                       t_handle, 20, 0.09, {0, 0, 0.05});
}

inline Demo spin_scene()
{
    Demo scene = flight_demo(
        "spin", "A free body beside its closed form, by four ways",
        {{0, 0}, {2.2, 1.5}}, 1.0 / 60, ways_to_tumble, [](const Settings&) {
            FlightSetup setup;
            setup.scene = spinning_plate();
            setup.camera.distance = 6;
            setup.traces = true;
            setup.traced = {1.2, 0, 0};
            setup.measure = [](const FlightState& s) {
                const Vec3 exact = exact_spin({1, 2, 3}, 0.5, 1, s.t),
                           omega = s.scene.bodies.u.segment<3>(3);
                std::vector<Real> numbers = free_spin(s);
                numbers.push_back((omega - exact).norm());
                return numbers;
            };
            setup.picture = [](SolidPicture& picture, const FlightState& s) {
                draw_spin(picture, s, 1.2);
            };
            return setup;
        });
    scene.columns = spin_columns();
    scene.columns.push_back(
        {"error", "rad/s", "of omega, beside (20.24)", Plot::logarithmic});
    return scene;
}

}  // namespace rigid
