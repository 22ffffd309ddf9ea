/// \file vibration.hpp
/// The ways in which an elastic body swings by itself, and a body of few of them.
///
///     K φ = ω² M φ,   φ_iᵀ M φ_j = δ_ij                                           (30.16)
///     x = x_rest + Σ φ_k q_k,   q̈_k + (α + β ω_k²) q̇_k + ω_k² q_k = φ_kᵀ f          (30.17)
///
/// K is the stiffness at rest. A block of vectors is multiplied by (K + σM)⁻¹ M, and
/// within it the small problem is solved whole, until its vectors stand still (subspace
/// iteration \cite bathe1973). Each q_k is then stepped by its own exact solution.
#pragma once

#include "chapters/30_elastic_bodies/elastic_solver.hpp"

namespace rigid {

template <int Dim>
struct Vibration {
    VecX omega;   ///< ω ascending [rad/s]; of a free body the first are zero
    MatX shapes;  ///< φ, a column each [kg^−½]
    int iterations = 0;
    /// the largest ‖K φ − ω² M φ‖ / ((ω² + σ) ‖M φ‖): what the eigenvectors miss
    Real residual = infinity;
    Status status = Status::iteration_limit;
};

/// The `count` slowest vibrations of a body about its rest shape; fixed freedoms stay.
/// \param tolerance  of the residual; solved as well where ‖K φ − ω² M φ‖ / ‖M φ‖ is 2⁻⁵²
///        of the largest ω² of the mesh: rounding leaves no less. Where that is more than the
///        least ω² that is not zero, rounding hides it: `iteration limit`
/// \throws std::invalid_argument  for a body that is not valid, and for a count that is not
///         from 1 to the number of free freedoms
template <int Dim>
Vibration<Dim> vibrations_of(const ElasticBody<Dim>& body, int count,
                             Real tolerance = 1e-9);

/// One freedom after h under a constant force: exact, (30.24).
/// \param c  damping [1/s], q̈ + c q̇ + ω² q = force
void swing(Real omega, Real c, Real force, Real h, Real& q, Real& speed);

/// A body as the sum of its vibrations.
template <int Dim>
struct ModalBody {
    Vibration<Dim> vibration;
    VecX q, speed;  ///< [kg^½ m], [kg^½ m/s]

    explicit ModalBody(const ElasticBody<Dim>& body, int count);
    /// One step of the body: its x and v become those of the sum. Throws
    /// std::invalid_argument for a step that is not positive, a body that is not valid or
    /// has another number of nodes than that whose vibrations these are.
    void step(ElasticBody<Dim>& body, Real h);
    /// q and q̇ of a body as it is: what none of the vibrations has is lost.
    void take(const ElasticBody<Dim>& body);

private:
    void require_same(const ElasticBody<Dim>& body) const;
    VecX f_, product_;
};

extern template Vibration<1> vibrations_of(const ElasticBody<1>&, int, Real);
extern template Vibration<2> vibrations_of(const ElasticBody<2>&, int, Real);
extern template Vibration<3> vibrations_of(const ElasticBody<3>&, int, Real);
extern template struct ModalBody<1>;
extern template struct ModalBody<2>;
extern template struct ModalBody<3>;

}  // namespace rigid
