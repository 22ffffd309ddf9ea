// The functions of houses.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/houses.hpp"

namespace rigid {

//! [house_by_hand]
Real card_house_by_hand(int storeys)
{
    // feet and tips from the middle of a flat card: what lies on one end presses a
    // little on the other
    const Real feet = Cards::half_thickness + Cards::sine,
               tips = Cards::pitch / 2 - Cards::half_thickness,
               share = (1 + feet / tips) / 2;
    std::vector<std::array<Real, 2>> load{{0, 0}};  // of each pair: left, right
    for (int pairs = 1; pairs < storeys; ++pairs) {
        std::vector<std::array<Real, 2>> below(static_cast<std::size_t>(pairs) + 1,
                                               {0, 0});
        for (std::size_t i = 0; i < load.size(); ++i) {
            const Real left = 1 + load[i][0], right = 1 + load[i][1];
            below[i][1] += 0.5 + share * left + (1 - share) * right;
            below[i + 1][0] += 0.5 + share * right + (1 - share) * left;
        }
        load = below;
    }
    Real p = 0;
    for (const auto& pair : load) p = std::max({p, pair[0], pair[1]});
    return (0.5 + p) / (1 + p) * Cards::sine / Cards::cosine;
}
//! [house_by_hand]

//! [arch]
RoughScene stone_arch(int stones, Real thickness, Real mu)
{
    RoughScene scene;
    scene.walls.push_back({{0, 1}, 0});
    const Real in = 1 - thickness / 2, out = 1 + thickness / 2;
    for (int k = 0; k < stones; ++k) {
        // the ends stand on the floor to the last bit
        const auto joint = [stones](int i) -> Vec2 {
            if (i == 0) return {1, 0};
            if (i == stones) return {-1, 0};
            return {cos(pi * i / stones), sin(pi * i / stones)};
        };
        const Polygon stone{
            {in * joint(k), out * joint(k), out * joint(k + 1), in * joint(k + 1)},
            0};
        add_body(scene, stone, 1000, mass_of(stone, 1000).centroid);
    }
    cover(scene, {mu, 0, 0, 0});
    return scene;
}

Real arch_by_hand(int stones)
{
    Real most = 0;
    for (int j = 1; 2 * j < stones; ++j) {
        const Real x = 2.0 * j / stones, t = tan(pi * j / stones),
                   b = (1 + x) * t / 2;
        most = std::max(most, std::sqrt(b * b + x) - b);
    }
    return most;
}
//! [arch]

}  // namespace rigid
