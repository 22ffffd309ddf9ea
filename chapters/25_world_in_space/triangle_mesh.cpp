// The functions of triangle_mesh.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/triangle_mesh.hpp"

namespace rigid {

//! [near]
int TriangleMesh::near(const SolidBox& box, std::vector<int>& stack,
                       std::vector<int>& found) const
{
    int looked = 0;
    found.clear();
    stack.assign(1, tree.root());
    while (!stack.empty()) {
        const auto& here = tree.node(stack.back());
        stack.pop_back();
        ++looked;
        if (!overlap(here.box, box)) continue;
        if (here.is_leaf()) found.push_back(here.item);
        else stack.push_back(here.right), stack.push_back(here.left);
    }
    std::sort(found.begin(), found.end());
    return looked;
}
//! [near]

void find_neighbours(TriangleMesh& mesh)
{
    mesh.beyond.assign(mesh.triangles.size(), {-1, -1, -1});
    const auto around = [&mesh](int v) {
        const auto i = static_cast<std::size_t>(v);
        return std::pair(mesh.first[i], mesh.first[i + 1]);
    };
    for (int s = 0; s < 3 * mesh.count(); ++s) {
        const auto here = static_cast<std::size_t>(s / 3),
                   side = static_cast<std::size_t>(s % 3);
        const int from = mesh.triangles[here][side],
                  to = mesh.triangles[here][(side + 1) % 3];
        auto [k, end] = around(from);
        if (const auto other = around(to); other.second - other.first < end - k)
            k = other.first, end = other.second;
        for (; k < end; ++k) {
            const int g = mesh.at[static_cast<std::size_t>(k)];
            const TriangleMesh::Triangle& other = mesh.triangle(g);
            for (std::size_t m = 0; m < 3; ++m) {
                const int start = other[m], stop = other[(m + 1) % 3];
                if (start == to && stop == from) mesh.beyond[here][side] = g;
                if (g != s / 3 && start == from && stop == to)
                    throw std::invalid_argument(
                        "triangles " + std::to_string(s / 3) + " and " +
                        std::to_string(g) + " of a mesh both go from vertex " +
                        std::to_string(from) + " to vertex " + std::to_string(to) +
                        "; an edge belongs to two at most, and they run along it "
                        "in opposite directions");
            }
        }
    }
}

//! [triangle_mesh]
std::shared_ptr<const TriangleMesh>
triangle_mesh(std::vector<Vec3> vertices,
              std::vector<TriangleMesh::Triangle> triangles)
{
    auto mesh = std::make_shared<TriangleMesh>();
    const auto refuse = [](const char* what, std::size_t i,
                           const std::string& why) {
        throw std::invalid_argument(std::string(what) + " " + std::to_string(i) +
                                    " of a mesh " + why);
    };
    if (triangles.empty())
        throw std::invalid_argument(
            "a mesh has no triangles; it needs one or more");
    const std::size_t N = vertices.size();
    for (std::size_t i = 0; i < N; ++i)
        if (const Vec3& p = vertices[i]; !p.allFinite())
            refuse("vertex", i,
                   "is at (" + shortest(p.x()) + ", " + shortest(p.y()) + ", " +
                       shortest(p.z()) + ") m; it must be finite");
    // of those in one place the first
    std::vector<int> order(N), name(N);
    std::iota(order.begin(), order.end(), 0);
    const auto place = [&vertices](int i) {
        const Vec3& p = vertices[static_cast<std::size_t>(i)];
        return std::array<Real, 3>{p.x(), p.y(), p.z()};
    };
    std::sort(order.begin(), order.end(), [&](int i, int j) {
        return std::pair(place(i), i) < std::pair(place(j), j);
    });
    for (std::size_t i = 0; i < N; ++i) {
        const bool again = i > 0 && place(order[i]) == place(order[i - 1]);
        name[static_cast<std::size_t>(order[i])] =
            again ? name[static_cast<std::size_t>(order[i - 1])] : order[i];
    }
    mesh->first.assign(N + 1, 0);
    for (std::size_t t = 0; t < triangles.size(); ++t) {
        for (int& i : triangles[t]) {
            if (i < 0 || static_cast<std::size_t>(i) >= N)
                refuse("triangle", t,
                       "has the vertex " + std::to_string(i) + " among " +
                           std::to_string(N));
            i = name[static_cast<std::size_t>(i)];
            ++mesh->first[static_cast<std::size_t>(i) + 1];
        }
        const auto corner = [&](std::size_t k) -> const Vec3& {
            return vertices[static_cast<std::size_t>(triangles[t][k])];
        };
        const Vec3 p = corner(1) - corner(0), q = corner(2) - corner(0),
                   area = cross(p, q);
        const Real longest =
            std::max({p.squaredNorm(), q.squaredNorm(), (p - q).squaredNorm()});
        // a height of 1e-10 of its length is nothing but rounding
        if (!(area.norm() > 1e-10 * longest) || !std::isfinite(area.norm()))
            refuse("triangle", t,
                   "has the area " + shortest(area.norm() / 2) +
                       " m² at a longest side of " + shortest(std::sqrt(longest)) +
                       " m; it must not be a line or a point");
        mesh->normals.push_back(area.normalized());
        const SolidBox box{corner(0).cwiseMin(corner(1)).cwiseMin(corner(2)),
                           corner(0).cwiseMax(corner(1)).cwiseMax(corner(2))};
        mesh->tree.place(static_cast<int>(t), box);
    }
    mesh->vertices = std::move(vertices), mesh->triangles = std::move(triangles);
    std::partial_sum(mesh->first.begin(), mesh->first.end(), mesh->first.begin());
    mesh->at.resize(3 * mesh->triangles.size());
    std::vector<int> next = mesh->first;
    for (int t = 0; t < mesh->count(); ++t)
        for (const int i : mesh->triangle(t))
            mesh->at[static_cast<std::size_t>(
                next[static_cast<std::size_t>(i)]++)] = t;
    find_neighbours(*mesh);
    return mesh;
}
//! [triangle_mesh]

}  // namespace rigid
