/// \file rigid_run.hpp
/// One scene of bodies that turn, under one of this chapter's methods.
#pragma once

#include "chapters/11_rotation/mechanisms.hpp"
#include "chapters/11_rotation/program/turning_run.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// What a scene's measures and pictures are made of.
struct RigidState {
    RigidScene scene;
    StepData<3> now;
    Real t = 0, h = 0;
    VecX before;  ///< velocities before the last step
    std::vector<Vec2> trail;
};

struct RigidSetup {
    RigidScene scene;
    std::function<std::vector<Real>(const RigidState&)> measure;
    /// besides bodies, joints and walls
    std::function<void(Canvas&, const RigidState&)> picture;
    /// a body whose point leaves a trail
    Index traced = world;
    Vec2 traced_point = {0, 0};
    /// what tunables change while it runs
    std::function<void(RigidScene&, const Settings&)> change;
    /// there is nothing more to see: the scene begins again
    std::function<bool(const RigidScene&)> over;
};

class RigidRun : public Run {
public:
    RigidRun(RigidSetup setup, const Settings& settings) : setup_(std::move(setup))
    {
        state_.scene = setup_.scene;
        state_.h = settings.h;
        state_.before = state_.scene.bodies.u;
        trace();
    }

    void step(const Settings& settings, const Input& input) override
    {
        RigidScene& scene = state_.scene;
        if (setup_.change) setup_.change(scene, settings);
        const StepSettings how = step_settings(settings, input, scene.bodies);
        const Real e =
            settings.tunables.contains("restitution") ? settings["restitution"] : 0;
        state_.before = scene.bodies.u;
        if (settings.method == "exact") {
            exact_.correction = exact_repair();
            exact_.correction.restitution = e;
            rigid::step(scene, how, exact_, state_.now);
        } else if (settings.method == "rattle") {
            rattle_.correction.restitution = e;
            rigid::step(scene, how, rattle_, state_.now);
        } else {
            sweeps_.correction.method = settings.method == "baumgarte"
                                            ? Stabilizer::baumgarte
                                            : Stabilizer::projection;
            sweeps_.correction.restitution = e;
            sweeps_.solver.sweeps.max_sweeps = static_cast<int>(settings["sweeps"]);
            rigid::step(scene, how, sweeps_, state_.now);
        }
        require_finite_state(scene.bodies);
        state_.t += settings.h;
        state_.h = settings.h;
        if (setup_.over && setup_.over(scene)) scene = setup_.scene;
        trace();
    }

    std::vector<Real> measure() const override { return setup_.measure(state_); }

    void draw(Canvas& canvas) const override
    {
        const RigidScene& scene = state_.scene;
        for (const HalfSpace& wall : scene.walls) paint_half_space(canvas, wall);
        canvas.polyline(state_.trail, {Colour::purple, 1.2, 0.9});
        for (Index k = 0; k < scene.bodies.count(); ++k)
            paint_rigid_body(canvas, scene, k);
        paint_rigid_joints(canvas, scene);
        if (setup_.picture) setup_.picture(canvas, state_);
    }

private:
    void trace()
    {
        if (setup_.traced == world) return;
        state_.trail.push_back(
            point_of(state_.scene.bodies.x, setup_.traced, setup_.traced_point));
        if (state_.trail.size() > 3000)
            state_.trail.erase(state_.trail.begin(), state_.trail.begin() + 1000);
    }
    RigidSetup setup_;
    RigidState state_;
    RigidExact exact_;
    RigidRattle rattle_;
    RigidSweeps sweeps_;
};

/// A scene with the methods and the tunables that all of them have.
inline Demo rigid_demo(const std::string& name, const std::string& summary,
                       const View& view,
                       const std::function<RigidSetup(const Settings&)>& setup)
{
    return turning_demo<RigidRun>(name, summary, view, 1.0 / 240,
                                  {"exact", "rattle", "sweeps", "baumgarte"},
                                  setup);
}

}  // namespace rigid
