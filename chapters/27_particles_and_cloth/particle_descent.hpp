/// \file particle_descent.hpp
/// One particle at a time, with all its rows: vertex block descent, chapter 16's (16.28) in space.
///
///     Δx = H⁻¹ f,   f = −m (x − y)/h² + Σ forces of its rows,   H = m/h² + Σ ∂² of its rows           (27.12)
///
/// Particles that share no row have one colour; colours follow each other. \cite chen2024
///
/// Augmented \cite giles2025: a spring of the sweep has F = λ + s C in place of k C, and after each sweep
///
///     λ ← F  if it is hard,   s ← min(k, s + β (m/h²) |C|/L)                                            (27.28)
///
/// so the springs are soft first and grow to their own stiffness; a hard one is held by its λ.
#pragma once

#include "chapters/27_particles_and_cloth/cloth.hpp"

namespace rigid {

class ParticleDescent {
public:
    /// The rows of each particle, and colours: a particle takes the first that none of
    /// its neighbours has.
    void find(const ClothScene& cloth);
    /// Each particle once, colour after colour; springs as begin() and grow() left them.
    void sweep(const ClothScene& cloth, const VecX& y, Real h, VecX& x);

    /// At the start of a step: s and λ of each spring. Plain: s = k and λ = 0.
    void begin(const ClothScene& cloth, Real h, bool augmented);
    /// (27.28), after a sweep.
    void grow(const ClothScene& cloth, Real h, const VecX& x);

    // Augmented: what is kept of the last step, and how fast s grows.
    Real kept = 0.99;  ///< part of λ and of s that a step starts from
    Real beta =
        10;  ///< growth of s for an error of one length of its spring [m/h²]
    VecX stiffness;  ///< s [N/m]
    VecX pull;       ///< λ [N]

    int colours() const { return colours_; }
    /// Of each particle, in the order of the visits; for a test.
    const std::vector<int>& order() const { return order_; }

private:
    /// a row of a particle: springs first, then bends, then hinges
    struct Meeting {
        int row = 0, corner = 0;
    };
    std::vector<Meeting> list_;
    std::vector<std::size_t> first_;
    std::vector<int> order_;
    int colours_ = 0;
};

}  // namespace rigid
