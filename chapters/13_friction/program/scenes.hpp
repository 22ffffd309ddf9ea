/// \file scenes.hpp
/// A block and a wheel on a slope, a disc that is thrown, a rod on its end, a belt.
#pragma once

#include "chapters/13_friction/friction_problems.hpp"
#include "chapters/13_friction/program/friction_run.hpp"

namespace rigid {

inline Tunable mu_tunable(Real value)
{
    return {"mu", "", "friction coefficient", value,
            0,    5,  Numbers::real,          OnChange::restarts};
}

/// The block of section 13.1: forces as arrows, and the cone that the push of the slope stays in.
inline Demo slope_scene()
{
    Demo scene = friction_demo(
        "slope", "A block on a slope sticks or slides: its push stays in a cone",
        {{0.35, 0.35}, {2.2, 1.45}}, [](const Settings& settings) {
            const Real degrees = settings["degrees"], mu = settings["mu"];
            FrictionSetup setup;
            setup.scene = on_a_slope(box(1, 1), 0.5, degrees, mu);
            setup.measure = [degrees,
                             mu](const FrictionState& s) -> std::vector<Real> {
                const Real hand = block_by_hand(degrees, mu);
                return {down_the_slope(s.scene), hand / 2 * s.t * (s.t + s.h),
                        s.impulse(normal_part) / s.h, s.impulse(tangent_part) / s.h,
                        static_cast<Real>(s.guesses)};
            };
            setup.picture = [mu](Canvas& canvas, const FrictionState& s) {
                if (!(s.impulse(normal_part) > 0)) return;
                const Vec2 n = s.scene.walls[0].normal, t = perpendicular(n);
                // where all that pushes acts together
                Vec2 foot(0, 0);
                for (std::size_t i = 0; i < s.now.contacts.size(); ++i)
                    foot += s.normal_impulse(i) / s.impulse(normal_part) *
                            s.now.contacts[i].point;
                const Real scale = 0.11;  // of newtons
                for (const Real side : {-mu, mu})
                    canvas.segment(foot, foot + 1.35 * (n + side * t).normalized(),
                                   {Colour::green, 1.5, 1, Paint::dashed});
                const Vec2 push =
                    (s.impulse(normal_part) * n + s.impulse(tangent_part) * t) /
                    s.h;
                const Vec2 centre = s.scene.bodies.position(0).head<2>();
                canvas.arrow(foot, foot + scale * push, paint::impulse);
                canvas.arrow(centre, centre + scale * Vec2(s.scene.gravity),
                             {Colour::orange, 2.5, 1});
                canvas.text(foot + scale * push + Vec2(0.06, 0.02),
                            "push of the slope", 14, paint::impulse);
                canvas.text(centre + scale * Vec2(s.scene.gravity) +
                                Vec2(0.06, -0.02),
                            "weight", 14, {Colour::orange, 1, 1});
            };
            return setup;
        });
    scene.tunables.push_back({"degrees", "°", "of the slope", 20, 0, 80,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back(mu_tunable(0.5));
    scene.columns = {{"moved", "m", "down the slope", Plot::linear},
                     {"by_hand", "m", "closed form"},
                     {"normal", "N", "force of the slope across", Plot::linear},
                     {"friction", "N", "along, upwards", Plot::linear},
                     {"guesses", "", "of the exact solver"}};
    return scene;
}

inline Demo disc_scene()
{
    Demo scene = friction_demo(
        "disc", "A disc that is thrown without spin slides, and then it rolls",
        {{9, 2.2}, {10, 3.5}}, [](const Settings& settings) {
            const Real v0 = settings["speed"], mu = settings["mu"];
            FrictionSetup setup;
            setup.scene = thrown_disc(v0, mu);
            setup.measure = [v0, mu](const FrictionState& s) -> std::vector<Real> {
                const RollingStart hand = rolling_start(v0, mu, 0.5);
                const Real d = s.t < hand.t ? v0 * s.t - mu * 9.81 * s.t * s.t / 2
                                            : hand.d + (s.t - hand.t) * hand.v;
                return {s.scene.bodies.x[0], d, s.scene.bodies.u[0],
                        s.scene.bodies.u[0] + 0.5 * s.scene.bodies.u[2]};
            };
            return setup;
        });
    scene.tunables.push_back({"speed", "m/s", "at the start", 10, 0, 30,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back(mu_tunable(0.2));
    scene.columns = {{"x", "m", "of the centre", Plot::linear},
                     {"by_hand", "m", "closed form"},
                     {"v", "m/s", "of the centre", Plot::linear},
                     {"slip", "m/s", "of the lowest point", Plot::linear}};
    return scene;
}

inline Demo rod_scene()
{
    Demo scene = friction_demo(
        "rod", "The end of a rod strikes a rough floor: sweeps may go on forever",
        {{0, 0.45}, {1.2, 0.8}}, [](const Settings& settings) {
            const Real angle = settings["angle"] * pi / 180, mu = settings["mu"],
                       slide = settings["slide"];
            FrictionSetup setup;
            setup.scene = rod_on_end(angle, {slide, -1}, 0, mu);
            setup.measure = [angle,
                             mu](const FrictionState& s) -> std::vector<Real> {
                const Vec2 end = point_of(s.scene.bodies.x, 0, {-0.5, 0});
                const Vec2 v = velocity_at(s.scene.bodies, 0, end);
                return {s.impulse(normal_part),
                        s.impulse(tangent_part),
                        v.x(),
                        v.y(),
                        sliding_mobility(angle, mu, -1),
                        sliding_mobility(angle, mu, 1)};
            };
            setup.picture = [](Canvas& canvas, const FrictionState& s) {
                const Vec2 end = point_of(s.scene.bodies.x, 0, {-0.5, 0});
                const Vec2 push(-s.impulse(tangent_part), s.impulse(normal_part));
                if (push.norm() > 0)
                    canvas.arrow(end, end + 0.5 * push, paint::impulse);
            };
            return setup;
        });
    scene.tunables.push_back({"angle", "°", "of the rod to the floor", 63.4349, 1,
                              89, Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"slide", "m/s",
                              "of the rod at the start, to the right", 5, -10, 10,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back(mu_tunable(1.6));
    scene.tunables.push_back(
        {"restitution", "", "e", 0, 0, 1, Numbers::real, OnChange::restarts});
    scene.columns = {
        {"normal", "N s", "impulse of the floor, upwards", Plot::linear},
        {"friction", "N s", "to the left", Plot::linear},
        {"end_x", "m/s", "velocity of the end", Plot::linear},
        {"end_y", "m/s", "upwards", Plot::linear},
        {"mobility_left", "1/kg", "of the end sliding to the left"},
        {"mobility_right", "1/kg", "sliding to the right"}};
    return scene;
}

inline Demo conveyor_scene()
{
    Demo scene = friction_demo(
        "conveyor",
        "Boxes and a disc on a belt: dragged along until they move with it",
        {{2.5, 1.2}, {4.5, 2}}, [](const Settings& settings) {
            FrictionSetup setup;
            setup.scene.walls.push_back({{0, 1}, 0});
            add_body(setup.scene, box(0.6, 0.6), 1.0, {0, 0.3});
            add_body(setup.scene, box(0.4, 1.2), 1.0, {1.5, 0.6});
            add_body(setup.scene, disc(0.4), 1.0, {-1.5, 0.4});
            cover(setup.scene, {settings["mu"], 0, 0, 0});
            setup.change = [](RoughScene& moved, const Settings& now) {
                // a positive belt runs to the left over a floor
                moved.wall_surfaces[0].belt = -now["belt"];
            };
            setup.measure = [](const FrictionState& s) -> std::vector<Real> {
                const VecX& u = s.scene.bodies.u;
                return {u[0], u[3], u[6], u[8]};
            };
            return setup;
        });
    scene.tunables.push_back({"belt", "m/s", "speed of the belt to the right", 1,
                              -5, 5, Numbers::real, OnChange::goes_on,
                              Keys::up_and_down});
    scene.tunables.push_back(mu_tunable(0.5));
    scene.columns = {{"box", "m/s", "velocity of the box", Plot::linear},
                     {"tower", "m/s", "of the tall box", Plot::linear},
                     {"disc", "m/s", "of the disc", Plot::linear},
                     {"spin", "rad/s", "of the disc", Plot::linear}};
    return scene;
}

}  // namespace rigid
