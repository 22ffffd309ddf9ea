// The functions of placed_shape.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/12_contact_manifolds/placed_shape.hpp"

namespace rigid {

Real inner_radius(const Placed& shape, const Vec2& centroid)
{
    if (shape.size() == 2) return shape.radius;
    Real nearest = shape.edges() > 0 ? infinity : 0;
    for (int i = 0; i < shape.edges(); ++i)
        nearest =
            std::min(nearest, shape.normal(i).dot(shape.vertex(i) - centroid));
    return nearest + shape.radius;
}

}  // namespace rigid
