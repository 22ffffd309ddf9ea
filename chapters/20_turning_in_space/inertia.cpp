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
    if (hull.vertices.size() <= 2) solid = round_mass(hull);
    else {
        if (hull.radius != 0)
            refuse("the radius in m of a polyhedron is", hull.radius,
                   "0 for its mass to be known");
        const Moments all = moments_of(hull);
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
