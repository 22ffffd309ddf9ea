/// \file space_scene.hpp
/// A scene in space: bodies, the solids that each is made of, what joins them, and what they stand on. y is up.
#pragma once

#include "chapters/25_space/inertia.hpp"
#include "chapters/25_space/space_bodies.hpp"
#include "chapters/25_space/triangle_mesh.hpp"
#include "common/contact.hpp"
#include "common/typical_length.hpp"

#include <array>
#include <vector>

namespace rigid {

/// What a joint measures, in the axes of its frame in body a: the way from its point in a to its point in b, and the
/// rotation q from a's frame to b's.
enum Coordinate : int {
    along_x,  ///< [m]
    along_y,
    along_z,
    twist,    ///< about x, 2 atan2(q_x, q_w) [rad]
    swing_y,  ///< 2 q_y, for small angles the angle about y
    swing_z,  ///< 2 q_z
    cone,     ///< the angle between both x axes [rad]
    pins,     ///< z_A · y_B, the sine of the angle between them less 90°
    coordinates
};

//! [joint]
/// A joint in its own coordinates: a frame in either body, and of each coordinate
/// the least and the greatest value. Both the same: it is locked. Infinite: free.
struct SpaceJoint {
    Index a = world, b = 0;
    /// the joint's point in either body's axes; of the world: in its
    Vec3 at_a = {0, 0, 0}, at_b = {0, 0, 0};
    /// rotation vectors: from the joint's axes to those of the body
    Vec3 frame_a = {0, 0, 0}, frame_b = {0, 0, 0};
    std::array<Real, coordinates> lo, hi;
    int motor = -1;             ///< the coordinate that a motor drives; −1: none
    Real speed = 0, force = 0;  ///< of the motor [m/s, N], or [rad/s, N m]

    SpaceJoint() { lo.fill(-infinity), hi.fill(infinity); }
    void lock(std::initializer_list<Coordinate> which)
    {
        for (const Coordinate c : which) {
            const auto i = static_cast<std::size_t>(c);
            lo[i] = hi[i] = 0;
        }
    }
    bool locked(int c) const
    {
        return lo[static_cast<std::size_t>(c)] == hi[static_cast<std::size_t>(c)];
    }
};
//! [joint]

/// The points p with normal·p ≥ offset are free, the others are wall.
struct SolidWall {
    Vec3 normal = {0, 1, 0};  ///< unit vector, out of the wall
    Real offset = 0;          ///< [m]
};

//! [ellipsoid]
/// A smooth solid that touches walls, and nothing else: all at + S n with ‖n‖ ≤ 1.
struct SolidEllipsoid {
    Index body = 0;
    Vec3 at = {0, 0, 0};              ///< its centre, in the body's axes [m]
    Mat3 stretch = Mat3::Identity();  ///< S, in the body's axes [m]
};
//! [ellipsoid]

//! [grip]
/// What two surfaces hold each other with, each of it up to this times λ_n.
struct Grip {
    Real friction = 0;  ///< μ: against sliding
    Real rolling = 0;   ///< arm of the moment against rolling [m]
    Real spinning = 0;  ///< arm of the moment against spinning about the normal [m]
};
//! [grip]

//! [contact]
/// A point of either body where they touch, or nearly: of their cores, so that the
/// surfaces are a radius away from it.
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

struct SpaceScene {
    static constexpr int dof = 6;
    Bodies<6> bodies{0};
    /// the hulls that each body is made of, in its principal axes
    std::vector<std::vector<Hull>> shapes;
    std::vector<SpaceJoint> joints;
    std::vector<SolidWall> walls;
    std::vector<std::shared_ptr<const TriangleMesh>> meshes;
    std::vector<SolidEllipsoid> ellipsoids;
    /// μ of each body, wall and mesh; empty: nothing there has friction
    std::vector<Real> friction, wall_friction, mesh_friction;
    /// arms of rolling and spinning friction of each body [m]; empty: none has any
    std::vector<Real> rolling, spinning;
    Vec3 gravity = {0, -9.81, 0};  ///< [m/s²]
    /// the length that settings are measured in [m]; 0 = typical_length()
    Real length = 0;
};

/// Throws std::invalid_argument unless each mesh is one, and no ellipsoid could fall through it.
void require_meshes(const SpaceScene& scene);

/// From the centroid of a body to the farthest point of its hulls [m].
Real reach_of(const std::vector<Hull>& shape);

/// ℓ, as in the plane (chapter 11).
inline Real typical_length(const SpaceScene& scene)
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
Index add_body(SpaceScene& scene, std::vector<Hull> shape, const SolidMass& solid,
               const Vec3& at, const Vec3& theta = {0, 0, 0});

/// Adds a uniform body of the given density [kg/m³].
inline Index add_body(SpaceScene& scene, const std::vector<Hull>& shape,
                      Real density, const Vec3& at, const Vec3& theta = {0, 0, 0})
{
    return add_body(scene, shape, mass_of(shape, density), at, theta);
}

/// Kinetic and potential energy of the bodies that can move [J].
Real energy(const SpaceScene& scene);

}  // namespace rigid
