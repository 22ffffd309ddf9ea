/// \file cloth_builders.hpp
/// Ropes and sheets of particles.
#pragma once

#include "chapters/27_particles_and_cloth/cloth.hpp"

namespace rigid {

/// A particle at rest. \param mass  [kg]; zero: pinned
int add_particle(ClothScene& cloth, const Vec3& at, Real mass);

inline void pin(ClothScene& cloth, int particle)
{
    cloth.bodies.inverse_mass.segment<3>(3 * particle).setZero();
}

//! [rope]
struct RopeSpec {
    int segments = 10;
    Real mass =
        1;  ///< of all particles together, each its share; those at the ends half [kg]
    Real stiffness =
        1e4;  ///< EA of the rope [N]: k = EA/L of each segment; infinite: inextensible
    Real bending = 0;  ///< EI [N m²]; 0: no bends
};
//! [rope]

/// Particles in a row from one point to the other, with springs and bends.
/// \return  the number of the first; the others follow it
int add_rope(ClothScene& cloth, const Vec3& from, const Vec3& to,
             const RopeSpec& spec);

//! [sheet]
enum class Bending : unsigned char { none, quadratic, angle, edges };

struct SheetSpec {
    int columns = 10, rows = 10;  ///< of squares
    Real spacing = 0.1;           ///< side of a square [m]
    Real density = 0.2;           ///< [kg/m²]
    Real stiffness = 1e3;         ///< of each spring along a side [N/m]
    Real shear = 100;             ///< of each along a diagonal [N/m]
    Real bending = 0;             ///< B [N m]
    /// quadratic: along both sides of the squares, and their twist, (27.22); angle:
    /// about each inner edge of the triangles; edges: the jump of slope there, (27.21)
    Bending how = Bending::quadratic;
    /// diagonals rise and fall in turn; false: all rise, and one direction is stiffer
    bool alternate = true;
};
//! [sheet]

/// A square of so many squares a side, its diagonals a hundredth as stiff. \param side  [m]
SheetSpec square_sheet(int squares, Real side, Real stiffness, Real bending);

/// Squares with a diagonal each, from a corner along two directions (of length one):
/// particle i + (columns + 1) j lies i squares along the first and j along the second.
/// Every edge is a spring.
/// \return  the number of the first particle
int add_sheet(ClothScene& cloth, const Vec3& corner, const Vec3& first,
              const Vec3& second, const SheetSpec& spec);

}  // namespace rigid
