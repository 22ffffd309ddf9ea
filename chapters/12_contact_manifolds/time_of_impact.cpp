// The functions of time_of_impact.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/12_contact_manifolds/time_of_impact.hpp"

namespace rigid {

Impact time_of_impact(const HalfSpace& wall, const MovingShape& b, Real target,
                      Real tolerance, ImpactMemory& memory)
{
    const Vec<3> way = b.way();
    const Real turning = std::abs(way[2]) * turning_radius(*b.shape);
    return advance(
        [&](Real part) {
            memory.b.move(*b.shape, b.at(part));
            return collide(wall, memory.b.view(), infinity);
        },
        [&](const Vec2& n) { return turning - n.dot(way.head<2>()); }, target,
        tolerance);
}

}  // namespace rigid
