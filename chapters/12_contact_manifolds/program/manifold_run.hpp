/// \file manifold_run.hpp
/// One scene of shapes that touch, under one of this chapter's methods.
#pragma once

#include "chapters/11_rotation/program/turning_run.hpp"
#include "chapters/12_contact_manifolds/names_kept.hpp"
#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/12_contact_manifolds/worse_manifolds.hpp"

#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// What a scene's measures and pictures are made of.
struct ManifoldState {
    RigidScene scene;
    StepData<3> now;
    Real t = 0, h = 0;
    VecX before;    ///< velocities before the last step
    Real kept = 1;  ///< share of the impulses that found their rows again
    std::vector<Vec2> trail;
};

struct ManifoldSetup {
    RigidScene scene;
    std::function<std::vector<Real>(const ManifoldState&)> measure;
    /// besides bodies, joints, walls and contacts
    std::function<void(Canvas&, const ManifoldState&)> picture;
    /// length of an arrow of 1 N s [m]; 0 = no arrows
    Real impulse_scale = 0;
    bool names = false;    ///< write each contact's name beside it
    Index traced = world;  ///< a body whose centroid leaves a trail
    std::function<void(RigidScene&, const Settings&)> change;
};

/// What a point is called: a2 is corner 2 of the first body, w0 corner 0 on a wall.
inline std::string name_of(const RigidScene& scene, const Contact& contact)
{
    const auto corners = [&](Index k) {
        return static_cast<Index>(
            scene.shapes[static_cast<std::size_t>(k)].vertices.size());
    };
    if (contact.a == world)
        return "w" + std::to_string(contact.feature % corners(contact.b));
    const Index of_a = corners(contact.a);
    return contact.feature < of_a ? "a" + std::to_string(contact.feature)
                                  : "b" + std::to_string(contact.feature - of_a);
}

class ManifoldRun : public Run {
public:
    ManifoldRun(ManifoldSetup setup, const Settings& settings)
        : setup_(std::move(setup))
    {
        state_.scene = setup_.scene;
        state_.h = settings.h;
        state_.before = state_.scene.bodies.u;
        exact_.correction = exact_correction();
    }

    void step(const Settings& settings, const Input& input) override
    {
        RigidScene& scene = state_.scene;
        if (setup_.change) setup_.change(scene, settings);
        const StepSettings how = step_settings(settings, input, scene.bodies);
        state_.before = scene.bodies.u;
        last_.remember(state_.now);
        const int sweeps = static_cast<int>(settings["sweeps"]);
        stop_ = !settings.tunables.contains("stop") || settings["stop"] > 0;
        if (settings.method == "exact") {
            exact_.contacts.fast.stop = stop_;
            rigid::step(scene, how, exact_, state_.now);
        } else if (settings.method == "one_point") take(one_point_, how, sweeps);
        else if (settings.method == "no_names") take(nameless_, how, sweeps);
        else take(sweeps_, how, sweeps);
        require_finite_state(scene.bodies);
        state_.kept = last_.share_kept(state_.now);
        state_.t += settings.h;
        state_.h = settings.h;
        if (setup_.traced != world)
            state_.trail.push_back(scene.bodies.position(setup_.traced).head<2>());
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
        paint_contacts(canvas);
        if (setup_.picture) setup_.picture(canvas, state_);
    }

private:
    template <class Contacts>
    struct Sweeps {
        Contacts contacts;
        Correction correction;
        WarmStart start;
        ImpulseSolver<3> solver;
    };
    template <class Method>
    void take(Method& method, const StepSettings& how, int sweeps)
    {
        method.solver.sweeps.max_sweeps = sweeps;
        method.contacts.fast.stop = stop_;
        rigid::step(state_.scene, how, method, state_.now);
    }
    void paint_contacts(Canvas& canvas) const
    {
        const StepData<3>& now = state_.now;
        for (std::size_t i = 0; i < now.sources.size(); ++i) {
            if (now.sources[i].of != Source::Of::contact) continue;
            const Contact& c =
                now.contacts[static_cast<std::size_t>(now.sources[i].index)];
            const Real lambda = static_cast<Index>(i) < now.solution.lambda.size()
                                    ? now.solution.lambda[static_cast<Index>(i)]
                                    : 0;
            const Vec2 head = c.point + setup_.impulse_scale * lambda * c.normal;
            if (setup_.impulse_scale > 0 && lambda > 0)
                canvas.arrow(c.point, head, paint::impulse);
            canvas.disc(c.point, 0.02, {Colour::red, 1, 1, Paint::filled});
            if (setup_.names)
                canvas.text(c.point + Vec2(0.05, 0.05), name_of(state_.scene, c),
                            14, paint::label);
        }
    }

    ManifoldSetup setup_;
    ManifoldState state_;
    NamedImpulses last_;
    bool stop_ = true;
    ManifoldExact exact_;
    Sweeps<Manifolds> sweeps_;
    Sweeps<OnePoint> one_point_;
    Sweeps<Nameless> nameless_;
};

/// A scene with the methods and the tunables that all of them have.
inline Demo
manifold_demo(const std::string& name, const std::string& summary, const View& view,
              const std::function<ManifoldSetup(const Settings&)>& setup)
{
    return turning_demo<ManifoldRun>(name, summary, view, 1.0 / 60,
                                     {"sweeps", "exact", "one_point", "no_names"},
                                     setup);
}

/// The deepest penetration that the step found [m].
inline Real deepest_overlap(const StepData<3>& now)
{
    Real deepest = 0;
    for (const Contact& contact : now.contacts)
        deepest = std::max(deepest, -contact.gap);
    return deepest;
}

}  // namespace rigid
