// The functions of friction_cone.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/friction_cone.hpp"

namespace rigid {

//! [pyramid]
Vec2 onto_pyramid(const Vec2& lambda, Real radius, int corners)
{
    if (corners == 0) return onto_disc(lambda, radius);
    const Real half = pi / corners;
    const Real side = std::floor(atan2(lambda.y(), lambda.x()) / (2 * half));
    const Real angle = (2 * side + 1) * half;  // to the middle of the nearest side
    const Vec2 out(cos(angle), sin(angle)), along(-out.y(), out.x());
    const Real height = radius * cos(half), width = radius * sin(half);
    if (!(out.dot(lambda) > height)) return lambda;
    return height * out + std::clamp(along.dot(lambda), -width, width) * along;
}
//! [pyramid]

}  // namespace rigid
