/// \file solid_run.hpp
/// One scene of solids, seen by a camera, under the methods of a chapter.
#pragma once

#include "chapters/20_turning_in_space/free_solids.hpp"
#include "chapters/20_turning_in_space/program/solid_picture.hpp"
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
template <class Scene>
struct SolidState {
    Scene scene;
    StepData<6> now;
    Real t = 0;
    Real energy = 0;  ///< at the start [J]
    Vec3 spin_momentum = {0, 0, 0};
    std::vector<Vec3> trail;
};

template <class Scene>
struct SolidSetup {
    Scene scene;
    Camera camera;
    std::function<std::vector<Real>(const SolidState<Scene>&)> measure;
    std::function<void(Scene&, const Settings&, Real t)> change;
    std::function<void(SolidPicture&, const SolidState<Scene>&)> picture;
    Vec3 traced = {0, 0, 0};  ///< a point of the last body that leaves a trail
    bool traces = false;
    Real ground = 0;    ///< half the side of the floor that is drawn [m]; 0: none
    Real pit = 0;       ///< how high sides of 45° rise around it [m]
    Real slop = 0.001;  ///< of contacts [ℓ]
    Real restitution = 0;     ///< of contacts
    Skin skin = Skin::glass;  ///< where no ground is drawn
    Index followed = world;   ///< a body that the eye follows; the world: none
    /// what every body is drawn as; empty: its hulls, blue and orange by turns
    std::vector<std::pair<Hull, Colour>> dress;
};

/// \tparam Steps  step(scene, settings, how, now), by the method that the settings name; made from a setup
template <class Scene, class Steps>
class SolidRun : public Run {
public:
    SolidRun(SolidSetup<Scene> setup, const Settings& settings)
        : setup_(std::move(setup)), steps_(setup_)
    {
        state_.scene = setup_.scene;
        state_.energy = energy(state_.scene);
        state_.spin_momentum = momenta(state_.scene.bodies).template tail<3>();
        look(settings, {});
        trace();
    }

    void step(const Settings& settings, const Input&) override
    {
        Scene& scene = state_.scene;
        if (setup_.change) setup_.change(scene, settings, state_.t);
        const StepSettings how{.h = settings.h,
                               .substeps =
                                   settings.tunables.contains("substeps")
                                       ? static_cast<int>(settings["substeps"])
                                       : 1};
        steps_.step(scene, settings, how, state_.now);
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
        const Scene& scene = state_.scene;
        Camera camera = camera_;
        if (setup_.followed != world)
            camera.target += centre_of(scene.bodies.x, setup_.followed) -
                             centre_of(setup_.scene.bodies.x, setup_.followed);
        SolidPicture picture(camera,
                             setup_.ground > 0 ? Skin::opaque : setup_.skin);
        if (setup_.ground > 0) picture.ground(setup_.ground, setup_.pit);
        Steps::draw_ground(picture, scene);
        for (Index k = 0; k < scene.bodies.count(); ++k) {
            const Mat3 R = rotation_of(scene.bodies.x, k);
            const Vec3 centre = centre_of(scene.bodies.x, k);
            for (const auto& [hull, colour] : setup_.dress)
                picture.hull(hull, centre, R, colour);
            if (!setup_.dress.empty()) continue;
            for (const Hull& hull : scene.shapes[static_cast<std::size_t>(k)])
                picture.hull(hull, centre, R,
                             k % 2 == 0 ? Colour::blue : Colour::orange);
        }
        Steps::draw_more(picture, scene);
        picture.line(state_.trail, {Colour::purple, 1.2, 0.9});
        if (setup_.picture) setup_.picture(picture, state_);
        picture.paint(canvas);
    }

private:
    void trace()
    {
        if (!setup_.traces) return;
        const Index last = state_.scene.bodies.count() - 1;
        state_.trail.push_back(
            point_of_solid(state_.scene.bodies.x, last, setup_.traced));
        if (state_.trail.size() > 3000)
            state_.trail.erase(state_.trail.begin(), state_.trail.begin() + 1000);
    }

    SolidSetup<Scene> setup_;
    SolidState<Scene> state_;
    Steps steps_;
    Camera camera_;
    Real turned_ = 0, raised_ = 0;  ///< by the reader's hand [rad]
    std::optional<Vec2> held_;      ///< where its pointer was
};

/// A scene with its methods, and the tunable that all of them have.
template <class Scene, class Steps>
Demo solid_demo(const std::string& name, const std::string& summary,
                const View& view, Real h, std::vector<std::string> methods,
                std::function<SolidSetup<Scene>(const Settings&)> setup)
{
    Demo scene = demo_of<SolidRun<Scene, Steps>>(
        name, summary, view, h, std::move(methods),
        {{"camera", "°", "where the eye is, around the scene", 0, -180, 180}},
        std::move(setup));
    scene.held = "turns the view";
    return scene;
}

}  // namespace rigid
