/// \file structures.hpp
/// What stands by friction: a house of cards and an arch of stones; and what it keeps busy: dominoes, a break, a wall, rubble.
#pragma once

#include "chapters/13_friction/houses.hpp"
#include "chapters/13_friction/moving_scenes.hpp"
#include "chapters/13_friction/program/friction_run.hpp"

#include <algorithm>

namespace rigid {

inline Tunable count_tunable(const char* name, const char* help, Real value,
                             Real low, Real high)
{
    return {name, "", help, value, low, high, Numbers::whole, OnChange::restarts};
}
inline Tunable rough_tunable(Real value)
{
    return {"mu", "", "friction coefficient", value,
            0.01, 5,  Numbers::real,          OnChange::restarts};
}

/// How far the body that has moved farthest is from where it was built [m].
inline Real farthest_moved(const RoughScene& scene, const VecX& start)
{
    Real most = 0;
    for (Index k = 0; k < scene.bodies.count(); ++k)
        most = std::max(most, (scene.bodies.x - start).segment<2>(3 * k).norm());
    return most;
}

inline Demo house_scene()
{
    Demo scene = touching_demo(
        "house",
        "A house of cards stands by friction, and falls below its least mu",
        {{0, 2.3}, {3.3, 2.6}}, 1.0 / 60, [](const Settings& settings) {
            const int storeys = static_cast<int>(settings["storeys"]);
            FrictionSetup setup;
            setup.scene = card_house(storeys, settings["mu"]);
            setup.first_sweeps = 10000;
            const VecX start = setup.scene.bodies.x;
            const Real hand = card_house_by_hand(storeys);
            setup.measure = [start,
                             hand](const FrictionState& s) -> std::vector<Real> {
                return {farthest_moved(s.scene, start), hand, energy(s.scene),
                        static_cast<Real>(s.guesses)};
            };
            return setup;
        });
    scene.tunables.push_back(count_tunable("storeys", "of the house", 5, 1, 8));
    scene.tunables.push_back(rough_tunable(0.4));
    scene.columns = {
        {"moved", "m", "the card that has moved farthest", Plot::logarithmic},
        {"by_hand", "", "mu that is enough"},
        {"energy", "J", "kinetic and potential", Plot::linear},
        {"guesses", "", "of the exact solver"}};
    return scene;
}

/// Where all that acts in a joint acts together, from one foot of an arch to the other.
inline std::vector<Vec2> thrust_line(const FrictionState& s)
{
    const Index stones = s.scene.bodies.count();
    std::vector<Vec2> sum(static_cast<std::size_t>(stones) + 1, Vec2(0, 0));
    std::vector<Real> push(sum.size(), 0);
    for (std::size_t i = 0; i < s.now.contacts.size(); ++i) {
        const Contact& c = s.now.contacts[i];
        const Index joint = c.a != world ? c.b : c.b == 0 ? 0 : stones;
        sum[static_cast<std::size_t>(joint)] += s.normal_impulse(i) * c.point;
        push[static_cast<std::size_t>(joint)] += s.normal_impulse(i);
    }
    std::vector<Vec2> line;
    for (std::size_t j = 0; j < sum.size(); ++j)
        if (push[j] > 0) line.push_back(sum[j] / push[j]);
    return line;
}

inline Demo arch_scene()
{
    Demo scene = touching_demo(
        "arch", "An arch of stones: its line of thrust, and the mu that it needs",
        {{0, 0.55}, {1.5, 0.75}}, 1.0 / 60, [](const Settings& settings) {
            const int stones = 2 * static_cast<int>(settings["stones"] / 2);
            FrictionSetup setup;
            setup.scene = stone_arch(stones, settings["thickness"], settings["mu"]);
            setup.first_sweeps = 10000;
            const VecX start = setup.scene.bodies.x;
            const Real hand = arch_by_hand(stones);
            setup.measure = [start,
                             hand](const FrictionState& s) -> std::vector<Real> {
                return {farthest_moved(s.scene, start), hand, energy(s.scene),
                        static_cast<Real>(s.guesses)};
            };
            setup.picture = [](Canvas& canvas, const FrictionState& s) {
                const std::vector<Vec2> line = thrust_line(s);
                canvas.polyline(line, {Colour::red, 2, 1});
                for (const Vec2& point : line)
                    canvas.disc(point, 0.012, {Colour::red, 1, 1, Paint::filled});
            };
            return setup;
        });
    scene.tunables.push_back(
        count_tunable("stones", "of the arch, even", 10, 4, 30));
    scene.tunables.push_back({"thickness", "m", "of the ring, whose radius is 1 m",
                              0.3, 0.05, 0.8, Numbers::real, OnChange::restarts});
    scene.tunables.push_back(rough_tunable(0.4));
    scene.columns = {
        {"moved", "m", "the stone that has moved farthest", Plot::logarithmic},
        {"by_hand", "", "mu that a thick arch needs"},
        {"energy", "J", "kinetic and potential", Plot::linear},
        {"guesses", "", "of the exact solver"}};
    return scene;
}

inline Demo domino_scene()
{
    Demo scene = touching_demo(
        "dominoes", "A run of dominoes: the speed of the wave settles",
        {{7.5, 0.8}, {8, 1.2}}, 1.0 / 480, [](const Settings& settings) {
            const int count = static_cast<int>(settings["count"]);
            FrictionSetup setup;
            setup.scene = domino_run(count, settings["gap"], 1, settings["mu"]);
            setup.measure = [count](const FrictionState& s) -> std::vector<Real> {
                int fallen = 0;
                for (int k = 0; k < count; ++k)
                    fallen += std::abs(s.scene.bodies.x[3 * k + 2]) > 0.01;
                return {static_cast<Real>(fallen), energy(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back(count_tunable("count", "of dominoes", 30, 2, 100));
    scene.tunables.push_back({"gap", "m", "between two of them", 0.35, 0.1, 0.8,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back(rough_tunable(0.2));
    scene.columns = {
        {"moving", "", "dominoes that have begun to tip", Plot::linear},
        {"energy", "J", "kinetic and potential", Plot::linear}};
    return scene;
}

inline Demo pool_scene()
{
    Demo scene = touching_demo(
        "pool", "The break of a pool game, from above: throw, spin and cloth",
        {{0, 0}, {1.35, 0.72}}, 1.0 / 480, [](const Settings& settings) {
            FrictionSetup setup;
            setup.scene = pool_break(settings["speed"], settings["spin"],
                                     settings["mu"], settings["cloth"]);
            setup.measure = [](const FrictionState& s) -> std::vector<Real> {
                const Vec<3> p = momenta(s.scene.bodies);
                return {energy(s.scene), p[0], p[1], p[2]};
            };
            return setup;
        });
    scene.tunables.push_back({"speed", "m/s", "of the first ball", 8, 0.1, 12,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back({"spin", "rad/s", "of the first ball", 60, -300, 300,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back(rough_tunable(0.06));
    scene.tunables.push_back({"cloth", "", "resistance of the cloth to a ball",
                              0.015, 0, 0.5, Numbers::real, OnChange::restarts});
    scene.columns = {{"energy", "J", "kinetic", Plot::linear},
                     {"momentum_x", "N s", "of all balls", Plot::linear},
                     {"momentum_y", "N s", "of all balls", Plot::linear},
                     {"angular", "N m s", "about the middle", Plot::linear}};
    return scene;
}

inline Demo wall_scene()
{
    Demo scene = touching_demo(
        "wall", "A heavy ball and a wall of bricks without mortar",
        {{1, 1.1}, {4.4, 1.7}}, 1.0 / 240, [](const Settings& settings) {
            FrictionSetup setup;
            setup.scene = brick_wall(static_cast<int>(settings["rows"]), 6,
                                     settings["mu"], settings["speed"]);
            setup.measure = [](const FrictionState& s) -> std::vector<Real> {
                return {energy(s.scene), static_cast<Real>(s.now.contacts.size()),
                        static_cast<Real>(s.guesses)};
            };
            return setup;
        });
    scene.tunables.push_back(count_tunable("rows", "of bricks", 8, 1, 20));
    scene.tunables.push_back({"speed", "m/s", "of the ball", 12, 0, 40,
                              Numbers::real, OnChange::restarts});
    scene.tunables.push_back(rough_tunable(0.6));
    scene.columns = {{"energy", "J", "kinetic and potential", Plot::linear},
                     {"contacts", "", "points", Plot::linear},
                     {"guesses", "", "of the exact solver"}};
    return scene;
}

inline Demo rubble_scene()
{
    Demo scene = touching_demo(
        "rubble", "Rubble falls into a trough and comes to rest",
        {{0, 1.6}, {3, 2}}, 1.0 / 240, [](const Settings& settings) {
            FrictionSetup setup;
            Random random(settings.seed);
            setup.scene = random_heap(random, static_cast<int>(settings["bodies"]),
                                      settings["mu"]);
            setup.measure = [](const FrictionState& s) -> std::vector<Real> {
                return {energy(s.scene), static_cast<Real>(s.now.contacts.size()),
                        static_cast<Real>(s.guesses)};
            };
            return setup;
        });
    scene.tunables.push_back(count_tunable("bodies", "number", 24, 1, 100));
    scene.tunables.push_back(rough_tunable(0.5));
    scene.columns = {{"energy", "J", "kinetic and potential", Plot::linear},
                     {"contacts", "", "points", Plot::linear},
                     {"guesses", "", "of the exact solver"}};
    return scene;
}

}  // namespace rigid
