/// \file typical_length.hpp
/// ℓ, the length that settings are measured in, of bodies that turn.
#pragma once

#include "common/bodies.hpp"
#include "common/elementary.hpp"

namespace rigid {

/// The power of ten next to the mean size of the bodies that can move, twice the way from the centroid to the farthest
/// point [m]; 1 m without any, or where their size is no number.
/// \param given     what the scene says [m]; 0: it is derived
/// \param reach_of  Real(Index k): from the centroid of body k to its farthest point [m]
/// Throws std::invalid_argument for a given length that is negative or not finite.
template <int Dof, class Reach>
Real typical_length(const Bodies<Dof>& bodies, Real given, const Reach& reach_of)
{
    if (!(given >= 0) || !std::isfinite(given))
        throw std::invalid_argument("the length of the scene is " + shortest(given) +
                                    " m; it must be positive and finite, or zero to be derived");
    if (given > 0) return given;
    Real sum = 0, count = 0;
    for (Index k = 0; k < bodies.count(); ++k) {
        if (!bodies.can_move(k)) continue;
        sum += 2 * reach_of(k);
        ++count;
    }
    return sum > 0 && sum < infinity ? pow(10.0, std::round(log10(sum / count))) : 1;
}

}  // namespace rigid
