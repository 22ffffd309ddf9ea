/// \file cloth.hpp
/// A cloth: particles, which are `Bodies<3>`, and the rows between them.
///
///     spring    d = x_b − x_a,   C = ‖d‖ − L,   energy ½ k C²                                     (27.1)
///     bend      d = Σ wᵢ xᵢ,     energy ½ B ‖d‖²: a slope that jumps, of particles on a line
///               or about the edge of two triangles                                                (27.21)
///     hinge     C = θ − θ₀ of two triangles, energy ½ B C²                                        (27.20)
///
/// A spring and a bend are one row, C = ‖Σ wᵢ xᵢ‖ − L, with L = 0 for a bend. A particle whose 1/m is zero is pinned: it
/// moves with its velocity, whatever pulls.
#pragma once

#include "chapters/20_turning_in_space/rotation.hpp"
#include "common/bodies.hpp"

#include <array>
#include <string>
#include <vector>

namespace rigid {

//! [rows]
struct ClothSpring {
    int a = 0, b = 1;  ///< particles
    Real length = 1;   ///< L [m]
    /// k [N/m]; infinite: an inextensible thread, for methods of rows alone
    Real stiffness = 1;
};

/// A row of up to four particles that is linear in the positions.
struct ClothBend {
    std::array<int, 4> p{-1, -1, -1, -1};  ///< particles; −1: none
    std::array<Real, 4> w{};               ///< weights, of the sum 0 [1/m]
    Real stiffness = 1;                    ///< B [N m]

    int count() const { return p[3] < 0 ? 3 : 4; }
    Vec3 value(const VecX& x) const
    {
        Vec3 d(0, 0, 0);
        for (std::size_t i = 0; i < 4 && p[i] >= 0; ++i)
            d += w[i] * x.segment<3>(3 * p[i]);
        return d;
    }
};

/// The angle between two triangles: p[0], p[1] are their edge, p[2] and p[3] their
/// other corners.
struct ClothHinge {
    std::array<int, 4> p{0, 1, 2, 3};
    Real angle = 0;      ///< θ₀ [rad]
    Real stiffness = 1;  ///< B [N m]
};
//! [rows]

struct ClothScene {
    static constexpr int dof = 3;
    Bodies<3> bodies{0};  ///< the particles
    /// where they were made: what is straight there is a thread, however it lies now;
    /// of another size than the particles: where they are
    std::vector<Vec3> made_at;
    std::vector<ClothSpring> springs;
    std::vector<ClothBend> bends;
    std::vector<ClothHinge> hinges;
    std::vector<std::array<int, 3>> triangles;  ///< what the wind blows at
    Vec3 gravity = {0, -9.81, 0};               ///< [m/s²]
    Vec3 wind = {0, 0, 0};                      ///< [m/s]
    Real air =
        0;  ///< half the density of the air times the drag of a plate [kg/m³]
    Real drag =
        0;  ///< part of its velocity that a particle loses in a second [1/s]
    /// raised by tear(), and by each change of rows or masses while the cloth moves
    int changes = 0;

    int count() const { return static_cast<int>(bodies.count()); }
};

/// Throws std::invalid_argument, with a sentence that names the row or the particle, unless all numbers are finite, springs
/// have a positive length and stiffness between two particles that are there, bends and hinges likewise, and triangles have
/// an area.
void require_valid(const ClothScene& cloth);
/// The part of it that looks at rows and masses.
void require_rows(const ClothScene& cloth);
/// The part of it that may change from step to step: places, velocities, forces, gravity and air. Quick where all is well.
void require_state(const ClothScene& cloth);

/// Throws std::invalid_argument unless a value is finite and zero or positive: "WHAT is -1; it must be …".
void require_not_negative(Real value, const std::string& what);

/// Throws std::invalid_argument if a spring is inextensible: only methods of rows take those.
void require_extensible(const ClothScene& cloth);

/// The angle of a hinge, from −π to π, zero where it is flat [rad].
Real hinge_angle(const ClothHinge& hinge, const VecX& x);

/// The angle with its derivatives with respect to the four particles [1/m].
Real hinge_angle(const ClothHinge& hinge, const VecX& x, std::array<Vec3, 4>& J);

/// The weights of (27.21): the slope behind an edge less that before it.
ClothBend bend_of(const ClothHinge& hinge, const VecX& x);

/// Energy of the rows at x [J].
Real row_energy(const ClothScene& cloth, const VecX& x);
/// Kinetic energy, height and rows [J].
Real energy(const ClothScene& cloth);
/// Adds −∂E/∂x of the rows at x to f [N].
void add_row_forces(const ClothScene& cloth, const VecX& x, VecX& f);

/// The largest ‖d‖/L − 1 of all springs, or 0: a spring that is pressed together makes
/// a fold, and stretches nothing.
/// \param stiff  of those springs alone that have at least this k: threads, and not
///               the diagonals that let them shear
Real largest_stretch(const ClothScene& cloth, Real stiff = 0);
/// The mean of all, those below 0 as 0.
Real mean_stretch(const ClothScene& cloth, Real stiff = 0);

/// Momentum of the particles that can move [N s].
Vec3 momentum(const ClothScene& cloth);

/// Tears what is stretched beyond 1 + strain: the spring goes, and with it the
/// triangles and the bends that had it as an edge.
/// \return  how many springs went
int tear(ClothScene& cloth, Real strain);

}  // namespace rigid
