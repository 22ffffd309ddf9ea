// The functions of smooth_touching.hpp, and its step.
#include "common/eigen_instances.hpp"

#include "chapters/23_faces_that_touch/smooth_touching.hpp"

namespace rigid {

//! [wall]
void collide(const SolidWall& wall, const PlacedSolid& b, const TouchSettings& how,
             ClipRoom& room, SolidTouch& touch)
{
    room.points.clear();
    touch.normal = wall.normal;
    // more than half right above another corner: that one touches, and of a plate
    // that is thinner than the margin the upper corners would carry it otherwise
    const auto is_above_another = [&](const Vec3& p) {
        return std::any_of(b.vertices.begin(), b.vertices.end(),
                           [&](const Vec3& q) {
                               const Real up = wall.normal.dot(p - q);
                               return up > 0 && (p - q).squaredNorm() < 2 * up * up;
                           });
    };
    for (std::size_t i = 0; i < b.vertices.size(); ++i) {
        const Real height = wall.normal.dot(b.vertices[i]) - wall.offset;
        if (height - b.radius() < how.margin && !is_above_another(b.vertices[i]))
            room.points.push_back({b.vertices[i] - height * wall.normal,
                                   b.vertices[i], height - b.radius(),
                                   static_cast<int>(i)});
    }
    keep_four(room.points, how.slack, touch);
}
//! [wall]

void ContactSearch::require_valid() const
{
    if (!(slack >= 0 && slack < 1))
        throw std::invalid_argument("the slack of contacts is " + shortest(slack) +
                                    " margins; it must be from 0 to 1");
    if (points < 1 || points > 4)
        throw std::invalid_argument("a pair of hulls has " +
                                    std::to_string(points) +
                                    " points at most; it must be 1 to 4");
}

void ContactSearch::touch_wall(const WalledSolids& scene, std::size_t w,
                               const TouchSettings& near, StepData<6>& now)
{
    const SolidWall& wall = scene.walls[w];
    for (Index b = 0; b < scene.bodies.count(); ++b) {
        const auto k = static_cast<std::size_t>(b);
        const Real height =
            wall.normal.dot(centre_of(scene.bodies.x, b)) - wall.offset;
        const TouchSettings how{near.margin + way_of[k], near.slack};
        if (!looks(b) || !scene.bodies.can_move(b) ||
            height - reach[k] >= how.margin)
            continue;
        Index first = 0;
        for (std::size_t v = 0; v < w; ++v) first += corners(k);
        for (const PlacedSolid& solid : solids[k]) {
            collide(wall, solid, how, room, touch);
            add(scene, world, b, 0, solid.radius(), first, now);
            first += static_cast<Index>(solid.vertices.size());
        }
    }
}

void ContactSearch::touch_pair(const WalledSolids& scene, int a, int b,
                               const TouchSettings& near, StepData<6>& now)
{
    const auto ka = static_cast<std::size_t>(a), kb = static_cast<std::size_t>(b);
    const TouchSettings how{near.margin + ahead_of[ka] + ahead_of[kb], near.slack};
    Index first = 0;
    const std::size_t before = now.contacts.size();
    for (const PlacedSolid& p : solids[ka])
        for (const PlacedSolid& q : solids[kb]) {
            collide(p, q, how, room, touch);
            add(scene, a, b, p.radius(), q.radius(), first, now);
            first += TouchNames(*p.form, *q.form).count();
        }
    if (now.contacts.size() > before) touching.push_back({a, b});
}

void ContactSearch::add(const WalledSolids& scene, Index a, Index b, Real radius_a,
                        Real radius_b, Index first_feature, StepData<6>& now)
{
    if (touch.count == 0) return;
    const Mat3 Ra = rotation_of(scene.bodies.x, a),
               Rb = rotation_of(scene.bodies.x, b);
    const auto in_axes = [&](Index k, const Mat3& R, const Vec3& p) -> Vec3 {
        return R.transpose() * (p - centre_of(scene.bodies.x, k));
    };
    if (touch.count > points) keep_deepest();
    for (int i = 0; i < touch.count; ++i) {
        const TouchPoint& p = touch.points[static_cast<std::size_t>(i)];
        now.contacts.push_back({a,
                                b,
                                first_feature + p.feature,
                                touch.normal,
                                in_axes(a, Ra, p.on_a),
                                in_axes(b, Rb, p.on_b),
                                radius_a,
                                radius_b,
                                {}});
    }
}

void ContactSearch::keep_deepest()
{
    const auto end = touch.points.begin() + touch.count;
    // of equals the one that is named first, whatever sorts them
    std::sort(touch.points.begin(), end,
              [](const TouchPoint& p, const TouchPoint& q) {
                  return p.gap < q.gap || (p.gap == q.gap && p.feature < q.feature);
              });
    touch.count = points;
}

template void step(WalledSolids&, const StepSettings&, SmoothSweeps&, StepData<6>&);

}  // namespace rigid
