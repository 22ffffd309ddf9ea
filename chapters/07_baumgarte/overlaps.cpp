// The functions of overlaps.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/07_baumgarte/overlaps.hpp"

namespace rigid {

DiscScene sunken_disc(Real depth)
{
    DiscScene scene;
    scene.bodies = Bodies<2>(1);
    scene.radius = VecX::Constant(1, 0.5);
    scene.bodies.x << 0, 0.5 - depth;
    scene.walls = {{{0, 1}, 0}};
    scene.half_size = {1.2, 1.2};
    scene.length = 1;  // the settings of this chapter are metres
    return scene;
}

DiscScene crowd(Index count, Real depth)
{
    constexpr Real radius = 0.25;
    if (!(depth < radius))
        throw std::invalid_argument(
            "the discs of the crowd overlap by " + shortest(depth) +
            " m; it must be less than their radius of 0.25 m");
    DiscScene scene = column_between_walls(count);
    scene.radius.setConstant(radius);
    for (Index k = 0; k < count; ++k)
        scene.bodies.position(k) =
            Vec2(0, radius - depth + (2 * radius - depth) * static_cast<Real>(k));
    scene.walls = {{{0, 1}, 0}, {{1, 0}, -radius}, {{-1, 0}, -radius}};
    scene.half_size = {0.5 * static_cast<Real>(count),
                       0.5 * static_cast<Real>(count)};
    return scene;
}

}  // namespace rigid
