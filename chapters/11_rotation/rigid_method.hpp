/// \file rigid_method.hpp
/// Methods of this chapter: the stages of Part I, with 3 in place of 2.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/06_sequential_impulse/impulse_solver.hpp"
#include "chapters/08_warm_starting/warm_start.hpp"
#include "chapters/09_active_sets/rattle.hpp"
#include "chapters/11_rotation/rigid_constraints.hpp"

namespace rigid {

//! [method]
struct RigidSweeps {
    AllBodies contacts;
    Correction correction;
    WarmStart start;
    ImpulseSolver<3> solver;
};

struct RigidExact {
    AllBodies contacts;
    Correction correction;
    ColdStart start;
    ExactSolver solver;
};

struct RigidRattle {
    AllBodies contacts;
    Rattle correction;
    ColdStart start;
    ExactSolver solver;
};
//! [method]

/// Positions are moved until every row is right to about 1e-13 of a second's way: no error is left to speak of.
inline Correction exact_repair()
{
    Correction correction;
    correction.method = Stabilizer::projection;
    correction.beta = 1;
    correction.correction_sweeps = 10000;
    correction.tolerance = 1e-11;
    return correction;
}

/// The inverse masses of body k, and ∞ for the motions that it cannot make: they have no share in a sum.
inline Vec<3> divisor(const Bodies<3>& bodies, Index k)
{
    const Vec<3> W = bodies.inverse_mass.segment<3>(3 * k);
    return (W.array() > 0).select(W, infinity);
}

/// Kinetic and potential energy of the bodies that can move [J].
inline Real energy(const RigidScene& scene)
{
    Real sum = 0;
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        if (!scene.bodies.can_move(k)) continue;
        const Vec<3> u = scene.bodies.velocity(k), W = divisor(scene.bodies, k);
        sum += u.cwiseAbs2().cwiseQuotient(W).sum() / 2 -
               scene.gravity.dot(scene.bodies.position(k).head<2>()) / W[0];
    }
    return sum;
}

/// Momentum and, about the origin, angular momentum of the bodies that can move [N s, N m s], (11.4).
inline Vec<3> momenta(const Bodies<3>& bodies)
{
    Vec<3> sum = Vec<3>::Zero();
    for (Index k = 0; k < bodies.count(); ++k) {
        if (!bodies.can_move(k)) continue;
        const Vec<3> p = bodies.velocity(k).cwiseQuotient(divisor(bodies, k));
        sum += p;
        sum[2] += cross2(bodies.position(k).head<2>(), p.head<2>());
    }
    return sum;
}

/// The largest |C| of a bilateral joint [m]; 0 without any.
inline Real largest_joint_error(const RigidScene& scene)
{
    Real largest = 0;
    for (const PointJoint& joint : scene.joints)
        if (joint.kind == ConstraintKind::bilateral)
            largest = std::max(largest,
                               std::abs(joint_constraint(scene.bodies.x, joint).C));
    return largest;
}

// Compiled once, in rigid_method.cpp.
extern template void step(RigidScene&, const StepSettings&, RigidSweeps&,
                          StepData<3>&);
extern template void step(RigidScene&, const StepSettings&, RigidExact&,
                          StepData<3>&);
extern template void step(RigidScene&, const StepSettings&, RigidRattle&,
                          StepData<3>&);

}  // namespace rigid
