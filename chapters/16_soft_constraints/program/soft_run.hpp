/// \file soft_run.hpp
/// One scene under one of this chapter's methods.
#pragma once

#include "chapters/11_rotation/program/turning_run.hpp"
#include "chapters/16_soft_constraints/soft_method.hpp"
#include "chapters/16_soft_constraints/soft_scenes.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// What a scene's measures and pictures are made of.
struct SoftState {
    JointedScene scene;
    StepData<3> now;
    Real t = 0, h = 0;

    /// The deepest overlap of a contact of the last step, after it [m].
    Real overlap() const
    {
        Real most = 0;
        for (const Contact& contact : now.contacts)
            most = std::max(
                most, -contact_constraint(contact, now.x_found, scene.bodies.x).C);
        return most;
    }
    /// Of the springs [J].
    Real spring_energy() const
    {
        Real sum = 0;
        for (const PointJoint& joint : scene.joints) {
            if (joint.kind != ConstraintKind::spring) continue;
            const Real C = joint_constraint(scene.bodies.x, joint).C;
            sum += joint.stiffness * C * C / 2;
        }
        return sum;
    }
};

struct SoftSetup {
    JointedScene scene;
    bool touches = true;  ///< false: no body touches another
    std::function<std::vector<Real>(const SoftState&)> measure;
    /// what tunables change while it runs
    std::function<void(JointedScene&, const Settings&, Real t)> change;
};

/// The methods side by side, with the tunables that they share.
struct SoftMethods {
    SoftSweeps<Manifolds> soft;
    JointSweeps<Manifolds> hard;
    PositionSweeps<Manifolds> positions;
    BodyDescent<Manifolds> bodies;
    ExactJoints<Manifolds> exact;

    SoftMethods()
    {
        hard.correction = steady_contacts();
        soft.solver.sweeps.tolerance = hard.solver.sweeps.tolerance = 0;
    }

    void forbid(const CollisionFilter& filter)
    {
        const auto set = [&filter](auto& method) {
            Manifolds& touching = method.contacts;
            touching.finder.filter = filter;
            // a body that is stopped on its way is torn off its joints
            touching.fast.stop = false;
        };
        set(soft), set(hard), set(positions), set(bodies), set(exact);
    }

    void step(SoftState& state, const StepSettings& how, const Settings& settings)
    {
        const int sweeps = static_cast<int>(settings["sweeps"]);
        const auto& name = settings.method;
        if (name == "soft" || name == "preloaded") {
            const Softness spring{settings["frequency"], settings["zeta"]};
            soft.correction.contacts = soft.correction.joints = spring;
            soft.correction.preloaded = name == "preloaded";
            soft.correction.finish =
                settings["relax"] > 0 ? SoftFinish::relaxation : SoftFinish::none;
            soft.solver.sweeps.max_sweeps = sweeps;
            rigid::step(state.scene, how, soft, state.now);
        } else if (name == "hard") {
            hard.solver.sweeps.max_sweeps = sweeps;
            rigid::step(state.scene, how, hard, state.now);
        } else if (name == "xpbd") {
            positions.correction.sweeps = sweeps;
            rigid::step(state.scene, how, positions, state.now);
        } else if (name == "bodies") {
            bodies.correction.sweeps = sweeps;
            rigid::step(state.scene, how, bodies, state.now);
        } else rigid::step(state.scene, how, exact, state.now);
    }
};

class SoftRun : public Run {
public:
    SoftRun(SoftSetup setup, const Settings& settings) : setup_(std::move(setup))
    {
        state_.scene = setup_.scene;
        state_.h = settings.h;
        CollisionFilter filter;
        if (!setup_.touches) filter.set_meets(0, 0, false);
        methods_.forbid(filter);
    }

    void step(const Settings& settings, const Input& input) override
    {
        if (setup_.change) setup_.change(state_.scene, settings, state_.t);
        const StepSettings how =
            step_settings(settings, input, state_.scene.bodies);
        methods_.step(state_, how, settings);
        require_finite_state(state_.scene.bodies);
        state_.t += settings.h;
        state_.h = settings.h;
    }

    std::vector<Real> measure() const override { return setup_.measure(state_); }

    void draw(Canvas& canvas) const override
    {
        const JointedScene& scene = state_.scene;
        for (const HalfSpace& wall : scene.walls) {
            const Vec2 middle = wall.normal * wall.offset,
                       along = 60 * perpendicular(wall.normal);
            canvas.segment(middle - along, middle + along, paint::wall);
        }
        for (const PointJoint& joint : scene.joints) {
            if (joint.kind != ConstraintKind::spring) continue;
            canvas.segment(point_of(scene.bodies.x, joint.a, joint.at_a),
                           point_of(scene.bodies.x, joint.b, joint.at_b),
                           {Colour::purple, 1.4, 0.9});
        }
        for (Index k = 0; k < scene.bodies.count(); ++k)
            paint_rigid_body(canvas, scene, k);
        for (const PointJoint& joint : scene.joints)
            if (joint.kind != ConstraintKind::spring &&
                joint.measure != PointJoint::Measure::angle)
                canvas.disc(point_of(scene.bodies.x, joint.b, joint.at_b), 0.02,
                            {Colour::orange, 1, 1, Paint::filled});
    }

private:
    SoftSetup setup_;
    SoftState state_;
    SoftMethods methods_;
};

/// A scene with the methods and the tunables that all of them have.
inline Demo soft_demo(const std::string& name, const std::string& summary,
                      const View& view, Real h,
                      const std::function<SoftSetup(const Settings&)>& setup)
{
    Demo scene = turning_demo<SoftRun>(
        name, summary, view, h,
        {"soft", "preloaded", "hard", "xpbd", "bodies", "exact"}, setup);
    scene.tunables.push_back(
        {"frequency", "Hz", "of contacts and joints", 30, 0.1, 1000});
    scene.tunables.push_back({"zeta", "", "their damping ratio", 10, 0, 100});
    scene.tunables.push_back({"relax", "", "1: the velocity that corrects is taken",
                              1, 0, 1, Numbers::whole});
    return scene;
}

}  // namespace rigid
