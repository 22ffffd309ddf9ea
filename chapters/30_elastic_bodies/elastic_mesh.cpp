#include "chapters/30_elastic_bodies/elastic_mesh.hpp"

#include "common/bodies.hpp"
#include "common/elementary.hpp"
#include "common/text.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <map>
#include <stdexcept>
#include <string>

namespace rigid {

namespace {

/// Throws unless there is such an element, of nodes that there are.
template <int Dim>
void require_element(const ElasticMesh<Dim>& mesh, int element)
{
    if (element < 0 || element >= mesh.count())
        throw std::invalid_argument("a mesh has no element " +
                                    std::to_string(element) + "; it has " +
                                    std::to_string(mesh.count()));
    for (int i = 0; i < mesh.per_element(); ++i)
        if (const int node = mesh.node(element, i);
            node < 0 || node >= mesh.nodes())
            throw std::invalid_argument("element " + std::to_string(element) +
                                        " has the node " + std::to_string(node) +
                                        "; there are " +
                                        std::to_string(mesh.nodes()));
}

/// The edges from corner 0 as columns.
template <int Dim>
Mat<Dim> edge_columns(const ElasticMesh<Dim>& mesh, int element)
{
    require_element(mesh, element);
    Mat<Dim> edges;
    for (int i = 0; i < Dim; ++i)
        edges.col(i) =
            mesh.at(mesh.node(element, i + 1)) - mesh.at(mesh.node(element, 0));
    return edges;
}

void require_count(const std::string& what, int count, int least = 1)
{
    if (count < least)
        throw std::invalid_argument("the " + what + " of a mesh are " +
                                    std::to_string(count) + "; there must be " +
                                    std::to_string(least) + " or more");
}

Real factorial(int n) { return n < 2 ? 1 : n * factorial(n - 1); }

/// Boxes between rows of nodes, two triangles in each.
void add_boxes(int nx, int ny, Diagonals diagonals, ElasticMesh<2>& mesh)
{
    const auto node = [nx](int i, int j) { return j * (nx + 1) + i; };
    const auto add = [&mesh](int a, int b, int c) {
        mesh.elements.insert(mesh.elements.end(), {a, b, c});
    };
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const int a = node(i, j), b = node(i + 1, j), c = node(i + 1, j + 1),
                      d = node(i, j + 1);
            if ((i + j) % 2 == 0 || diagonals == Diagonals::parallel)
                add(a, b, c), add(a, c, d);
            else add(a, b, d), add(b, c, d);
        }
}

}  // namespace

template <int Dim>
Real measure_of(const ElasticMesh<Dim>& mesh, int element)
{
    const Mat<Dim> edges = edge_columns(mesh, element);
    return edges.determinant() / factorial(Dim);
}

template <int Dim>
Real edge_length(const ElasticMesh<Dim>& mesh)
{
    const Mat<Dim> edges = edge_columns(mesh, 0);
    Real sum = 0;
    for (int i = 0; i < Dim; ++i) sum += edges.col(i).norm();
    return sum / Dim;
}

namespace {

/// The elements have straight edges, so a node that is not in the middle of its own would
/// be a strain at rest.
template <int Dim>
void require_straight(const ElasticMesh<Dim>& mesh)
{
    for (int e = 0; e < mesh.count(); ++e) {
        int i = Dim + 1;
        for (const auto& [a, b] : edges_of_element<Dim>()) {
            const Vec<Dim> p = mesh.at(mesh.node(e, a)),
                           q = mesh.at(mesh.node(e, b)),
                           off = mesh.at(mesh.node(e, i)) - (p + q) / 2;
            if (!(off.norm() <= 1e-9 * (q - p).norm()))
                throw std::invalid_argument(
                    "node " + std::to_string(mesh.node(e, i)) + " of element " +
                    std::to_string(e) + " is " + shortest(off.norm()) +
                    " m from the middle of its edge; it must be there");
            ++i;
        }
    }
}

}  // namespace

template <int Dim>
void require_valid(const ElasticMesh<Dim>& mesh)
{
    if (mesh.order != 1 && mesh.order != 2)
        throw std::invalid_argument("the order of the elements is " +
                                    std::to_string(mesh.order) +
                                    "; it must be 1 or 2");
    if (mesh.rest.size() % Dim != 0 || mesh.count() == 0 ||
        mesh.elements.size() % static_cast<std::size_t>(mesh.per_element()) != 0)
        throw std::invalid_argument(
            "a mesh has " + std::to_string(mesh.rest.size()) + " coordinates and " +
            std::to_string(mesh.elements.size()) +
            " corners of elements; it must have " + std::to_string(Dim) +
            " a node and " + std::to_string(mesh.per_element()) +
            " an element, and one element at least");
    require_finite(mesh.rest, "rest");
    std::vector<bool> used(static_cast<std::size_t>(mesh.nodes()));
    for (int e = 0; e < mesh.count(); ++e) {
        require_element(mesh, e);
        for (int i = 0; i < mesh.per_element(); ++i)
            used[static_cast<std::size_t>(mesh.node(e, i))] = true;
        Real longest = 0;
        for (const auto& [a, b] : edges_of_element<Dim>())
            longest = std::max(
                longest,
                (mesh.at(mesh.node(e, a)) - mesh.at(mesh.node(e, b))).norm());
        Real cube = 1;
        for (int i = 0; i < Dim; ++i) cube *= longest;
        const Real measure = measure_of(mesh, e);
        if (!(measure > 1e-9 * cube))
            throw std::invalid_argument(
                "element " + std::to_string(e) + " is " +
                (measure < -1e-9 * cube ? "inverted" : "flat") +
                ": its measure is " + shortest(measure) +
                " where its longest edge is " + shortest(longest) +
                " m; number its nodes counterclockwise, and move them apart");
    }
    if (mesh.order == 2) require_straight(mesh);
    const auto loose = std::find(used.begin(), used.end(), false);
    if (loose != used.end())
        throw std::invalid_argument("node " + std::to_string(loose - used.begin()) +
                                    " is loose: it must belong to an element");
}

template <int Dim>
ElasticMesh<Dim> quadratic(const ElasticMesh<Dim>& mesh)
{
    if (mesh.order != 1)
        throw std::invalid_argument(
            "the mesh is quadratic already; it must be linear");
    ElasticMesh<Dim> out;
    out.order = 2;
    std::vector<Real> rest(mesh.rest.data(), mesh.rest.data() + mesh.rest.size());
    std::map<std::array<int, 2>, int> middles;
    for (int e = 0; e < mesh.count(); ++e) {
        require_element(mesh, e);
        for (int i = 0; i <= Dim; ++i) out.elements.push_back(mesh.node(e, i));
        for (const auto& [i, j] : edges_of_element<Dim>()) {
            const int a = mesh.node(e, i), b = mesh.node(e, j);
            const auto [found, is_new] =
                middles.emplace(std::array{std::min(a, b), std::max(a, b)},
                                static_cast<int>(rest.size()) / Dim);
            if (is_new) {
                const Vec<Dim> middle = (mesh.at(a) + mesh.at(b)) / 2;
                rest.insert(rest.end(), middle.data(), middle.data() + Dim);
            }
            out.elements.push_back(found->second);
        }
    }
    out.rest = Eigen::Map<const VecX>(rest.data(), static_cast<Index>(rest.size()));
    return out;
}

template <int Dim>
ElasticMesh<Dim> joined(const ElasticMesh<Dim>& a, const ElasticMesh<Dim>& b)
{
    if (a.order != b.order)
        throw std::invalid_argument(
            "the meshes have the orders " + std::to_string(a.order) + " and " +
            std::to_string(b.order) + "; they must be the same");
    ElasticMesh<Dim> out = a;
    out.rest.resize(a.rest.size() + b.rest.size());
    out.rest << a.rest, b.rest;
    for (const int node : b.elements) out.elements.push_back(a.nodes() + node);
    return out;
}

ElasticMesh<1> bar_mesh(Real length, int elements)
{
    require_count("elements", elements);
    ElasticMesh<1> mesh;
    mesh.rest.resize(elements + 1);
    for (int i = 0; i <= elements; ++i) mesh.rest[i] = length * i / elements;
    for (int i = 0; i < elements; ++i) {
        mesh.elements.push_back(i);
        mesh.elements.push_back(i + 1);
    }
    return mesh;
}

ElasticMesh<2> rectangle_mesh(const Vec2& corner, const Vec2& size, int nx, int ny,
                              Diagonals diagonals)
{
    require_count("boxes along x", nx), require_count("boxes along y", ny);
    ElasticMesh<2> mesh;
    mesh.rest.resize(2 * (nx + 1) * (ny + 1));
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i)
            mesh.rest.segment<2>(2 * (j * (nx + 1) + i))
                << corner.x() + size.x() * i / nx,
                corner.y() + size.y() * j / ny;
    add_boxes(nx, ny, diagonals, mesh);
    return mesh;
}

ElasticMesh<2> ring_mesh(Real inner, Real outer, int nr, int na, Real grading)
{
    require_count("layers", nr), require_count("boxes around", na);
    ElasticMesh<2> mesh;
    mesh.rest.resize(2 * (nr + 1) * (na + 1));
    Real whole = 0, layer = 1;
    for (int j = 0; j < nr; ++j) whole += layer, layer *= grading;
    Real inside = 0;
    layer = 1;
    for (int j = 0; j <= nr;
         ++j) {  // the angle falls, so that boxes are not inverted
        const Real r = j == nr ? outer : inner + (outer - inner) * inside / whole;
        for (int i = 0; i <= na; ++i) {
            const Real angle = pi / 2 * (na - i) / na;
            mesh.rest.segment<2>(2 * (j * (na + 1) + i))
                << (i == 0 ? 0 : r * cos(angle)),
                (i == na ? 0 : r * sin(angle));
        }
        inside += layer, layer *= grading;
    }
    add_boxes(na, nr, Diagonals::alternate, mesh);
    return mesh;
}

ElasticMesh<2> disc_mesh(const Vec2& centre, Real radius, int rings)
{
    require_count("rings", rings);
    ElasticMesh<2> mesh;
    std::vector<Vec2> points{centre};
    for (int r = 1; r <= rings; ++r)
        for (int i = 0; i < 6 * r; ++i) {
            const Real angle = 2 * pi * i / (6 * r), at = radius * r / rings;
            points.push_back(centre + at * Vec2(cos(angle), sin(angle)));
        }
    const auto node = [](int ring, int i) {
        return ring == 0 ? 0 : 1 + 3 * ring * (ring - 1) + i % (6 * ring);
    };
    for (int r = 1; r <= rings; ++r)
        for (int sector = 0; sector < 6; ++sector)
            for (int i = 0; i < r; ++i) {
                const int outer = sector * r + i, inner = sector * (r - 1) + i;
                mesh.elements.insert(
                    mesh.elements.end(),
                    {node(r - 1, inner), node(r, outer), node(r, outer + 1)});
                if (i < r - 1)
                    mesh.elements.insert(mesh.elements.end(),
                                         {node(r - 1, inner), node(r, outer + 1),
                                          node(r - 1, inner + 1)});
            }
    mesh.rest.resize(2 * static_cast<Index>(points.size()));
    for (std::size_t i = 0; i < points.size(); ++i)
        mesh.rest.segment<2>(2 * static_cast<Index>(i)) = points[i];
    return mesh;
}

ElasticMesh<2> lattice_mesh(Real side, int columns, int rows)
{
    require_count("columns", columns, 2), require_count("rows", rows, 2);
    ElasticMesh<2> mesh;
    mesh.rest.resize(2 * columns * rows);
    const auto node = [columns](int i, int j) { return j * columns + i; };
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i)
            mesh.rest.segment<2>(2 * node(i, j)) << side * (i + (j % 2) / 2.0),
                side * j * std::sqrt(3.0) / 2;
    for (int j = 0; j + 1 < rows; ++j)
        for (int i = 0; i + 1 < columns; ++i) {
            const int a = node(i, j), b = node(i + 1, j), d = node(i, j + 1),
                      c = node(i + 1, j + 1);
            if (j % 2 == 0)
                mesh.elements.insert(mesh.elements.end(), {a, b, d, b, c, d});
            else mesh.elements.insert(mesh.elements.end(), {a, b, c, a, c, d});
        }
    return mesh;
}

ElasticMesh<3> block_mesh(const Vec<3>& corner, const Vec<3>& size, int nx, int ny,
                          int nz)
{
    const std::array<int, 3> n{nx, ny, nz};
    for (std::size_t axis = 0; axis < 3; ++axis)
        require_count(std::string("boxes along ") + "xyz"[axis], n[axis]);
    ElasticMesh<3> mesh;
    const auto node = [&n](const std::array<int, 3>& at) {
        return (at[2] * (n[1] + 1) + at[1]) * (n[0] + 1) + at[0];
    };
    mesh.rest.resize(3 * (nx + 1) * (ny + 1) * (nz + 1));
    for (int k = 0; k <= nz; ++k)
        for (int j = 0; j <= ny; ++j)
            for (int i = 0; i <= nx; ++i)
                mesh.rest.segment<3>(3 * node({i, j, k}))
                    << corner[0] + size[0] * i / nx,
                    corner[1] + size[1] * j / ny, corner[2] + size[2] * k / nz;
    // six ways from one corner of a box to the opposite one, an axis at a time
    constexpr int ways[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1},
                                {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int k = 0; k < nz; ++k)
        for (int j = 0; j < ny; ++j)
            for (int i = 0; i < nx; ++i)
                for (int w = 0; w < 6; ++w) {
                    std::array<int, 3> at{i, j, k};
                    std::array<int, 4> corners{node(at), 0, 0, 0};
                    for (std::size_t s = 0; s < 3; ++s) {
                        ++at[static_cast<std::size_t>(ways[w][s])];
                        corners[s + 1] = node(at);
                    }
                    if (w >= 3) std::swap(corners[1], corners[2]);
                    mesh.elements.insert(mesh.elements.end(), corners.begin(),
                                         corners.end());
                }
    return mesh;
}

ElasticMesh<3> ball_mesh(const Vec<3>& centre, Real radius, int finer, int shells)
{
    require_count("quarterings", finer, 0), require_count("shells", shells);
    const Real golden = (1 + std::sqrt(5.0)) / 2;
    std::vector<Vec<3>> points;  // of the icosahedron, then of its finer ones
    for (const Real a : {-1.0, 1.0})
        for (const Real b : {-golden, golden}) {
            points.emplace_back(0, a, b);
            points.emplace_back(a, b, 0);
            points.emplace_back(b, 0, a);
        }
    std::vector<std::array<int, 3>> faces;  // three corners at the distance 2
    const auto are_near = [&points](int i, int j) {
        return (points[static_cast<std::size_t>(i)] -
                points[static_cast<std::size_t>(j)])
                   .squaredNorm() < 4.1;
    };
    for (int i = 0; i < 12; ++i)
        for (int j = i + 1; j < 12; ++j)
            for (int k = j + 1; k < 12; ++k)
                if (are_near(i, j) && are_near(j, k) && are_near(i, k))
                    faces.push_back({i, j, k});
    for (int time = 0; time < finer; ++time) {
        std::map<std::array<int, 2>, int> middles;
        const auto middle = [&](int a, int b) {
            const auto [found, is_new] =
                middles.emplace(std::array{std::min(a, b), std::max(a, b)},
                                static_cast<int>(points.size()));
            if (is_new) {
                const Vec<3> sum = points[static_cast<std::size_t>(a)] +
                                   points[static_cast<std::size_t>(b)];
                points.push_back(sum);
            }
            return found->second;
        };
        std::vector<std::array<int, 3>> next;
        for (const auto& [a, b, c] : faces) {
            const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
            next.insert(next.end(),
                        {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
        faces = std::move(next);
        // a sum lies inside of the ball: the next middles are between points of its surface
        for (Vec<3>& p : points) p /= p.norm();
    }
    for (Vec<3>& p : points) p /= p.norm();
    ElasticMesh<3> mesh;
    const int each = static_cast<int>(points.size());
    mesh.rest.resize(3 * (1 + shells * each));
    mesh.rest.segment<3>(0) = centre;
    for (int s = 1; s <= shells; ++s)
        for (int i = 0; i < each; ++i)
            mesh.rest.segment<3>(3 * (1 + (s - 1) * each + i)) =
                centre + radius * s / shells * points[static_cast<std::size_t>(i)];
    const auto add = [&mesh](std::array<int, 4> corners) {
        const Vec<3> o = mesh.at(corners[0]);
        const Vec<3> a = mesh.at(corners[1]) - o, b = mesh.at(corners[2]) - o,
                     c = mesh.at(corners[3]) - o;
        if (a.cross(b).dot(c) < 0) std::swap(corners[2], corners[3]);
        mesh.elements.insert(mesh.elements.end(), corners.begin(), corners.end());
    };
    for (std::array<int, 3> face : faces) {
        // in the order of their numbers, so that neighbours cut their common side alike
        std::sort(face.begin(), face.end());
        const auto [a, b, c] = face;
        add({0, 1 + a, 1 + b, 1 + c});
        for (int s = 1; s < shells; ++s) {
            const int low = 1 + (s - 1) * each, high = low + each;
            add({low + a, low + b, low + c, high + c});
            add({low + a, low + b, high + b, high + c});
            add({low + a, high + a, high + b, high + c});
        }
    }
    return mesh;
}

std::vector<std::array<int, 3>> surface_triangles(const ElasticMesh<3>& mesh)
{
    // the corners of a face from outside, and the nodes in the middle of its sides
    constexpr int face[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
    constexpr int middle[4][4] = {
        {-1, 4, 5, 7}, {4, -1, 6, 8}, {5, 6, -1, 9}, {7, 8, 9, -1}};
    std::map<std::array<int, 3>, int> count;
    const auto key = [&mesh](int e, const int(&f)[3]) {
        std::array<int, 3> corners{mesh.node(e, f[0]), mesh.node(e, f[1]),
                                   mesh.node(e, f[2])};
        std::sort(corners.begin(), corners.end());
        return corners;
    };
    for (int e = 0; e < mesh.count(); ++e)
        for (const auto& f : face) ++count[key(e, f)];
    std::vector<std::array<int, 3>> found;
    for (int e = 0; e < mesh.count(); ++e)
        for (const auto& f : face) {
            if (count[key(e, f)] > 1) continue;
            const int a = mesh.node(e, f[0]), b = mesh.node(e, f[1]),
                      c = mesh.node(e, f[2]);
            if (mesh.order == 1) {
                found.push_back({a, b, c});
                continue;
            }
            const int ab = mesh.node(e, middle[f[0]][f[1]]),
                      bc = mesh.node(e, middle[f[1]][f[2]]),
                      ca = mesh.node(e, middle[f[2]][f[0]]);
            found.insert(found.end(),
                         {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
        }
    return found;
}

std::vector<std::array<int, 2>> outline(const ElasticMesh<2>& mesh)
{
    // the two ends of each side of an element, and the node in its middle
    std::map<std::array<int, 2>, int> sides;
    constexpr int middle[3] = {3, 5, 4};  // of (0, 1), (1, 2), (2, 0)
    for (int e = 0; e < mesh.count(); ++e)
        for (int i = 0; i < 3; ++i)
            sides[{mesh.node(e, i), mesh.node(e, (i + 1) % 3)}] =
                mesh.order == 1 ? -1 : mesh.node(e, middle[i]);
    std::vector<std::array<int, 2>> found;
    for (const auto& [side, between] : sides) {
        if (sides.contains({side[1], side[0]})) continue;
        if (between < 0) {
            found.push_back(side);
            continue;
        }
        found.push_back({side[0], between});
        found.push_back({between, side[1]});
    }
    return found;
}

template <int Dim>
std::vector<int> surface_nodes(const ElasticMesh<Dim>& mesh)
{
    std::map<std::vector<int>, int>
        faces;  // corners ascending; how many elements have it
    for (int e = 0; e < mesh.count(); ++e)
        for (int out = 0; out <= Dim; ++out) {
            std::vector<int> face;
            for (int i = 0; i <= Dim; ++i)
                if (i != out) face.push_back(mesh.node(e, i));
            std::sort(face.begin(), face.end());
            ++faces[face];
        }
    std::vector<bool> is_on(static_cast<std::size_t>(mesh.nodes()));
    for (int e = 0; e < mesh.count(); ++e)
        for (int out = 0; out <= Dim; ++out) {
            std::vector<int> face;
            for (int i = 0; i <= Dim; ++i)
                if (i != out) face.push_back(mesh.node(e, i));
            std::sort(face.begin(), face.end());
            if (faces[face] > 1) continue;
            for (const int node : face)
                is_on[static_cast<std::size_t>(node)] = true;
            if (mesh.order == 1) continue;
            int middle = Dim + 1;
            for (const auto& [a, b] : edges_of_element<Dim>()) {
                if (a != out && b != out)
                    is_on[static_cast<std::size_t>(mesh.node(e, middle))] = true;
                ++middle;
            }
        }
    std::vector<int> found;
    for (int i = 0; i < mesh.nodes(); ++i)
        if (is_on[static_cast<std::size_t>(i)]) found.push_back(i);
    return found;
}

#define RIGID_ELASTIC_MESH(D)                                                      \
    template Real measure_of(const ElasticMesh<D>&, int);                          \
    template Real edge_length(const ElasticMesh<D>&);                              \
    template void require_valid(const ElasticMesh<D>&);                            \
    template ElasticMesh<D> quadratic(const ElasticMesh<D>&);                      \
    template ElasticMesh<D> joined(const ElasticMesh<D>&, const ElasticMesh<D>&);  \
    template std::vector<int> surface_nodes(const ElasticMesh<D>&);
RIGID_ELASTIC_MESH(1)
RIGID_ELASTIC_MESH(2)
RIGID_ELASTIC_MESH(3)

}  // namespace rigid
