/// \file scene_stacks.hpp
/// A box over the end of another, stacks, and blocks over the end of a table.
#pragma once

#include "chapters/12_contact_manifolds/program/manifold_run.hpp"

namespace rigid {

inline Demo across_scene()
{
    Demo scene = manifold_demo(
        "across", "A box lies over the end of another: two points bear its weight",
        {{0.3, 0.55}, {2.6, 1.75}}, [](const Settings&) {
            ManifoldSetup setup;
            setup.scene = box_over_an_end();
            setup.impulse_scale = 1.5;
            setup.names = true;
            setup.measure = [](const ManifoldState& s) -> std::vector<Real> {
                Real left = 0, right = 0;
                for (std::size_t i = 0; i < s.now.contacts.size(); ++i)
                    (s.now.contacts[i].point.x() < 1.5 ? left : right) +=
                        s.now.solution.lambda[static_cast<Index>(i)] / s.now.h;
                return {left, right, s.scene.bodies.x[5]};
            };
            return setup;
        });
    scene.columns = {{"left", "N", "force at its own corner", Plot::linear},
                     {"right", "N", "at the corner of the lower box", Plot::linear},
                     {"angle", "rad", "of the upper box", Plot::linear}};
    return scene;
}

inline Demo stack_scene()
{
    Demo scene = manifold_demo(
        "stack",
        "Boxes on one another: with one point each, or without names, "
        "they do not stand",
        {{0, 3}, {5.2, 3.5}}, [](const Settings& settings) {
            ManifoldSetup setup;
            const int boxes = static_cast<int>(settings["boxes"]);
            setup.scene = box_stack(boxes);
            setup.impulse_scale = 0.3;
            setup.measure = [boxes](const ManifoldState& s) -> std::vector<Real> {
                Real lean = 0, turn = 0;
                for (int k = 0; k < boxes; ++k) {
                    lean = std::max(lean, std::abs(s.scene.bodies.x[3 * k]));
                    turn = std::max(turn, std::abs(s.scene.bodies.x[3 * k + 2]));
                }
                return {lean, turn, deepest_overlap(s.now), s.kept,
                        energy(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back({"boxes", "", "on one another", 6, 1, 30,
                              Numbers::whole, OnChange::restarts});
    scene.columns = {
        {"lean", "m", "farthest from the axis", Plot::linear},
        {"turn", "rad", "largest angle", Plot::linear},
        {"overlap", "m", "deepest", Plot::logarithmic},
        {"kept", "", "share of the impulses that found their rows", Plot::linear},
        {"energy", "J", "kinetic and potential", Plot::linear}};
    return scene;
}

inline Demo overhang_scene()
{
    Demo scene = manifold_demo(
        "overhang", "Blocks over the end of a table: how far out may they lie?",
        {{0, 0.7}, {2.2, 1.5}}, [](const Settings& settings) {
            ManifoldSetup setup;
            const int blocks = static_cast<int>(settings["blocks"]);
            setup.scene = overhang(blocks, settings["part"]);
            setup.impulse_scale = 0.4;
            setup.measure = [blocks](const ManifoldState& s) -> std::vector<Real> {
                Real turn = 0;
                for (int k = 1; k <= blocks; ++k)
                    turn = std::max(turn, std::abs(s.scene.bodies.x[3 * k + 2]));
                return {s.scene.bodies.x[3 * blocks] + 0.5, turn, s.kept};
            };
            return setup;
        });
    scene.methods = {"exact", "sweeps", "one_point", "no_names"};
    scene.tunables.push_back(
        {"blocks", "", "number", 6, 1, 12, Numbers::whole, OnChange::restarts});
    scene.tunables.push_back({"part", "", "of the limit", 0.98, 0.5, 1.5,
                              Numbers::real, OnChange::restarts});
    scene.columns = {
        {"out", "m", "from the table's end to that of the top block", Plot::linear},
        {"turn", "rad", "largest angle", Plot::linear},
        {"kept", "", "share of the impulses that found their rows", Plot::linear}};
    return scene;
}

inline Demo pile_scene()
{
    Demo scene = manifold_demo(
        "pile", "Discs, boxes, capsules and rounded pentagons fall into a trough",
        {{0, 3}, {5.2, 3.5}}, [](const Settings& settings) {
            ManifoldSetup setup;
            setup.scene = pile(static_cast<int>(settings["bodies"]));
            setup.measure = [](const ManifoldState& s) -> std::vector<Real> {
                return {static_cast<Real>(s.now.contacts.size()),
                        deepest_overlap(s.now), s.kept, energy(s.scene)};
            };
            return setup;
        });
    scene.tunables.push_back(
        {"bodies", "", "number", 42, 1, 200, Numbers::whole, OnChange::restarts});
    scene.columns = {
        {"contacts", "", "points", Plot::linear},
        {"overlap", "m", "deepest", Plot::logarithmic},
        {"kept", "", "share of the impulses that found their rows", Plot::linear},
        {"energy", "J", "kinetic and potential", Plot::linear}};
    return scene;
}

}  // namespace rigid
