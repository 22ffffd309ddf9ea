// The functions of looped_trusses.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/08_warm_starting/looped_trusses.hpp"

namespace rigid {

DiscScene truss(const std::vector<Vec2>& places,
                const std::vector<std::array<Index, 2>>& rods)
{
    DiscScene scene;
    const auto count = static_cast<Index>(places.size());
    scene.bodies = Bodies<2>(count);
    scene.radius = VecX::Constant(count, 0.05);
    for (Index k = 0; k < count; ++k) {
        scene.bodies.position(k) = places[static_cast<std::size_t>(k)];
        scene.bodies.inverse_mass.segment<2>(2 * k).setOnes();
    }
    for (const auto& [a, b] : rods)
        scene.links.push_back(
            {a, b, (scene.bodies.position(b) - scene.bodies.position(a)).norm()});
    scene.linked = PairSet::all();
    scene.gravity = {0, 0};
    return scene;
}

DiscScene five_discs_in_loops()
{
    DiscScene scene =
        truss({{0, -0.3}, {0, 0.4}, {0.4, -1}, {0.2, 0.7}, {0.2, -0.7}},
              {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {1, 2}, {1, 3}, {1, 4}});
    scene.bodies.velocity(0) << 1e-6, 0;
    return scene;
}

DiscScene looped_truss(Random& random)
{
    const Index count = 4 + random.index(9);
    std::vector<Vec2> places;
    for (int tries = 0; static_cast<Index>(places.size()) < count; ++tries) {
        const Real x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        bool free = true;
        for (const Vec2& other : places)
            free = free && (Vec2(x, y) - other).norm() > 0.15;
        if (free || tries > 1000) places.emplace_back(x, y);
    }
    std::vector<std::array<Index, 2>> pairs, rods;
    for (Index a = 0; a < count; ++a)
        for (Index b = a + 1; b < count; ++b) pairs.push_back({a, b});
    for (std::size_t i = pairs.size(); i-- > 1;)
        std::swap(pairs[i], pairs[static_cast<std::size_t>(
                                random.index(static_cast<Index>(i) + 1))]);
    const Index wanted = count + random.index(2 * count - 2);
    for (const auto& [a, b] : pairs) {
        const auto at = [&places](Index k) {
            return places[static_cast<std::size_t>(k)];
        };
        bool free = static_cast<Index>(rods.size()) < wanted;
        for (const auto& [c, d] : rods)
            free = free && !rods_cross(at(a), at(b), at(c), at(d));
        if (free) rods.push_back({a, b});
    }
    DiscScene scene = truss(places, rods);
    const Real spread = random.uniform(0, 2);
    for (Index k = 0; k < count; ++k) {
        scene.bodies.inverse_mass.segment<2>(2 * k) *=
            pow(10, random.uniform(-0.5, 0.5) * spread);
        const Real x = random.uniform(-1, 1), y = random.uniform(-1, 1);
        scene.bodies.velocity(k) << x, y;
    }
    return scene;
}

}  // namespace rigid
