// The functions of linkages.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/09_active_sets/linkages.hpp"

namespace rigid {

DiscScene linked_discs(Index count)
{
    require_count("rods of a pendulum", count);
    DiscScene scene;
    scene.bodies = Bodies<2>(count + 1);
    scene.radius = VecX::Constant(count + 1, 0.1);
    scene.bodies.inverse_mass.head<2>().setZero();
    for (Index k = 1; k <= count; ++k) {
        scene.bodies.position(k) = Vec2(1, -static_cast<Real>(k - 1));
        scene.links.push_back({k - 1, k, 1});
    }
    scene.linked = PairSet::all();
    scene.half_size.setConstant(1.1 * static_cast<Real>(count));
    return scene;
}

DiscScene four_bar(Real energy)
{
    DiscScene scene;
    scene.bodies = Bodies<2>(4);
    scene.radius = VecX::Constant(4, 0.1);
    scene.bodies.inverse_mass.head<4>().setZero();
    // Two sides of 1 m from (0.5, 0) and from (0, 1) meet at the right of both.
    const Vec2 left(0, 1), pivot(0.5, 0), middle = (left + pivot) / 2,
                                          half = (left - pivot) / 2;
    const Vec2 right =
        middle - perpendicular(half) * std::sqrt(1 / half.squaredNorm() - 1);
    scene.bodies.x << 0, 0, pivot, left, right;
    scene.links = {{0, 2, 1}, {2, 3, 1}, {1, 3, 1}};
    scene.linked = PairSet::all();
    scene.half_size.setConstant(1.6);
    // The speeds that the rods allow, and of these so much as the energy requires.
    const Vec2 first(1, 0), across = perpendicular(right - pivot),
                            coupler = right - left;
    const Vec2 second = across * (coupler.dot(first) / coupler.dot(across));
    const Real potential = potential_energy(scene.bodies, scene.gravity);
    if (!(energy >= potential) || !std::isfinite(energy))
        throw std::invalid_argument(
            "the energy of a four-bar linkage is " + shortest(energy) +
            " J; it must be finite and at least " + shortest(potential) + " J");
    const Real speed = std::sqrt(2 * (energy - potential) /
                                 (first.squaredNorm() + second.squaredNorm()));
    scene.bodies.velocity(2) = speed * first;
    scene.bodies.velocity(3) = speed * second;
    return scene;
}

}  // namespace rigid
