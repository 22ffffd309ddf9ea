/// \file projective.hpp
/// All rows together, again and again, with one matrix that never changes: projective dynamics.
///
///     local     of each row the nearest d of length L:  p = L d/‖d‖
///     global    (M/h² + Σ k wᵀw) x = M y/h² + Σ k wᵀp        one factor for all steps                    (27.14)
///
/// Both at once are x ← x − P⁻¹ ∂G(x): Newton's method with P in place of H. As P − H is positive semi-definite, G never
/// rises. Springs and bends are rows of this kind; an angle is not. \cite bouaziz2014
#pragma once

#include "chapters/27_particles_and_cloth/cloth.hpp"

#include <Eigen/SparseCore>

namespace rigid {

class Projective {
public:
    Real residual = 0;  ///< the largest h²/m ‖∂G‖ of the last pass, before it [m]

    /// Factors P for a time step.
    /// \throws std::invalid_argument  for hinges
    void prepare(const ClothScene& cloth, Real h);
    /// One local and one global pass.
    void pass(const ClothScene& cloth, const VecX& y, Real h, VecX& x);
    /// Entries of the factor.
    Index entries() const { return factor_.nonZeros(); }

private:
    Eigen::SparseMatrix<Real> factor_;  ///< L below its diagonal of ones
    std::vector<int> order_;            ///< particle of each line of the factor
    std::vector<Vec3> right_;
    VecX force_, pivot_;
};

}  // namespace rigid
