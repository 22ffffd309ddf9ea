/// \file family.hpp
/// What to check in a set of cases whose block is singular: not one answer belongs to it but a family, and some
/// members may keep to the bounds while the one that elimination happens to give does not.
///
///     Is there a λ with   A_FF λ_F + A_FB λ_B + q_F = 0,   lo ≤ λ ≤ hi,   w_i ≥ 0 at lo,   w_i ≤ 0 at hi ?
///
/// Written with nonnegative unknowns (distances from the bounds, and the w of the rows that are at
/// a bound) it is E v = f, v ≥ 0. The least ‖E v − f‖² over v ≥ 0 answers it: zero means yes.
/// \cite lawson1974, chapter 29
#pragma once

#include "chapters/03_mlcp_formulation/cases.hpp"
#include "chapters/03_mlcp_formulation/verification.hpp"
#include "common/elementary.hpp"

#include <Eigen/QR>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace rigid {

/// A dense copy of an MLCP in which each row is scaled to A_ii = 1, but for a factor of 2, so that units and masses don't
/// matter: λ_i = scale_i · λ̂_i, ŵ_i = scale_i · w_i with scale_i = 1/d_i, d_i the power of two next to √A_ii or what
/// row_unit() says. A power of two changes no digit: rows that differ in their last one still do.
struct DenseMlcp {
    MatX A;
    VecX q, lo, hi, scale;

    DenseMlcp() = default;
    explicit DenseMlcp(const Mlcp& mlcp);

private:
    /// A row without entries has no unit of its own; its λ has that of the rows that it moves.
    Real unit_of(const Mlcp& mlcp, Index i) const;
};

/// The v ≥ 0 with the least ‖E v − f‖, by the method of Lawson and Hanson: free the unknown that has to
/// grow most, solve for the free ones, and send back to zero those that went below it.
VecX nonnegative_least_squares(const MatX& E, const VecX& f);

/// All answers of a scaled problem that belong to one set of cases.
class Family {
public:
    Family(const DenseMlcp& problem, const std::vector<BoundState>& set);

    /// Some member, if there is one.
    std::optional<VecX> member() const { return solve(E_, f_); }

    /// A member with the given λ_i, if there is one.
    std::optional<VecX> member_with_lambda(Index i, Real value) const
    {
        return member_with(from_.row(i), value - base_[i]);
    }

    /// A member with the given w_i, if there is one.
    std::optional<VecX> member_with_w(Index i, Real value) const
    {
        const Eigen::RowVectorXd line = problem_.A.row(i);
        return member_with(line * from_, value - line.dot(base_) - problem_.q[i]);
    }

    /// True if the answer to some question was no and could not be proved.
    bool unsure() const { return unsure_; }

private:
    std::optional<VecX> member_with(const Eigen::RowVectorXd& line,
                                    Real value) const;

    /// The part of `left` that lies along the columns of E that v uses.
    static VecX along(const MatX& E, const VecX& v, const VecX& left)
    {
        MatX used = E;
        for (Index j = 0; j < E.cols(); ++j)
            if (!(v[j] > 0)) used.col(j).setZero();
        return used * used.colPivHouseholderQr().solve(left);
    }

    /// No v ≥ 0 has E v = f where some y has Eᵀy ≤ 0 and fᵀy > 0, since 0 ≥ (Eᵀy)ᵀv = fᵀy.
    static bool proves(const MatX& E, const VecX& f, const VecX& v, const VecX& y)
    {
        if (E.cols() == 0) return f.dot(y) > 0;
        const Real most = std::max((E.transpose() * y).maxCoeff(), Real{0}),
                   reach = v.sum() + f.norm() / E.colwise().norm().maxCoeff();
        return most * reach <= 1e-6 * f.dot(y);
    }

    /// What is left of f at the least distance is such a y. If it isn't, nothing is known.
    std::optional<VecX> solve(const MatX& E, const VecX& f) const;

    const DenseMlcp& problem_;
    Index n_;
    VecX base_;
    MatX from_, E_;
    VecX f_;
    Real numbers_ = 0;  ///< how large the numbers are that f is the sum of
    mutable bool unsure_ = false;
};

}  // namespace rigid
