/// \file ways_run.hpp
/// One scene under one way, drawn and measured.
#pragma once

#include "chapters/11_rotation/program/turning_run.hpp"
#include "chapters/26_four_ways/push_joints.hpp"
#include "chapters/26_four_ways/ways.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// The way of that name.
inline Way way_named(const std::string& name)
{
    for (const Way way : all_ways)
        if (to_string(way) == name) return way;
    throw std::invalid_argument("there is no way called " + name);
}

class WaysRun : public Run {
public:
    WaysRun(WayScene scene, const Settings& settings)
        : given_(std::move(scene)),
          run_(way_named(settings.method), given_,
               {settings["stiffness"], static_cast<int>(settings["sweeps"])})
    {
        before_ = energy(run_.scene());
    }

    void step(const Settings& settings, const Input&) override
    {
        const Status status = run_.advance(settings.h);
        require_finite_state(run_.scene().bodies);
        if (status != Status::solved)
            throw StepFailure("no force or impulse is found that obeys the "
                              "constraints (" +
                              std::string(to_string(status)) + ")");
    }

    std::vector<Real> measure() const override
    {
        const JointedScene& scene = run_.scene();
        std::vector<PushJoint> near;
        find_push_joints(scene, given_.filter, 0, near);
        Real overlap = 0;
        for (const PushJoint& push : near)
            overlap = std::max(overlap, -gap_of(push, scene.bodies.x).C);
        return {largest_joint_error(scene), overlap, energy(scene) - before_};
    }

    void draw(Canvas& canvas) const override
    {
        const JointedScene& scene = run_.scene();
        for (const HalfSpace& wall : scene.walls) {
            const Vec2 middle = wall.normal * wall.offset,
                       along = 60 * perpendicular(wall.normal);
            canvas.segment(middle - along, middle + along, paint::wall);
        }
        for (Index k = 0; k < scene.bodies.count(); ++k)
            paint_rigid_body(canvas, scene, k);
        paint_rigid_joints(canvas, scene);
    }

private:
    WayScene given_;
    WayRun run_;
    Real before_ = 0;
};

/// A scene with those ways that can take it.
inline Demo ways_demo(const std::string& name, const std::string& summary,
                      const View& view, const std::function<WayScene()>& make)
{
    std::vector<std::string> methods;
    const WayScene scene = make();
    for (const Way way : all_ways)
        if (can_take(way, scene)) methods.emplace_back(to_string(way));
    // the book's own way first: it can take every scene
    std::stable_partition(methods.begin(), methods.end(),
                          [](const auto& one) { return one == "impulses"; });
    Demo demo = demo_of<WaysRun, WayScene>(
        name, summary, view, 1.0 / 240, methods,
        {{"stiffness", "N/m", "of springs in place of constraints", scene.stiffness,
          10, 1e8, Numbers::real, OnChange::restarts},
         {"sweeps", "", "sweeps a step, of positions", 20, 1, 200, Numbers::whole,
          OnChange::restarts}},
        [make](const Settings&) { return make(); });
    demo.columns = {
        {"joint", "m", "the largest error of a joint", Plot::logarithmic},
        {"overlap", "m", "the deepest", Plot::logarithmic},
        {"energy", "J", "gained since the start", Plot::linear}};
    return demo;
}

}  // namespace rigid
