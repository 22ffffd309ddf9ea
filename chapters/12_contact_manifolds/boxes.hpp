/// \file boxes.hpp
/// Rectangles along the axes: what is outside each other's box cannot touch.
#pragma once

#include "common/math.hpp"

namespace rigid {

/// A rectangle along the axes that contains something.
struct Box {
    Vec2 low = {infinity, infinity}, high = {-infinity, -infinity};  ///< [m]
};

inline bool overlap(const Box& a, const Box& b)
{
    return a.low.x() <= b.high.x() && b.low.x() <= a.high.x() &&
           a.low.y() <= b.high.y() && b.low.y() <= a.high.y();
}

inline Box joined(const Box& a, const Box& b)
{
    return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

inline Box grown(const Box& box, Real by)
{
    return {box.low - Vec2(by, by), box.high + Vec2(by, by)};
}

inline Real perimeter(const Box& box)
{
    return 2 * (box.high.x() - box.low.x() + box.high.y() - box.low.y());
}

inline bool contains(const Box& outer, const Box& inner)
{
    return outer.low.x() <= inner.low.x() && outer.low.y() <= inner.low.y() &&
           outer.high.x() >= inner.high.x() && outer.high.y() >= inner.high.y();
}

}  // namespace rigid
