/// \file engine_scenes.hpp
/// The scenes that this book's step is measured on beside other engines. Each engine builds its world from the
/// same DiscScene: nothing is tuned to one of them.
///
/// g = 10 m/s², no friction, no restitution, no damping; everything starts without velocity. Lengths are exact and gaps
/// zero but for a nanometre: what rests is set off by so much, disc by disc in directions drawn by lot, since a chain
/// that hangs straight to the last bit has no sideways motion that could grow. The discs of a chain do not collide
/// with anything.
#pragma once

#include "common/scenes.hpp"

#include <string>
#include <vector>

namespace rigid {

struct EngineScene {
    std::string name;
    DiscScene scene;
    /// false: no disc ever touches anything, so no engine has to look
    bool collides = true;
    bool rests = true;  ///< where it stands is where it stays; else it swings
};

/// What another engine is given besides the scene. Nothing else of it is changed.
struct PeerSettings {
    bool may_sleep = false;  ///< by its own rule
    /// an overlap of up to this much it leaves alone [m]; 5 mm is Box2D's own
    Real slop = 5e-3;
};

/// How long to each side, and how thick, an engine's wall is for a half-space [m]. No
/// disc of these scenes comes near its end, and floats have digits left on it.
inline Real wall_reach(const DiscScene& scene)
{
    return 1 + 4 * (scene.bodies.x.lpNorm<Eigen::Infinity>() +
                    scene.radius.lpNorm<Eigen::Infinity>());
}

/// How far each disc of a scene at rest is from where it would rest [m].
inline constexpr Real nudge = 1e-9;

/// What a chain of N links is, hanging or swinging, once nothing of it collides.
inline EngineScene engine_chain(const std::string& name, DiscScene scene,
                                bool rests)
{
    scene.gravity = {0, -10};
    scene.linked = PairSet::all();
    if (rests) scene = perturbed(std::move(scene), 1, nudge);
    return {
        .name = name, .scene = std::move(scene), .collides = false, .rests = rests};
}

inline EngineScene engine_pile(const std::string& name, DiscScene scene)
{
    scene.gravity = {0, -10};
    return {name, perturbed(std::move(scene), 1, nudge)};
}

/// All of them, by the names that the table has.
inline std::vector<EngineScene> engine_scenes()
{
    std::vector<EngineScene> scenes;
    const auto number = [](auto n) { return std::to_string(static_cast<int>(n)); };
    for (const Index count : {10, 50, 200})
        for (const Real mass : {1.0, 10.0, 100.0})
            scenes.push_back(
                engine_chain("hanging_" + number(count) + "_" + number(mass),
                             hanging_chain(count, mass), true));
    for (const Index count : {10, 50, 200})
        for (const Real mass : {1.0, 10.0, 100.0})
            scenes.push_back(
                engine_chain("swinging_" + number(count) + "_" + number(mass),
                             swinging_chain(count, mass), false));
    for (const Index count : {10, 20, 50})
        for (const Real mass : {1.0, 100.0})
            scenes.push_back(
                engine_pile("column_" + number(count) + "_" + number(mass),
                            column_between_walls(count, mass)));
    for (const Index base : {10, 20, 40})
        scenes.push_back(engine_pile("triangle_" + number(base), triangle(base)));
    return scenes;
}

}  // namespace rigid
