/// \file friction_run.hpp
/// One scene with friction, under one of this chapter's methods.
#pragma once

#include "chapters/11_rotation/program/turning_run.hpp"
#include "chapters/12_contact_manifolds/manifold_method.hpp"
#include "chapters/13_friction/slopes.hpp"

#include <functional>
#include <string>
#include <type_traits>
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
    /// sweeps of the very first step, which has no impulses to start from
    int first_sweeps = 0;
};

/// \tparam Contacts  the contacts stage: of chapter 11, or of chapter 12 where bodies
///                   touch each other
template <class Contacts>
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
        const StepSettings how = step_settings(settings, input, scene.bodies);
        const Real e =
            settings.tunables.contains("restitution") ? settings["restitution"] : 0;
        if (settings.method == "exact") {
            exact_.correction.restitution = e;
            rigid::step(scene, how, exact_, state_.now);
            state_.guesses = exact_.solver.find.memory.work.guesses;
        } else if (settings.method == "lemke") {
            if constexpr (!touching) {
                lemke_.correction.restitution = e;
                rigid::step(scene, how, lemke_, state_.now);
            }
        } else if (settings.method == "skipping") {
            if constexpr (touching) {
                skipping_.correction.restitution = e;
                skipping_.solver.sweeps.max_sweeps =
                    static_cast<int>(settings["sweeps"]);
                // an island that is this good is done, and may rest
                skipping_.solver.sweeps.tolerance = 1e-6;
                rigid::step(scene, how, skipping_, state_.now);
            }
        } else {
            sweeps_.correction.restitution = e;
            sweeps_.solver.sweeps.max_sweeps =
                std::max(static_cast<int>(settings["sweeps"]),
                         state_.t > 0 ? 0 : setup_.first_sweeps);
            rigid::step(scene, how, sweeps_, state_.now);
        }
        require_finite_state(scene.bodies);
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
        const AwakeSet& set = skipping_.contacts.set;
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            paint_rigid_body(canvas, scene, k);
            if (k < static_cast<Index>(set.activity.size()) && set.is_asleep(k))
                canvas.text(scene.bodies.position(k).head<2>(), "z", 14,
                            {Colour::faint}, Align::centre);
        }
        if (setup_.picture) setup_.picture(canvas, state_);
    }

private:
    /// the methods of touching_demo(), else those of friction_demo()
    static constexpr bool touching = std::is_same_v<Contacts, Manifolds>;

    FrictionSetup setup_;
    FrictionState state_;
    ExactFriction<Contacts> exact_;
    LemkeFriction<Contacts> lemke_;
    FrictionSweeps<Contacts> sweeps_;
    SkippingFriction skipping_;
};

/// A scene with the methods and the tunables that all of them have.
inline Demo
friction_demo(const std::string& name, const std::string& summary, const View& view,
              const std::function<FrictionSetup(const Settings&)>& setup)
{
    return turning_demo<FrictionRun<AllBodies>>(
        name, summary, view, 1.0 / 240, {"exact", "sweeps", "lemke"}, setup);
}

/// The same for bodies that touch each other; more of them than Lemke's tableau has room for.
inline Demo
touching_demo(const std::string& name, const std::string& summary, const View& view,
              Real h, const std::function<FrictionSetup(const Settings&)>& setup)
{
    Demo scene = turning_demo<FrictionRun<Manifolds>>(
        name, summary, view, h, {"exact", "sweeps", "skipping"}, setup);
    for (Tunable& tunable : scene.tunables)
        if (tunable.name == "sweeps") tunable.value = 30;
    return scene;
}

}  // namespace rigid
