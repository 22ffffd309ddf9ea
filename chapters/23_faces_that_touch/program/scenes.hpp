/// \file scenes.hpp
/// A stack of boxes, and a box that turns over another.
#pragma once

#include "chapters/23_faces_that_touch/program/space_run.hpp"
#include "common/elementary.hpp"

namespace rigid {

inline Demo stack_scene()
{
    Demo scene = touching_demo(
        "stack", "Smooth boxes on boxes: four points to a pair, or one",
        {{0, 0}, {8, 6}}, 1.0 / 60, {"four_points", "one_point"},
        [](const Settings& settings) {
            TouchingSetup setup;
            const auto boxes = static_cast<int>(settings["boxes"]);
            for (int i = 0; i < boxes; ++i)
                add_body(setup.scene, {solid_box({1, 1, 1})}, 1000.0,
                         {0, i + 0.5, 0}, {0, i * settings["turn"] * pi / 180, 0});
            setup.scene.walls = {{{0, 1, 0}, 0}};
            setup.camera.target = {0, 5, 0};
            setup.camera.distance = 20;
            setup.ground = 4;
            const VecX start = setup.scene.bodies.x;
            setup.measure = [start](const TouchingState& s) -> std::vector<Real> {
                const VecX& x = s.scene.bodies.x;
                Real sunk = 0;
                for (Index k = 0; k < s.scene.bodies.count(); ++k)
                    sunk = std::max(sunk, start[6 * k + 1] - x[6 * k + 1]);
                return {energy(s.scene) - s.energy, sunk, deepest_overlap(s.now),
                        static_cast<Real>(s.now.contacts.size())};
            };
            return setup;
        });
    scene.tunables.push_back({"boxes", "", "of the stack", 10, 1, 30,
                              Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"turn", "°", "of each box against the one below", 3,
                              0, 45, Numbers::real, OnChange::restarts});
    scene.tunables.push_back(
        {"substeps", "", "of a step", 1, 1, 64, Numbers::whole});
    scene.tunables.push_back(
        {"sweeps", "", "of a step, at most", 500, 1, 5000, Numbers::whole});
    scene.columns = {
        {"energy", "J", "less that of the start", Plot::linear},
        {"sunk", "m", "the farthest that a box has moved down", Plot::linear},
        {"overlap", "m", "the deepest", Plot::linear},
        {"points", "", "where solids touch", Plot::linear}};
    return scene;
}

/// Nothing pushes the bodies: they fly on and tumble.
class OverSteps {
public:
    explicit OverSteps(const TouchingSetup&) {}
    void step(WalledSolids& scene, const Settings&, const StepSettings& how,
              StepData<6>&)
    {
        for (Index k = 0; k < scene.bodies.count(); ++k)
            scene.bodies.integrate(k, scene.bodies.velocity(k), how.h);
    }
    static void draw_ground(SolidPicture&, const WalledSolids&) {}
    static void draw_more(SolidPicture&, const WalledSolids&) {}
};

inline Demo over_scene()
{
    Demo scene = solid_demo<WalledSolids, OverSteps>(
        "over", "A box slides and turns over another: where the faces touch",
        {{0, 0.3}, {3, 2}}, 1.0 / 60, {"clipping"}, [](const Settings& settings) {
            TouchingSetup setup;
            WalledSolids& s = setup.scene;
            s.gravity.setZero();
            add_body(s, {solid_box({2, 0.4, 2})}, 1.0, {0, -0.2, 0});
            add_body(s, {solid_box({1.6, 0.4, 1.6})}, 1.0,
                     {settings["aside"], 0.2, 0.5});
            s.bodies.u.segment<3>(9) = Vec3(0, settings["spin"], 0);
            setup.camera.distance = 8;
            setup.camera.height = 0.7;
            struct Found {
                ClipRoom room;
                SolidTouch touch;
            };
            const SolidForm fa = form_of(s.shapes[0][0]),
                            fb = form_of(s.shapes[1][0]);
            const auto look = [fa, fb](const TouchingState& now) {
                Found found;
                PlacedSolid a, b;
                const VecX& x = now.scene.bodies.x;
                a.place(fa, centre_of(x, 0), rotation_of(x, 0));
                b.place(fb, centre_of(x, 1), rotation_of(x, 1));
                collide(a, b, {0.02, 1e-4}, found.room, found.touch);
                return found;
            };
            setup.measure = [look](const TouchingState& now) -> std::vector<Real> {
                const Found found = look(now);
                return {static_cast<Real>(found.room.points.size()),
                        static_cast<Real>(found.touch.count)};
            };
            setup.picture = [look](SolidPicture& picture,
                                   const TouchingState& now) {
                const Found found = look(now);
                std::vector<Vec3> rim;
                for (const ClipCorner& c : found.room.polygon) rim.push_back(c.at);
                if (!rim.empty()) rim.push_back(rim.front());
                picture.line(rim, {Colour::ink, 2, 1});
                for (int i = 0; i < found.touch.count; ++i) {
                    const Vec3& p =
                        found.touch.points[static_cast<std::size_t>(i)].on_b;
                    picture.arrow(p, p + Vec3(0, 0.5, 0), {Colour::red, 2, 1});
                }
            };
            return setup;
        });
    scene.tunables.push_back({"aside", "m", "of the upper box", 0.5, -1.5, 1.5,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"spin", "rad/s", "of the upper box", 0.5, -3, 3,
                              Numbers::real, OnChange::restarts});
    scene.columns = {{"corners", "", "of what lies over the face", Plot::linear},
                     {"points", "", "that are kept", Plot::linear}};
    return scene;
}

}  // namespace rigid
