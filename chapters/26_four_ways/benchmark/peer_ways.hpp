/// \file peer_ways.hpp
/// The scenes of the ways in other engines, where they are installed: each by its public interface alone, with its defaults but for
/// the step, no sleep and no damping. Bodies are boxes and balls in space that move in the plane.
///
///     ODE             impulses, all at once, by its exact step
///     Bullet          impulses, by its ten sweeps
///     Bullet's trees  coordinates of joints: btMultiBody
///     Simbody         coordinates of joints, of order four
///     MuJoCo          coordinates of joints, soft accelerations for all else
#pragma once

#include "chapters/26_four_ways/benchmark/peer_bodies.hpp"

#ifdef RIGID_HAS_ODE
#include "chapters/26_four_ways/benchmark/peer_ode.hpp"
#endif
#ifdef RIGID_HAS_BULLET
#include "chapters/26_four_ways/benchmark/peer_bullet.hpp"
#include "chapters/26_four_ways/benchmark/peer_bullet_trees.hpp"
#endif

#ifdef RIGID_HAS_SIMBODY
#include "chapters/26_four_ways/benchmark/peer_simbody.hpp"
#endif
#ifdef RIGID_HAS_MUJOCO
#include "chapters/26_four_ways/benchmark/peer_mujoco.hpp"
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
#ifdef RIGID_HAS_SIMBODY
    one(std::type_identity<SimbodyWays>{});
#endif
#ifdef RIGID_HAS_MUJOCO
    one(std::type_identity<MujocoWays>{});
#endif
}

}  // namespace rigid
