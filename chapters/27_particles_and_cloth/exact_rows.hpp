/// \file exact_rows.hpp
/// All rows together, in impulses: the sparse factor of A + Γ.
///
///     r = y + M⁻¹JᵀΛ − x,   (A + Γ) ΔΛ = −(C + Γ Λ + J r),   x ← x + r + M⁻¹Jᵀ ΔΛ                     (27.17)
///
/// until C + Γ Λ = 0 and M (x − y) = JᵀΛ: the answer of the implicit step itself, and for γ = 0 of a cloth that does not
/// stretch at all, where no method of positions has a matrix. XPBD leaves r out.
#pragma once

#include "chapters/27_particles_and_cloth/cloth.hpp"

#include <Eigen/SparseCholesky>

namespace rigid {

class ExactRows {
public:
    Real tolerance = 1e-11;  ///< of C + Γ Λ and of r [m]
    int iterations = 40;
    VecX lambda;  ///< Λ: springs, three a bend, hinges [N s²]

    // What the last call found.
    int steps = 0;
    Real residual = 0;  ///< [m]
    bool solved = false;

    void solve(const ClothScene& cloth, const VecX& y, Real h, VecX& x);

private:
    struct Entry {
        int row = 0, particle = 0;
        Vec3 J = {0, 0, 0};
    };
    void find_rows(const ClothScene& cloth, const VecX& x, Real h);

    std::vector<Entry> entries_;
    VecX C_, gamma_, right_;
    std::vector<Eigen::Triplet<Real>> triplets_;
    Eigen::SimplicialLDLT<Eigen::SparseMatrix<Real>> factor_;
};

}  // namespace rigid
