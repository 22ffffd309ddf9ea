/// \file scene_cradle.hpp
/// Newton's cradle under the two laws of impact.
#pragma once

#include "chapters/06_sequential_impulse/program/impulse_scenes.hpp"
#include "chapters/06_sequential_impulse/small_scenes.hpp"
#include "common/elementary.hpp"

#include <memory>

namespace rigid {

class CradleRun : public Run {
public:
    explicit CradleRun(const Settings& settings)
        : count_(static_cast<Index>(settings["balls"])),
          scene_(cradle(count_,
                        std::min(static_cast<Index>(settings["lifted"]), count_),
                        settings["angle"] * pi / 180))
    {
        start_ = energy();
    }
    void step(const Settings& settings, const Input& input) override
    {
        StepSettings step;
        step.h = settings.h;
        now_.restitution = settings["restitution"];
        now_.sweeps = sweeps_of(settings);
        step.hand = input.pointer;
        held_ = held_disc(scene_, input.pressed, step.hand, held_);
        step.pulled = held_;
        const ImpactOrder law = settings.method == "sequential"
                                    ? ImpactOrder::sequential
                                    : ImpactOrder::simultaneous;
        impact_step(scene_, step, law, now_);
        if (!scene_.bodies.x.allFinite())
            throw StepFailure("a position is not finite");
    }
    std::vector<Real> measure() const override
    {
        return {angle(0),
                angle(count_ / 2),
                angle(count_ - 1),
                energy() - start_,
                momentum(scene_.bodies).x(),
                largest_link_error(scene_)};
    }
    void draw(Canvas& canvas) const override
    {
        canvas.segment({-0.12 * static_cast<Real>(count_), 1},
                       {0.12 * static_cast<Real>(count_), 1}, paint::wall);
        for (Index k = 0; k < count_; ++k) {
            canvas.segment(scene_.bodies.position(count_ + k),
                           scene_.bodies.position(k), paint::axis);
            canvas.disc(scene_.bodies.position(k), 0.1, paint::body);
        }
        canvas.text({0, -0.3},
                    "energy " + significant(100 * energy_left(), 4) + " %", 14,
                    paint::label, Align::centre);
    }

private:
    Real angle(Index k) const
    {
        const Vec2 d =
            scene_.bodies.position(k) - scene_.bodies.position(count_ + k);
        return atan2(d.x(), -d.y()) * 180 / pi;
    }
    Real energy() const { return mechanical_energy(scene_); }
    Real energy_left() const { return start_ > 0 ? energy() / start_ : 1; }

    Index count_, held_ = world;
    DiscScene scene_;
    ImpactStep now_;
    Real start_ = 0;
};

inline Demo cradle_scene()
{
    Demo scene;
    scene.name = "cradle";
    scene.summary = "Newton's cradle: impacts one after the other, or all at once";
    scene.view = {{0, 0.4}, {1.2, 0.78}};
    scene.h = 1.0 / 960;
    scene.h_low = 1e-4;
    scene.h_high = 1.0 / 120;
    scene.methods = {"sequential", "simultaneous"};
    scene.side_by_side = scene.methods;
    scene.tunables = sweep_tunables(200, 9);
    scene.tunables.push_back(
        {"balls", "", "N", 5, 2, 9, Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"lifted", "", "balls that are drawn aside", 1, 1, 8,
                              Numbers::whole, OnChange::restarts,
                              Keys::up_and_down});
    scene.tunables.push_back(
        {"angle", "°", "by so much", 30, 0, 60, Numbers::real, OnChange::restarts});
    scene.tunables.push_back(tunables::restitution(1));
    scene.columns = {
        {"first", "°", "angle of the first ball", Plot::linear},
        {"middle", "°", "angle of the middle one", Plot::linear},
        {"last", "°", "angle of the last one", Plot::linear},
        {"energy_gain", "J", "energy now less that at the start", Plot::linear},
        {"momentum_x", "N s", "of all balls", Plot::linear},
        {"link_error", "m", "largest difference of a rod from its length",
         Plot::logarithmic}};
    scene.start = [](const Settings& settings) {
        return std::make_unique<CradleRun>(settings);
    };
    return scene;
}

}  // namespace rigid
