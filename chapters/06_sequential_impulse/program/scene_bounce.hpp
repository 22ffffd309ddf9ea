/// \file scene_bounce.hpp
/// Three balls that bounce, with the height of each beside its closed form.
#pragma once

#include "chapters/06_sequential_impulse/program/impulse_scenes.hpp"

#include <array>
#include <memory>

namespace rigid {

/// Height over the floor at the time t of a ball that is dropped from `height` at t = 0: parabola after parabola,
/// each with e times the speed of the one before.
inline Real bouncing_height(Real height, Real e, Real g, Real t)
{
    Real v = std::sqrt(2 * g * height), begin = std::sqrt(2 * height / g);
    if (t < begin) return height - 0.5 * g * t * t;
    for (int bounce = 0; bounce < 1000; ++bounce) {
        v *= e;
        const Real flight = 2 * v / g;
        if (t < begin + flight) return (t - begin) * (v - 0.5 * g * (t - begin));
        begin += flight;
        if (flight < 1e-9) break;
    }
    return 0;
}

class BounceRun : public Run {
public:
    explicit BounceRun(const Settings& settings)
        : e_{settings["e_1"], settings["e_2"], settings["e_3"]}
    {
        for (std::size_t k = 0; k < 3; ++k) {
            scenes_[k] = column(1);
            scenes_[k].bodies.x[1] += settings["drop"];
        }
        drop_ = settings["drop"];
        note();
    }
    void step(const Settings& settings, const Input&) override
    {
        h_ = settings.h;
        for (std::size_t k = 0; k < 3; ++k) {
            ImpulseMethod method;
            method.correction.restitution = e_[k];
            if (settings.method == "none") method.correction.threshold = 0;
            if (settings.method == "fixed")
                method.correction.threshold = settings["slowest"] / (9.81 * h_);
            rigid::step(scenes_[k], {.h = h_}, method, now_);
        }
        ++steps_;
        note();
    }
    std::vector<Real> measure() const override
    {
        std::vector<Real> values;
        for (std::size_t k = 0; k < 3; ++k) values.push_back(height(k));
        for (std::size_t k = 0; k < 3; ++k)
            values.push_back(bouncing_height(drop_, e_[k], 9.81, t()));
        for (std::size_t k = 0; k < 3; ++k)
            values.push_back(scenes_[k].bodies.u[1]);
        return values;
    }
    void draw(Canvas& canvas) const override
    {
        const std::array colours = {Colour::blue, Colour::green, Colour::orange};
        canvas.segment({-1.0, 0}, {-0.3, 0}, paint::wall);
        canvas.segment({-0.2, 0}, {1.6, 0}, paint::axis);
        for (std::size_t k = 0; k < 3; ++k) {
            const Style style = {colours[k], 1.5, 0.4, Paint::filled};
            const Vec2 at(-0.9 + 0.25 * static_cast<Real>(k), 0.1 + height(k));
            canvas.disc(at, 0.1, style);
            canvas.text({at.x(), -0.1}, "e = " + significant(e_[k], 3), 13,
                        paint::label, Align::centre);
            canvas.polyline(heights_[k], {colours[k], 1.5, 1});
            std::vector<Vec2> theory;
            for (int i = 0; i <= 600; ++i) {
                const Real s = window_ * i / 600;
                theory.push_back(
                    in_chart(s, bouncing_height(drop_, e_[k], 9.81, s)));
            }
            canvas.polyline(theory, {Colour::ink, 1, 0.6, Paint::dashed});
        }
        canvas.text({1.6, -0.1}, significant(window_, 3) + " s", 13, paint::label,
                    Align::right);
        canvas.text({-0.2, -0.1}, "height against time; dashed: closed form", 13,
                    paint::label);
    }

private:
    Real t() const { return static_cast<Real>(steps_) * h_; }
    Real height(std::size_t k) const { return scenes_[k].bodies.x[1] - 0.1; }
    Vec2 in_chart(Real time, Real height) const
    {
        return {-0.2 + 1.8 * time / window_, height / drop_};
    }
    void note()
    {
        if (t() > window_) return;
        for (std::size_t k = 0; k < 3; ++k)
            heights_[k].push_back(in_chart(t(), height(k)));
    }

    std::array<Real, 3> e_;
    std::array<DiscScene, 3> scenes_;
    std::array<std::vector<Vec2>, 3> heights_;
    StepData<2> now_;
    Real drop_ = 1, h_ = 1.0 / 60;
    static constexpr Real window_ = 4.5;  ///< [s] that the chart shows
    long steps_ = 0;
};

inline Demo bounce_scene()
{
    Demo scene;
    scene.name = "bounce";
    scene.summary = "Three balls with e = 0.5, 0.8 and 1, and three thresholds "
                    "below which nothing bounces";
    scene.view = {{0.3, 0.55}, {1.4, 0.75}};
    scene.h_high = 1.0 / 20;
    scene.methods = {"scaled", "none", "fixed"};
    scene.side_by_side = {"scaled", "fixed"};
    scene.tunables = {
        {"e_1", "", "restitution of the first ball", 0.5, 0, 1, Numbers::real,
         OnChange::restarts},
        {"e_2", "", "of the second", 0.8, 0, 1, Numbers::real, OnChange::restarts},
        {"e_3", "", "of the third", 1, 0, 1, Numbers::real, OnChange::restarts},
        {"drop", "m", "height to fall from", 1, 0.1, 5, Numbers::real,
         OnChange::restarts},
        {"slowest", "m/s", "approach that still bounces, of method fixed", 1, 0, 3,
         Numbers::real, OnChange::restarts}};
    scene.columns = {
        {"height_1", "m", "of the first ball over the floor", Plot::linear},
        {"height_2", "m", "of the second", Plot::linear},
        {"height_3", "m", "of the third", Plot::linear},
        {"exact_1", "m", "what the closed form says", Plot::linear, "height_1"},
        {"exact_2", "m", "what the closed form says", Plot::linear, "height_2"},
        {"exact_3", "m", "what the closed form says", Plot::linear, "height_3"},
        {"speed_1", "m/s", "upwards"},
        {"speed_2", "m/s", "upwards"},
        {"speed_3", "m/s", "upwards"}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<BounceRun>(settings);
    };
    return scene;
}

}  // namespace rigid
