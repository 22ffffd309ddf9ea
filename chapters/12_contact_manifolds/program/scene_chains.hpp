/// \file scene_chains.hpp
/// A box and a disc slide over a floor of many pieces: over boxes they stumble, over a chain they do not.
#pragma once

#include "chapters/12_contact_manifolds/program/manifold_run.hpp"

namespace rigid {

/// A floor of pieces of half a metre from x = −4.5 m to 4.5 m, edges of a chain or boxes side by side, and on it a box
/// and a disc of the same speed.
inline RigidScene floor_of_pieces(bool chain, Real speed)
{
    RigidScene scene;
    scene.length = 1;
    std::vector<Vec2> points;
    for (int i = 9; i >= -9; --i) points.push_back({0.5 * i, 0});
    if (chain) add_chain(scene, points);
    else
        for (int i = -9; i < 9; ++i)
            add_body(scene, box(0.5, 0.5), Mass{}, {0.5 * i + 0.25, -0.25});
    for (const bool round : {false, true}) {
        const Index k = add_body(scene, round ? disc(0.2) : box(0.5, 0.4), 1,
                                 {round ? -4.2 : -3.3, 0.2});
        scene.bodies.velocity(k) << speed, 0, 0;
    }
    return scene;
}

inline Demo chain_scene()
{
    Demo scene = manifold_demo(
        "chain",
        "A floor of many pieces: as boxes it stops what slides, as a chain it "
        "does not",
        {{0, 0.5}, {4.8, 1.4}}, [](const Settings& settings) {
            ManifoldSetup setup;
            const bool chain = settings["chain"] > 0;
            setup.scene = floor_of_pieces(chain, settings["speed"]);
            setup.impulse_scale = 0.5;
            const Index box = setup.scene.bodies.count() - 2;
            setup.measure = [box](const ManifoldState& s) -> std::vector<Real> {
                return {s.scene.bodies.u[3 * box], s.scene.bodies.u[3 * box + 3],
                        s.scene.bodies.u[3 * box + 4],
                        static_cast<Real>(s.now.contacts.size())};
            };
            setup.picture = [](Canvas& canvas, const ManifoldState&) {
                for (int i = -9; i <= 9; ++i)
                    canvas.segment({0.5 * i, -0.16}, {0.5 * i, -0.02},
                                   {Colour::faint, 1.5, 1});
            };
            return setup;
        });
    scene.methods = {"exact", "sweeps"};
    scene.tunables.push_back({"chain", "", "1: a chain, 0: boxes side by side", 1,
                              0, 1, Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"speed", "m/s", "at the start", 2, 0.1, 20,
                              Numbers::real, OnChange::restarts});
    scene.columns = {{"box", "m/s", "velocity of the box", Plot::linear},
                     {"disc", "m/s", "of the disc", Plot::linear},
                     {"up", "m/s", "of the disc, upwards", Plot::linear},
                     {"contacts", "", "points", Plot::linear}};
    return scene;
}

}  // namespace rigid
