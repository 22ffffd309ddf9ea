/// \file hydrostatics.hpp
/// What of a polygon is under water: its area, the middle of it, the width of the waterline; and whether it floats upright.
///
///     F = ρ g A  upwards at the centroid of A            Archimedes
///     GM = BM − BG,   BM = W³ / 12 A                     the metacentre M of a waterline of the width W above B, (29.17)
///
/// A polygon is cut by straight lines, one after the other; each cut of a convex polygon leaves a convex one.
#pragma once

#include "chapters/11_rotation/polygon.hpp"

#include <vector>

namespace rigid {

/// Which side of a vertical or level line is kept.
enum class Keep { right_of, left_of, below };

//! [cut]
/// The part of a convex polygon on one side of a line x = bound or y = bound; its
/// new corners are on it to the bit.
inline void cut(const std::vector<Vec2>& corners, Keep side, Real bound,
                std::vector<Vec2>& kept)
{
    const Index axis = side == Keep::below ? 1 : 0;
    const Real sign = side == Keep::right_of ? 1 : -1;
    kept.clear();
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 &a = corners[i],
                   &b = corners[i + 1 < corners.size() ? i + 1 : 0];
        const Real sa = sign * (a[axis] - bound), sb = sign * (b[axis] - bound);
        if (sa >= 0) kept.push_back(a);
        if ((sa > 0 && sb < 0) || (sa < 0 && sb > 0)) {
            Vec2 p = a + sa / (sa - sb) * (b - a);
            p[axis] = bound;  // to the bit
            kept.push_back(p);
        }
    }
}
//! [cut]

/// What of a polygon lies below a level surface.
struct Submerged {
    Real area = 0;           ///< [m²]
    Vec2 centroid = {0, 0};  ///< the centre of buoyancy B [m]
    Real width = 0;          ///< of the waterline [m]
};

/// Area and centroid of a polygon that has been cut, and the length of its edges on the line y = level.
/// \param memory  a polygon that is used for the pieces
Submerged measure_below(const std::vector<Vec2>& corners, Real level,
                        Polygon& memory);

/// Of a convex polygon at a level [m].
Submerged submerged(const std::vector<Vec2>& corners, Real level);

/// How deep a uniform box of this height floats upright when its density is `part` of the water's [m].
/// Throws std::invalid_argument unless 0 < part < 1 and the height is positive.
inline Real box_draught(Real height, Real part)
{
    if (!(height > 0 && height < infinity))
        throw std::invalid_argument("the box is " + shortest(height) +
                                    " m high; it must be positive and finite");
    if (!(part > 0 && part < 1))
        throw std::invalid_argument(
            "the box has " + shortest(part) +
            " of the water's density; it floats between 0 and 1");
    return part * height;
}

/// GM of a uniform box that floats upright, (29.18); it is stable where this is positive [m].
inline Real box_metacentric_height(Real width, Real height, Real part)
{
    if (!(width > 0 && width < infinity))
        throw std::invalid_argument("the box is " + shortest(width) +
                                    " m wide; it must be positive and finite");
    const Real draught = box_draught(height, part);
    return width * width / (12 * draught) - (height - draught) / 2;  // (29.18)
}

}  // namespace rigid
