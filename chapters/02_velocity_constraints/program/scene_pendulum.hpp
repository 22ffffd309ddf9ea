/// \file scene_pendulum.hpp
/// A pendulum through a distance row, under three time steps at once.
#pragma once

#include "chapters/01_euler_integration/exact.hpp"
#include "chapters/02_velocity_constraints/program/drawing.hpp"
#include "chapters/02_velocity_constraints/program/scene_beads.hpp"
#include "common/elementary.hpp"
#include "common/measure.hpp"
#include "common/program/program.hpp"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace rigid {

/// A pendulum of 1 m and 1 kg with three time steps at once, beside the exact one.
class PendulumRun : public Run {
public:
    explicit PendulumRun(const Settings& settings)
        : angle_(settings["angle"] * pi / 180)
    {
        for (Bodies<2>& bodies : bodies_) bodies.x = place(angle_);
    }

    //! [pendulum_step]
    void step(const Settings& settings, const Input&) override
    {
        for (std::size_t i = 0; i < 3; ++i) {
            const int parts = 1 << i;  // h, h/2, h/4
            const Real h = settings.h / parts;
            for (int k = 0; k < parts; ++k) {
                Bodies<2>& bodies = bodies_[i];
                const Constraint<2> rod = anchor_constraint(bodies.x, 0, {0, 0}, 1);
                bodies.f.setZero();
                add_gravity(bodies, {0, -g});
                if (settings.method == "spring")
                    add_stiff_spring(bodies, rod, settings["stiffness"]);
                bodies.u += h * bodies.inverse_mass.cwiseProduct(bodies.f);
                tension_[i] =
                    settings.method == "spring" ? settings["stiffness"] * rod.C : 0;
                if (settings.method == "row") {
                    const Row<2> row = bilateral(rod, bodies.inverse_mass);
                    const RowAnswer answer = solve_row(row, bodies.u);
                    row.apply(answer.lambda, bodies.u);
                    // N s over s: the mean force of the step
                    tension_[i] = -answer.lambda / h;
                }
                bodies.x += h * bodies.u;
            }
        }
        time_ += settings.h;
    }
    //! [pendulum_step]

    std::vector<Real> measure() const override
    {
        const State<1> truth = exact_pendulum(Pendulum{}, angle_, time_);
        // m g cos θ + m u²/L
        const Real exact_tension = g * cos(truth.x[0]) + truth.u.squaredNorm();
        const Real energy =
            kinetic_energy(bodies_[2]) + potential_energy(bodies_[2], {0, -g});
        const Real stretch = 1000 * (bodies_[2].x.norm() - 1);
        return {error(0),    error(1),      error(2), stretch,
                tension_[2], exact_tension, energy};
    }

    void draw(Canvas& canvas) const override
    {
        const std::array<Colour, 3> colours = {Colour::orange, Colour::purple,
                                               Colour::blue};
        const std::array<const char*, 3> names = {"h", "h/2", "h/4"};
        const Vec2 truth = place(exact_angle());
        canvas.segment({0, 0}, truth, {Colour::faint, 6, 1});
        canvas.disc(truth, 0.09, {Colour::ink, 1.5, 0.25, Paint::filled});
        canvas.disc({0, 0}, 0.02, paint::fixed);
        canvas.text({-1.4, 0.6}, "exact", 15, paint::label);
        for (std::size_t i = 0; i < 3; ++i) {
            const Vec2 x = bodies_[i].x;
            canvas.segment({0, 0}, x, {colours[i], 2, 1});
            canvas.disc(x, 0.05, {colours[i], 1.5, 0.5, Paint::filled});
            canvas.text({-1.4, 0.47 - 0.13 * static_cast<Real>(i)},
                        std::string(names[i]) + ": error of the angle " +
                            fixed(180 / pi * error(i), 2) + "°",
                        15, {colours[i], 1.5, 1});
        }
    }

private:
    static constexpr Real g = 9.81;
    static Vec2 place(Real angle) { return {sin(angle), -cos(angle)}; }
    Real exact_angle() const
    {
        return exact_pendulum(Pendulum{}, angle_, time_).x[0];
    }
    Real error(std::size_t i) const
    {
        const Vec2 truth = place(exact_angle());
        const Vec2 x = bodies_[i].x;
        return atan2(cross2(truth, x), truth.dot(x));
    }

    Real angle_, time_ = 0;
    std::array<Bodies<2>, 3> bodies_{Bodies<2>(1), Bodies<2>(1), Bodies<2>(1)};
    std::array<Real, 3> tension_{};
};

inline Demo pendulum_scene()
{
    Demo scene;
    scene.name = "pendulum";
    scene.summary = "A pendulum through a distance row with the steps h, h/2 and "
                    "h/4, beside the exact one";
    scene.view = {{0, -0.25}, {1.5, 1.05}};
    scene.h = 1.0 / 60;
    scene.methods = {"row", "spring"};
    scene.tunables = {{"angle", "°", "where it is let go at rest", 90, 1, 179,
                       Numbers::real, OnChange::restarts},
                      {"stiffness", "N/m",
                       "of the spring that stands in for the rod", 1000, 10, 1e5}};
    scene.columns = {
        {"error_h", "rad", "angle with the step h, less the exact one",
         Plot::linear},
        {"error_h2", "rad", "the same with h/2", Plot::linear},
        {"error_h4", "rad", "the same with h/4", Plot::linear},
        {"stretch", "mm", "length of the rod less 1 m, with h/4", Plot::linear},
        {"tension", "N", "mean pull of the rod in the step, with h/4",
         Plot::linear},
        {"tension_exact", "N", "pull of the rod in the exact motion", Plot::linear,
         "tension"},
        {"energy", "J", "kinetic and potential, with h/4", Plot::linear}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<PendulumRun>(settings);
    };
    return scene;
}

}  // namespace rigid
