/// \file kept_scenes.hpp
/// What has to be kept where things move: each scene is a world, a time, a number that is read of its motion, and what that
/// number has to be.
#pragma once

#include "chapters/19_engine/benchmark/kept_exact.hpp"
#include "chapters/19_engine/benchmark/kept_worlds.hpp"

#include <string>

namespace rigid::kept {

struct Scene {
    std::string name;
    std::string what;  ///< is kept, with its unit
    Real seconds;
    std::function<World()> make;
    Read read;
    Real right;
    Real driven = 0;  ///< the acceleration to the right that body 0 is given [m/s²]
};

inline std::vector<Scene> scenes()
{
    std::vector<Scene> all;
    const std::string energy_in = "energy, of the start's";
    const Real right_angle = pi / 2, minute = 60;
    const auto hang = [](const JointedScene& scene) {
        return [=] { return hung(scene); };
    };

    // ---- pendulums (V1, V4)
    all.push_back(
        {"pendulum", "amplitude after a minute [rad]", minute,
         hang(on_a_pin(disc(0.1), 0.005, {rigid::sin(0.5), -rigid::cos(0.5)}, 0)),
         largest(swing_of(0), minute - 3), 0.5});
    const JointedScene two = rods({right_angle, right_angle}),
                       three = rods({right_angle, right_angle, right_angle});
    // two rods: the digits are those of other programs, with 30 digits and more
    all.push_back({"double pendulum, 1 s", "angle of the first rod [rad]", 1,
                   hang(two), at_end(angle_of(0)), -1.207716238190638});
    all.push_back({"double pendulum, 3 s", "angle of the first rod [rad]", 3,
                   hang(two), at_end(angle_of(0)), 1.025086012288729});
    all.push_back({"double pendulum, a minute", energy_in, minute, hang(two),
                   energy_kept(energy(rods({0, 0}))), 1});
    all.push_back({"triple pendulum, 1 s", "angle of the first rod [rad]", 1,
                   hang(three), at_end(angle_of(0)),
                   at_end(angle_of(0))(exact_motion(three, 1))});
    all.push_back({"triple pendulum, a minute", energy_in, minute, hang(three),
                   energy_kept(energy(rods({0, 0, 0}))), 1});
    all.push_back({"chain of 20, a minute", energy_in, minute,
                   hang(chain_scene({20, 0.1, 0.1, 1, 0.5})),
                   energy_kept(energy(chain_scene({20, 0.1, 0.1, 1, 0}))), 1});

    // ---- what turns
    all.push_back({"wheel on a pin, a minute", "spin [rad/s]", minute,
                   hang(on_a_pin(disc(0.5), 0.125, {0, 0}, 10)), at_end(spin_of(0)),
                   10});
    all.push_back({"wheel on a pin at half its radius, a minute", energy_in, minute,
                   hang(on_a_pin(disc(0.5), 0.125, {0.25, 0}, 10)),
                   energy_kept(-9.81 * 0.25), 1});
    all.push_back({"two welded boxes, 10 s", "spin [rad/s]", 10,
                   [] { return welded_world(10); }, at_end(spin_of(0)), 10});
    all.push_back({"four-bar linkage, 10 s", energy_in, 10,
                   hang(cranks_scene(2, 1, 8)),
                   energy_kept(energy(cranks_scene(2, -right_angle, 0))), 1});
    const JointedScene thrower = trebuchet_scene(1000, JointKind::distance);
    const Read fastest = largest(speed_of(2), 0);
    all.push_back({"trebuchet, 2 s", "largest speed of its stone [m/s]", 2,
                   hang(thrower), fastest, fastest(exact_motion(thrower, 2))});
    // lowest: all hang from the axle at 2.6 m, the long arm up
    all.push_back(
        {"trebuchet, a minute", energy_in, minute, hang(thrower),
         energy_kept(9.81 * (1000 * 1.0 + 60 * 4.1 +
                             10 * (6.6 - thrower.placed[2].joint.length))),
         1});

    // ---- what hangs under a load (V3)
    const std::pair<JointKind, const char*> held_by[] = {
        {JointKind::distance, " kg on distance joints, 5 s"},
        {JointKind::rope, " kg on ropes, 5 s"},
        {JointKind::revolute, " kg on pinned rods, 5 s"}};
    for (const auto& [kind, name] : held_by)
        for (const int load : {100, 1000}) {
            const JointedScene scene = beads(kind, load);
            const auto last = static_cast<std::size_t>(scene.bodies.count() - 1);
            const Real length = 2 * Vec2(0.01, -0.5).norm();
            all.push_back({std::to_string(load) + name,
                           "distance from the hook, at worst [m]", 5, hang(scene),
                           farthest_from(distance_of(last), length), length});
        }

    // ---- what bounces (V2, V5); heights are above where a body would rest
    const auto falls = [](std::vector<std::pair<Polygon, Real>> shapes, Real fall,
                          Real e) {
        return [=] { return falling_world(shapes, fall, 1e-3, e); };
    };
    all.push_back({"ball, e = 1", "tenth apex [m]", 14,
                   falls({{disc(0.5), 1}}, 2, 1), the_peak(height_of(1, 0.5), 10),
                   2});
    all.push_back({"ball, e = 0.8", "fifth apex [m]", 6,
                   falls({{disc(0.5), 1}}, 2, 0.8), the_peak(height_of(1, 0.5), 5),
                   2 * rigid::pow(0.64, 5)});
    all.push_back({"ball on a ball", "apex of the upper one [m]", 3,
                   falls({{disc(0.5), 100}, {disc(0.1), 1}}, 1, 1),
                   the_peak(height_of(2, 1.1), 1), first_apex(100, 1, 1, 1e-3)});
    all.push_back({"box on a smaller box", "apex of the upper one [m]", 3,
                   falls({{box(0.4, 0.4), 3}, {box(0.5, 0.5), 1}}, 1, 1),
                   the_peak(height_of(2, 0.65), 1), first_apex(3, 1, 1, 1e-3)});
    all.push_back({"cradle of five, a minute", energy_in, minute, cradle_world,
                   energy_kept(-5 * 9.81 * 1.5), 1});

    // ---- what slides, and what may not (V6, V7)
    // A disc that cannot turn touches at one point, so its way is known. A box has a length over the seam, where its load
    // lies is not in the equations: up to a few of its lengths more are right, too.
    const Real v = 5, left = 1, g = 9.81;
    const auto slide = [&](const std::string& name, const Polygon& shape,
                           const Mass& mass, Real height, Real bevel) {
        all.push_back(
            {name, "way until it stops [m]", 6,
             [=] {
                 return seam_world(shape, mass, {-left, height}, v, bevel);
             },
             at_end(way_of(2)), left + (v * v / 2 - 0.5 * g * left) / (0.1 * g)});
    };
    const Mass stiff{1, {0, 0}, 1e6};
    slide("disc over a seam", disc(0.1), stiff, 0.1, 0.02);
    slide("disc over flush boxes", disc(0.1), stiff, 0.1, 0);
    slide("box over flush boxes", box(0.1, 0.06), Mass{1, {0, 0}, 1e-3}, 0.03, 0);
    all.push_back({"box on a platform, 4 s", "slip at 5 m/s², μ = 0.6 [m]", 4,
                   [] { return platform_world(5); }, at_end(way_of(1, 0)), 0, 5});
    return all;
}

}  // namespace rigid::kept
