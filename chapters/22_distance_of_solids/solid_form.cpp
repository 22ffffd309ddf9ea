// The functions of solid_form.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/22_distance_of_solids/solid_form.hpp"

namespace rigid {

void require_valid(const SolidForm& form)
{
    const Hull& hull = form.hull;
    const auto refuse = [](const std::string& what) {
        throw std::invalid_argument("a hull " + what);
    };
    if (hull.vertices.empty()) refuse("has no vertices");
    if (!(hull.radius >= 0 && hull.radius <= largest_number))
        refuse("has the radius " + shortest(hull.radius) +
               " m; it must be between 0 and 1e75");
    if (hull.vertices.size() <= 2) return;
    if (hull.faces.size() < 4)
        refuse("of " + std::to_string(hull.vertices.size()) + " vertices has " +
               std::to_string(hull.faces.size()) +
               " faces; it needs at least four");
    // what rounding leaves of a corner that lies in the plane of a face
    const Real flat = 1e-9 * form.reach;
    for (std::size_t f = 0; f < hull.faces.size(); ++f) {
        const Vec3& on = hull.vertices[static_cast<std::size_t>(hull.faces[f][0])];
        Real deepest = 0;
        for (const Vec3& p : hull.vertices) {
            const Real out = form.normals[f].dot(p - on);
            if (!(out <= flat))
                refuse("is not convex: a vertex is " + shortest(out) +
                       " m outside of face " + std::to_string(f));
            deepest = std::min(deepest, out);
        }
        if (!(deepest < -flat)) refuse("is flat");
        for (const int i : hull.faces[f]) {
            const Vec3& p = hull.vertices[static_cast<std::size_t>(i)];
            if (form.normals[f].dot(p - on) < -flat)
                refuse("has a face that is not flat: vertex " + std::to_string(i) +
                       " is " + shortest(-form.normals[f].dot(p - on)) +
                       " m inside of face " + std::to_string(f));
        }
    }
    std::vector<int> faces_of(form.edges.size(), 0);
    for (const std::vector<int>& face : form.face_edges)
        for (const int e : face) ++faces_of[static_cast<std::size_t>(e)];
    for (const int count : faces_of)
        if (count != 2)
            refuse("is not closed: an edge is one of " + std::to_string(count) +
                   " faces");
}

SolidForm form_of(const Hull& hull)
{
    SolidForm form;
    form.hull = hull;
    const auto corner = [&hull](int i) -> const Vec3& {
        return hull.vertices[static_cast<std::size_t>(i)];
    };
    require_vertices(hull);
    for (const Vec3& p : hull.vertices) {
        if (!(p.array().abs() <= largest_number).all())
            throw std::invalid_argument(
                "a hull has a vertex at (" + shortest(p.x()) + ", " +
                shortest(p.y()) + ", " + shortest(p.z()) +
                "); all three must be finite, and none beyond 1e75");
        form.reach = std::max(form.reach, p.norm() + hull.radius);
    }
    if (hull.vertices.size() == 2) form.edges.push_back({0, 1});
    for (const std::vector<int>& face : hull.faces) {
        if (face.size() < 3)
            throw std::invalid_argument("a face has " +
                                        std::to_string(face.size()) +
                                        " vertices; it needs at least three");
        // twice its area times its normal: the sum of the triangles from one corner
        Vec3 area(0, 0, 0);
        std::vector<int> edges;
        for (std::size_t k = 0; k < face.size(); ++k) {
            const int i = face[k], j = face[(k + 1) % face.size()];
            area += cross(corner(i) - corner(face[0]), corner(j) - corner(face[0]));
            const SolidEdge edge{std::min(i, j), std::max(i, j)};
            const auto at = std::find(form.edges.begin(), form.edges.end(), edge);
            edges.push_back(static_cast<int>(at - form.edges.begin()));
            if (at == form.edges.end()) form.edges.push_back(edge);
        }
        // less has a square that is none, and so no normal
        if (!(area.norm() >= 1 / (largest_number * largest_number)))
            throw std::invalid_argument("a face has no area");
        form.normals.push_back(area.normalized());
        form.face_edges.push_back(std::move(edges));
    }
    for (const SolidEdge& edge : form.edges) {
        const Vec3 way = corner(edge.to) - corner(edge.from);
        if (!(way.norm() >= 1 / largest_number))
            throw std::invalid_argument("an edge has no length");
        const Vec3 d = way.normalized();
        const auto parallel = [&d](const Vec3& other) {
            return cross(d, other).squaredNorm() < 1e-20;  // a few roundings
        };
        if (std::none_of(form.directions.begin(), form.directions.end(), parallel))
            form.directions.push_back(d);
    }
    require_valid(form);
    return form;
}

Real inner_radius(const std::vector<SolidForm>& forms)
{
    if (forms.empty()) return 0;
    Real least = infinity;
    for (const SolidForm& form : forms) {
        Vec3 middle(0, 0, 0);
        for (const Vec3& p : form.hull.vertices) middle += p;
        middle /= static_cast<Real>(form.hull.vertices.size());
        Real nearest = form.normals.empty() ? 0 : infinity;
        for (std::size_t f = 0; f < form.normals.size(); ++f) {
            const auto on = static_cast<std::size_t>(form.hull.faces[f][0]);
            nearest = std::min(
                nearest, form.normals[f].dot(form.hull.vertices[on] - middle));
        }
        least = std::min(least, nearest + form.hull.radius);
    }
    return least;
}

}  // namespace rigid
