// The functions of ellipsoid.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/24_friction_is_a_disc/ellipsoid.hpp"

namespace rigid {

SpaceContact touch_of(const SolidWall& wall, const SolidEllipsoid& e, const VecX& x)
{
    SpaceContact contact;
    contact.b = e.body;
    contact.normal = wall.normal;
    contact.at_b =
        lowest_point(e, rotation_of(x, e.body).transpose() * wall.normal);
    const Vec3 p = point_of_solid(x, e.body, contact.at_b);
    contact.at_a = p - (wall.normal.dot(p) - wall.offset) * wall.normal;
    return contact;
}

}  // namespace rigid
