/// \file particle_descent.hpp
/// One particle at a time, with all its rows: vertex block descent, chapter 16's (16.28) in space.
///
///     Δx = H⁻¹ f,   f = −m (x − y)/h² + Σ forces of its rows,   H = m/h² + Σ ∂² of its rows           (27.12)
///
/// Particles that share no row have one colour; colours follow each other. \cite chen2024
#pragma once

#include "chapters/27_particles_and_cloth/cloth.hpp"

namespace rigid {

class ParticleDescent {
public:
    /// The rows of each particle, and colours: a particle takes the first that none of
    /// its neighbours has.
    void find(const ClothScene& cloth);
    /// Each particle once, colour after colour.
    void sweep(const ClothScene& cloth, const VecX& y, Real h, VecX& x);

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
