/// \file enter_awake.hpp
/// How a scene, and a disc that is added to it later, gets into the contacts stage that keeps the awake bodies in a list.
#pragma once

#include "chapters/10_skipping_work/awake_bodies.hpp"

#include <stdexcept>
#include <string>
#include <utility>

namespace rigid {

inline void AwakeBodies::reset(const DiscScene& scene, CollisionFilter filter)
{
    require_bodies(scene);
    const auto K = static_cast<std::size_t>(scene.bodies.count());
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if (scene.bodies.inverse_mass[2 * k] !=
            scene.bodies.inverse_mass[2 * k + 1])
            throw std::invalid_argument("disc " + std::to_string(k) +
                                        " has two different masses");
    wake_all(scene.bodies);
    length = typical_length(scene);
    broad.reset(scene, std::move(filter));
    links_on =
        incidence(K, scene.links.size(), [&](std::size_t i, const auto& visit) {
            visit(scene.links[i].a);
            visit(scene.links[i].b);
        });
    bends_on =
        incidence(K, scene.bends.size(), [&](std::size_t i, const auto& visit) {
            visit(scene.bends[i].left);
            visit(scene.bends[i].middle);
            visit(scene.bends[i].right);
        });
    joints_on =
        incidence(K, scene.joints.size(), [&](std::size_t i, const auto& visit) {
            if (scene.joints[i].a != world) visit(scene.joints[i].a);
            visit(scene.joints[i].b);
        });
}

inline void AwakeBodies::add(const DiscScene& scene, Index k)
{
    Sleepers<2>::add(scene.bodies, k);
    broad.add(scene, k);
    for (Incidence* const on : {&links_on, &bends_on, &joints_on})
        on->first.push_back(on->first.back());
}

}  // namespace rigid
