/// \file cloth_run.hpp
/// One scene of cloth, under one of this chapter's methods. Scenes of cloth that touches have more in their state; what that
/// is draws itself.
#pragma once

#include "chapters/20_turning_in_space/program/solid_picture.hpp"
#include "chapters/27_particles_and_cloth/cloth_scenes.hpp"
#include "chapters/27_particles_and_cloth/cloth_step.hpp"
#include "common/program/demo_of.hpp"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

template <class Cloth, class Memory>
struct ClothStateOf {
    using Scene = Cloth;
    Cloth cloth;
    Memory memory;
    Real t = 0;
    Real energy = 0;  ///< at the start [J]
    Real stiff = 0;   ///< springs that count as threads have at least this k [N/m]
};
using ClothState = ClothStateOf<ClothScene, ClothMemory>;

template <class State>
struct ClothSetup {
    typename State::Scene cloth;
    Camera camera;
    Real ground = 0;    ///< half the side of the floor that is drawn [m]; 0: none
    bool mesh = false;  ///< springs are drawn, too
    std::vector<Vec3> curve = {};  ///< drawn beside it; empty: none
    std::function<std::vector<Real>(const State&)> measure;
    std::function<void(State&, const Settings&)> change;
};

/// What a cloth touches; this one nothing.
inline void draw_solids(SolidPicture&, const ClothScene&) {}

/// A tunable that not every scene has.
inline Real value_or(const Settings& settings, const char* name, Real other)
{
    return settings.tunables.contains(name) ? settings[name] : other;
}

template <class State>
class ClothRun : public Run {
public:
    ClothRun(ClothSetup<State> setup, const Settings&) : setup_(std::move(setup))
    {
        state_.cloth = setup_.cloth;
        state_.energy = energy(state_.cloth);
        Real most = 0;
        for (const ClothSpring& s : state_.cloth.springs)
            most = std::max(most, s.stiffness);
        state_.stiff = most / 2;
        require_valid(state_.cloth);
    }

    void step(const Settings& settings, const Input& input) override
    {
        if (setup_.change) setup_.change(state_, settings);
        hold(settings, input);
        ClothSettings how;
        how.h = settings.h;
        how.method =
            cloth_method(settings.method == "forgotten" ? "xpbd" : settings.method);
        how.keep_lambda = settings.method != "forgotten";
        how.substeps = static_cast<int>(settings["substeps"]);
        how.sweeps = static_cast<int>(settings["sweeps"]);
        if (const Real limit = value_or(settings, "limit", 0); limit > 0)
            how.strain_limit = limit / 100, how.limit_stiffness = state_.stiff;
        if (const Real strength = value_or(settings, "strength", 0); strength > 0)
            how.strength = strength / 100;
        using rigid::step;  // of a cloth that touches: its own
        step(state_.cloth, how, state_.memory);
        for (Index k = 0; k < state_.cloth.bodies.count(); ++k)
            if (!state_.cloth.bodies.position(k).allFinite())
                throw StepFailure("the position of particle " + std::to_string(k) +
                                  " is not finite");
        state_.t += settings.h;
    }

    std::vector<Real> measure() const override { return setup_.measure(state_); }

    void look(const Settings& settings, const Input&) override
    {
        camera_ = setup_.camera;
        camera_.azimuth += settings["camera"] * pi / 180;
    }

    void draw(Canvas& canvas) const override
    {
        const auto& cloth = state_.cloth;
        SolidPicture picture(camera_, Skin::opaque);
        if (setup_.ground > 0) picture.ground(setup_.ground, 0);
        draw_solids(picture, cloth);
        const auto at = [&cloth](int p) -> Vec3 {
            return cloth.bodies.position(p);
        };
        for (const auto& t : cloth.triangles) {
            // both sides of a cloth are seen
            picture.facet({at(t[0]), at(t[1]), at(t[2])}, Colour::green);
            picture.facet({at(t[0]), at(t[2]), at(t[1])}, Colour::blue);
        }
        if (setup_.mesh || cloth.triangles.empty())
            for (const ClothSpring& s : cloth.springs)
                picture.line({at(s.a), at(s.b)}, {Colour::blue, 1.5, 0.9});
        if (!setup_.curve.empty()) picture.line(setup_.curve, {Colour::red, 2, 1});
        if (cloth.count() < 12)
            for (int k = 0; k < cloth.count(); ++k)
                picture.line({at(k) - Vec3(0.04, 0, 0), at(k) + Vec3(0.04, 0, 0)},
                             {Colour::red, 6, 1});
        if (held_ >= 0) picture.line({at(held_), hand_}, {Colour::red, 2, 1});
        picture.paint(canvas);
    }

private:
    /// The hand moves the particle that was nearest to it, at its depth.
    void hold(const Settings& settings, const Input& input)
    {
        Bodies<3>& bodies = state_.cloth.bodies;
        if (held_ >= 0 && !input.pressed) {
            bodies.inverse_mass.segment<3>(3 * held_).setConstant(inverse_mass_);
            bodies.velocity(held_).setZero();
            ++state_.cloth.changes;
            held_ = -1;
        }
        if (!input.pressed) return;
        if (held_ < 0) {
            Real nearest = infinity;
            for (int k = 0; k < state_.cloth.count(); ++k)
                if (const Real d =
                        (camera_.project(bodies.position(k)) - input.pointer)
                            .norm();
                    d < nearest)
                    nearest = d, held_ = k;
            inverse_mass_ = bodies.inverse_mass[3 * held_];
            bodies.inverse_mass.segment<3>(3 * held_).setZero();
            ++state_.cloth.changes;
        }
        const Mat3 axes = camera_.axes();
        Vec3 seen = axes * (bodies.position(held_) - camera_.target);
        const Real scale = camera_.distance / std::max(camera_.distance - seen.z(),
                                                       0.05 * camera_.distance);
        seen.head<2>() = input.pointer / scale;
        hand_ = camera_.target + axes.transpose() * seen;
        const Vec3 way = hand_ - bodies.position(held_);
        const Real size = way.norm(), most = 5 * settings.h;  // at 5 m/s
        bodies.velocity(held_) = way * (size > most ? most / size : 1) / settings.h;
    }

    ClothSetup<State> setup_;
    State state_;
    Camera camera_;
    int held_ = -1;
    Real inverse_mass_ = 0;
    Vec3 hand_ = {0, 0, 0};
};

/// The methods that have finite springs, all of them.
inline const std::vector<std::string> cloth_methods{
    "threads",  "xpbd",   "pbd",      "particles", "augmented", "projective",
    "implicit", "newton", "midpoint", "exact",     "forgotten", "explicit"};

template <class State>
Demo cloth_demo(const std::string& name, const std::string& summary,
                const View& view, int substeps, int sweeps,
                std::function<ClothSetup<State>(const Settings&)> setup)
{
    Demo scene = demo_of<ClothRun<State>>(
        name, summary, view, 1.0 / 60, cloth_methods,
        {{"camera", "°", "where the eye is, around the scene", 0, -180, 180},
         {"substeps", "", "of a step", static_cast<Real>(substeps), 1, 200,
          Numbers::whole},
         {"sweeps", "", "of a sub-step, or passes", static_cast<Real>(sweeps), 1,
          500, Numbers::whole}},
        std::move(setup));
    scene.held = "pulls the cloth";
    return scene;
}

/// What most scenes measure.
inline const std::vector<Column> cloth_columns{
    {"stretch", "%", "of the thread that is stretched most", Plot::linear},
    {"mean", "%", "stretch of the threads", Plot::linear},
    {"energy", "J", "less that of the start", Plot::linear}};

template <class State>
std::vector<Real> cloth_measures(const State& s)
{
    return {100 * largest_stretch(s.cloth, s.stiff),
            100 * mean_stretch(s.cloth, s.stiff), energy(s.cloth) - s.energy};
}

}  // namespace rigid
