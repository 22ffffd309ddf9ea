/// \file friction_run.hpp
/// One scene with friction, under one of this chapter's methods.
#pragma once

#include "chapters/04_pgs/program/drawing.hpp"
#include "chapters/13_friction/slopes.hpp"
#include "common/program/program.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// What a scene's measures and pictures are made of.
struct FrictionState {
    RoughScene scene;
    StepData<3> now;
    Real t = 0, h = 0;
    int guesses = 0;  ///< of the exact solver in the last step

    /// Impulse of the contact rows of one kind in the last step, together [N s].
    Real impulse(int part) const
    {
        Real sum = 0;
        for (std::size_t i = 0; i < now.sources.size(); ++i)
            if (now.sources[i].of == Source::Of::contact &&
                now.sources[i].part == part)
                sum += now.solution.lambda[static_cast<Index>(i)];
        return sum;
    }

    /// The push at contact number i [N s].
    Real normal_impulse(std::size_t i) const
    {
        for (std::size_t k = 0; k < now.sources.size(); ++k)
            if (now.sources[k].of == Source::Of::contact &&
                now.sources[k].part == normal_part &&
                now.sources[k].index == static_cast<int>(i))
                return now.solution.lambda[static_cast<Index>(k)];
        return 0;
    }
};

struct FrictionSetup {
    RoughScene scene;
    std::function<std::vector<Real>(const FrictionState&)> measure;
    /// besides bodies and walls
    std::function<void(Canvas&, const FrictionState&)> picture;
    /// what tunables change while it runs
    std::function<void(RoughScene&, const Settings&)> change;
};

class FrictionRun : public Run {
public:
    FrictionRun(FrictionSetup setup, const Settings& settings)
        : setup_(std::move(setup))
    {
        state_.scene = setup_.scene;
        state_.h = settings.h;
    }

    void step(const Settings& settings, const Input& input) override
    {
        RoughScene& scene = state_.scene;
        if (setup_.change) setup_.change(scene, settings);
        StepSettings how{.h = settings.h,
                         .substeps = static_cast<int>(settings["substeps"])};
        if (input.pressed) {
            how.hand = input.pointer;
            how.pulled = nearest(input.pointer);
        }
        const Real e =
            settings.tunables.contains("restitution") ? settings["restitution"] : 0;
        if (settings.method == "exact") {
            exact_.correction.restitution = e;
            rigid::step(scene, how, exact_, state_.now);
            state_.guesses = exact_.solver.find.memory.work.guesses;
        } else if (settings.method == "lemke") {
            lemke_.correction.restitution = e;
            rigid::step(scene, how, lemke_, state_.now);
        } else {
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
    }

    std::vector<Real> measure() const override { return setup_.measure(state_); }

    void draw(Canvas& canvas) const override
    {
        const RoughScene& scene = state_.scene;
        for (const HalfSpace& wall : scene.walls) {
            const Vec2 middle = wall.normal * wall.offset,
                       along = 30 * perpendicular(wall.normal);
            canvas.segment(middle - along, middle + along, paint::wall);
        }
        for (Index k = 0; k < scene.bodies.count(); ++k) paint_body(canvas, k);
        if (setup_.picture) setup_.picture(canvas, state_);
    }

private:
    Index nearest(const Vec2& pointer) const
    {
        const Bodies<3>& bodies = state_.scene.bodies;
        Index found = world;
        Real least = infinity;
        for (Index k = 0; k < bodies.count(); ++k) {
            const Real distance = (bodies.position(k).head<2>() - pointer).norm();
            if (bodies.can_move(k) && distance < least) least = distance, found = k;
        }
        return found;
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

    FrictionSetup setup_;
    FrictionState state_;
    ExactFriction<AllBodies> exact_;
    LemkeFriction<AllBodies> lemke_;
    FrictionSweeps<AllBodies> sweeps_;
};

/// A scene with the methods and the tunables that all of them have.
inline Demo
friction_demo(const std::string& name, const std::string& summary, const View& view,
              const std::function<FrictionSetup(const Settings&)>& setup)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.view = view;
    scene.h = 1.0 / 240;
    scene.methods = {"exact", "sweeps", "lemke"};
    scene.tunables = {
        {"substeps", "", "parts of a step", 1, 1, 64, true, false, true},
        {"sweeps", "", "sweeps a sub-step, of the method that sweeps", 10, 1, 200,
         true, false, false}};
    scene.start = [setup](const Settings& settings) {
        return std::make_unique<FrictionRun>(setup(settings), settings);
    };
    return scene;
}

}  // namespace rigid
