// The functions of convex_hull.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/22_distance_of_solids/convex_hull.hpp"

namespace rigid {

std::vector<int> around(const std::vector<Vec3>& points, std::vector<int> face,
                        const Vec3& n, Real flat)
{
    // start at the corner that is farthest from the first: it is one for certain
    int start = face[0];
    const auto at = [&points](int i) -> const Vec3& {
        return points[static_cast<std::size_t>(i)];
    };
    for (const int i : face)
        if ((at(i) - at(face[0])).norm() > (at(start) - at(face[0])).norm())
            start = i;
    // wrap a string around them: the next has all others to its left
    std::vector<int> loop;
    for (int here = start; loop.size() <= face.size();) {
        loop.push_back(here);
        int next = -1;
        for (const int i : face) {
            if (i == here) continue;
            if (next < 0) {
                next = i;
                continue;
            }
            const Vec3 way = at(next) - at(here), other = at(i) - at(here);
            const Real left = n.dot(cross(way, other));
            if (left < -flat * way.norm() ||
                (left <= flat * way.norm() && other.norm() > way.norm()))
                next = i;
        }
        here = next;
        if (here == start) break;
    }
    return loop;
}

//! [hull]
Hull solid_hull(const std::vector<Vec3>& given)
{
    Real size = 0;
    for (const Vec3& p : given) {
        if (!p.allFinite())
            throw std::invalid_argument("a point of a hull is not finite");
        size = std::max(size, (p - given[0]).norm());
    }
    const Real flat = 1e-10 * size;  // a hundred thousand roundings
    std::vector<Vec3> points;        // of several in one place the first
    for (const Vec3& p : given)
        if (std::none_of(points.begin(), points.end(),
                         [&](const Vec3& q) { return (p - q).norm() <= 4 * flat; }))
            points.push_back(p);
    const int count = static_cast<int>(points.size());
    const auto at = [&points](int i) -> const Vec3& {
        return points[static_cast<std::size_t>(i)];
    };
    std::vector<std::vector<int>> faces, found;
    for (int i = 0; i < count; ++i)
        for (int j = i + 1; j < count; ++j)
            for (int k = j + 1; k < count; ++k) {
                const Vec3 area = cross(at(j) - at(i), at(k) - at(i));
                if (!(area.norm() > flat * size)) continue;  // on one line
                Vec3 n = area.normalized();
                Real low = 0, high = 0;
                std::vector<int> face;
                for (int l = 0; l < count; ++l) {
                    const Real out = n.dot(at(l) - at(i));
                    low = std::min(low, out), high = std::max(high, out);
                    if (std::abs(out) <= flat) face.push_back(l);
                }
                if (low < -flat && high > flat) continue;  // points on both sides
                if (low >= -flat && high <= flat)
                    throw std::invalid_argument(
                        "the points of a hull lie in a plane");
                if (high > flat) n = -n;
                if (std::find(found.begin(), found.end(), face) != found.end())
                    continue;
                faces.push_back(around(points, face, n, flat));
                found.push_back(std::move(face));
            }
    if (faces.size() < 4)
        throw std::invalid_argument("a hull of " + std::to_string(count) +
                                    " points has " + std::to_string(faces.size()) +
                                    " faces; it needs at least four");
    // points inside the hull are left out
    Hull hull;
    std::vector<int> number(points.size(), -1);
    for (std::vector<int>& face : faces)
        for (int& i : face) {
            int& mine = number[static_cast<std::size_t>(i)];
            if (mine < 0) {
                mine = static_cast<int>(hull.vertices.size());
                hull.vertices.push_back(at(i));
            }
            i = mine;
        }
    hull.faces = std::move(faces);
    return hull;
}
//! [hull]

}  // namespace rigid
