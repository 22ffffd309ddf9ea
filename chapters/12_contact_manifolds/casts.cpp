// The functions of casts.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/12_contact_manifolds/casts.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <limits>

namespace rigid {

static void require_valid(const Ray& ray)
{
    const auto within = [&ray](Real most) {
        return (ray.from.array().abs() <= most).all() &&
               (ray.way.array().abs() <= most).all();
    };
    if (within(largest_number)) return;
    const bool finite = within(std::numeric_limits<Real>::max());
    throw std::invalid_argument(
        "a ray begins at (" + shortest(ray.from.x()) + ", " +
        shortest(ray.from.y()) + ") and goes (" + shortest(ray.way.x()) + ", " +
        shortest(ray.way.y()) + "); " +
        (finite ? "none of these may be beyond 1e75" : "both must be finite"));
}

//! [cast]
RayHit cast(const Ray& ray, const Placed& shape)
{
    require_valid(ray);
    RayHit first;
    if (distance_to(shape, ray.from) <= 0) {
        first.hit = true, first.part = 0;
        return first;
    }
    const auto enter = [&](Real s, const Vec2& normal) {
        if (s >= 0 && s <= first.part && (!first.hit || s < first.part))
            first.hit = true, first.part = s, first.normal = normal;
    };
    const Real rho = shape.radius, d2 = ray.way.squaredNorm(),
               length = std::sqrt(d2);
    const Vec2 along = length > 0 ? Vec2(ray.way / length) : Vec2(0, 0);
    for (int i = 0; i < shape.edges(); ++i) {
        const Vec2 &n = shape.normal(i), &v = shape.vertex(i);
        const Real closing = -n.dot(ray.way);
        if (!(closing > 0)) continue;
        // a corner is on one side of the ray for both of its edges: a ray through
        // it meets one of them, whatever rounding says
        const Vec2 begin = v + rho * n - ray.from,
                   end = shape.vertex(shape.next(i)) + rho * n - ray.from;
        if (cross2(ray.way, begin) * cross2(ray.way, end) > 0) continue;
        // of a ray along the edge this is 0/0: it is nowhere but on the edge
        const auto [first_end, last_end] =
            std::minmax({begin.dot(ray.way) / d2, end.dot(ray.way) / d2});
        enter(
            std::clamp((n.dot(ray.from - v) - rho) / closing, first_end, last_end),
            n);
    }
    for (int i = 0; i < shape.size() && rho > 0; ++i) {
        // ‖r + s d‖ = ρ with r = o − v
        const Vec2 r = ray.from - shape.vertex(i);
        const Real half = r.dot(ray.way), beta = cross2(along, r);
        if (!(std::abs(beta) <= rho) || !(half < 0)) continue;
        const Real before = std::sqrt((rho - beta) * (rho + beta));
        enter(-half / d2 - before / length,
              Vec2((beta * perpendicular(along) - before * along) / rho));
    }
    return first;
}
//! [cast]

bool meets(const Ray& ray, Real part, const Box& box)
{
    Real from = 0, to = part;
    for (Index i = 0; i < 2; ++i) {
        const Real a = box.low[i] - ray.from[i], b = box.high[i] - ray.from[i];
        if (ray.way[i] == 0) {
            if (a > 0 || b < 0) return false;
            continue;
        }
        const Real s = a / ray.way[i], t = b / ray.way[i];
        from = std::max(from, std::min(s, t));
        to = std::min(to, std::max(s, t));
    }
    return from <= to * (1 + 1e-12) + 1e-300;
}

}  // namespace rigid
