/// \file scene_one_row.hpp
/// A bead on a circular wire, a disc beside a rail: one body, one row, and the formula that foretells its error.
#pragma once

#include "chapters/02_velocity_constraints/curves.hpp"
#include "chapters/02_velocity_constraints/geometry.hpp"
#include "chapters/04_pgs/program/drawing.hpp"
#include "chapters/07_baumgarte/closed_forms.hpp"
#include "chapters/07_baumgarte/one_row_step.hpp"
#include "chapters/07_baumgarte/program/stabilized_scenes.hpp"
#include "common/elementary.hpp"
#include "common/measure.hpp"

#include <functional>
#include <memory>

namespace rigid {

class OneRowRun : public Run {
public:
    OneRowRun(bool circle, const Settings& settings, const View& view)
        : circle_(circle), view_(view)
    {
        scene_.at = [circle](const VecX& x) {
            return circle ? circle_constraint(x, 0, 1)
                          : alignment_constraint<2>(x, world, 0, Vec2(0, 1), 0);
        };
        if (circle) scene_.bodies.x << 1, 0;
        else scene_.bodies.x << -0.9 * view.half_size.x(), 1;
        scene_.bodies.u << 0, 0;
        scene_.bodies.u[circle ? 1 : 0] = settings["speed"];
        theory_ = error();
        remember();
    }

    void step(const Settings& settings, const Input&) override
    {
        Correction& correction = method_.correction;
        correction.method = stabilizer_named(settings.method);
        correction.beta = settings["beta"];
        scene_.gravity = {0, circle_ ? -settings["gravity"] : 0};
        const Real h = settings.h;
        rigid::step(scene_, {.h = h}, method_, now_);
        if (!scene_.bodies.x.allFinite())
            throw StepFailure("the position of body 0 is not finite");
        const bool corrects = correction.method != Stabilizer::none;
        const Real beta = corrects ? correction.beta : 0;
        if (!circle_) theory_ *= 1 - beta;
        else if (!corrects || correction.method == Stabilizer::baumgarte)
            theory_ = std::sqrt(1 + next_bead(theory_ * (2 + theory_), beta,
                                              h * settings["speed"])) -
                      1;
        else theory_ = 0;
        remember();
    }

    std::vector<Real> measure() const override
    {
        return {error(), theory_,
                now_.solution.lambda.size() > 0 ? now_.solution.lambda[0] : 0,
                kinetic_energy(scene_.bodies)};
    }

    void draw(Canvas& canvas) const override
    {
        std::vector<Vec2> wire;
        for (int i = 0; i <= 200; ++i)
            wire.push_back(circle_
                               ? Vec2(cos(2 * pi * i / 200), sin(2 * pi * i / 200))
                               : Vec2(view_.half_size.x() * (i / 100.0 - 1), 0));
        canvas.polyline(wire, paint::wall);
        canvas.polyline(trail_, {Colour::purple, 1.2, 0.9});
        canvas.disc(scene_.bodies.x, 0.05, paint::body);
        canvas.arrow(scene_.bodies.x,
                     scene_.bodies.x +
                         0.4 * scene_.bodies.u /
                             std::max(Real{1}, scene_.bodies.u.norm()),
                     paint::error);
        const Vec2 corner =
            view_.centre + Vec2(-0.95, 0.9).cwiseProduct(view_.half_size);
        canvas.text(corner, "off by " + significant(1000 * error(), 3) + " mm", 14,
                    paint::label);
        if (theory_ != 0)
            canvas.text(corner - Vec2(0, 0.1 * view_.half_size.y()),
                        "theory " + significant(1000 * theory_, 3) + " mm", 14,
                        paint::label);
    }

private:
    /// Distance from the wire, outwards or upwards [m].
    Real error() const
    {
        return circle_ ? scene_.bodies.x.norm() - 1 : scene_.bodies.x[1];
    }
    void remember()
    {
        trail_.push_back(scene_.bodies.x);
        if (trail_.size() > 3000)
            trail_.erase(trail_.begin(), trail_.begin() + 1000);
    }

    bool circle_;
    View view_;
    OneRowScene<std::function<Constraint<2>(const VecX&)>> scene_;
    OneRowMethod method_;
    StepData<2> now_;
    std::vector<Vec2> trail_;
    Real theory_ = 0;
};

inline Demo one_row_scene(bool circle)
{
    Demo scene;
    scene.name = circle ? "bead" : "rail";
    scene.summary =
        circle
            ? "A bead on a wire of radius 1 m: it drifts off, or settles beside it"
            : "A disc 1 m beside its rail: the error shrinks by 1 − beta in each "
              "step";
    scene.view = circle ? View{{0, 0}, {2, 1.9}} : View{{0, 0}, {1.7, 1.3}};
    scene.h = circle ? 0.01 : 1.0 / 60;
    scene.h_low = 1e-4;
    scene.h_high = 0.5;
    scene.methods = stabilizer_names();
    scene.side_by_side = {"baumgarte", "none", "projection"};
    scene.tunables = {tunables::beta(0.2, 2.5, Keys::up_and_down),
                      tunables::at_start("speed", "m/s", "at the start",
                                         circle ? 1.0 : 0.5, 0, 10)};
    if (circle)
        scene.tunables.push_back(
            tunables::number("gravity", "m/s²", "downwards", 0, 0, 20));
    scene.columns = {
        {"error", "m", "distance from the wire, outwards", Plot::linear},
        {"theory", "m",
         circle ? "(7.3) or (7.17), without gravity; 0 for the other ways"
                : "(7.5)",
         Plot::linear, "error"},
        {"lambda", "N s", "impulse of the row"},
        {"kinetic", "J", "kinetic energy", Plot::linear}};
    scene.start = [circle, view = scene.view](const Settings& settings) {
        return std::make_unique<OneRowRun>(circle, settings, view);
    };
    return scene;
}

}  // namespace rigid
