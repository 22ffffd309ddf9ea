/// \file scene_wedge.hpp
/// A block on a wedge that may slide away under it; its answer is exact.
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

/// A block on a frictionless wedge that may slide on the floor. It starts again at the bottom.
class WedgeRun : public Run {
public:
    explicit WedgeRun(const Settings& settings)
        : bodies_(2), angle_(settings["angle"] * pi / 180),
          normal_(sin(angle_), cos(angle_))
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
            bilateral(alignment_constraint<2>(bodies_.x, world, 0, Vec2(0, 1), 0),
                      bodies_.inverse_mass),
            bilateral(alignment_constraint<2>(bodies_.x, 0, 1, normal_, offset_),
                      bodies_.inverse_mass)};
        const RowsAnswer answer = solve_rows(rows, bodies_.u);
        apply(rows, answer.lambda, bodies_.u);
        floor_ = answer.lambda[0] / h;
        force_ = answer.lambda[1] / h;
        acceleration_ = (bodies_.u[0] - before) / h;
        bodies_.x += h * bodies_.u;
        const Real run = bodies_.x[2] - bodies_.x[0];
        if (run > width - 0.16 || run < -0.2 || std::abs(bodies_.x[0]) > 2)
            rewind();
    }
    //! [wedge_step]

    std::vector<Real> measure() const override
    {
        const Real s = sin(angle_), c = cos(angle_);
        const Real N = m_ * g * c / (1 + m_ / M_ * s * s);
        return {acceleration_, -N * s / M_, force_, N, floor_};
    }

    void draw(Canvas& canvas) const override
    {
        const Vec2 wedge = bodies_.position(0), block = bodies_.position(1);
        const Real height = width * tan(angle_);
        canvas.segment({-1.6, 0}, {1.6, 0}, paint::wire);
        canvas.polygon({wedge, wedge + Vec2(width, 0), wedge + Vec2(0, height)},
                       {Colour::ink, 2, 0.2, Paint::filled});
        canvas.box(block, {half, half}, -angle_, paint::body);
        const Vec2 touch = block - half * normal_;
        labelled_arrow(canvas, touch, 0.05 * force_ * normal_, "+N",
                       paint::impulse);
        labelled_arrow(canvas, touch, -0.05 * force_ * normal_, "−N",
                       paint::impulse);
        labelled_arrow(canvas, block, {0, -0.05 * m_ * g}, "", paint::direction);
        const std::vector<Real> values = measure();
        canvas.text({-1.5, 1.31},
                    "force between block and wedge λ/h = " + fixed(values[2], 6) +
                        " N, exact " + fixed(values[3], 6) + " N",
                    15, paint::label);
        canvas.text({-1.5, 1.2},
                    "acceleration of the wedge " + fixed(values[0], 6) +
                        " m/s², exact " + fixed(values[1], 6) + " m/s²",
                    15, paint::label);
    }

private:
    static constexpr Real g = 9.81, width = 1.2, half = 0.1;

    /// The block at the top of the slope; x of the wedge is its lower left corner.
    void rewind()
    {
        bodies_.x << -0.2, 0, 0, 0;
        const Vec2 top(0.12, (width - 0.12) * tan(angle_));
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

inline Demo wedge_scene()
{
    Demo scene;
    scene.name = "wedge";
    scene.summary = "A block on a frictionless wedge that slides away under it";
    scene.view = {{0, 0.55}, {1.6, 0.85}};
    scene.h = 1.0 / 240;
    scene.methods = {"one-shot"};
    scene.tunables = {
        {"wedge", "kg", "mass of the wedge", 4, 0.1, 100},
        {"block", "kg", "mass of the block", 1, 0.1, 100},
        {"angle", "°", "slope", 30, 5, 45, Numbers::real, OnChange::restarts}};
    scene.columns = {
        {"acceleration", "m/s²", "of the wedge", Plot::linear},
        {"acceleration_exact", "m/s²", "closed form", Plot::linear, "acceleration"},
        {"force", "N", "λ/h between block and wedge", Plot::linear},
        {"force_exact", "N", "closed form", Plot::linear, "force"},
        {"floor", "N", "λ/h between floor and wedge", Plot::linear}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<WedgeRun>(settings);
    };
    return scene;
}

}  // namespace rigid
