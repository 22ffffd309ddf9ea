/// \file scene_groove.hpp
/// A disc falls into a groove: two contacts that help each other, and what the two ways of clamping make of it.
#pragma once

#include "chapters/04_pgs/program/drawing.hpp"
#include "chapters/06_sequential_impulse/program/impulse_run.hpp"
#include "chapters/06_sequential_impulse/small_scenes.hpp"

#include <memory>

namespace rigid {

class GrooveRun : public Run {
public:
    explicit GrooveRun(const Settings& settings)
        : angle_(settings["angle"] * pi / 180), scene_(groove(angle_)), rest_(scene_.bodies.position(0))
    {
        scene_.bodies.x[1] += settings["drop"];
        method_.solver.random = Random(settings.seed);
    }
    void step(const Settings& settings, const Input&) override
    {
        choose_solver(settings, method_.solver);
        rigid::step(scene_, {.h = settings.h, .margin = settings["margin"]}, method_, now_);
        trail_.push_back(scene_.bodies.position(0));
        h_ = settings.h;
    }
    std::vector<Real> measure() const override
    {
        const Vec2 off = scene_.bodies.position(0) - rest_, u = scene_.bodies.velocity(0);
        const VecX& lambda = now_.solution.lambda;
        return {off.x(),
                off.y(),
                u.x(),
                u.y(),
                u.norm() / (9.81 * h_),
                lambda.size() == 2 ? lambda[0] / h_ : 0,
                lambda.size() == 2 ? lambda[1] / h_ : 0};
    }
    void draw(Canvas& canvas) const override
    {
        for (const Real side : {-1.0, 1.0})
            canvas.segment({0, 0}, 0.55 * Vec2(side * std::cos(angle_), std::sin(angle_)), paint::wall);
        canvas.disc(rest_, 0.1, {Colour::faint, 1, 1, false, true});
        canvas.disc(scene_.bodies.position(0), 0.1, paint::body);
        canvas.polyline(trail_, {Colour::blue, 1.5, 0.7, false, false});
        for (std::size_t i = 0; i < now_.rows.size(); ++i) {
            const Vec2 n = now_.rows[i].Jb.transpose(), touch = scene_.bodies.position(0) - 0.1 * n;
            const Real force = now_.solution.lambda[static_cast<Index>(i)] / h_;
            if (force > 0.1) canvas.arrow(touch, touch + std::min(0.3, 0.015 * force) * n, paint::impulse);
        }
        const Vec2 off = 1000 * (scene_.bodies.position(0) - rest_);
        canvas.text({-0.52, 0.42}, "off its place by " + fixed(off.x(), 2) + ", " + fixed(off.y(), 2) + " mm",
                    14, paint::label);
        canvas.text({-0.52, 0.375}, "speed " + significant(scene_.bodies.u.norm() / (9.81 * h_), 3) + " g h",
                    14, paint::label);
    }

private:
    Real angle_;
    DiscScene scene_;
    Vec2 rest_;
    WrongClampingMethod method_;
    StepData<2> now_;
    std::vector<Vec2> trail_;
    Real h_ = 1.0 / 60;
};

inline Demo groove_scene()
{
    Demo scene;
    scene.name = "groove";
    scene.summary = "A disc falls into a groove: clamp the sum of the impulses, or each correction";
    scene.view = {{0, 0.2}, {0.56, 0.27}};
    scene.h_high = 1.0 / 30;
    scene.methods = impulse_methods();
    scene.side_by_side = {"given", "correction"};
    scene.tunables = sweep_tunables(10, 0);
    scene.tunables.push_back({"angle", "°", "of the sides of the groove", 30, 1, 85, false, true, true});
    scene.tunables.push_back({"drop", "m", "height to fall from", 0.2, 0, 0.3, false, true, false});
    scene.tunables.push_back({"margin", "m", "a contact gets its row when its gap is below this", 0.02, 1e-9,
                              0.1, false, false, false});
    scene.columns = {{"x", "m", "off its place of rest", true, false},
                     {"y", "m", "off its place of rest", true, false},
                     {"u_x", "m/s", "velocity", false, false},
                     {"u_y", "m/s", "velocity", false, false},
                     {"speed_gh", "", "speed, in units of g h", true, false},
                     {"force_1", "N", "of the side that rises to the left; visited first", true, false},
                     {"force_2", "N", "of the other side", true, false}};
    scene.start = [](const Settings& settings) { return std::make_unique<GrooveRun>(settings); };
    return scene;
}

}  // namespace rigid
