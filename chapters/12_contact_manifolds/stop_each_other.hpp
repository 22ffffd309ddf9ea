/// \file stop_each_other.hpp
/// Fast bodies in pairs: each that stops early stands in the way of others.
#pragma once

#include "chapters/12_contact_manifolds/time_of_impact.hpp"

namespace rigid {

//! [each_other]
/// Of two fast bodies: both move until one of them stops, then the other alone.
/// \return  a hit at the part of the step at which they meet
/// \tparam Moving  MovingShape, or what moves in space (chapter 25)
template <class Moving, class FirstImpact>
Impact impact_of_two(const Moving& a, Real part_a, const Moving& b, Real part_b,
                     const FirstImpact& first_impact)
{
    const auto piece = [](const Moving& m, Real from, Real to, Real part) {
        return m.piece(std::min(from, part), std::min(to, part));
    };
    const Real first = std::min(part_a, part_b), end = std::max(part_a, part_b);
    Impact both =
        first_impact(piece(a, 0, first, part_a), piece(b, 0, first, part_b));
    both.part *= first;
    if (both.hit || first == end) return both;
    Impact alone =
        first_impact(piece(a, first, end, part_a), piece(b, first, end, part_b));
    alone.part = first + alone.part * (end - first);
    return alone;
}

/// Fast bodies in pairs, until none stops any earlier. After 20 rounds all of them
/// stay where they were: nothing can have gone through anything then.
/// \param part_of  Real&(int): how much of its way each of them goes
/// \param fast     with the pairs that may meet
template <class Motion, class FirstImpact, class PartOf, class Fast>
void stop_each_other(const Motion& motion, const FirstImpact& first_impact,
                     const PartOf& part_of, Fast& fast)
{
    bool earlier = !fast.pairs.empty();
    for (int round = 0; earlier; ++round) {
        if (round == 20) {
            for (const int k : fast.bodies) part_of(k) = 0;
            return;
        }
        earlier = false;
        for (const auto& pair : fast.pairs) {
            const int a = pair.first, b = pair.second;
            const auto ka = static_cast<std::size_t>(a),
                       kb = static_cast<std::size_t>(b);
            Real &part_a = part_of(a), &part_b = part_of(b);
            const Real inner = std::max(fast.inner[ka], fast.inner[kb]);
            const Impact impact =
                impact_of_two(motion(a), part_a, motion(b), part_b,
                              [&](const auto& of_a, const auto& of_b) {
                                  return first_impact(of_a, of_b, inner);
                              });
            if (!impact.hit) continue;
            for (Real* const part : {&part_a, &part_b}) {
                // rounding is no reason for another round
                earlier = earlier || impact.part < *part - 1e-12;
                *part = std::min(*part, impact.part);
            }
        }
    }
}
//! [each_other]

}  // namespace rigid
