/// \file dense_cones.hpp
/// Rows with discs of friction where every row moves every other: a full A, solved exactly.
///
///     w = A λ + q,   lo ≤ λ ≤ hi ⟂ w,   ‖λ_t‖ ≤ μ λ_n                          (24.3)
///
/// Algorithm 24.2 with another linear system: the cases of its rows are those of (24.14),
/// and the equations (24.15) of a guess are a full matrix of the unknowns, which is solved by
/// elimination with row pivots, sums in one order. What guesses do not settle gets sweeps.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "chapters/24_friction_is_a_disc/cone_cases.hpp"

#include <vector>

namespace rigid {

struct DenseCones {
    int guesses = 14;  ///< in a row
    int retreats = 4;  ///< sweeps between them: 10, 30, 90, …

    // The problem: the caller fills it after begin().
    std::vector<Real> A;             ///< m×m, row by row [1/kg]
    VecX q;                          ///< [m/s]
    std::vector<SolverRow<6>> rows;  ///< bounds and λ to start from
    std::vector<Feedback> feedback;  ///< which row bounds it, and μ
    int guessed = 0, swept = 0;      ///< of the last solve

    /// Room for m rows; they are free, λ is zero. Keeps memory.
    void begin(std::size_t m);
    /// Solves it: λ and the residual into `solution`, `solved` if that is at most
    /// `enough` [m/s], else `iteration limit` and the best λ that was found.
    /// \param same  A, bounds and pairs are those of the last solve
    void solve(Real enough, bool same, Solution& solution);

private:
    /// Rows of λ or w, each with a factor: a normal has its own and all that it bounds.
    struct Mix {
        int count = 0;
        std::array<int, 8> row{};
        std::array<Real, 8> part{};
        void add(std::size_t k, Real p);
    };
    ConeRows view();
    void find_discs();
    void velocities();
    bool accept(Real enough);
    void press();
    bool guess_on(Real enough);
    void write_equations();
    void solve_guess(Real enough);
    /// L U of the equations; a pivot below 1e-14 of the largest entry is left out.
    void factor();
    void substitute(std::vector<Real>& x) const;
    void sweep();

    std::vector<DiscOfRows> discs_;
    std::vector<int> disc_at_;
    ConeGuess g_;
    std::vector<Mix> tests_, columns_;
    std::vector<Real> matrix_, x_;
    std::vector<int> pivot_;
    VecX best_, from_;
    Real residual_ = infinity;
};

}  // namespace rigid
