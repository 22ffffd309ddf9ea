// The functions of polygon.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/11_rotation/polygon.hpp"

namespace rigid {

void require_valid(const Polygon& shape)
{
    const std::size_t n = shape.vertices.size();
    if (n == 0)
        throw std::invalid_argument(
            "the polygon has no vertex; it needs one or more");
    if (!(shape.radius >= 0 && shape.radius <= largest_number))
        throw std::invalid_argument("the radius of the polygon is " +
                                    shortest(shape.radius) +
                                    " m; it must be between 0 and 1e75");
    for (std::size_t i = 0; i < n; ++i)
        if (!(shape.vertices[i].array().abs() <= largest_number).all())
            throw std::invalid_argument(
                "vertex " + std::to_string(i) + " of the polygon is (" +
                shortest(shape.vertices[i].x()) + ", " +
                shortest(shape.vertices[i].y()) +
                "); both must be numbers between -1e75 and 1e75");
    Real turned = 0;  // all exterior angles together: once around
    for (std::size_t i = 0; i < n && n > 1; ++i) {
        const Vec2 before = shape.vertices[(i + 1) % n] - shape.vertices[i];
        const Vec2 after =
            shape.vertices[(i + 2) % n] - shape.vertices[(i + 1) % n];
        if (before.norm() == 0)
            throw std::invalid_argument(
                "vertices " + std::to_string(i) + " and " +
                std::to_string((i + 1) % n) +
                " of the polygon are the same point; each must be its own");
        if (before.norm() < 1 / largest_number)
            throw std::invalid_argument("the edge of the polygon from vertex " +
                                        std::to_string(i) + " is " +
                                        shortest(before.norm()) +
                                        " m long; it must be 1e-75 or more");
        if (n == 2) break;
        const Real angle = atan2(cross2(before, after), before.dot(after));
        if (!(angle > 0 && angle < pi))
            throw std::invalid_argument("the polygon turns by " + shortest(angle) +
                                        " rad at vertex " +
                                        std::to_string((i + 1) % n) +
                                        "; a convex one, counterclockwise, turns "
                                        "by more than 0 and less than π");
        turned += angle;
    }
    if (turned > 3 * pi)
        throw std::invalid_argument("the polygon goes around " +
                                    shortest(std::round(turned / (2 * pi))) +
                                    " times; a convex one goes around once");
}

}  // namespace rigid
