/// \file dense_llt.hpp
/// The active rows of a dense A as L Lᵀ, and a border for the few rows that have changed since.
///
///     [ A₀₀  B ] [ x ]   [ r ]         B has a column a_0j for a row j that came in, and a unit column e_i
///     [ Bᵀ   D ] [ y ] = [ c ]         for a row i that went out: its equation is left open
///
/// (9.10). With Y = L⁻¹B the small matrix is S = D − YᵀY (9.11): a triangular solve for each changed row instead
/// of a new factorisation. \cite golub2013
#pragma once

#include "chapters/09_active_sets/block_principal_pivoting.hpp"
#include "chapters/09_active_sets/small_llt.hpp"

#include <Eigen/LU>
#include <cmath>
#include <vector>

namespace rigid {

class DenseLlt {
public:
    void load(const Mlcp& mlcp);

    void forget()
    {
        factored_.clear();
        base_.clear();
        changed_.clear();
        slots_.clear();
    }

    /// With a proximal term, from a factor that is not bordered: would the rows have done without the term? True if
    /// each pivot is far above it.
    bool is_independent(const GuessedProblem& problem) const
    {
        for (Index r = 0; r < base(); ++r)
            if (!(L_(r, r) * L_(r, r) > 100 * problem.shift[base_[index(r)]]))
                return false;
        return changed_.empty() && !factored_.empty();
    }

    /// Factors the rows that are `between`, or borders the last factor. False if they depend on each other.
    bool factor(const GuessedProblem& problem, const std::vector<BoundState>& cases,
                ActiveSetWork& work);

    /// Solves for the active rows: their entries of x are the right side, then the answer.
    void solve(VecX& x) const;

    void multiply(const Mlcp&, const VecX& x, VecX& product) const
    {
        product.setZero(x.size());
        for (Index j = 0; j < x.size(); ++j)
            if (x[j] != 0) product += x[j] * A_.col(j);
    }

private:
    /// n×n numbers. What was there goes first: if the new ones cannot be had, nothing is freed twice.
    static void make_room(MatX& matrix, Index n)
    {
        if (matrix.rows() == n) return;
        matrix.resize(0, 0);
        matrix.resize(n, n);
    }

    static std::size_t index(Index i) { return static_cast<std::size_t>(i); }
    template <class List>
    static Index size(const List& list)
    {
        return static_cast<Index>(list.size());
    }
    Index base() const { return size(base_); }
    /// Scaled to a unit diagonal: 1/√a for a row that came in, 0 for one that went out.
    Real came_in(Index c) const { return in_[index(c)]; }

    bool factor_anew(const GuessedProblem& problem,
                     const std::vector<BoundState>& cases);

    /// (9.11): the rows that differ from the base as a border; false if there are
    /// too many of them.
    bool border(const GuessedProblem& problem,
                const std::vector<BoundState>& cases);

    /// share of A_ii that a pivot must keep
    static constexpr Real rank_tolerance = 1e-11;

    MatX A_, L_, Y_, schur_;
    /// the rows of the factor; of a row, its place there or -1
    std::vector<Index> base_, place_;
    /// rows that Y has a column for; rows that differ now
    std::vector<Index> slots_, changed_, column_;
    std::vector<Real> in_;
    Eigen::PartialPivLU<MatX> S_;
    mutable VecX x_;
    std::vector<BoundState> factored_;
};

}  // namespace rigid
