/// \file scene_rods.hpp
/// Rods that are struck, at an end or anywhere.
#pragma once

#include "chapters/11_rotation/program/rigid_run.hpp"

namespace rigid {

/// Velocities of points along a rod as arrows, before (dashed colour) and after.
inline void draw_point_velocities(Canvas& canvas, const Bodies<3>& bodies,
                                  const VecX& before, Real scale)
{
    Bodies<3> old = bodies;
    old.u = before;
    for (int i = 0; i <= 6; ++i) {
        const Vec2 p = point_of(bodies.x, 0, {i / 6.0 - 0.5, 0});
        canvas.arrow(p, p + scale * velocity_at(old, 0, p),
                     {Colour::faint, 1.5, 1});
        canvas.arrow(p, p + scale * velocity_at(bodies, 0, p),
                     {Colour::blue, 2, 1});
    }
}

inline Demo rod_scene()
{
    Demo scene = rigid_demo(
        "rod", "A rod falls on its end without gravity: it hops, and spins",
        {{0, 0.22}, {0.75, 0.5}}, [](const Settings& settings) {
            const Real angle = settings["angle"] * pi / 180,
                       e = settings["restitution"];
            RigidSetup setup;
            setup.scene = struck_rod(angle);
            // it has left the picture
            setup.over = [](const RigidScene& moved) {
                return !(std::abs(moved.bodies.x[0]) < 1.3 &&
                         std::abs(moved.bodies.x[1] - 0.22) < 1.1);
            };
            setup.measure = [angle, e](const RigidState& s) -> std::vector<Real> {
                const Vec<3> hand = struck_rod_by_hand(angle, e);
                const Real lambda =
                    s.now.solution.lambda.size() > 0 ? s.now.solution.lambda[0] : 0;
                return {lambda,
                        s.scene.bodies.u[1],
                        s.scene.bodies.u[2],
                        hand[0],
                        hand[1],
                        hand[2]};
            };
            setup.picture = [](Canvas& canvas, const RigidState& s) {
                draw_point_velocities(canvas, s.scene.bodies, s.before, 0.15);
                const Vec2 end = point_of(s.scene.bodies.x, 0, {-0.5, 0});
                const Real lambda =
                    s.now.solution.lambda.size() > 0 ? s.now.solution.lambda[0] : 0;
                if (lambda > 0) {
                    canvas.arrow(end - Vec2(0, 0.5 * lambda), end, paint::impulse);
                    canvas.text(end + Vec2(0.03, -0.2),
                                "λ = " + significant(lambda, 6) + " N s", 15,
                                paint::impulse);
                }
                canvas.text({-0.72, 0.66},
                            "v = " + significant(s.scene.bodies.u[1], 6) +
                                " m/s,  ω = " +
                                significant(s.scene.bodies.u[2], 6) + " rad/s",
                            15, paint::label);
            };
            return setup;
        });
    scene.tunables.push_back({"angle", "°", "of the rod to the floor", 30, 1, 90,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back(
        {"restitution", "", "e", 0.5, 0, 1, Numbers::real, OnChange::restarts});
    scene.columns = {
        {"lambda", "N s", "impulse of the floor in the last step", Plot::linear},
        {"v", "m/s", "of the centre, upwards", Plot::linear},
        {"omega", "rad/s", "counterclockwise", Plot::linear},
        {"lambda_exact", "N s", "by hand"},
        {"v_exact", "m/s", "by hand"},
        {"omega_exact", "rad/s", "by hand"}};
    return scene;
}

/// A free rod that was struck across at a distance d from its centre by 1 N s.
inline Demo percussion_scene()
{
    Demo scene = rigid_demo(
        "percussion",
        "A free rod is struck across: one point of it stays where it is at first",
        {{0, 0.1}, {0.85, 0.5}}, [](const Settings& settings) {
            const Real d = settings["distance"];
            RigidSetup setup;
            setup.scene.gravity = {0, 0};
            add_body(setup.scene, capsule(1, 0), thin_rod(1, 1), {0, 0});
            setup.scene.bodies.u << 0, 1, 12 * d;
            setup.measure = [](const RigidState& s) -> std::vector<Real> {
                const Bodies<3>& bodies = s.scene.bodies;
                return {
                    velocity_at(bodies, 0, point_of(bodies.x, 0, {-0.5, 0})).y(),
                    velocity_at(bodies, 0, point_of(bodies.x, 0, {0.5, 0})).y(),
                    bodies.u[2]};
            };
            setup.picture = [d](Canvas& canvas, const RigidState& s) {
                draw_point_velocities(canvas, s.scene.bodies, s.before, 0.1);
                const Vec2 hit(d, 0);
                canvas.arrow(hit - Vec2(0, 0.3), hit, paint::impulse);
                canvas.segment({-0.5, 0}, {0.5, 0},
                               {Colour::faint, 1, 1, Paint::dashed});
                if (d > 1.0 / 6) {
                    canvas.disc({-1 / (12 * d), 0}, 0.015,
                                {Colour::green, 1, 1, Paint::filled});
                    canvas.text({-1 / (12 * d), -0.07}, "stays at first", 14,
                                {Colour::green, 1, 1}, Align::centre);
                }
            };
            return setup;
        });
    scene.tunables.push_back({"distance", "m",
                              "from the centre to where it is struck", 0.5, -0.5,
                              0.5, Numbers::real, OnChange::restarts});
    scene.columns = {
        {"left", "m/s", "velocity of the left end, upwards", Plot::linear},
        {"right", "m/s", "of the right end", Plot::linear},
        {"omega", "rad/s", "counterclockwise", Plot::linear}};
    return scene;
}

}  // namespace rigid
