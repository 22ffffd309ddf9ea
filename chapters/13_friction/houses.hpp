/// \file houses.hpp
/// What stands by friction alone: a house of cards and an arch of stones, with the μ that each needs.
///
///     house    μ ≥ (½ + p) / (1 + p) tan θ of each card, p the load on its tip in weights       (13.13)
///     arch     tan ψ tan(φ_j + ψ) ≥ 2j / N at each joint, μ = tan ψ, φ_j = j π / N from the crown    (13.20)
#pragma once

#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/friction_solver.hpp"
#include "common/elementary.hpp"

#include <array>

namespace rigid {

//! [cards]
/// A house of cards of 1 m and 1 kg, 8 mm thick. Two cards lean on each other, over
/// their feet 5 m for 12 m of height; their ends are round. Flat cards lie on the
/// tips, and the next storey stands on these.
struct Cards {
    static constexpr Real half_thickness = 0.004, sine = 5.0 / 13,
                          cosine = 12.0 / 13;
    /// from tip to tip: the flat cards have a gap of half a thickness between them
    static constexpr Real pitch = 1 + half_thickness;
};
inline RoughScene card_house(int storeys, Real mu)
{
    const Real r = Cards::half_thickness, s = Cards::sine, c = Cards::cosine;
    RoughScene scene;
    scene.walls.push_back({{0, 1}, 0});
    Real y = 0;
    for (int count = storeys; count > 0; --count, y += c + 4 * r) {
        const auto middle = [count](int i) {
            return (i - 0.5 * (count - 1)) * Cards::pitch;
        };
        for (int i = 0; i < count; ++i)
            for (const Real side : {-1.0, 1.0})
                add_body(scene, capsule(1, r), thin_rod(1, 1),
                         {middle(i) + side * (r + s / 2), y + r + c / 2},
                         atan2(c, -side * s));
        for (int i = 0; i + 1 < count; ++i)
            add_body(scene, box(1, 2 * r), thin_rod(1, 1),
                     {(middle(i) + middle(i + 1)) / 2, y + c + 3 * r});
    }
    cover(scene, {mu, 0, 0, 0});
    return scene;
}
//! [cards]

/// (13.13): a μ that is enough for a house of thin cards, and nearly the least: the
/// loads are carried down from the top, p on the tip of each card [weights of a
/// card].
Real card_house_by_hand(int storeys);

/// Half a ring of equal stones over a span, its two ends on the floor.
/// \param thickness  of the ring, whose mean radius is 1 m [m]
RoughScene stone_arch(int stones, Real thickness, Real mu);

/// (13.20): the least μ of a thick arch of an even number of stones.
Real arch_by_hand(int stones);

}  // namespace rigid
