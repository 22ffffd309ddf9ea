/// \file scene_edits.hpp
/// The only ways to change a scene from outside while it runs: each of them wakes the bodies that the change concerns.
///
/// Nothing touches the discs above one that is gone, so no step could notice by itself that they must fall.
#pragma once

#include "chapters/10_skipping_work/skipping_world.hpp"
#include "common/text.hpp"

#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// Throws std::invalid_argument unless there is a disc k, and still is.
void require_disc(const SkippingWorld& now, Index k);

//! [scene_edits]
/// Disc k wakes, and all discs within its margin, and those that a link, a joint or a
/// bend joins to it.
/// \throws std::invalid_argument  for a disc that is not there
inline void wake_around(SkippingWorld& now, Index k)
{
    require_disc(now, k);
    const auto i = static_cast<int>(k);
    now.method.contacts.set.wake(k);
    now.method.contacts.broad.grid.near(
        now.method.contacts.broad.grid.position(i),
        now.method.contacts.broad.reach_of(now.scene.radius[k]), ~std::uint64_t{0},
        [&](int b) { now.method.contacts.set.wake(b); });
    for (const int l : now.method.contacts.links_on.of(i)) {
        const Link& link = now.scene.links[static_cast<std::size_t>(l)];
        now.method.contacts.set.wake(link.a == k ? link.b : link.a);
    }
    for (const int j : now.method.contacts.joints_on.of(i)) {
        const Joint& joint = now.scene.joints[static_cast<std::size_t>(j)];
        for (const Index b : {joint.a, joint.b})
            if (b != world) now.method.contacts.set.wake(b);
    }
    for (const int l : now.method.contacts.bends_on.of(i)) {
        const Bend& bend = now.scene.bends[static_cast<std::size_t>(l)];
        for (const Index b : {bend.left, bend.middle, bend.right})
            now.method.contacts.set.wake(b);
    }
}

/// Gives a disc another place, velocity and mass, and wakes the bodies that this
/// concerns, where it was and where it is.
/// \param x             [m]
/// \param u             [m/s]
/// \param inverse_mass  [1/kg]; 0 makes it a fixed disc, or, with a velocity, one
///                      that moves and is not moved
/// \throws std::invalid_argument  for a disc that is not there, or a number that
///     makes no sense
inline void change_disc(SkippingWorld& now, Index k, const Vec2& x, const Vec2& u,
                        Real inverse_mass)
{
    require_disc(now, k);
    const auto refuse = [k](const std::string& what) {
        throw std::invalid_argument("disc " + std::to_string(k) +
                                    " is to get the " + what);
    };
    const auto check = [&](const std::string& name, const Vec2& v) {
        if (!v.allFinite())
            refuse(name + ' ' + shortest(v.x()) + ", " + shortest(v.y()) +
                   "; it must be finite");
    };
    check("place", x);
    check("velocity", u);
    if (!(inverse_mass >= 0) || !std::isfinite(inverse_mass))
        refuse("inverse mass " + shortest(inverse_mass) +
               " 1/kg; it must be zero or positive and finite");
    wake_around(now, k);
    now.scene.bodies.position(k) = x;
    now.scene.bodies.velocity(k) = u;
    if (now.found.u_star.size() > 2 * k) now.found.u_star.segment<2>(2 * k) = u;
    if (now.method.correction.v.size() > 2 * k)
        now.method.correction.v.segment<2>(2 * k).setZero();
    now.scene.bodies.inverse_mass.segment<2>(2 * k).setConstant(inverse_mass);
    now.method.contacts.broad.grid.move(static_cast<int>(k), x);
    wake_around(now, k);
    // it has to rest again for all of t_rest, awake or not
    now.method.contacts.rests[static_cast<std::size_t>(k)] = disturbed;
    const bool moves = inverse_mass > 0 || u.squaredNorm() > 0;
    if (moves && !now.method.contacts.set.is_awake(k))
        now.method.contacts.set.awake.push_back(static_cast<int>(k));
    now.method.contacts.set.activity[static_cast<std::size_t>(k)] =
        moves ? Activity::awake : Activity::fixed;
    now.method.contacts.set.woken.push_back(
        static_cast<int>(k));  // as if it had just woken: its pairs are found again
}

/// Gives a disc another velocity, and wakes what that concerns. Written into
/// `bodies.u` instead, the velocity of a sleeper would be lost: no step looks at
/// it.
/// \param u  [m/s]; of a fixed disc: it moves from now on, and nothing moves it
/// \throws std::invalid_argument  for a disc that is not there, or a velocity that
///     is not finite
inline void set_velocity(SkippingWorld& now, Index k, const Vec2& u)
{
    require_disc(now, k);
    const Vec2 x = now.scene.bodies.position(k);
    change_disc(now, k, x, u, now.scene.bodies.inverse_mass[2 * k]);
}

/// Gives a disc an impulse: u ← u + P / m. It wakes, as in set_velocity().
/// \param impulse  P [N s]
/// \throws std::invalid_argument  for a disc that is not there or that no impulse
///     moves, or one that is not finite
inline void push(SkippingWorld& now, Index k, const Vec2& impulse)
{
    require_disc(now, k);
    const Real inverse_mass = now.scene.bodies.inverse_mass[2 * k];
    if (!(inverse_mass > 0))
        throw std::invalid_argument(
            "disc " + std::to_string(k) +
            " is fixed; no impulse moves it, set_velocity() does");
    const Vec2 u = now.scene.bodies.velocity(k) + inverse_mass * impulse;
    if (!u.allFinite())
        throw std::invalid_argument(
            "disc " + std::to_string(k) + " is to get the impulse " +
            shortest(impulse.x()) + ", " + shortest(impulse.y()) +
            " N s; it must be finite, and so must the velocity that it gives");
    set_velocity(now, k, u);
}

/// Adds a disc to the running world. Discs close to it wake; no other disc is
/// looked at.
/// \param u  velocity [m/s]
/// \return   its number
/// \throws std::invalid_argument  for a number that makes no sense
inline Index add_disc(SkippingWorld& now, const Vec2& x, const Vec2& u, Real mass,
                      Real radius)
{
    if (!u.allFinite())
        throw std::invalid_argument("the velocity of a new disc is " +
                                    shortest(u.x()) + ", " + shortest(u.y()) +
                                    "; it must be finite");
    const Index k = add_disc(now.scene, x, mass, radius);
    now.scene.bodies.velocity(k) = u;
    now.method.contacts.add(now.scene, k);
    for (VecX* const v : {&now.found.u_star, &now.method.correction.v})
        if (v->size() == 2 * k) {
            v->conservativeResize(2 * k + 2);
            v->tail<2>().setZero();
        }
    wake_around(now, k);
    return k;
}

/// Takes a disc out of the scene, with its links and bends. What stood on it wakes.
inline void take_away(SkippingWorld& now, Index k)
{
    require_disc(now, k);
    wake_around(now, k);
    now.method.contacts.broad.grid.remove(static_cast<int>(k));
    now.method.contacts.set.activity[static_cast<std::size_t>(k)] = Activity::gone;
    now.method.contacts.set.woken.push_back(static_cast<int>(k));
}

/// Puts other walls in the place of those that are there, and wakes all bodies.
/// \throws std::invalid_argument  for a wall that makes no sense
inline void change_walls(SkippingWorld& now, std::vector<HalfSpace> walls)
{
    DiscScene only;  // a scene of nothing but these walls
    only.walls = std::move(walls);
    require_valid(only);
    now.scene.walls = std::move(only.walls);
    for (Index k = 0; k < now.scene.bodies.count(); ++k)
        now.method.contacts.set.wake(k);
    now.method.contacts.changed = true;
}
//! [scene_edits]

}  // namespace rigid
