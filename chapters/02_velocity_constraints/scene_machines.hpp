/// \file scene_machines.hpp
/// Two machines with exact answers: Atwood's, and the block on a wedge that may slide.
#pragma once

#include "chapters/02_velocity_constraints/drawing.hpp"
#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/02_velocity_constraints/solve_rows.hpp"
#include "common/forces.hpp"
#include "common/program/program.hpp"

#include <memory>
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
        m1_ = settings["m1"], m2_ = settings["m2"], m_ = turning ? settings["pulley"] : 0;
        bodies_.inverse_mass << 1 / m1_, 1 / m1_, 1 / m2_, 1 / m2_, 2 / settings["pulley"], 0;
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
        if (turning) {  // (2.29): what comes off the rim on the left goes on at the right
            const std::vector<Row<2>> rows = {
                bilateral(linear_constraint<2>(bodies_.x, 0, up, 2, rim, -1), bodies_.inverse_mass),
                bilateral(linear_constraint<2>(bodies_.x, 1, up, 2, Vec2(-rim), -1), bodies_.inverse_mass)};
            const RowsAnswer answer = solve_rows(rows, bodies_.u);
            apply(rows, answer.lambda, bodies_.u);
            left_ = answer.lambda[0] / h, right_ = answer.lambda[1] / h;
        } else {  // one rope, one tension
            const Row<2> row =
                bilateral(rope_constraint(bodies_.x, 0, {-r, 0}, 1, {r, 0}, 2), bodies_.inverse_mass);
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
        canvas.disc({0, 0}, r, {Colour::ink, 2, 0.15, true, false});
        canvas.disc({0, 0}, 0.02, paint::fixed);
        const Real angle = bodies_.x[4] / r;
        for (int i = 0; i < 3; ++i) {
            const Real turned = angle + 2 * pi * i / 3;
            canvas.segment({0, 0}, 0.9 * r * Vec2(std::cos(turned), std::sin(turned)),
                           {Colour::ink, 1.5, 1, false, false});
        }
        std::vector<Vec2> rope = {bodies_.position(0)};
        for (int i = 0; i <= 40; ++i) rope.push_back({-r * std::cos(pi * i / 40), r * std::sin(pi * i / 40)});
        rope.push_back(bodies_.position(1));
        canvas.polyline(rope, {Colour::purple, 2, 1, false, false});
        const std::vector<Real> values = measure();
        for (Index k = 0; k < 2; ++k) {
            const Vec2 x = bodies_.position(k);
            const Real m = k == 0 ? m1_ : m2_, half = 0.09 * std::cbrt(m);
            canvas.box(x, {half, half}, 0, paint::body);
            canvas.text(x - Vec2(0, 0.025), fixed(m, 1) + " kg", 13, paint::label, Align::centre);
            const Vec2 side((k == 0 ? -1 : 1) * (half + 0.03), 0);
            canvas.arrow(x + side, x + side + Vec2(0, 0.02 * (k == 0 ? left_ : right_)), paint::impulse);
            canvas.arrow(x + side, x + side - Vec2(0, 0.02 * m * g), paint::direction);
            canvas.text(x + side + Vec2(0.5 * side.x(), 0.1),
                        "λ/h = " + fixed(k == 0 ? left_ : right_, 3) + " N", 14, paint::impulse,
                        k == 0 ? Align::right : Align::left);
        }
        canvas.text({0, 0.42}, "a = " + fixed(values[0], 6) + " m/s², exact " + fixed(values[1], 6) + " m/s²",
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

inline Scene atwood_scene()
{
    Scene scene;
    scene.name = "atwood";
    scene.summary = "Two masses on a rope over a pulley that turns: acceleration and tensions are exact";
    scene.view = {{0, -0.8}, {1.3, 1.35}};
    scene.h = 1.0 / 240;
    scene.methods = {"turning", "massless"};
    scene.tunables = {
        {"m1", "kg", "mass on the left", 2, 0.1, 10, false, false, false},
        {"m2", "kg", "mass on the right", 1, 0.1, 10, false, false, false},
        {"pulley", "kg", "mass of the pulley, a uniform disc", 1, 0.01, 10, false, false, false}};
    scene.columns = {{"acceleration", "m/s^2", "of the left mass, downwards", true, false},
                     {"acceleration_exact", "m/s^2", "closed form", false, false},
                     {"tension_left", "N", "λ/h of the left part of the rope", true, false},
                     {"tension_left_exact", "N", "closed form", false, false},
                     {"tension_right", "N", "λ/h of the right part of the rope", true, false},
                     {"tension_right_exact", "N", "closed form", false, false}};
    scene.start = [](const Settings& settings) { return std::make_unique<AtwoodRun>(settings); };
    return scene;
}

/// A block on a frictionless wedge that may slide on the floor. It starts again at the bottom.
class WedgeRun : public Run {
public:
    explicit WedgeRun(const Settings& settings)
        : bodies_(2), angle_(settings["angle"] * pi / 180), normal_(std::sin(angle_), std::cos(angle_))
    {
        rewind();
    }

    //! [wedge_step]
    void step(const Settings& settings, const Input& input) override
    {
        const Real h = settings.h;
        M_ = settings["wedge"], m_ = settings["block"];
        bodies_.inverse_mass << 1 / M_, 1 / M_, 1 / m_, 1 / m_;
        bodies_.f.setZero();
        add_gravity(bodies_, {0, -g});
        if (input.pressed) add_pull(bodies_, 1, input.pointer);
        const Real before = bodies_.u[0];
        bodies_.u += h * bodies_.inverse_mass.cwiseProduct(bodies_.f);

        // (2.30): the wedge stays on the floor, the block stays on the slope
        const std::vector<Row<2>> rows = {
            bilateral(alignment_constraint<2>(bodies_.x, world, 0, Vec2(0, 1), 0), bodies_.inverse_mass),
            bilateral(alignment_constraint<2>(bodies_.x, 0, 1, normal_, offset_), bodies_.inverse_mass)};
        const RowsAnswer answer = solve_rows(rows, bodies_.u);
        apply(rows, answer.lambda, bodies_.u);
        floor_ = answer.lambda[0] / h;
        force_ = answer.lambda[1] / h;
        acceleration_ = (bodies_.u[0] - before) / h;
        bodies_.x += h * bodies_.u;
        const Real run = bodies_.x[2] - bodies_.x[0];
        if (run > width - 0.16 || run < -0.2 || std::abs(bodies_.x[0]) > 2) rewind();
    }
    //! [wedge_step]

    std::vector<Real> measure() const override
    {
        const Real s = std::sin(angle_), c = std::cos(angle_);
        const Real N = m_ * g * c / (1 + m_ / M_ * s * s);
        return {acceleration_, -N * s / M_, force_, N, floor_};
    }

    void draw(Canvas& canvas) const override
    {
        const Vec2 wedge = bodies_.position(0), block = bodies_.position(1);
        const Real height = width * std::tan(angle_);
        canvas.segment({-1.6, 0}, {1.6, 0}, paint::wire);
        canvas.polygon({wedge, wedge + Vec2(width, 0), wedge + Vec2(0, height)},
                       {Colour::ink, 2, 0.2, true, false});
        canvas.box(block, {half, half}, -angle_, paint::body);
        const Vec2 touch = block - half * normal_;
        labelled_arrow(canvas, touch, 0.05 * force_ * normal_, "+N", paint::impulse);
        labelled_arrow(canvas, touch, -0.05 * force_ * normal_, "−N", paint::impulse);
        labelled_arrow(canvas, block, {0, -0.05 * m_ * g}, "", paint::direction);
        const std::vector<Real> values = measure();
        canvas.text({-1.5, 1.31},
                    "force between block and wedge λ/h = " + fixed(values[2], 6) + " N, exact " +
                        fixed(values[3], 6) + " N",
                    15, paint::label);
        canvas.text({-1.5, 1.2},
                    "acceleration of the wedge " + fixed(values[0], 6) + " m/s², exact " +
                        fixed(values[1], 6) + " m/s²",
                    15, paint::label);
    }

private:
    static constexpr Real g = 9.81, width = 1.2, half = 0.1;

    /// The block at the top of the slope; x of the wedge is its lower left corner.
    void rewind()
    {
        bodies_.x << -0.2, 0, 0, 0;
        const Vec2 top(0.12, (width - 0.12) * std::tan(angle_));
        bodies_.position(1) = bodies_.position(0) + top + half * normal_;
        bodies_.u.setZero();
        offset_ = normal_.dot(top) + half;
    }

    Bodies<2> bodies_;
    Real angle_;
    Vec2 normal_;
    Real offset_ = 0, M_ = 4, m_ = 1;
    Real acceleration_ = 0, force_ = 0, floor_ = 0;
};

inline Scene wedge_scene()
{
    Scene scene;
    scene.name = "wedge";
    scene.summary = "A block on a frictionless wedge that slides away under it";
    scene.view = {{0, 0.55}, {1.6, 0.85}};
    scene.h = 1.0 / 240;
    scene.methods = {"one-shot"};
    scene.tunables = {{"wedge", "kg", "mass of the wedge", 4, 0.1, 100, false, false, false},
                      {"block", "kg", "mass of the block", 1, 0.1, 100, false, false, false},
                      {"angle", "deg", "slope", 30, 5, 45, false, true, false}};
    scene.columns = {{"acceleration", "m/s^2", "of the wedge", true, false},
                     {"acceleration_exact", "m/s^2", "closed form", false, false},
                     {"force", "N", "λ/h between block and wedge", true, false},
                     {"force_exact", "N", "closed form", false, false},
                     {"floor", "N", "λ/h between floor and wedge", true, false}};
    scene.start = [](const Settings& settings) { return std::make_unique<WedgeRun>(settings); };
    return scene;
}

}  // namespace rigid
