// The functions of face_clipping.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/23_faces_that_touch/face_clipping.hpp"

namespace rigid {

//! [four]
void choose_four(const std::vector<TouchPoint>& points, Real slack,
                 SolidTouch& touch)
{
    touch.count = 0;
    const auto at = [&](int k) -> const Vec3& {
        return touch.points[static_cast<std::size_t>(k)].on_b;
    };
    const auto keep = [&](std::size_t i) {
        if (i == points.size()) return false;
        touch.points[static_cast<std::size_t>(touch.count++)] = points[i];
        return true;
    };
    // twice the area of a triangle, seen against the normal
    const auto area = [&](const Vec3& p, const Vec3& q, const Vec3& r) {
        return touch.normal.dot(cross(q - p, r - p));
    };
    Real deepest = infinity;
    for (const TouchPoint& p : points) deepest = std::min(deepest, p.gap);
    const auto is_deep = [&](const TouchPoint& p) {
        return p.gap <= deepest + slack ? 1 : 0;
    };
    const auto far = [&](const TouchPoint& p) { return (p.on_b - at(0)).norm(); };
    if (!keep(best_point(points, 0, is_deep))) return;
    if (!keep(best_point(points, 0, far))) return;
    const Real none = 1e-9 * (at(1) - at(0)).squaredNorm();
    const auto beside = [&](const TouchPoint& p) {
        return std::abs(area(at(0), at(1), p.on_b));
    };
    if (!keep(best_point(points, none, beside))) return;
    const Real turn = area(at(0), at(1), at(2)) > 0 ? 1 : -1;
    const auto outside = [&](const TouchPoint& p) {
        return std::max({-turn * area(at(0), at(1), p.on_b),
                         -turn * area(at(1), at(2), p.on_b),
                         -turn * area(at(2), at(0), p.on_b)});
    };
    keep(best_point(points, none, outside));
}
//! [four]

void keep_four(const std::vector<TouchPoint>& points, Real slack, SolidTouch& touch)
{
    choose_four(points, slack, touch);
    std::sort(touch.points.begin(), touch.points.begin() + touch.count,
              [](const TouchPoint& p, const TouchPoint& q) {
                  return p.feature < q.feature;
              });
}

}  // namespace rigid
