/// \file solid_scene.hpp
/// A scene in space: bodies, and the solids that each is made of. y is up. Later chapters add what joins them and what they
/// stand on.
#pragma once

#include "chapters/20_turning_in_space/inertia.hpp"
#include "chapters/20_turning_in_space/space_bodies.hpp"
#include "common/contact.hpp"
#include "common/typical_length.hpp"

#include <array>
#include <vector>

namespace rigid {

//! [grip]
/// What two surfaces hold each other with, each of it up to this times λ_n
/// (chapter 24).
struct Grip {
    Real friction = 0;  ///< μ: against sliding
    Real rolling = 0;   ///< arm of the moment against rolling [m]
    Real spinning = 0;  ///< arm of the moment against spinning about the normal [m]
};
//! [grip]

//! [contact]
/// What a step's contacts are in space: a point of either body where they touch, or
/// nearly; of their cores, so that the surfaces are a radius away from it (chapter 23).
struct SpaceContact {
    Index a = world, b = 0;   ///< the bodies; a wall of the world is always a
    Index feature = 0;        ///< which of several contacts of this pair
    Vec3 normal = {0, 1, 0};  ///< unit vector from a to b
    Vec3 at_a = {0, 0, 0}, at_b = {0, 0, 0};  ///< in either body's axes
    Real radius_a = 0, radius_b = 0;          ///< [m]
    Grip grip;                                ///< of the two surfaces
};
template <>
struct ContactOf<6> {
    using Type = SpaceContact;
};
//! [contact]

struct SolidScene {
    static constexpr int dof = 6;
    Bodies<6> bodies{0};
    /// the hulls that each body is made of, in its principal axes
    std::vector<std::vector<Hull>> shapes;
    Vec3 gravity = {0, -9.81, 0};  ///< [m/s²]
    /// the length that settings are measured in [m]; 0 = typical_length()
    Real length = 0;

    /// The body that shape k is of: all hulls of a body have its number.
    Index carrier(Index k) const { return k; }
};

/// From the centroid of a body to the farthest point of its hulls [m].
Real reach_of(const std::vector<Hull>& shape);

/// ℓ, as in the plane (chapter 11).
inline Real typical_length(const SolidScene& scene)
{
    return typical_length(scene.bodies, scene.length, [&scene](Index k) {
        return reach_of(scene.shapes[static_cast<std::size_t>(k)]);
    });
}

/// Adds a body. Its shape is moved and turned into its centroid and its principal
/// axes, its rotation so that it lies as it was given.
/// \param solid  mass, centroid and inertia in the axes of the shape; the mass zero
///               makes a body that cannot move
/// \param at     where the origin of the shape's axes comes to lie [m]
/// \param theta  rotation vector of the shape's axes
/// \return       its number
/// Throws std::invalid_argument for a mass or an inertia that no body has.
Index add_body(SolidScene& scene, std::vector<Hull> shape, const SolidMass& solid,
               const Vec3& at, const Vec3& theta = {0, 0, 0});

/// Throws std::invalid_argument unless a number that a scene is made of is positive and
/// finite.
void require_positive(const char* what, Real value);

/// Adds a uniform body of the given density [kg/m³].
inline Index add_body(SolidScene& scene, const std::vector<Hull>& shape,
                      Real density, const Vec3& at, const Vec3& theta = {0, 0, 0})
{
    return add_body(scene, shape, mass_of(shape, density), at, theta);
}

/// Kinetic and potential energy of the bodies that can move [J].
Real energy(const SolidScene& scene);

}  // namespace rigid
