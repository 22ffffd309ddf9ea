/// \file scene_hand.hpp
/// The reader's hand: which body it holds while the button is down.
#pragma once

#include "common/forces.hpp"
#include "common/program/program.hpp"

namespace rigid {

/// The body whose centre is nearest to a point, among those that can move.
inline Index nearest_body(const Bodies<2>& bodies, const Vec2& p)
{
    Index best = 0;
    Real distance = infinity;
    for (Index k = 0; k < bodies.count(); ++k) {
        const Real d = (bodies.position(k) - p).norm();
        if (bodies.can_move(k) && d < distance) best = k, distance = d;
    }
    return best;
}

/// Which body the reader's hand holds: the one that was nearest when the button went down.
class HeldBody {
public:
    void pull(Bodies<2>& bodies, const Input& input)
    {
        if (!input.pressed) held_ = world;
        else if (held_ == world) held_ = nearest_body(bodies, input.pointer);
        if (held_ != world) add_pull(bodies, held_, input.pointer);
    }

private:
    Index held_ = world;
};

}  // namespace rigid
