/// \file peer_ways.hpp
/// The scenes of the ways in other engines, where they are installed: each by its public interface alone, with its defaults but for
/// the step, no sleep and no damping. Bodies are boxes and balls in space that move in the plane.
///
///     ODE             impulses, all at once, by its exact step
///     Bullet          impulses, by its ten sweeps
///     Bullet's trees  coordinates of joints: btMultiBody
#pragma once

#include "chapters/26_four_ways/benchmark/peer_bodies.hpp"

#ifdef RIGID_HAS_ODE
#include "chapters/26_four_ways/benchmark/peer_ode.hpp"
#endif
#ifdef RIGID_HAS_BULLET
#include "chapters/26_four_ways/benchmark/peer_bullet.hpp"
#include "chapters/26_four_ways/benchmark/peer_bullet_trees.hpp"
#endif

#include <type_traits>

namespace rigid {

/// Calls one for each engine that is installed.
/// \param one  void(std::type_identity<Peer>)
template <class One>
void for_each_peer([[maybe_unused]] const One& one)
{
#ifdef RIGID_HAS_ODE
    one(std::type_identity<OdeWays>{});
#endif
#ifdef RIGID_HAS_BULLET
    one(std::type_identity<BulletWays>{});
    one(std::type_identity<BulletTreeWays>{});
#endif
}

/// A run to the time of the scene, as run_way().
template <class Peer>
WayResult run_peer(const WayScene& way, Real h)
{
    const auto steps = static_cast<int>(std::ceil(way.time / h - 1e-9));
    JointedScene scene = way.scene;
    const Real before = energy(scene);
    WayResult result;
    Peer peer(way);
    for (int i = 0; i < steps; ++i) peer.step(way.time / steps);
    peer.read(scene);
    result.error = way.error(scene);
    result.energy_gain = energy(scene) - before;
    result.drift = drift_of(way, scene);
    if (!(result.error < 100) || !(result.energy_gain < 15))
        result.why_not = "it flies apart";
    return result;
}

}  // namespace rigid
