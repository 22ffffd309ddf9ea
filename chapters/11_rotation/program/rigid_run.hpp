/// \file rigid_run.hpp
/// One scene of bodies that turn, under one of this chapter's methods.
#pragma once

#include "chapters/04_pgs/program/drawing.hpp"
#include "chapters/11_rotation/mechanisms.hpp"
#include "common/program/program.hpp"

#include <functional>
#include <memory>
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
        StepSettings how{.h = settings.h,
                         .substeps = static_cast<int>(settings["substeps"])};
        if (input.pressed) pull(input.pointer, how);
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
        for (Index k = 0; k < scene.bodies.count(); ++k)
            if (!scene.bodies.position(k).allFinite() ||
                !scene.bodies.velocity(k).allFinite())
                throw StepFailure("the state of body " + std::to_string(k) +
                                  " is not finite");
        state_.t += settings.h;
        state_.h = settings.h;
        trace();
    }

    std::vector<Real> measure() const override { return setup_.measure(state_); }

    void draw(Canvas& canvas) const override
    {
        const RigidScene& scene = state_.scene;
        for (const HalfSpace& wall : scene.walls) paint_wall(canvas, wall);
        canvas.polyline(state_.trail, {Colour::purple, 1.2, 0.9, false, false});
        for (Index k = 0; k < scene.bodies.count(); ++k) paint_body(canvas, k);
        for (const PointJoint& joint : scene.joints) {
            if (joint.measure == PointJoint::Measure::angle) continue;
            const Vec2 a = point_of(scene.bodies.x, joint.a, joint.at_a),
                       b = point_of(scene.bodies.x, joint.b, joint.at_b);
            if (joint.measure == PointJoint::Measure::distance)
                canvas.segment(a, b, {Colour::purple, 2, 1, false, false});
            canvas.disc(b, 0.025, {Colour::orange, 1, 1, true, false});
        }
        if (setup_.picture) setup_.picture(canvas, state_);
    }

private:
    void pull(const Vec2& pointer, StepSettings& how) const
    {
        const Bodies<3>& bodies = state_.scene.bodies;
        Real nearest = infinity;
        for (Index k = 0; k < bodies.count(); ++k) {
            const Real distance = (bodies.position(k).head<2>() - pointer).norm();
            if (bodies.can_move(k) && distance < nearest)
                nearest = distance, how.pulled = k;
        }
        how.hand = pointer;
    }
    void trace()
    {
        if (setup_.traced == world) return;
        state_.trail.push_back(
            point_of(state_.scene.bodies.x, setup_.traced, setup_.traced_point));
        if (state_.trail.size() > 3000)
            state_.trail.erase(state_.trail.begin(), state_.trail.begin() + 1000);
    }
    static void paint_wall(Canvas& canvas, const HalfSpace& wall)
    {
        const Vec2 middle = wall.normal * wall.offset,
                   along = 3 * perpendicular(wall.normal);
        const bool upright = std::abs(wall.normal.x()) > 0.5;
        canvas.segment(upright ? middle : Vec2(middle - along),
                       middle + (upright ? Vec2(0, 3) : along), paint::wall);
    }
    void paint_body(Canvas& canvas, Index k) const
    {
        const VecX& x = state_.scene.bodies.x;
        const Polygon& shape = state_.scene.shapes[static_cast<std::size_t>(k)];
        const Style style =
            state_.scene.bodies.can_move(k) ? paint::body : paint::fixed_body;
        std::vector<Vec2> corners;
        for (const Vec2& vertex : shape.vertices)
            corners.push_back(point_of(x, k, vertex));
        if (corners.size() == 1) {
            canvas.disc(corners[0], shape.radius, style);
            canvas.segment(corners[0], point_of(x, k, {0.9 * shape.radius, 0}),
                           {Colour::blue, 1.5, 1, false, false});
        } else if (corners.size() == 2)
            canvas.segment(corners[0], corners[1],
                           {style.colour, 5, 0.8, false, false});
        else canvas.polygon(corners, style);
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
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.view = view;
    scene.h = 1.0 / 240;
    scene.methods = {"exact", "rattle", "sweeps", "baumgarte"};
    scene.tunables = {
        {"substeps", "", "parts of a step", 1, 1, 64, true, false, true},
        {"sweeps", "", "sweeps a sub-step, of the methods that sweep", 10, 1, 200,
         true, false, false}};
    scene.start = [setup](const Settings& settings) {
        return std::make_unique<RigidRun>(setup(settings), settings);
    };
    return scene;
}

}  // namespace rigid
