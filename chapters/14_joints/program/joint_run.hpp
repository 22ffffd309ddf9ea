/// \file joint_run.hpp
/// One scene with joints, under one of this chapter's methods.
#pragma once

#include "chapters/11_rotation/program/turning_run.hpp"
#include "chapters/14_joints/hand.hpp"
#include "chapters/14_joints/joint_method.hpp"

#include <array>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// What a scene's measures and pictures are made of.
struct JointState {
    JointedScene scene;
    StepData<3> now;
    Real t = 0, h = 0;
    Real energy_at_start = 0;
    std::int64_t tree_rows = 0;  ///< solved so far by chapter 15's trees
    int asleep = 0;              ///< bodies, where a method lets them sleep
    int rounds = 0;              ///< of a method that has them, in the last solve

    /// What the solver left in the last step; 0 before the first [m/s].
    Real residual() const
    {
        return std::isfinite(now.solution.residual) ? now.solution.residual : 0;
    }
};

/// The largest error of a joint that is whole [m].
inline Real largest_gap(const JointedScene& scene)
{
    Real largest = 0;
    for (const PlacedJoint& placed : scene.placed) {
        if (placed.broken) continue;
        for (int i = 0; i < placed.count; ++i) {
            const PointJoint& row =
                scene.joints[static_cast<std::size_t>(placed.first + i)];
            if (row.kind == ConstraintKind::bilateral)
                largest = std::max(
                    largest, std::abs(joint_constraint(scene.bodies.x, row).C));
        }
    }
    return largest;
}

struct JointSetup {
    JointedScene scene;
    CollisionFilter filter;  ///< of the shapes that touch
    bool touches = false;    ///< false: no body touches another
    std::function<std::vector<Real>(const JointState&)> measure;
    /// besides bodies, joints and walls
    std::function<void(Canvas&, const JointState&)> picture;
    /// what tunables change while it runs
    std::function<void(JointedScene&, const Settings&)> change;
    /// a body whose point leaves a trail
    Index traced = world;
    Vec2 traced_point = {0, 0};
};

/// The methods of this chapter.
struct JointMethods {
    ExactJoints<Manifolds> exact;
    JointSweeps<Manifolds> sweeps;

    std::array<Manifolds*, 2> touching()
    {
        return {&exact.contacts, &sweeps.contacts};
    }

    void step(JointState& state, const StepSettings& how, const Settings& settings)
    {
        if (settings.method == "exact")
            rigid::step(state.scene, how, exact, state.now);
        else by_sweeps(state, how, settings, sweeps);
    }

    static void by_sweeps(JointState& state, const StepSettings& how,
                          const Settings& settings, JointSweeps<Manifolds>& sweeps)
    {
        sweeps.correction.method = Stabilizer::projection;
        sweeps.solver.sweeps.max_sweeps = static_cast<int>(settings["sweeps"]);
        rigid::step(state.scene, how, sweeps, state.now);
    }
};

/// \tparam Methods  touching(): the contacts stages of all of them; step(): by the one that
///                  settings.method names
template <class Methods>
class JointRunBy : public Run {
public:
    JointRunBy(JointSetup setup, const Settings& settings)
        : setup_(std::move(setup))
    {
        state_.scene = setup_.scene;
        state_.h = settings.h;
        state_.energy_at_start = energy(state_.scene);
        if (!setup_.touches) setup_.filter.set_meets(0, 0, false);
        for (Manifolds* touching : methods_.touching()) {
            touching->finder.filter = setup_.filter;
            never_stop(*touching);
        }
        trace();
    }

    void step(const Settings& settings, const Input& input) override
    {
        JointedScene& scene = state_.scene;
        if (setup_.change) setup_.change(scene, settings);
        StepSettings how = step_settings(settings, input, scene.bodies);
        if (settings.method != "rattle") {  // chapter 15's, without springs as rows
            drag(input, how.pulled);
            how.pulled = world;
        }
        methods_.step(state_, how, settings);
        require_finite_state(scene.bodies);
        state_.t += settings.h;
        state_.h = settings.h;
        trace();
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
        canvas.polyline(trail_, {Colour::purple, 1.2, 0.9});
        for (Index k = 0; k < scene.bodies.count(); ++k)
            paint_rigid_body(canvas, scene, k);
        for (const PlacedJoint& placed : scene.placed) paint_joint(canvas, placed);
        if (setup_.picture) setup_.picture(canvas, state_);
    }

private:
    //! [drag]
    /// The pointer holds the body that it was nearest to when it was pressed.
    void drag(const Input& input, Index nearest)
    {
        JointedScene& scene = state_.scene;
        if (!input.pressed) {
            if (held_) remove_last_joint(scene);
            held_ = false;
        } else if (held_) {
            move_hand(scene, scene.placed.size() - 1, input.pointer);
        } else if (nearest != world) {
            const Vec2 middle = scene.bodies.position(nearest).head<2>();
            RigidJoint hand = hand_joint(scene, nearest, middle);
            hand.at_a = input.pointer;
            add_joint(scene, hand);
            held_ = true;
        }
    }
    //! [drag]

    void paint_joint(Canvas& canvas, const PlacedJoint& placed) const
    {
        const RigidJoint& joint = placed.joint;
        const VecX& x = state_.scene.bodies.x;
        if (placed.broken || joint.kind == JointKind::gear) return;
        const Vec2 a = point_of(x, joint.a, joint.at_a),
                   b = point_of(x, joint.b, joint.at_b);
        const Style line{Colour::purple, 2, 1};
        if (joint.kind == JointKind::pulley) {
            canvas.segment(a, joint.over_a, line);
            canvas.segment(joint.over_a, joint.over_b, line);
            canvas.segment(joint.over_b, b, line);
        } else if (joint.kind == JointKind::distance ||
                   joint.kind == JointKind::rope || joint.kind == JointKind::mouse)
            canvas.segment(a, b, line);
        canvas.disc(b, 0.02, {Colour::orange, 1, 1, Paint::filled});
    }

    void trace()
    {
        if (setup_.traced == world) return;
        trail_.push_back(
            point_of(state_.scene.bodies.x, setup_.traced, setup_.traced_point));
        if (trail_.size() > 3000)
            trail_.erase(trail_.begin(), trail_.begin() + 1000);
    }

    JointSetup setup_;
    JointState state_;
    std::vector<Vec2> trail_;
    Methods methods_;
    bool held_ = false;  ///< the last joint is the hand
};

/// Another speed for the motor of a joint.
inline void set_motor(JointedScene& scene, std::size_t number, Real speed)
{
    RigidJoint joint = scene.placed[number].joint;
    if (joint.motor.speed == speed) return;
    joint.motor.speed = speed;
    change_joint(scene, number, joint);
}

using JointRun = JointRunBy<JointMethods>;

/// A scene with this chapter's methods.
inline Demo joint_demo(const std::string& name, const std::string& summary,
                       const View& view, Real h,
                       const std::function<JointSetup(const Settings&)>& setup)
{
    return turning_demo<JointRun>(name, summary, view, h, {"exact", "sweeps"},
                                  setup);
}

}  // namespace rigid
