// The functions of hydrostatics.hpp.
#include "chapters/29_waves/hydrostatics.hpp"

namespace rigid {

Submerged measure_below(const std::vector<Vec2>& corners, Real level,
                        Polygon& memory)
{
    Submerged found;
    if (corners.size() < 3) return found;
    memory.vertices = corners;
    Vec2 sum(0, 0);
    for_each_piece(memory, [&](Real area, const Vec2& centroid, Real) {
        found.area += area;
        sum += area * (centroid - corners[0]);
    });
    if (!(found.area > 0)) return {};
    found.centroid = corners[0] + sum / found.area;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i],
                   &b = corners[i + 1 < corners.size() ? i + 1 : 0];
        if (a.y() == level && b.y() == level)
            found.width += std::abs(b.x() - a.x());
    }
    return found;
}

Submerged submerged(const std::vector<Vec2>& corners, Real level)
{
    std::vector<Vec2> kept;
    Polygon memory;
    cut(corners, Keep::below, level, kept);
    return measure_below(kept, level, memory);
}

}  // namespace rigid
