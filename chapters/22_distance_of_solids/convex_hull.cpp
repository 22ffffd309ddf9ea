// The functions of convex_hull.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/22_distance_of_solids/convex_hull.hpp"
#include "chapters/22_distance_of_solids/gjk.hpp"

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
/// The planes through three points that have no point on one side, in which what is
/// nearer than `flat` lies; without faces, if that is all of them.
static Hull hull_of(const std::vector<Vec3>& points, Real size, Real flat)
{
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
                if (low >= -flat && high <= flat) return {};
                if (high > flat) n = -n;
                if (std::find(found.begin(), found.end(), face) != found.end())
                    continue;
                faces.push_back(around(points, face, n, flat));
                found.push_back(std::move(face));
            }
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

static bool is_solid(const Hull& hull)
{
    try {
        return form_of(hull).hull.faces.size() >= 4;
    } catch (const std::invalid_argument&) {
        return false;
    }
}

/// Leaves out each point that is within `near` of the hull of the others.
static void keep_corners(std::vector<Vec3>& points, Real near)
{
    PlacedSolid point, others;
    for (std::size_t i = points.size(); i-- > 0 && points.size() > 1;) {
        point.vertices = {points[i]};
        others.vertices = points;
        others.vertices.erase(others.vertices.begin() + static_cast<Index>(i));
        if (nearest_points(point, others).distance <= near)
            points = others.vertices;
    }
}

Hull solid_hull(const std::vector<Vec3>& given)
{
    Real size = 0;
    for (const Vec3& p : given) {
        if (!p.allFinite())
            throw std::invalid_argument("a point of a hull is not finite");
        size = std::max(size, (p - given[0]).norm());
    }
    Real flat = 1e-10 * size;  // a hundred thousand roundings
    std::vector<Vec3> points;  // of several in one place the first
    for (const Vec3& p : given)
        if (std::none_of(points.begin(), points.end(),
                         [&](const Vec3& q) { return (p - q).norm() <= 4 * flat; }))
            points.push_back(p);
    if (points.size() < 4)
        throw std::invalid_argument("a hull has " + std::to_string(points.size()) +
                                    " points in different places; it needs at "
                                    "least four");
    if (!(size >= 1e-65 && size <= largest_number))
        throw std::invalid_argument("the points of a hull are " + shortest(size) +
                                    " m apart; it must be from 1e-65 to 1e75 m");
    Hull hull = hull_of(points, size, flat);
    if (hull.faces.empty())
        throw std::invalid_argument("the points of a hull lie in a plane");
    if (is_solid(hull)) return hull;
    // Points that are d off the line of two others tell a plane to 2e-16 size²/d, and
    // whether a fourth lies in it: for less than `flat`, d = 1e-5 size
    const Real near = 1e-5 * size;
    keep_corners(points, near);
    const bool thin = hull_of(points, size, near).faces.empty();
    // a point that lies about `flat` beside a plane lies farther than a tenth of it
    for (int tries = 0; !thin && tries < 5; ++tries, flat /= 10) {
        hull = hull_of(points, size, flat);
        if (is_solid(hull)) return hull;
    }
    throw std::invalid_argument(
        thin ? "the points of a hull lie within 1e-5 of their spread of a plane, "
               "and do not tell its sides apart"
             : "the points of a hull make no faces that close");
}

}  // namespace rigid
