/// \file scene_machines.hpp
/// Discs with joints that are rows with other bounds; the first are three lifts.
#pragma once

#include "chapters/04_pgs/program/drawing.hpp"
#include "chapters/06_sequential_impulse/lift.hpp"
#include "chapters/06_sequential_impulse/program/impulse_run.hpp"
#include "common/program/program.hpp"

#include <memory>

namespace rigid {

/// A scene of a few discs with joints that the reader can set.
class MachineRun : public Run {
public:
    void step(const Settings& settings, const Input&) override
    {
        scene_.gravity = {0, -settings["gravity"]};
        scene_.joints.clear();
        add_joints(settings);
        choose_solver(settings, method_.solver);
        rigid::step(scene_, {.h = settings.h}, method_, now_);
        if (!scene_.bodies.x.allFinite()) throw StepFailure("a position is not finite");
        h_ = settings.h;
        ++steps_;
    }

protected:
    /// The joints as the reader has set them.
    virtual void add_joints(const Settings& settings) = 0;

    /// The force of joint i [N].
    Real force_of(std::size_t i) const
    {
        const std::size_t first = now_.rows.size() - scene_.joints.size();
        return now_.rows.empty() ? 0 : now_.solution.lambda[static_cast<Index>(first + i)] / h_;
    }
    Real t() const { return static_cast<Real>(steps_) * h_; }

    DiscScene scene_;
    WrongClampingMethod method_;
    StepData<2> now_;
    Real h_ = 1;
    long steps_ = 0;
};

inline Demo machine_scene(const std::string& name, const std::string& summary)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.h_high = 1.0 / 30;
    scene.methods = {"given", "coloured", "blocks"};
    scene.tunables = sweep_tunables(100, 9);
    scene.tunables.push_back({"gravity", "m/s²", "size of gravity", 9.81, 0, 20, false, false, false});
    return scene;
}

/// Three lifts of 1 kg whose motors have less force than the weight, a little more, and twice as much.
class LiftRun : public MachineRun {
public:
    LiftRun()
    {
        scene_.bodies = Bodies<2>(3);
        scene_.radius = VecX::Constant(3, 0.12);
        for (Index k = 0; k < 3; ++k) scene_.bodies.position(k) = Vec2(shaft(k), 0.5);
    }
    std::vector<Real> measure() const override
    {
        std::vector<Real> values;
        for (Index k = 0; k < 3; ++k) values.push_back(scene_.bodies.velocity(k).y());
        for (Index k = 0; k < 3; ++k) values.push_back(scene_.bodies.position(k).y());
        for (std::size_t k = 0; k < 3; ++k) values.push_back(force_of(4 * k + 1));
        return values;
    }
    void draw(Canvas& canvas) const override
    {
        for (Index k = 0; k < 3; ++k) {
            const Real x = shaft(k);
            const Vec2 p = scene_.bodies.position(k);
            canvas.segment({x, low}, {x, high}, paint::grid);
            for (const Real y : {low - 0.12, high + 0.12})
                canvas.segment({x - 0.2, y}, {x + 0.2, y}, paint::wall);
            canvas.box(p, {0.16, 0.12}, 0, paint::body);
            const Real motor = force_of(4 * static_cast<std::size_t>(k) + 1);
            if (std::abs(motor) > 0.1) canvas.arrow(p, p + Vec2(0, 0.02 * motor), paint::impulse);
            canvas.text({x, low - 0.25}, "F = " + fixed(share(k), 1) + " mg", 15, paint::label,
                        Align::centre);
            canvas.text({x, low - 0.34},
                        significant(p.y() < high ? scene_.bodies.velocity(k).y() : 0, 3) + " m/s", 14,
                        paint::label, Align::centre);
        }
    }

private:
    static constexpr Real low = 0.2, high = 1.8;
    static Real shaft(Index k) { return -0.6 + 0.6 * static_cast<Real>(k); }
    static Real share(Index k) { return k == 0 ? 0.9 : k == 1 ? 1.1 : 2.0; }

    void add_joints(const Settings& settings) override
    {
        for (Index k = 0; k < 3; ++k)
            add_lift(scene_, {k, shaft(k), low, high, settings["speed"], share(k) * settings["gravity"]});
    }
};

inline Demo lift_scene()
{
    Demo scene =
        machine_scene("lift", "Three lifts with motors of 0.9, 1.1 and 2 times the weight, between stops");
    scene.view = {{0, 0.9}, {1.1, 1.2}};
    scene.tunables.push_back(
        {"speed", "m/s", "that the motors want; negative = down", 0.5, -2, 2, false, false, true});
    scene.columns = {{"speed_weak", "m/s", "of the lift with 0.9 times the weight", true, false},
                     {"speed_fair", "m/s", "of the lift with 1.1 times", true, false},
                     {"speed_strong", "m/s", "of the lift with 2 times", true, false},
                     {"height_weak", "m", "of that lift", false, false},
                     {"height_fair", "m", "of that lift", false, false},
                     {"height_strong", "m", "of that lift", false, false},
                     {"force_weak", "N", "of that lift's motor", true, false},
                     {"force_fair", "N", "of that lift's motor", true, false},
                     {"force_strong", "N", "of that lift's motor", true, false}};
    scene.start = [](const Settings&) { return std::make_unique<LiftRun>(); };
    return scene;
}

}  // namespace rigid
