// The functions of space_touching.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_space/space_touching.hpp"

namespace rigid {

//! [wall]
void collide(const SolidWall& wall, const PlacedSolid& b, const TouchSettings& how,
             ClipRoom& room, SolidTouch& touch)
{
    room.points.clear();
    touch.normal = wall.normal;
    for (std::size_t i = 0; i < b.vertices.size(); ++i) {
        const Real height = wall.normal.dot(b.vertices[i]) - wall.offset;
        if (height - b.radius() < how.margin)
            room.points.push_back({b.vertices[i] - height * wall.normal,
                                   b.vertices[i], height - b.radius(),
                                   static_cast<int>(i)});
    }
    keep_four(room.points, how.slack, touch);
}
//! [wall]

void TouchingSolids::require_valid() const
{
    if (!(slack >= 0 && slack < 1))
        throw std::invalid_argument("the slack of contacts is " + shortest(slack) +
                                    " margins; it must be from 0 to 1");
    if (!(ahead >= 0) || !std::isfinite(ahead))
        throw std::invalid_argument(
            "solids look " + shortest(ahead) +
            " inner radii ahead; it must be zero or positive and finite");
    if (points < 1 || points > 4)
        throw std::invalid_argument("a pair of hulls has " +
                                    std::to_string(points) +
                                    " points at most; it must be 1 to 4");
}

void TouchingSolids::touch_wall(const SpaceScene& scene, std::size_t w,
                                const TouchSettings& near, StepData<6>& now)
{
    const SolidWall& wall = scene.walls[w];
    for (Index b = 0; b < scene.bodies.count(); ++b) {
        const auto k = static_cast<std::size_t>(b);
        const Real height =
            wall.normal.dot(centre_of(scene.bodies.x, b)) - wall.offset;
        const TouchSettings how{near.margin + ahead_of[k], near.slack};
        if (!looks(b) || !scene.bodies.can_move(b) ||
            height - reach[k] >= how.margin)
            continue;
        Index first = 0;
        for (std::size_t v = 0; v < w; ++v) first += corners(k);
        for (const PlacedSolid& solid : solids[k]) {
            collide(wall, solid, how, room, touch);
            add(scene, world, b, 0, solid.radius(), first, wall_grip(scene, w, k),
                now);
            first += static_cast<Index>(solid.vertices.size());
        }
    }
}

void TouchingSolids::touch_meshes(const SpaceScene& scene, Index b,
                                  const TouchSettings& near, StepData<6>& now)
{
    const auto k = static_cast<std::size_t>(b);
    const TouchSettings how{near.margin + ahead_of[k], near.slack};
    Index first = 0;  // below zero: hulls on walls have the others
    for (std::size_t m = 0; m < scene.meshes.size(); ++m)
        for (const PlacedSolid& solid : solids[k]) {
            const TriangleMesh& mesh = *scene.meshes[m];
            const int names = take_names(mesh, *solid.form, ground, first);
            collide(mesh, solid, names, how, room, touch, ground);
            for (std::size_t i = 0; i < ground.count; ++i) {
                touch.normal = ground.manifolds[i].normal;
                keep_four(ground.manifolds[i].points, how.slack, touch);
                add(scene, world, b, 0, solid.radius(), first,
                    mesh_grip(scene, m, k), now);
            }
        }
}

void TouchingSolids::touch_pair(const SpaceScene& scene, int a, int b,
                                const TouchSettings& near, StepData<6>& now)
{
    const auto ka = static_cast<std::size_t>(a), kb = static_cast<std::size_t>(b);
    const TouchSettings how{near.margin + ahead_of[ka] + ahead_of[kb], near.slack};
    Index first = 0;
    const std::size_t before = now.contacts.size();
    for (const PlacedSolid& p : solids[ka])
        for (const PlacedSolid& q : solids[kb]) {
            collide(p, q, how, room, touch);
            add(scene, a, b, p.radius(), q.radius(), first, grip_of(scene, ka, kb),
                now);
            first += TouchNames(*p.form, *q.form).count();
        }
    if (now.contacts.size() > before) touching.push_back({a, b});
}

void TouchingSolids::add(const SpaceScene& scene, Index a, Index b, Real radius_a,
                         Real radius_b, Index first_feature, const Grip& grip,
                         StepData<6>& now)
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
        now.contacts.push_back({a, b, first_feature + p.feature, touch.normal,
                                in_axes(a, Ra, p.on_a), in_axes(b, Rb, p.on_b),
                                radius_a, radius_b, grip});
    }
}

void TouchingSolids::keep_deepest()
{
    const auto end = touch.points.begin() + touch.count;
    std::sort(
        touch.points.begin(), end,
        [](const TouchPoint& p, const TouchPoint& q) { return p.gap < q.gap; });
    touch.count = points;
}

}  // namespace rigid
