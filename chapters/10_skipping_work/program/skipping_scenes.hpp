/// \file skipping_scenes.hpp
/// Scenes most of which needs nothing: discs scattered about, rain on hills, a net, a field of discs at rest.
#pragma once

#include "chapters/10_skipping_work/collision_filter.hpp"
#include "common/elementary.hpp"
#include "common/random.hpp"
#include "common/scenes.hpp"

#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid {

/// Sets disc k: where, how large, and its mass by its area (100 kg/m²).
inline void set_disc(DiscScene& scene, Index k, const Vec2& x, Real radius)
{
    scene.bodies.position(k) = x;
    scene.radius[k] = radius;
    scene.bodies.inverse_mass.segment<2>(2 * k).setConstant(
        1 / (100 * pi * radius * radius));
}

/// The same of a disc that cannot move.
inline void set_fixed_disc(DiscScene& scene, Index k, const Vec2& x, Real radius)
{
    set_disc(scene, k, x, radius);
    scene.bodies.inverse_mass.segment<2>(2 * k).setZero();
}

/// So many discs, still to be placed; none is a scene as well.
inline DiscScene empty_scene(Index count)
{
    if (count < 0)
        throw std::invalid_argument("the number of discs is " +
                                    std::to_string(count) +
                                    "; it must be 0 or more");
    DiscScene scene;
    scene.bodies = Bodies<2>(count);
    scene.radius = VecX::Ones(count);
    // whatever the radii: the settings of this chapter are metres
    scene.length = 1;
    return scene;
}

/// N discs anywhere in a square, as they come: some overlap.
/// \param share   of the square's area that they cover together
/// \param ratio   largest radius over smallest; every size in between is equally likely on a logarithmic scale
/// \param stretch the square becomes a rectangle: so many times as wide, as many times less high
inline DiscScene scattered(Index count, Real share, Real ratio, std::uint64_t seed,
                           Real stretch = 1)
{
    Random random(seed);
    DiscScene scene = empty_scene(count);
    Real area = 0;
    for (Index k = 0; k < count; ++k) {
        const Real radius = 0.1 * pow(ratio, random.uniform() - 1);
        set_disc(scene, k, {0, 0}, radius);
        area += pi * radius * radius;
    }
    const Real side = std::sqrt(area / share);
    for (Index k = 0; k < count; ++k) {
        const Real y = random.uniform(-0.5, 0.5), x = random.uniform(-0.5, 0.5);
        scene.bodies.position(k) = Vec2(x * side * stretch, y * side / stretch);
    }
    scene.half_size = Vec2(0.5 * side * stretch, 0.5 * side / stretch);
    return scene;
}

/// The ground of the rain at x [m]: valleys 4 m apart, of different depths.
inline Real ground(Real x) { return 1.6 * cos(0.5 * pi * x) + 0.3 * sin(0.37 * x); }

/// N discs of 5 to 10 cm, hung up in lines above a ground of fixed discs between two walls: let go, it rains.
/// The fixed discs come first.
inline DiscScene rain_on_hills(Index count, std::uint64_t seed, Real width = 36)
{
    constexpr Real step = 0.28, between = 0.24;
    Random random(seed);
    std::vector<Real> stones;  // where along x: `step` apart along the ground
    for (Real x = -width / 2; x < width / 2;) {
        stones.push_back(x);
        const Real rise = (ground(x + 0.01) - ground(x - 0.01)) / 0.02;
        x += step / std::sqrt(1 + rise * rise);
    }
    const auto fixed = static_cast<Index>(stones.size());
    const auto in_line = static_cast<Index>((width - 0.2) / between);
    DiscScene scene = empty_scene(fixed + count);
    for (Index k = 0; k < fixed; ++k) {
        const Real radius = random.uniform(0.2, 0.26),
                   x = stones[static_cast<std::size_t>(k)];
        set_fixed_disc(scene, k,
                       {x, ground(x) - radius + random.uniform(-0.04, 0.04)},
                       radius);
    }
    for (Index i = 0; i < count; ++i) {
        const Real x = between * (static_cast<Real>(i % in_line) -
                                  0.5 * static_cast<Real>(in_line - 1));
        const Index line = i / in_line;
        const Real y = 2.2 + between * static_cast<Real>(line);
        const Real radius = random.uniform(0.05, 0.1),
                   aside = random.uniform(-0.015, 0.015);
        set_disc(scene, fixed + i, {x + aside, y}, radius);
    }
    // Nothing gets through: behind the stones there is a wall.
    scene.walls = {{{0, 1}, -2.6}, {{1, 0}, -width / 2}, {{-1, 0}, -width / 2}};
    scene.half_size = {width / 2, width / 4};
    return scene;
}

/// A net of side × side discs, each linked to its neighbours; the upper corners are fixed. Its discs are all of
/// group 1, which does not meet itself: see net_filter().
inline DiscScene net(Index side)
{
    require_count("discs along a side of a net", side);
    constexpr Real length = 0.1;
    DiscScene scene = empty_scene(side * side);
    const auto at = [side](Index line, Index column) {
        return line * side + column;
    };
    for (Index line = 0; line < side; ++line)
        for (Index column = 0; column < side; ++column) {
            const bool hung = line == 0 && (column == 0 || column == side - 1);
            const Real x = length * (static_cast<Real>(column) -
                                     0.5 * static_cast<Real>(side - 1));
            const Vec2 place(x, -length * static_cast<Real>(line));
            if (hung) set_fixed_disc(scene, at(line, column), place, 0.06);
            else set_disc(scene, at(line, column), place, 0.06);
            if (column > 0)
                scene.links.push_back(
                    {at(line, column - 1), at(line, column), length});
            if (line > 0)
                scene.links.push_back(
                    {at(line - 1, column), at(line, column), length});
        }
    scene.half_size.setConstant(0.8 * length * static_cast<Real>(side));
    return scene;
}

inline CollisionFilter net_filter(const DiscScene& scene)
{
    CollisionFilter filter;
    filter.group.assign(static_cast<std::size_t>(scene.bodies.count()), 1);
    filter.set_meets(1, 1, false);
    return filter;
}

/// `sleepers` discs that lie on a floor, one beside the other and not touching; far above them a pendulum, which
/// never rests. Its anchor is body 0, its bob body 1.
inline DiscScene field(Index sleepers)
{
    if (sleepers < 0)
        throw std::invalid_argument("the number of sleepers in a field is " +
                                    std::to_string(sleepers) +
                                    "; it must be 0 or more");
    DiscScene scene = empty_scene(2 + sleepers);
    set_fixed_disc(scene, 0, {0, 5}, 0.05);
    set_disc(scene, 1, {1, 5}, 0.1);
    scene.links = {{0, 1, 1}};
    for (Index i = 0; i < sleepers; ++i)
        set_disc(
            scene, 2 + i,
            {0.3 * (static_cast<Real>(i) - 0.5 * static_cast<Real>(sleepers)), 0.1},
            0.1);
    scene.walls = {{{0, 1}, 0}};
    scene.half_size = {8, 4};
    return scene;
}

/// `count` columns of `height` discs on a floor, a metre apart, and a ball far above to the left, fixed until it is let
/// go. The ball is body 0.
inline DiscScene columns_and_ball(Index count, Index height)
{
    DiscScene scene = empty_scene(1 + count * height);
    set_fixed_disc(scene, 0, {-4.2, 0.3}, 0.3);
    for (Index c = 0; c < count; ++c)
        for (Index i = 0; i < height; ++i)
            set_disc(scene, 1 + c * height + i,
                     {static_cast<Real>(c) - 0.5 * static_cast<Real>(count - 1),
                      0.1 + 0.2 * static_cast<Real>(i)},
                     0.1);
    scene.walls = {{{0, 1}, 0}};
    scene.half_size = {4.2, 2};
    return scene;
}

}  // namespace rigid
