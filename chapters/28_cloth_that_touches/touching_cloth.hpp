/// \file touching_cloth.hpp
/// A cloth and what it may touch: solids, meshes, itself. Solids are bodies of six freedoms, `Bodies<6>`.
#pragma once

#include "chapters/20_turning_in_space/space_bodies.hpp"
#include "chapters/25_world_in_space/triangle_mesh.hpp"
#include "chapters/27_particles_and_cloth/cloth.hpp"

#include <memory>

namespace rigid {

/// What a particle touches. Lengths are in the axes of the body that it belongs to.
struct ClothSolid {
    enum class Shape : unsigned char { wall, ball, capsule, box, mesh };
    Shape shape = Shape::ball;
    Vec3 half = {
        0, 0,
        0};  ///< of a box: half its edges; of a capsule: (0, half its straight part, 0) [m]
    Real radius =
        0;  ///< of a ball, of a capsule, of the rounded edges of a box [m]
    Real friction = 0;  ///< μ
    /// of a mesh: its triangles have one side, to which particles are pushed
    std::shared_ptr<const TriangleMesh> mesh = nullptr;

    bool operator==(const ClothSolid&) const = default;
};

/// A particle that is tied to a point of a solid.
struct ClothTie {
    int particle = 0, solid = 0;
    Vec3 at = {0, 0, 0};  ///< in the solid's axes, from its centre [m]

    bool operator==(const ClothTie&) const = default;
};

struct TouchingCloth : ClothScene {
    Bodies<6> solids{0};             ///< 1/m zero: moves as its velocity says
    std::vector<ClothSolid> shapes;  ///< of the solids, one each
    std::vector<ClothTie> ties;      ///< each particle in one at most
    Real thickness = 0;  ///< how far particles stay away from solids [m]
    /// how far triangles and edges stay away from each other [m]; 0: they pass
    Real self_thickness = 0;
    Real self_friction = 0;  ///< μ of cloth on itself
};

/// Throws std::invalid_argument as that of a cloth does, and unless there is a shape for each solid and a particle
/// of its own and a solid for each tie, thicknesses and frictions are finite and not negative, and twice the thickness against itself is at most the length of each spring.
void require_valid(const TouchingCloth& cloth);
/// The part of it that chapter 27 does not check.
void require_touchable(const TouchingCloth& cloth);

/// Kinetic energy, height and rows, of cloth and solids [J].
Real energy(const TouchingCloth& cloth);
/// Momentum of particles and solids that can move [N s].
Vec3 momentum(const TouchingCloth& cloth);

/// A solid that the cloth may touch; mass zero: it cannot move but by its velocity.
/// \param shape  its `half` as in ClothSolid
/// \throws std::invalid_argument  for a mass that it cannot have, and leaves the cloth as it was
int add_solid(TouchingCloth& cloth, const ClothSolid& shape, Real mass,
              const Vec3& at, const Vec3& theta = {0, 0, 0});

/// Ties a particle to a solid at the place where it is. Throws std::invalid_argument unless both are there, and for a particle that is tied.
void tie(TouchingCloth& cloth, int particle, int solid);

}  // namespace rigid
