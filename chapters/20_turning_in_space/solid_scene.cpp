// The functions of solid_scene.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/20_turning_in_space/solid_scene.hpp"

namespace rigid {

Real reach_of(const std::vector<Hull>& shape)
{
    Real farthest = 0;
    for (const Hull& hull : shape)
        for (const Vec3& vertex : hull.vertices)
            farthest = std::max(farthest, vertex.norm() + hull.radius);
    return farthest;
}

//! [add_body]
Index add_body(SolidScene& scene, std::vector<Hull> shape, const SolidMass& solid,
               const Vec3& at, const Vec3& theta)
{
    if (!(solid.mass >= 0) || !std::isfinite(solid.mass))
        throw std::invalid_argument(
            "a body has the mass " + shortest(solid.mass) +
            " kg; it must be positive, or zero (it cannot move)");
    if (!at.allFinite() || !theta.allFinite() || !solid.centroid.allFinite())
        throw std::invalid_argument("a body has a position, a rotation or a "
                                    "centroid that is not finite");
    const bool moves = solid.mass > 0;
    PrincipalAxes principal;
    if (moves) {
        const Mat3& I = solid.inertia;  // whose diagonal require_moments() sees
        const Real most = I.cwiseAbs().maxCoeff();
        if (!I.allFinite() ||
            (I - I.transpose()).cwiseAbs().maxCoeff() > 1e-9 * most)
            throw std::invalid_argument(
                "a body has an inertia that is not symmetric or not finite");
        principal = principal_axes(solid.inertia);
        require_moments(principal.moments);
    }
    for (Hull& hull : shape)
        for (Vec3& vertex : hull.vertices)
            vertex = principal.axes.transpose() * (vertex - solid.centroid);
    const Index k = scene.bodies.count();
    scene.bodies.resize(k + 1);
    scene.bodies.position(k) << at + rotation_matrix(theta) * solid.centroid,
        add_rotation(theta, rotation_vector(principal.axes));
    auto inverse = scene.bodies.inverse_mass.segment<6>(6 * k);
    inverse.setZero();
    if (moves) {
        inverse.head<3>().setConstant(1 / solid.mass);
        inverse.tail<3>() = principal.moments.cwiseInverse();
    }
    scene.shapes.push_back(std::move(shape));
    return k;
}
//! [add_body]

void require_positive(const char* what, Real value)
{
    if (!(value > 0) || !std::isfinite(value))
        throw std::invalid_argument(std::string(what) + " is " + shortest(value) +
                                    "; it must be positive and finite");
}

Real energy(const SolidScene& scene)
{
    Real sum = kinetic_energy(scene.bodies);
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if (scene.bodies.inverse_mass[6 * k] > 0)  // it may turn about a point
            sum -= scene.gravity.dot(centre_of(scene.bodies.x, k)) /
                   scene.bodies.inverse_mass[6 * k];
    return sum;
}

}  // namespace rigid
