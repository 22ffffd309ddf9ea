/// \file exact_rows.hpp
/// All rows together, in places and impulses: one sparse factor.
///
///     [ M + h²K   Jᵀ ] [  Δx ]   [ M (y − x) + JᵀΛ ]
///     [ J         −Γ ] [ −ΔΛ ] = [ −(C + Γ Λ)      ],   K = Σ T/‖d‖ (1 − n nᵀ),  T = max(0, −Λ/h²)     (27.17)
///
/// until C + Γ Λ = 0 and M (x − y) = JᵀΛ: the answer of the implicit step itself, and for γ = 0 of a cloth that does not
/// stretch at all, where no method of positions has a matrix. K is how the rows turn under their tension: without it what is
/// left is A + Γ, the matrix of XPBD's rows, and no answer is found where a thread pulls by more than m ‖d‖/h². The factor is
/// chapter 9's: above the line all pivots are positive and below it negative, in whatever order \cite vanderbei1995.
#pragma once

#include "chapters/09_active_sets/sparse_ldlt.hpp"
#include "chapters/27_particles_and_cloth/cloth.hpp"

namespace rigid {

class ExactRows {
public:
    Real tolerance = 1e-11;  ///< of C + Γ Λ and of M⁻¹(M (y − x) + JᵀΛ) [m]
    int iterations = 40;
    /// Λ: springs, three a bend, hinges [N s²]; a step begins with that of the step before, which says K
    VecX lambda;

    // What the last call found.
    int steps = 0;
    Real residual = 0;  ///< [m]
    bool solved = false;

    /// Which numbers meet, and where the factor has entries: once for each set of rows and pins.
    void prepare(const ClothScene& cloth);
    void solve(const ClothScene& cloth, const VecX& y, Real h, VecX& x);

    /// Numbers in the factor, below its diagonal.
    Index entries() const { return factor_.elimination.entries(); }

private:
    struct Entry {
        int row = 0, particle = 0;
        Vec3 J = {0, 0, 0};
    };
    void find_rows(const ClothScene& cloth, const VecX& x, Real h);
    void fill(const ClothScene& cloth, const VecX& x);
    void add(int row, int column, Real value);

    std::vector<Entry> entries_;  ///< row after row
    std::vector<int>
        number_;  ///< of a particle among those that can move; −1: pinned
    std::vector<char> held_;  ///< rows of which nothing can move
    int free_ = 0;
    VecX C_, gamma_, right_, push_;
    Mlcp system_;  ///< (27.17), without bounds
    GuessedProblem problem_;
    SparseLdlt factor_;
    std::vector<BoundState> all_;  ///< no row is at a bound
    ActiveSetWork work_;
};

}  // namespace rigid
