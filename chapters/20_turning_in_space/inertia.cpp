// The functions of inertia.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/20_turning_in_space/inertia.hpp"

namespace rigid {

Hull solid_box(const Vec3& size, const Vec3& at)
{
    Hull hull;
    for (int i = 0; i < 8; ++i)
        hull.vertices.push_back(at + Vec3((i & 1 ? 0.5 : -0.5) * size.x(),
                                          (i & 2 ? 0.5 : -0.5) * size.y(),
                                          (i & 4 ? 0.5 : -0.5) * size.z()));
    hull.faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                  {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    return hull;
}

SolidMass round_mass(const Hull& hull)
{
    const Real r = hull.radius, r2 = r * r;
    const bool long_one = hull.vertices.size() == 2;
    const Vec3 along = hull.vertices.back() - hull.vertices.front();
    const Real l = along.norm();
    const Real balls = 4 * pi / 3 * r2 * r, cylinder = pi * r2 * l;
    // second moments along the axis and across it; the balls' halves are shifted
    const Real across = cylinder * r2 / 4 + balls * r2 / 5;
    const Real lengthwise =
        cylinder * l * l / 12 + balls * (r2 / 5 + 3 * r * l / 8 + l * l / 4);
    SolidMass solid;
    solid.mass = balls + cylinder;
    solid.centroid = (hull.vertices.front() + hull.vertices.back()) / 2;
    Mat3 S = across * Mat3::Identity();
    if (long_one && l > 0)
        S += (lengthwise - across) / (l * l) * (along * along.transpose());
    solid.inertia = inertia_of(S);
    return solid;
}

void require_vertices(const Hull& hull)
{
    const auto count = static_cast<int>(hull.vertices.size());
    for (const std::vector<int>& face : hull.faces)
        for (const int i : face)
            if (i < 0 || i >= count)
                throw std::invalid_argument("a face names vertex " +
                                            std::to_string(i) + " among " +
                                            std::to_string(count));
}

/// The areas of the faces, as vectors, add up to none. Otherwise what moments_of() sums
/// depends on where the origin is.
static void require_closed(const Hull& hull)
{
    Vec3 sum(0, 0, 0);
    Real all = 0;
    for (const std::vector<int>& face : hull.faces)
        for (std::size_t i = 1; i + 1 < face.size(); ++i) {
            const auto corner = [&](std::size_t k) -> const Vec3& {
                return hull.vertices[static_cast<std::size_t>(face[k])];
            };
            const Vec3 area =
                cross(corner(i) - corner(0), corner(i + 1) - corner(0));
            sum += area, all += area.norm();
        }
    if (sum.norm() > 1e-9 * all)  // far above rounding
        throw std::invalid_argument(
            "the faces of a body do not close: their areas add up to " +
            shortest(sum.norm() / 2) + " m², along one direction");
}

/// Whether the origin is so far away that (20.15) cancels: at the distance d its terms
/// have the roundings of d⁵, and their sum is like V s² of a solid of the size s. A
/// billion times that leaves seven digits.
static bool is_far(const Hull& hull, Real volume)
{
    const Vec3& first = hull.vertices[0];
    Real size = 0;
    for (const Vec3& p : hull.vertices) size = std::max(size, (p - first).norm());
    const Real d = first.norm(), times = d / size;
    return times * times * d * d * d > 1e9 * volume;
}

//! [mass]
SolidMass mass_of(const Hull& hull, Real density)
{
    const auto refuse = [](const std::string& what, Real value,
                           const std::string& right) {
        throw std::invalid_argument(what + " " + shortest(value) + "; it must be " +
                                    right);
    };
    if (!(density > 0) || !std::isfinite(density))
        refuse("the density in kg/m³ is", density, "positive and finite");
    if (hull.vertices.empty())
        throw std::invalid_argument("the body has no vertices");
    SolidMass solid;
    if (hull.vertices.size() <= 2) {
        if (!(hull.radius >= 0))
            refuse("the radius in m of a body is", hull.radius, "zero or positive");
        solid = round_mass(hull);
    } else {
        if (hull.radius != 0)
            refuse("the radius in m of a polyhedron is", hull.radius,
                   "0 for its mass to be known");
        require_vertices(hull);
        require_closed(hull);
        const Moments all = moments_of(hull);
        if (is_far(hull, all.volume)) {  // its moments are taken from a corner
            Hull near = hull;
            for (Vec3& p : near.vertices) p -= hull.vertices[0];
            SolidMass moved = mass_of(near, density);
            moved.centroid += hull.vertices[0];
            return moved;
        }
        solid.mass = all.volume;
        solid.centroid = all.first / all.volume;
        solid.inertia = inertia_of(all.second - all.volume * solid.centroid *
                                                    solid.centroid.transpose());
    }
    if (!(solid.mass > 0) || !std::isfinite(solid.mass))
        refuse("the volume of the body in m³ is", solid.mass,
               "positive: a radius, or faces counterclockwise from outside");
    solid.mass *= density;
    solid.inertia *= density;
    return solid;
}

SolidMass mass_of(const std::vector<Hull>& hulls, Real density)
{
    if (hulls.empty()) throw std::invalid_argument("the body has no hulls");
    SolidMass all;
    for (const Hull& hull : hulls) {
        const SolidMass part = mass_of(hull, density);
        all.mass += part.mass;
        all.centroid += part.mass * part.centroid;
    }
    all.centroid /= all.mass;
    for (const Hull& hull : hulls) {
        const SolidMass part = mass_of(hull, density);
        const Vec3 c = part.centroid - all.centroid;
        all.inertia += part.inertia + inertia_of(part.mass * c * c.transpose());
    }
    return all;
}
//! [mass]

void require_moments(const Vec3& moments)
{
    const Real sum = moments.sum(), largest = moments.maxCoeff();
    if (!moments.allFinite() || !(moments.minCoeff() > 0) ||
        !(2 * largest <= sum * (1 + 1e-9)))
        throw std::invalid_argument(
            "a body has the principal moments of inertia " + shortest(moments[0]) +
            ", " + shortest(moments[1]) + ", " + shortest(moments[2]) +
            " kg m²; they must be positive, and none larger than the sum of the "
            "other two");
}

}  // namespace rigid
