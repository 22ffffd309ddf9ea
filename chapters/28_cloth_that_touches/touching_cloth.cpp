// The functions of touching_cloth.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/28_cloth_that_touches/touching_cloth.hpp"

#include "chapters/20_turning_in_space/inertia.hpp"

namespace rigid {

namespace touching_checks {

void require_there(const TouchingCloth& cloth, int particle, int solid,
                   const std::string& who)
{
    if (particle < 0 || particle >= cloth.count() || solid < 0 ||
        solid >= cloth.solids.count())
        throw std::invalid_argument(
            who + " is of particle " + std::to_string(particle) + " and solid " +
            std::to_string(solid) + "; there are " + std::to_string(cloth.count()) +
            " and " + std::to_string(cloth.solids.count()));
}

/// \param before  so many ties are looked at
void require_untied(const TouchingCloth& cloth, int particle, std::size_t before,
                    const std::string& who)
{
    for (std::size_t i = 0; i < before; ++i)
        if (cloth.ties[i].particle == particle)
            throw std::invalid_argument(
                who + " is of particle " + std::to_string(particle) +
                ", which tie " + std::to_string(i) + " has; a particle has one");
}

/// A ball has no edges, and a capsule a straight part along y alone.
void require_shape(const ClothSolid& s, const std::string& who)
{
    using Shape = ClothSolid::Shape;
    require_not_negative(s.friction, "the friction of " + who);
    require_not_negative(s.radius, "the radius of " + who);
    for (int i = 0; i < 3; ++i) {
        require_not_negative(s.half[i], "half the size of " + who);
        if (s.half[i] > 0 &&
            (s.shape == Shape::ball || (s.shape == Shape::capsule && i != 1)))
            throw std::invalid_argument(
                who + " has half a size of " + shortest(s.half[i]) + " m along " +
                "xyz"[i] +
                "; that of a ball is zero, and of a capsule but along y");
    }
    if ((s.shape == Shape::mesh) != (s.mesh != nullptr))
        throw std::invalid_argument(
            who + (s.shape == Shape::mesh
                       ? " is a mesh without triangles; it needs a mesh"
                       : " is no mesh; it must not have one"));
}

}  // namespace touching_checks

using namespace touching_checks;

void require_valid(const TouchingCloth& cloth)
{
    require_valid(static_cast<const ClothScene&>(cloth));
    require_touchable(cloth);
}

void require_touchable(const TouchingCloth& cloth)
{
    require_valid(cloth.solids);
    if (cloth.shapes.size() != static_cast<std::size_t>(cloth.solids.count()))
        throw std::invalid_argument(
            "there are " + std::to_string(cloth.shapes.size()) + " shapes for " +
            std::to_string(cloth.solids.count()) + " solids; each needs one");
    for (std::size_t i = 0; i < cloth.shapes.size(); ++i) {
        const std::string who = "solid " + std::to_string(i);
        require_shape(cloth.shapes[i], who);
        const auto w =
            cloth.solids.inverse_mass.segment<6>(6 * static_cast<Index>(i));
        if (w[1] != w[0] || w[2] != w[0] ||
            (w[0] == 0 && w.tail<3>().maxCoeff() > 0))
            throw std::invalid_argument(
                who + " has the inverse masses " + shortest(w[0]) + ", " +
                shortest(w[1]) + " and " + shortest(w[2]) +
                " 1/kg; the three must be the same, and not zero if it turns");
    }
    for (std::size_t i = 0; i < cloth.ties.size(); ++i) {
        const ClothTie& t = cloth.ties[i];
        const std::string who = "tie " + std::to_string(i);
        require_there(cloth, t.particle, t.solid, who);
        require_untied(cloth, t.particle, i, who);
        if (!t.at.allFinite())
            throw std::invalid_argument("the place of " + who + " is not finite");
    }
    require_not_negative(cloth.thickness, "the thickness of the cloth");
    require_not_negative(cloth.self_friction,
                         "the friction of the cloth on itself");
    require_not_negative(cloth.self_thickness,
                         "the thickness of the cloth against itself");
    for (std::size_t i = 0; i < cloth.springs.size(); ++i)
        if (!(2 * cloth.self_thickness <= cloth.springs[i].length))
            throw std::invalid_argument(
                "the thickness of the cloth against itself is " +
                shortest(cloth.self_thickness) + " m, and the length of spring " +
                std::to_string(i) + " " + shortest(cloth.springs[i].length) +
                " m; it must be at most half of that");
}

Real energy(const TouchingCloth& cloth)
{
    Real sum = energy(static_cast<const ClothScene&>(cloth));
    for (Index k = 0; k < cloth.solids.count(); ++k)
        if (const Real w = cloth.solids.inverse_mass[6 * k]; w > 0)
            sum -= cloth.gravity.dot(centre_of(cloth.solids.x, k)) / w;
    return sum + kinetic_energy(cloth.solids);
}

Vec3 momentum(const TouchingCloth& cloth)
{
    return momenta(cloth.solids).head<3>() +
           momentum(static_cast<const ClothScene&>(cloth));
}

int add_solid(TouchingCloth& cloth, const ClothSolid& shape, Real mass,
              const Vec3& at, const Vec3& theta)
{
    require_not_negative(mass, "the mass of a solid");
    Vec<6> inverse = Vec<6>::Zero();
    if (mass > 0) {
        if (shape.shape == ClothSolid::Shape::wall ||
            shape.shape == ClothSolid::Shape::mesh)
            throw std::invalid_argument(
                "the mass of a solid is " + shortest(mass) +
                " kg; a ball, a capsule or a box may have a positive one, and what "
                "cannot move zero");
        // of a box with its rounded edges, as if they were sharp
        const Hull hull =
            shape.shape == ClothSolid::Shape::box
                ? solid_box(2 * (shape.half + Vec3::Constant(shape.radius)))
            : shape.shape == ClothSolid::Shape::ball
                ? solid_ball(shape.radius)
                : Hull{{-shape.half, shape.half}, {}, shape.radius};
        const SolidMass solid = mass_of(hull, 1);
        const Vec3 I = mass / solid.mass * solid.inertia.diagonal();
        inverse << Vec3::Constant(1 / mass), I.cwiseInverse();
    }
    const Index k = cloth.solids.count();
    cloth.solids.resize(k + 1);
    cloth.solids.position(k) << at, theta;
    cloth.solids.inverse_mass.segment<6>(6 * k) = inverse;
    cloth.shapes.push_back(shape);
    return static_cast<int>(k);
}

void tie(TouchingCloth& cloth, int particle, int solid)
{
    require_there(cloth, particle, solid, "a tie");
    require_untied(cloth, particle, cloth.ties.size(), "a tie");
    const Mat3 axes = rotation_of(cloth.solids.x, solid);
    cloth.ties.push_back({particle, solid,
                          axes.transpose() * (cloth.bodies.position(particle) -
                                              centre_of(cloth.solids.x, solid))});
}

}  // namespace rigid
