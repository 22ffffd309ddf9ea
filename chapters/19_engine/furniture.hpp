/// \file furniture.hpp
/// A world to look at and to measure: bodies of several shapes.
#pragma once

#include "chapters/19_engine/world_scenes.hpp"
#include "common/random.hpp"

namespace rigid {

/// Tables, barbells, crosses and hooks in a trough: bodies of two to four shapes.
inline World furniture_world(int bodies, std::uint64_t seed)
{
    World made;
    for (const HalfSpace& wall : trough_of_pour(5)) made.add_wall(wall);
    Random random(seed);
    const std::vector<Polygon> kinds[] = {
        {shifted(box(0.1, 0.5), {-0.4, -0.3}), shifted(box(0.1, 0.5), {0.4, -0.3})},
        {shifted(disc(0.22), {-0.5, 0}), shifted(disc(0.22), {0.5, 0})},
        {box(0.12, 1)},
        {shifted(box(0.12, 0.6), {0.44, 0.3}), shifted(box(0.5, 0.12), {0.2, 0.6}),
         shifted(disc(0.12), {-0.5, 0})}};
    for (int i = 0; i < bodies; ++i) {
        const Real x = random.uniform(-0.2, 0.2), angle = random.uniform(-0.5, 0.5);
        std::vector<ShapeDefinition> more;
        for (const Polygon& shape : kinds[i % 4]) more.push_back({.shape = shape});
        made.add_body(body_of(box(1, 0.12),
                              {1.6 * (i % 3) - 1.6 + x, 1.2 + 1.2 * (i / 3)},
                              i % 4 == 2 ? angle + pi / 4 : angle),
                      more);
    }
    return made;
}

}  // namespace rigid
