/// \file scene_atwood.hpp
/// Atwood's machine: two masses on a rope over a pulley that turns; its answer is exact.
#pragma once

#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/02_velocity_constraints/program/drawing.hpp"
#include "chapters/02_velocity_constraints/solve_rows.hpp"
#include "common/elementary.hpp"
#include "common/forces.hpp"
#include "common/program/program.hpp"

#include <memory>
#include <string>
#include <vector>

namespace rigid {

/// Two masses on a rope over a pulley. The pulley is a body too: its one coordinate is the length of
/// rope that has run over its rim, its mass I/r². It starts again when a mass arrives at the pulley.
class AtwoodRun : public Run {
public:
    explicit AtwoodRun(const Settings&) : bodies_(3) { rewind(); }

    //! [atwood_step]
    void step(const Settings& settings, const Input& input) override
    {
        const Real h = settings.h;
        const bool turning = settings.method == "turning";
        m1_ = settings["m1"], m2_ = settings["m2"],
        m_ = turning ? settings["pulley"] : 0;
        bodies_.inverse_mass << 1 / m1_, 1 / m1_, 1 / m2_, 1 / m2_,
            2 / settings["pulley"], 0;
        bodies_.f.setZero();
        bodies_.f[1] = -m1_ * g;
        bodies_.f[3] = -m2_ * g;
        if (input.pressed) {
            const Index k = input.pointer.x() < 0 ? 0 : 1;
            add_pull(bodies_, k, {bodies_.position(k).x(), input.pointer.y()});
        }
        const Real before = bodies_.u[1];
        bodies_.u += h * bodies_.inverse_mass.cwiseProduct(bodies_.f);

        const Vec2 up(0, 1), rim(1, 0);
        // (2.29): what comes off the rim on the left goes on at the right
        if (turning) {
            const std::vector<Row<2>> rows = {
                bilateral(linear_constraint<2>(bodies_.x, 0, up, 2, rim, -1),
                          bodies_.inverse_mass),
                bilateral(linear_constraint<2>(bodies_.x, 1, up, 2, Vec2(-rim), -1),
                          bodies_.inverse_mass)};
            const RowsAnswer answer = solve_rows(rows, bodies_.u);
            apply(rows, answer.lambda, bodies_.u);
            left_ = answer.lambda[0] / h, right_ = answer.lambda[1] / h;
        } else {  // one rope, one tension
            const Row<2> row =
                bilateral(rope_constraint(bodies_.x, 0, {-r, 0}, 1, {r, 0}, 2),
                          bodies_.inverse_mass);
            const RowAnswer answer = solve_row(row, bodies_.u);
            row.apply(answer.lambda, bodies_.u);
            left_ = right_ = answer.lambda / h;
            bodies_.u[4] = -bodies_.u[1];
        }
        acceleration_ = (before - bodies_.u[1]) / h;
        bodies_.x += h * bodies_.u;
        if (std::max(bodies_.x[1], bodies_.x[3]) > -0.35) rewind();
    }
    //! [atwood_step]

    std::vector<Real> measure() const override
    {
        const Real a = (m1_ - m2_) * g / (m1_ + m2_ + m_ / 2);
        return {acceleration_, a, left_, m1_ * (g - a), right_, m2_ * (g + a)};
    }

    void draw(Canvas& canvas) const override
    {
        canvas.disc({0, 0}, r, {Colour::ink, 2, 0.15, Paint::filled});
        canvas.disc({0, 0}, 0.02, paint::fixed);
        const Real angle = bodies_.x[4] / r;
        for (int i = 0; i < 3; ++i) {
            const Real turned = angle + 2 * pi * i / 3;
            canvas.segment({0, 0}, 0.9 * r * Vec2(cos(turned), sin(turned)),
                           {Colour::ink, 1.5, 1});
        }
        std::vector<Vec2> rope = {bodies_.position(0)};
        for (int i = 0; i <= 40; ++i)
            rope.push_back({-r * cos(pi * i / 40), r * sin(pi * i / 40)});
        rope.push_back(bodies_.position(1));
        canvas.polyline(rope, {Colour::purple, 2, 1});
        const std::vector<Real> values = measure();
        for (Index k = 0; k < 2; ++k) {
            const Vec2 x = bodies_.position(k);
            const Real m = k == 0 ? m1_ : m2_, half = 0.09 * pow(m, 1. / 3);
            canvas.box(x, {half, half}, 0, paint::body);
            canvas.text(x - Vec2(0, 0.025), fixed(m, 1) + " kg", 13, paint::label,
                        Align::centre);
            const Vec2 side((k == 0 ? -1 : 1) * (half + 0.03), 0);
            canvas.arrow(x + side,
                         x + side + Vec2(0, 0.02 * (k == 0 ? left_ : right_)),
                         paint::impulse);
            canvas.arrow(x + side, x + side - Vec2(0, 0.02 * m * g),
                         paint::direction);
            canvas.text(x + side + Vec2(0.5 * side.x(), 0.1),
                        "λ/h = " + fixed(k == 0 ? left_ : right_, 3) + " N", 14,
                        paint::impulse, k == 0 ? Align::right : Align::left);
        }
        canvas.text({0, 0.42},
                    "a = " + fixed(values[0], 6) + " m/s², exact " +
                        fixed(values[1], 6) + " m/s²",
                    15, paint::label, Align::centre);
    }

private:
    static constexpr Real g = 9.81, r = 0.22;

    void rewind()
    {
        bodies_.x << -r, -1, r, -1, 0, 0;
        bodies_.u.setZero();
    }

    Bodies<2> bodies_;
    Real m1_ = 2, m2_ = 1, m_ = 1;
    Real acceleration_ = 0, left_ = 0, right_ = 0;
};

inline Demo atwood_scene()
{
    Demo scene;
    scene.name = "atwood";
    scene.summary = "Two masses on a rope over a pulley that turns: acceleration "
                    "and tensions are exact";
    scene.view = {{0, -0.8}, {1.3, 1.35}};
    scene.h = 1.0 / 240;
    scene.methods = {"turning", "massless"};
    scene.tunables = {
        {"m1", "kg", "mass on the left", 2, 0.1, 10},
        {"m2", "kg", "mass on the right", 1, 0.1, 10},
        {"pulley", "kg", "mass of the pulley, a uniform disc", 1, 0.01, 10}};
    scene.columns = {
        {"acceleration", "m/s²", "of the left mass, downwards", Plot::linear},
        {"acceleration_exact", "m/s²", "closed form", Plot::linear, "acceleration"},
        {"tension_left", "N", "λ/h of the left part of the rope", Plot::linear},
        {"tension_left_exact", "N", "closed form", Plot::linear, "tension_left"},
        {"tension_right", "N", "λ/h of the right part of the rope", Plot::linear},
        {"tension_right_exact", "N", "closed form", Plot::linear, "tension_right"}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<AtwoodRun>(settings);
    };
    return scene;
}

}  // namespace rigid
