/// \file constraint_kinds.hpp
/// What geometry gives for a constraint at the present positions: C, its derivative J, and of which kind it is.
///
/// All later code uses the kind, never a row's place in a list.
#pragma once

#include "common/bodies.hpp"

namespace rigid {

/// What the impulse of a constraint may do, and whether C is an error to be corrected.
enum class ConstraintKind : unsigned char {
    bilateral,   ///< pushes and pulls: C = 0, and any other C is an error
    unilateral,  ///< only pushes: C ≥ 0, and C < 0 is an error
    /// C is to grow at a given speed, as far as a force allows; C itself is no
    /// error
    motor,
    /// the same, as far as the impulse of another constraint allows (chapter 13)
    friction,
    spring,  ///< pulls C back by itself, the more the larger C is (chapter 16)
    inerter,  ///< resists a change of J u, as a mass between its two would (chapter 15)
};

/// Whether C is an error that a method may correct. What a motor, friction or a spring does about C is its own affair.
constexpr bool has_error(ConstraintKind kind)
{
    return kind == ConstraintKind::bilateral || kind == ConstraintKind::unilateral;
}

/// \f$C(x)\f$ and \f$J = \partial C / \partial x\f$ at the present positions, (2.2), and the kind of the constraint.
template <int Dof>
struct Constraint {
    Index a = world;  ///< the world is always a
    Index b = 0;
    /// ≥ 0 means separated (unilateral), = 0 means fulfilled (bilateral) [m]
    Real C = 0;
    /// block of J for body a; zero for the world
    RowVec<Dof> Ja = RowVec<Dof>::Zero();
    RowVec<Dof> Jb = RowVec<Dof>::Zero();  ///< block of J for body b
    ConstraintKind kind = ConstraintKind::bilateral;
    /// a contact: its bodies may part faster than they need to (chapter 6)
    bool bounces = false;
    Real speed = 0;  ///< of a motor, friction, an inerter: the wanted J u [m/s]
    /// of a motor: at most this, to either side; of a spring: the same, 0 = as much
    /// as it takes [N]
    Real force = 0;
    /// of friction: the number of the constraint whose λ bounds it
    int bounded_by = -1;
    Real friction = 0;   ///< of friction: μ, |λ| ≤ μ λ of that constraint
    Real weakening = 0;  ///< of friction: how much less μ is while it slides
    Real stiffness = 0;  ///< of a spring [N/m]
    Real damping = 0;    ///< of a spring [N s/m]
    Real inertance = 0;  ///< of an inerter [kg]
};

/// b of a constraint without an error to correct [m/s]: minus the wanted speed; of a spring k C / (h k + c), with which
/// and γ = 1 / (h (h k + c)) the row's λ is the spring's own impulse −h (k C + c Ċ) at the end of the step (chapter 16).
template <int Dof>
Real own_bias(const Constraint<Dof>& c, Real h)
{
    if (c.kind == ConstraintKind::spring)
        return c.stiffness * c.C / (h * c.stiffness + c.damping);
    return -c.speed;
}

}  // namespace rigid
