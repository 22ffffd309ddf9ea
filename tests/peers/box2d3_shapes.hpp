/// \file box2d3_shapes.hpp
/// A shape of the book in Box2D 3. Only a source that sees no Box2D 2.4 can include it.
#pragma once

#include "chapters/11_rotation/polygon.hpp"

#include <box2d/box2d.h>

#include <vector>

namespace rigid {

inline b2Vec2 vector(const Vec2& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }

/// A disc, a capsule or a polygon with a radius.
inline void add_shape(b2BodyId body, const Polygon& shape, const b2ShapeDef& def)
{
    const auto r = static_cast<float>(shape.radius);
    std::vector<b2Vec2> corners;
    for (const Vec2& v : shape.vertices) corners.push_back(vector(v));
    if (corners.size() == 1) {
        const b2Circle disc{corners[0], r};
        b2CreateCircleShape(body, &def, &disc);
    } else if (corners.size() == 2) {
        const b2Capsule capsule{corners[0], corners[1], r};
        b2CreateCapsuleShape(body, &def, &capsule);
    } else {
        const b2Hull hull = b2ComputeHull(corners.data(), static_cast<int>(corners.size()));
        const b2Polygon polygon = b2MakePolygon(&hull, r);
        b2CreatePolygonShape(body, &def, &polygon);
    }
}

}  // namespace rigid
