// The functions of mesh_touch.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/mesh_touch.hpp"

namespace rigid {

const PlacedSolid& MeshMemory::take(const TriangleMesh& mesh, int t)
{
    form.normals[0] = mesh.normal(t);
    form.reach = 0;
    for (std::size_t k = 0; k < 3; ++k) {
        const Vec3& p = form.hull.vertices[k] = mesh.corner(t, static_cast<int>(k));
        const Vec3 way = mesh.corner(t, (static_cast<int>(k) + 1) % 3) - p;
        form.reach = std::max(form.reach, way.norm());
        form.directions[k] = way.normalized();
    }
    placed.place(form, {0, 0, 0}, Mat3::Identity());
    return placed;
}

int take_names(const TriangleMesh& mesh, const SolidForm& form,
               const MeshMemory& memory, Index& first)
{
    const int names = TouchNames(memory.form, form).count();
    first -= static_cast<Index>(names) * mesh.count();
    if (first < std::numeric_limits<std::int32_t>::min())
        throw std::invalid_argument(
            "a mesh of " + std::to_string(mesh.count()) +
            " triangles and a hull of " + std::to_string(form.edges.size()) +
            " edges could touch in more points than there are names, 2^31");
    return names;
}

void add_to_manifolds(const SolidTouch& touch, int first_name, Real slack,
                      MeshMemory& memory)
{
    std::size_t m = 0;
    // a cosine of 1 − 1e-12: the sine that answer_of() takes for none
    while (m < memory.count &&
           !(memory.manifolds[m].normal.dot(touch.normal) > 1 - 1e-12))
        ++m;
    if (m == memory.count) {
        if (memory.manifolds.size() == m) memory.manifolds.emplace_back();
        memory.manifolds[m].normal = touch.normal;
        memory.manifolds[m].points.clear();
        ++memory.count;
    }
    std::vector<TouchPoint>& points = memory.manifolds[m].points;
    for (int i = 0; i < touch.count; ++i) {
        TouchPoint p = touch.points[static_cast<std::size_t>(i)];
        p.feature += first_name;
        // what lies over an edge lies over two triangles: the first has it
        if (std::none_of(points.begin(), points.end(), [&](const TouchPoint& q) {
                return (q.on_b - p.on_b).norm() <= slack;
            }))
            points.push_back(p);
    }
}

void farthest_first(std::vector<TouchPoint>& points)
{
    Vec3 middle(0, 0, 0);
    for (const TouchPoint& p : points)
        middle += p.on_b / static_cast<Real>(points.size());
    // they are few
    for (auto here = points.begin(); here != points.end(); ++here)
        std::iter_swap(
            here, std::max_element(here, points.end(),
                                   [&](const TouchPoint& p, const TouchPoint& q) {
                                       return (p.on_b - middle).norm() <
                                              (q.on_b - middle).norm();
                                   }));
}

//! [mesh]
void collide(const TriangleMesh& mesh, const PlacedSolid& b, int names,
             const TouchSettings& how, ClipRoom& room, SolidTouch& touch,
             MeshMemory& memory)
{
    memory.count = 0;
    memory.boxes +=
        mesh.near(grown(box_of(b), how.margin), memory.stack, memory.near);
    for (const int t : memory.near) {
        ++memory.triangles;
        if (behind(mesh, t, b)) continue;
        const PlacedSolid& a = memory.take(mesh, t);
        collide(a, b, how, room, touch);
        if (touch.count == 0) continue;
        const Answer answer =
            memory.as_one ? answer_of(mesh, t, touch.normal) : Answer::stays;
        if (answer == Answer::of_a_neighbour) continue;
        if (answer == Answer::of_its_face)
            touch_on_face(a, b, {mesh.normal(t), 0, 0, Whose::a}, how, room, touch);
        add_to_manifolds(touch, t * names, how.slack, memory);
    }
    for (std::size_t m = 0; m < memory.count; ++m)
        farthest_first(memory.manifolds[m].points);
}
//! [mesh]

}  // namespace rigid
