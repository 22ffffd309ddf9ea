/// \file row_sweeps.hpp
/// One row at a time, in positions: position-based dynamics and its extension, chapter 16's (16.21) in space.
///
///     PBD    x ← x + s M⁻¹Jᵀ ΔΛ,  ΔΛ = −C/A                 stiff by the number of sweeps             (27.9)
///     XPBD   ΔΛ = −(C + γ Λ)/(A + γ),  γ = 1/(h² k)          one answer, whatever the number           (27.11)
///
/// Λ is the sum of all ΔΛ of a step: set to zero between two sweeps it is PBD again, with s = A/(A + γ).
/// \cite muller2007 \cite macklin2016 \cite macklin2019
#pragma once

#include "chapters/27_particles_and_cloth/cloth.hpp"

namespace rigid {

//! [row_change]
/// (27.11): ΔΛ of a visit. \param sum  Λ so far
inline Real row_change(Real C, Real A, Real gamma, Real sum)
{
    return -(C + gamma * sum) / (A + gamma);
}
//! [row_change]

struct RowSweeps {
    bool positions_alone = false;  ///< PBD
    Real share = 1;                ///< s of PBD, from 0 to 1
    bool keep_lambda = true;       ///< false: the mistake

    // What is kept through a step.
    VecX lambda, bend_lambda, hinge_lambda;  ///< Λ [N s²]; of a bend three

    /// Λ = 0, at the start of a (sub-)step.
    void begin(const ClothScene& cloth);
    /// Every row once: springs, if they are wanted, bends, hinges.
    void sweep(const ClothScene& cloth, Real h, VecX& x, bool with_springs = true);
};

//! [limit]
/// Springs beyond (1 + strain) L are drawn back: rows with Λ ≤ 0 and γ = 0 (27.24).
struct StrainLimit {
    Real strain = infinity;
    Real stiff = 0;  ///< springs of at least this k [N/m]: threads, not diagonals
    std::vector<int> beyond;

    /// Those that are beyond it now. \return  whether there are any
    bool find(const ClothScene& cloth, const VecX& x);
    /// Each of those once, to nine tenths of the strain if it is beyond that: its
    /// neighbours take up a part of what it gives.
    void draw_back(const ClothScene& cloth, VecX& x) const;
};
//! [limit]

}  // namespace rigid
