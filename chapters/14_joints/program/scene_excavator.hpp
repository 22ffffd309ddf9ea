/// \file scene_excavator.hpp
/// An excavator: tracks, a boom, an arm and a bucket on motors, and stones to move.
#pragma once

#include "chapters/14_joints/bar_linkages.hpp"
#include "chapters/14_joints/program/joint_run.hpp"
#include "common/elementary.hpp"

namespace rigid {

inline JointSetup excavator_setup(const Settings& settings)
{
    JointSetup setup;
    JointedScene& all = setup.scene;
    setup.touches = true;
    all.walls = {{{0, 1}, 0}, {{1, 0}, -6}, {{-1, 0}, -9}};
    const Vec2 foot(1, 1.2), elbow(3.6, 3), wrist(4.6, 1.2), heel(4.4, 0.55),
        lip(3.7, 0.4);
    const auto beam = [&all](const Vec2& from, const Vec2& to, Real width,
                             Real kilograms) {
        const Vec2 d = to - from;
        const Real L = d.norm();
        return add_body(all, box(L + width, width),
                        Mass{kilograms, {0, 0}, kilograms * L * L / 12},
                        (from + to) / 2, atan2(d.y(), d.x()));
    };
    const Index tracks = add_body(all, box(3.4, 1.1), Mass{8000, {0, 0}, 9000},
                                  {0, 0.55}),
                boom = beam(foot, elbow, 0.3, 900),
                arm = beam(elbow, wrist, 0.22, 500),
                back = beam(wrist, heel, 0.1, 120),
                floor = beam(heel, lip, 0.1, 120);
    const auto drive = [&all](Index a, Index b, const Vec2& at, Real torque,
                              Real lower, Real upper) {
        RigidJoint joint = joint_at(all, JointKind::revolute, a, b, at);
        joint.motor.force = torque;
        joint.lower = lower, joint.upper = upper;
        return add_joint(all, joint);
    };
    const std::size_t first = drive(tracks, boom, foot, 3e5, -0.9, 0.5);
    drive(boom, arm, elbow, 1.5e5, -1, 1.6);
    drive(arm, back, wrist, 5e4, -1.6, 1.6);
    add_joint(all, joint_at(all, JointKind::weld, back, floor, heel));
    for (int i = 0; i < static_cast<int>(settings["stones"]); ++i) {
        const Real r = 0.14 + 0.02 * (i % 3);
        const Vec2 at(5.4 + 0.42 * (i % 6), 0.25 + 0.45 * (i / 6));
        if (i % 2 == 0) add_body(all, disc(r), 1500.0, at);
        else add_body(all, box(2 * r, 1.6 * r, 0.02), 1500.0, at, 0.3 * i);
    }
    cover(all, {0.7, 0, 0, 0.02});
    setup.filter = forbid_pairs(all.bodies.count(),
                                {{arm, floor}, {tracks, arm}, {boom, back}});
    setup.change = [first, tracks](JointedScene& moved, const Settings& now) {
        set_motor(moved, first, now["boom"]);
        set_motor(moved, first + 1, now["arm"]);
        set_motor(moved, first + 2, now["bucket"]);
        // below the machine the tracks run backwards
        moved.surfaces[static_cast<std::size_t>(tracks)].belt = -now["drive"];
    };
    setup.measure = [=](const JointState& s) -> std::vector<Real> {
        const VecX& x = s.scene.bodies.x;
        const Vec2 tip = point_of(x, floor, {(lip - heel).norm() / 2, 0});
        return {tip.x(), tip.y(), largest_gap(s.scene), s.residual()};
    };
    return setup;
}

inline Demo excavator_demo()
{
    Demo scene = joint_demo("excavator", "Tracks, a boom, an arm and a bucket dig",
                            {{2, 2}, {6.5, 3.2}}, 1.0 / 120, excavator_setup);
    const auto speed = [&scene](const std::string& name, const std::string& unit,
                                const std::string& help, Real most, Keys keys) {
        scene.tunables.push_back({name, unit, help, 0, -most, most, Numbers::real,
                                  OnChange::goes_on, keys});
    };
    speed("boom", "rad/s", "speed of its motor", 0.6, Keys::up_and_down);
    speed("arm", "rad/s", "speed of its motor", 1, Keys::none);
    speed("bucket", "rad/s", "speed of its motor", 1.5, Keys::none);
    speed("drive", "m/s", "of the tracks", 1, Keys::none);
    scene.tunables.push_back(
        {"stones", "", "to move", 18, 0, 60, Numbers::whole, OnChange::restarts});
    scene.columns = {{"lip_x", "m", "of the bucket's edge", Plot::linear},
                     {"lip_y", "m", "its height", Plot::linear},
                     {"gap", "m", "largest error of a joint", Plot::logarithmic},
                     {"residual", "m/s", "what the solver left"}};
    return scene;
}

}  // namespace rigid
