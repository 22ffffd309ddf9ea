/// \file family.hpp
/// What to check in a set of cases whose block is singular: not one answer belongs to it but a family, and some
/// members may keep to the bounds while the one that elimination happens to give does not.
///
///     Is there a λ with   A_FF λ_F + A_FB λ_B + q_F = 0,   lo ≤ λ ≤ hi,   w_i ≥ 0 at lo,   w_i ≤ 0 at hi ?
///
/// Written with nonnegative unknowns (distances from the bounds, and the w of the rows that are at
/// a bound) it is E v = f, v ≥ 0. The least ‖E v − f‖² over v ≥ 0 answers it: zero means yes.
/// \cite lawson1974, chapter 23
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
    explicit DenseMlcp(const Mlcp& mlcp)
        : A(mlcp.A), q(mlcp.q), lo(mlcp.lo), hi(mlcp.hi)
    {
        scale.resize(mlcp.size());
        for (Index i = 0; i < mlcp.size(); ++i)
            scale[i] = std::ldexp(
                1, -static_cast<int>(std::round(log2(unit_of(mlcp, i)))));
        A = scale.asDiagonal() * A * scale.asDiagonal();
        q.array() *= scale.array();
        lo.array() /= scale.array();
        hi.array() /= scale.array();
    }

private:
    /// A row without entries has no unit of its own; its λ has that of the rows that it moves.
    Real unit_of(const Mlcp& mlcp, Index i) const
    {
        const Real moves = A.col(i).cwiseAbs().maxCoeff();
        if (!(moves > 0) || A.row(i).cwiseAbs().maxCoeff() > 0)
            return row_unit(mlcp, i, A(i, i));
        Real unit = 0;
        for (Index j = 0; j < A.rows(); ++j)
            if (const Real across = std::abs(A(j, j)); across > 0)
                unit = std::max(unit, std::abs(A(j, i)) / std::sqrt(across));
        return unit > 0 ? unit : std::sqrt(moves);
    }
};

/// The v ≥ 0 with the least ‖E v − f‖, by the method of Lawson and Hanson: free the unknown that has to
/// grow most, solve for the free ones, and send back to zero those that went below it.
inline VecX nonnegative_least_squares(const MatX& E, const VecX& f)
{
    const Index n = E.cols();
    VecX v = VecX::Zero(n);
    std::vector<Index> free;
    const Real small = 1e-13 * (f.norm() + 1e-300) *
                       (E.cols() ? E.colwise().norm().maxCoeff() : 1);
    for (Index round = 0; round < 5 * n; ++round) {
        VecX wish = E.transpose() * (f - E * v);
        for (const Index j : free) wish[j] = 0;
        Index grows = 0;
        if (n == 0 || !(wish.maxCoeff(&grows) > small)) break;
        free.push_back(grows);
        while (!free.empty()) {
            MatX columns(E.rows(), static_cast<Index>(free.size()));
            for (std::size_t k = 0; k < free.size(); ++k)
                columns.col(static_cast<Index>(k)) = E.col(free[k]);
            const VecX wanted = columns.colPivHouseholderQr().solve(f);
            Real reach = 1;  // how far towards it all stay ≥ 0
            for (std::size_t k = 0; k < free.size(); ++k) {
                const Real to = wanted[static_cast<Index>(k)], from = v[free[k]];
                if (to <= 0)
                    reach =
                        std::min(reach, from > 0 ? from / (from - to) : Real{0});
            }
            for (std::size_t k = 0; k < free.size(); ++k)
                v[free[k]] += reach * (wanted[static_cast<Index>(k)] - v[free[k]]);
            if (reach >= 1) break;
            std::erase_if(free, [&](Index j) {
                if (v[j] > 1e-14 * v.maxCoeff()) return false;
                v[j] = 0;
                return true;
            });
        }
    }
    return v;
}

/// All answers of a scaled problem that belong to one set of cases.
class Family {
public:
    Family(const DenseMlcp& problem, const std::vector<BoundState>& set)
        : problem_(problem), n_(problem.q.size()), base_(VecX::Zero(n_)),
          from_(MatX::Zero(n_, 0))
    {
        // λ = base + from · v, a column for each nonnegative unknown.
        std::vector<std::pair<Index, Real>> columns;
        for (Index i = 0; i < n_; ++i) {
            const BoundState here = set[static_cast<std::size_t>(i)];
            const bool low = std::isfinite(problem.lo[i]),
                       high = std::isfinite(problem.hi[i]);
            if (here == BoundState::at_lo || (here == BoundState::between && low))
                base_[i] = problem.lo[i];
            else if (here == BoundState::at_hi || high) base_[i] = problem.hi[i];
            if (here != BoundState::between) continue;
            if (low || !high) columns.emplace_back(i, 1);
            if (!low) columns.emplace_back(i, -1);
        }
        from_ = MatX::Zero(n_, static_cast<Index>(columns.size()));
        for (std::size_t k = 0; k < columns.size(); ++k)
            from_(columns[k].first, static_cast<Index>(k)) = columns[k].second;

        // One equation for each row (w = 0, or w = ± a slack ≥ 0), and one for each second bound.
        MatX slacks = MatX::Zero(n_, n_), upper = MatX::Zero(0, 0);
        std::vector<Index> used, boxed;
        for (Index i = 0; i < n_; ++i) {
            const BoundState here = set[static_cast<std::size_t>(i)];
            // a pinned row may have any w
            if (!(problem.lo[i] < problem.hi[i])) continue;
            used.push_back(i);
            if (here == BoundState::at_lo) slacks(i, i) = -1;
            if (here == BoundState::at_hi) slacks(i, i) = 1;
            if (here == BoundState::between && std::isfinite(problem.lo[i]) &&
                std::isfinite(problem.hi[i]))
                boxed.push_back(i);
        }
        const Index rows = static_cast<Index>(used.size() + boxed.size()),
                    lambdas = from_.cols();
        E_ = MatX::Zero(rows, lambdas + n_ + static_cast<Index>(boxed.size()));
        f_ = VecX::Zero(rows);
        const MatX A_from = problem.A * from_;
        const VecX w_base = problem.A * base_ + problem.q;
        numbers_ = (problem.A.cwiseAbs() * base_.cwiseAbs() + problem.q.cwiseAbs())
                       .maxCoeff();
        Index line = 0;
        for (const Index i : used) {
            E_.row(line).head(lambdas) = A_from.row(i);
            E_.row(line).segment(lambdas, n_) = slacks.row(i);
            f_[line++] = -w_base[i];
        }
        // λ − lo + slack = hi − lo
        for (std::size_t k = 0; k < boxed.size(); ++k, ++line) {
            E_.row(line).head(lambdas) = from_.row(boxed[k]);
            E_(line, lambdas + n_ + static_cast<Index>(k)) = 1;
            f_[line] = problem.hi[boxed[k]] - problem.lo[boxed[k]];
        }
    }

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
                                    Real value) const
    {
        MatX E = MatX::Zero(E_.rows() + 1, E_.cols());
        VecX f(f_.size() + 1);
        E.topRows(E_.rows()) = E_;
        E.row(E_.rows()).head(line.size()) = line;
        f << f_, value;
        return solve(E, f);
    }

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
    std::optional<VecX> solve(const MatX& E, const VecX& f) const
    {
        const VecX v = nonnegative_least_squares(E, f);
        const VecX left = f - E * v;
        if (left.norm() <= 1e-9 * f.norm() + 1e-14 * numbers_)
            return base_ + from_ * v.head(from_.cols());
        // The second without what rounding of f has left along the columns in use.
        unsure_ = unsure_ || !(proves(E, f, v, left) ||
                               proves(E, f, v, left - along(E, v, left)));
        return std::nullopt;
    }

    const DenseMlcp& problem_;
    Index n_;
    VecX base_;
    MatX from_, E_;
    VecX f_;
    Real numbers_ = 0;  ///< how large the numbers are that f is the sum of
    mutable bool unsure_ = false;
};

}  // namespace rigid
