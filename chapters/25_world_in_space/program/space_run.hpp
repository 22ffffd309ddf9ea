/// \file space_run.hpp
/// One scene in space, under one of this chapter's methods.
#pragma once

#include "chapters/25_world_in_space/program/solid_picture.hpp"
#include "chapters/25_world_in_space/step_in_parts.hpp"
#include "common/program/demo_of.hpp"

#include <algorithm>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// What a scene's measures and pictures are made of.
struct SpaceState {
    SpaceScene scene;
    StepData<6> now;
    Real t = 0;
    Real energy = 0;  ///< at the start [J]
    Vec3 spin_momentum = {0, 0, 0};
    std::vector<Vec3> trail;
};

struct SpaceSetup {
    SpaceScene scene;
    Camera camera;
    std::function<std::vector<Real>(const SpaceState&)> measure;
    std::function<void(SpaceScene&, const Settings&, Real t)> change;
    std::function<void(SolidPicture&, const SpaceState&)> picture;
    Vec3 traced = {0, 0, 0};  ///< a point of the last body that leaves a trail
    bool traces = false;
    Real ground = 0;    ///< half the side of the floor that is drawn [m]; 0: none
    Real pit = 0;       ///< how high sides of 45° rise around it [m]
    Real slop = 0.001;  ///< of contacts [ℓ]
    Real restitution = 0;     ///< of contacts
    Skin skin = Skin::glass;  ///< where no ground is drawn
    Index followed = world;   ///< a body that the eye follows; the world: none
};

/// The deepest overlap of contacts where the step found them [m].
inline Real deepest_overlap(const StepData<6>& now)
{
    Real deepest = 0;
    for (const Constraint<6>& c : now.constraints)
        if (c.kind == ConstraintKind::unilateral) deepest = std::max(deepest, -c.C);
    return deepest;
}

class SpaceRun : public Run {
public:
    SpaceRun(SpaceSetup setup, const Settings& settings) : setup_(std::move(setup))
    {
        state_.scene = setup_.scene;
        state_.energy = energy(state_.scene);
        state_.spin_momentum = momenta(state_.scene.bodies).tail<3>();
        one_point_.contacts.points = 1;
        one_by_one_.contacts.ground.as_one = false;
        cones_.correction.slop = boxes_.correction.slop = guesses_.correction.slop =
            setup_.slop;
        cones_.correction.restitution = boxes_.correction.restitution =
            guesses_.correction.restitution = setup_.restitution;
        look(settings, {});
        trace();
    }

    void step(const Settings& settings, const Input&) override
    {
        SpaceScene& scene = state_.scene;
        if (setup_.change) setup_.change(scene, settings, state_.t);
        const StepSettings how{.h = settings.h,
                               .substeps =
                                   settings.tunables.contains("substeps")
                                       ? static_cast<int>(settings["substeps"])
                                       : 1};
        if (settings.method == "explicit")
            tumble_all(Tumbling::explicit_term, how.h);
        else if (settings.method == "implicit")
            tumble_all(Tumbling::implicit_term, how.h);
        else if (settings.method == "momentum")
            tumble_all(Tumbling::momentum_kept, how.h);
        else if (settings.method == "exact")
            rigid::step(scene, how, exact_, state_.now);
        else if (settings.method == "cone") take(cones_, settings, how);
        else if (settings.method == "box") take(boxes_, settings, how);
        else if (settings.method == "pyramid") {
            pyramids_.solver.corners = static_cast<int>(settings["corners"]);
            take(pyramids_, settings, how);
        } else if (settings.method == "exact_cone")
            take(guesses_, settings, how, 1e-9);
        else if (settings.method == "one_point") take(one_point_, settings, how);
        else if (settings.method == "one_by_one") take(one_by_one_, settings, how);
        else {
            islands_.solver.sweeps = {200, 1e-9};
            rigid::step(scene, how, islands_, state_.now);
        }
        for (Index k = 0; k < scene.bodies.count(); ++k)
            if (!scene.bodies.position(k).allFinite() ||
                !scene.bodies.velocity(k).allFinite())
                throw StepFailure("the state of body " + std::to_string(k) +
                                  " is not finite");
        state_.t += settings.h;
        trace();
    }

    std::vector<Real> measure() const override { return setup_.measure(state_); }

    /// The eye moves around the scene with the pointer while its button is held, and stays where it was left.
    void look(const Settings& settings, const Input& input) override
    {
        if (input.pressed && held_) {
            const Vec2 way = 4 / setup_.camera.distance * (input.pointer - *held_);
            turned_ -= way.x();
            raised_ -= way.y();  // as if the hand held the scene
        }
        held_ = input.pressed ? std::optional<Vec2>(input.pointer) : std::nullopt;
        camera_ = setup_.camera;
        camera_.azimuth += settings["camera"] * pi / 180 + turned_;
        // never quite overhead or underneath
        raised_ = std::clamp(raised_, -1.5 - camera_.height, 1.5 - camera_.height);
        camera_.height += raised_;
    }

    void draw(Canvas& canvas) const override
    {
        const SpaceScene& scene = state_.scene;
        Camera camera = camera_;
        if (setup_.followed != world)
            camera.target += centre_of(scene.bodies.x, setup_.followed) -
                             centre_of(setup_.scene.bodies.x, setup_.followed);
        SolidPicture picture(camera,
                             setup_.ground > 0 ? Skin::opaque : setup_.skin);
        if (setup_.ground > 0) picture.ground(setup_.ground, setup_.pit);
        for (const auto& mesh : scene.meshes) picture.mesh(*mesh);
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Mat3 R = rotation_of(scene.bodies.x, k);
            const Vec3 centre = centre_of(scene.bodies.x, k);
            for (const Hull& hull : scene.shapes[static_cast<std::size_t>(k)])
                picture.hull(hull, centre, R,
                             k % 2 == 0 ? Colour::blue : Colour::orange);
        }
        for (const SolidEllipsoid& e : scene.ellipsoids)
            picture.boat(e, centre_of(scene.bodies.x, e.body),
                         rotation_of(scene.bodies.x, e.body), Colour::blue);
        picture.line(state_.trail, {Colour::purple, 1.2, 0.9});
        if (setup_.picture) setup_.picture(picture, state_);
        picture.paint(canvas);
    }

private:
    template <class Method>
    void take(Method& method, const Settings& settings, const StepSettings& how,
              Real tolerance = 1e-6)
    {
        method.solver.sweeps = {static_cast<int>(settings["sweeps"]), tolerance};
        if (settings.tunables.contains("stiff"))
            method.correction.stiff = settings["stiff"] > 0;
        const bool parts = settings.tunables.contains("parts");
        step_in_parts(state_.scene, how,
                      parts ? static_cast<int>(settings["parts"]) : 1, method,
                      state_.now);
    }
    void tumble_all(Tumbling way, Real h)
    {
        Bodies<6>& bodies = state_.scene.bodies;
        for (Index k = 0; k < bodies.count(); ++k) {
            const Vec3 inertia =
                bodies.inverse_mass.segment<3>(6 * k + 3).cwiseInverse();
            Vec3 theta = bodies.x.segment<3>(6 * k + 3),
                 omega = bodies.u.segment<3>(6 * k + 3);
            tumble(way, inertia, h, theta, omega);
            bodies.x.segment<3>(6 * k + 3) = theta;
            bodies.u.segment<3>(6 * k + 3) = omega;
        }
    }
    void trace()
    {
        if (!setup_.traces) return;
        const Index last = state_.scene.bodies.count() - 1;
        state_.trail.push_back(
            point_of_solid(state_.scene.bodies.x, last, setup_.traced));
        if (state_.trail.size() > 3000)
            state_.trail.erase(state_.trail.begin(), state_.trail.begin() + 1000);
    }

    SpaceSetup setup_;
    SpaceState state_;
    Camera camera_;
    Real turned_ = 0, raised_ = 0;  ///< by the reader's hand [rad]
    std::optional<Vec2> held_;      ///< where its pointer was
    SpaceExact exact_;
    SpaceIslands islands_;
    TouchingCones cones_, pyramids_, one_point_, one_by_one_,
        guesses_ = exact_cones();
    TouchingBoxes boxes_;
};

/// A scene with its methods, and the tunable that all of them have.
inline Demo space_demo(const std::string& name, const std::string& summary,
                       const View& view, Real h, std::vector<std::string> methods,
                       std::function<SpaceSetup(const Settings&)> setup)
{
    Demo scene = demo_of<SpaceRun>(
        name, summary, view, h, std::move(methods),
        {{"camera", "°", "where the eye is, around the scene", 0, -180, 180}},
        std::move(setup));
    scene.held = "turns the view";
    return scene;
}

}  // namespace rigid
