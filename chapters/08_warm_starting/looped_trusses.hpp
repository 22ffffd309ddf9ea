/// \file looped_trusses.hpp
/// Trusses whose rods form loops: what a warm start was not made for.
///
/// A rod couples its row to those of all rods at its two ends. Where they close a circle, sweeps have complex
/// eigenvalues, and (8.7) does not hold.
#pragma once

#include "common/elementary.hpp"
#include "common/random.hpp"
#include "common/scenes.hpp"

#include <array>
#include <cmath>
#include <vector>

namespace rigid {

/// Discs at these places, joined by rods and otherwise alone: nothing collides, nothing weighs.
inline DiscScene truss(const std::vector<Vec2>& places,
                       const std::vector<std::array<Index, 2>>& rods)
{
    DiscScene scene;
    const auto count = static_cast<Index>(places.size());
    scene.bodies = Bodies<2>(count);
    scene.radius = VecX::Constant(count, 0.05);
    for (Index k = 0; k < count; ++k) {
        scene.bodies.position(k) = places[static_cast<std::size_t>(k)];
        scene.bodies.inverse_mass.segment<2>(2 * k).setOnes();
    }
    for (const auto& [a, b] : rods)
        scene.links.push_back(
            {a, b, (scene.bodies.position(b) - scene.bodies.position(a)).norm()});
    scene.linked = PairSet::all();
    scene.gravity = {0, 0};
    return scene;
}

/// Five discs of 1 kg and seven rods; as many as make it rigid. Disc 0 moves at a millionth of a metre a second.
inline DiscScene five_discs_in_loops()
{
    DiscScene scene =
        truss({{0, -0.3}, {0, 0.4}, {0.4, -1}, {0.2, 0.7}, {0.2, -0.7}},
              {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}});
    scene.bodies.velocity(0) << 1e-6, 0;
    return scene;
}

/// Do the segments ab and cd cross?
inline bool rods_cross(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d)
{
    const auto side = [](const Vec2& p, const Vec2& q, const Vec2& r) {
        return cross2(q - p, r - p);
    };
    return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/// A random truss in the plane: 4 to 12 discs in a square of 2 m, masses up to a hundredfold apart, rods that do not
/// cross, at least as many as discs where the square has room: so there are loops. Each disc has a random
/// velocity of up to 1 m/s along x and y.
inline DiscScene looped_truss(Random& random)
{
    const Index count = 4 + random.index(9);
    std::vector<Vec2> places;
    for (int tries = 0; static_cast<Index>(places.size()) < count; ++tries) {
        const Real x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        bool free = true;
        for (const Vec2& other : places)
            free = free && (Vec2(x, y) - other).norm() > 0.15;
        if (free || tries > 1000) places.emplace_back(x, y);
    }
    std::vector<std::array<Index, 2>> pairs, rods;
    for (Index a = 0; a < count; ++a)
        for (Index b = a + 1; b < count; ++b) pairs.push_back({a, b});
    for (std::size_t i = pairs.size(); i-- > 1;)
        std::swap(pairs[i], pairs[static_cast<std::size_t>(
                                random.index(static_cast<Index>(i) + 1))]);
    const Index wanted = count + random.index(2 * count - 2);
    for (const auto& [a, b] : pairs) {
        const auto at = [&places](Index k) {
            return places[static_cast<std::size_t>(k)];
        };
        bool free = static_cast<Index>(rods.size()) < wanted;
        for (const auto& [c, d] : rods)
            free = free && !rods_cross(at(a), at(b), at(c), at(d));
        if (free) rods.push_back({a, b});
    }
    DiscScene scene = truss(places, rods);
    const Real spread = random.uniform(0, 2);
    for (Index k = 0; k < count; ++k) {
        scene.bodies.inverse_mass.segment<2>(2 * k) *=
            pow(10, random.uniform(-0.5, 0.5) * spread);
        const Real x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        scene.bodies.velocity(k) << x, y;
    }
    return scene;
}

}  // namespace rigid
