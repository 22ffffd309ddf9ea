// The functions of solid_touch.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/23_faces_that_touch/solid_touch.hpp"

namespace rigid {

//! [collide]
void collide(const PlacedSolid& a, const PlacedSolid& b, const TouchSettings& how,
             ClipRoom& room, SolidTouch& touch)
{
    touch.count = 0;
    const Real radii = a.radius() + b.radius(), reach = radii + how.margin;
    // 1
    const Axis face = best_face(a, b, how.slack);
    if (face.separation >= reach) return;
    Axis other = best_across_edges(a, b);
    if (other.separation >= reach) return;
    // 2: faces and edges of what has none don't say whether it is apart
    Nearest near;
    const bool has_faces = a.has_faces() || b.has_faces();
    if (!has_faces || std::max(face.separation, other.separation) > 0)
        near = nearest_points(a, b);
    if (near.distance >= reach) return;
    // the difference of two points that are nearer than this has no direction
    const bool apart = near.distance > 1e-7 * (a.form->reach + b.form->reach);
    if (apart) other = {(near.on_b - near.on_a).normalized(), near.distance};
    else if (!has_faces && other.separation == -infinity)  // any will part them
        other = {across(a.directions.empty() ? b.directions : a.directions), 0};
    const Real deepest =
        std::max(face.separation, other.separation) - radii + how.slack;
    // 3, 4
    if (face.face >= 0 && face.separation + how.slack >= other.separation) {
        touch_on_face(a, b, face, how, room, touch);
        if (reaches(touch, deepest)) return;
        if (!(other.separation + how.slack >= face.separation)) other = face;
    }
    const Vec3& n = touch.normal = other.normal;
    const int ea = edge_towards(a, n), eb = edge_towards(b, -n);
    const bool along_edges = other.face < 0 && ea >= 0 && eb >= 0;
    touch.count = 0;
    if (along_edges) touch_along_edges(a, b, ea, eb, how, room, touch);
    if (reaches(touch, deepest)) return;
    // 5
    Vec3 on_b = apart || !has_faces ? near.on_b : b.corner(b.support(-n));
    if (other.face >= 0 && other.whose == Whose::b)
        on_b = a.corner(a.support(n)) + other.separation * n;
    else if (along_edges && !apart) on_b = crossing_point(a, b, ea, eb);
    const Real gap = other.separation - radii;
    touch.count = gap < how.margin ? 1 : 0;
    touch.points[0] = {on_b - other.separation * n, on_b, gap,
                       TouchNames(*a.form, *b.form).single()};
}
//! [collide]

}  // namespace rigid
