/// \file enumeration.hpp
/// The plainest exact way: guess for each row which of its three cases holds, solve, look whether it fits,
/// and try all guesses. Slow, and the truth that every later solver is held to.
///
///     at_lo:   λ = lo, and w ≥ 0 must come out
///     between: w = 0,  and lo ≤ λ ≤ hi must come out
///     at_hi:   λ = hi, and w ≤ 0 must come out
///
/// (3.24). At most 3ᵐ sets of cases, 2ᵐ for contacts. An answer counts only by its natural residual; a
/// singular block is asked for its whole family; how many answers there are is decided by comparing
/// those that were found. \cite cottle1992
#pragma once

#include "chapters/02_velocity_constraints/solve_rows.hpp"
#include "chapters/03_mlcp_formulation/family.hpp"

#include <Eigen/LU>
#include <array>
#include <string>
#include <vector>

namespace rigid {

struct EnumerationSettings {
    bool stop_at_first = false;  ///< take the first set that fits; nothing is then said about uniqueness
    std::vector<RowCase> first;  ///< the guess to begin with; the others follow by how many rows differ
    Real tolerance = 1e-10;      ///< of the natural residual, relative to the numbers in the problem
    long most_sets =
        43'046'721;  ///< 3¹⁶: refuse a problem with more; with stop_at_first, give up after so many
};

inline constexpr Index most_rows = 32;  ///< that an enumeration takes

class Enumerator {
public:
    Enumerator(const Mlcp& mlcp, const EnumerationSettings& settings) : mlcp_(mlcp), settings_(settings)
    {
        require_valid(mlcp);
        const Index n = mlcp.size();
        if (n > most_rows)
            throw std::invalid_argument("the problem has " + std::to_string(n) +
                                        " rows; enumeration takes at most " + std::to_string(most_rows));
        dense_ = DenseMlcp(mlcp);
        z_.resize(n);
        w_.resize(n);
        best_ = mlcp.lo.cwiseMax(0).cwiseMin(mlcp.hi).cwiseQuotient(dense_.scale);
        Real sets = 1;
        for (Index i = 0; i < n; ++i) {
            cases_.push_back(cases_of(mlcp, i));
            sets *= static_cast<Real>(cases_.back().size());
            if (cases_.back().size() > 1) choices_.push_back(i);
            set_.push_back(first_guess(i));
        }
        if (!settings.stop_at_first && sets > static_cast<Real>(settings.most_sets))
            throw std::invalid_argument("the " + std::to_string(n) + " rows have " + std::to_string(sets) +
                                        " sets of cases; enumeration looks at no more than " +
                                        std::to_string(settings.most_sets));
    }

    Solution run()
    {
        try_all();
        if (found_ == 0 && !given_up_) {  // perhaps an answer is another member of a singular set's family
            families_ = true;
            try_all();
        }
        Solution solution;
        solution.iterations = static_cast<int>(tried_);
        solution.lambda = best_.cwiseProduct(dense_.scale);
        solution.residual = natural_residual(mlcp_, solution.lambda);
        solution.status = found_ > 0  ? Status::solved
                          : given_up_ ? Status::iteration_limit
                                      : Status::infeasible;
        if (!settings_.stop_at_first)
            solution.uniqueness = found_ == 0       ? Uniqueness::none
                                  : w_differs_      ? Uniqueness::any
                                  : lambda_differs_ ? Uniqueness::w_unique
                                                    : Uniqueness::unique;
        return solution;
    }

private:
    static std::vector<RowCase> cases_of(const Mlcp& mlcp, Index i)
    {
        const bool room = mlcp.lo[i] < mlcp.hi[i];
        std::vector<RowCase> cases;
        if (room) cases.push_back(RowCase::between);
        if (std::isfinite(mlcp.lo[i])) cases.push_back(RowCase::at_lo);
        if (room && std::isfinite(mlcp.hi[i])) cases.push_back(RowCase::at_hi);
        return cases;
    }

    /// The guess that was given, or else what q alone says: what pushes is at work where q asks for it.
    RowCase first_guess(Index i) const
    {
        const std::vector<RowCase>& cases = cases_.back();
        const auto possible = [&](RowCase c) {
            return std::find(cases.begin(), cases.end(), c) != cases.end();
        };
        RowCase guess = mlcp_.q[i] < 0 ? RowCase::between : RowCase::at_lo;
        if (static_cast<Index>(settings_.first.size()) == mlcp_.size())
            guess = settings_.first[static_cast<std::size_t>(i)];
        return possible(guess) ? guess : cases.front();
    }

    //! [order]
    /// All sets, those near the first guess first: it itself, then those that differ from it in one row, …
    void try_all()
    {
        for (std::size_t distance = 0; distance <= choices_.size(); ++distance) try_sets(0, distance);
    }

    /// Those that differ from the present set in so many of the rows choices_[from], choices_[from + 1], …
    void try_sets(std::size_t from, std::size_t distance)
    {
        if (settled()) return;
        if (distance == 0) return try_set();
        for (std::size_t k = from; k + distance <= choices_.size(); ++k) {
            const auto row = static_cast<std::size_t>(choices_[k]);
            const RowCase kept = set_[row];
            for (const RowCase other : cases_[row])
                if (other != kept) {
                    set_[row] = other;
                    try_sets(k + 1, distance - 1);
                }
            set_[row] = kept;
        }
    }
    //! [order]

    bool settled() const { return given_up_ || w_differs_ || (settings_.stop_at_first && found_ > 0); }

    //! [set]
    /// (3.25): the rows that are between their bounds make a linear system; the others are known.
    void try_set()
    {
        if (settings_.stop_at_first && tried_ >= settings_.most_sets) {
            given_up_ = true;
            return;
        }
        ++tried_;
        const Index n = mlcp_.size();
        Index k = 0;
        for (Index i = 0; i < n; ++i) {
            const RowCase here = set_[static_cast<std::size_t>(i)];
            if (here == RowCase::between) free_[static_cast<std::size_t>(k++)] = i;
            z_[i] = here == RowCase::at_lo ? dense_.lo[i] : here == RowCase::at_hi ? dense_.hi[i] : 0;
        }
        w_ = dense_.q;
        sizes_ = dense_.q.cwiseAbs();
        for (Index j = 0; j < n; ++j)
            if (z_[j] < 0 || z_[j] > 0) {
                w_ += dense_.A.col(j) * z_[j];
                sizes_ += dense_.A.col(j).cwiseAbs() * std::abs(z_[j]);
            }
        numbers_ =
            n > 0 ? sizes_.maxCoeff() : 0;  // what the system is made of: the measure for what is small

        bool singular = false;
        if (k > 0) {
            block_.resize(k, k);
            right_.resize(k);
            for (Index r = 0; r < k; ++r) {
                for (Index c = 0; c < k; ++c) block_(r, c) = dense_.A(free_at(r), free_at(c));
                right_[r] = -w_[free_at(r)];
            }
            lu_.setThreshold(rank_tolerance);
            lu_.compute(block_);
            singular = lu_.rank() < k;
            if (families_ && !singular) return;  // it had its say in the first round
            free_z_ = lu_.solve(right_);
            if (singular && !((block_ * free_z_ - right_).cwiseAbs().maxCoeff() <= 1e-9 * numbers_))
                return;  // no λ at all gives w = 0
            for (Index r = 0; r < k; ++r) {
                z_[free_at(r)] = free_z_[r];
                w_ += dense_.A.col(free_at(r)) * free_z_[r];
            }
        } else if (families_) {
            return;
        }
        if (families_) {
            if (const auto member = Family(dense_, set_).member()) accept_if_it_fits(*member);
            return;
        }
        if (fits() && accept_if_it_fits(z_) && singular && !settings_.stop_at_first) look_around();
    }
    //! [set]

    /// Does what came out keep to the set's conditions?  With room for rounding: the residual decides later.
    bool fits() const
    {
        const Real slack = 1e-7 * numbers_;
        for (Index i = 0; i < mlcp_.size(); ++i) {
            if (z_[i] < dense_.lo[i] - slack || z_[i] > dense_.hi[i] + slack) return false;
            if (!(dense_.lo[i] < dense_.hi[i])) continue;
            const RowCase here = set_[static_cast<std::size_t>(i)];
            if (here == RowCase::at_lo && w_[i] < -slack) return false;
            if (here == RowCase::at_hi && w_[i] > slack) return false;
        }
        return true;
    }

    /// The last word is the natural residual's, in m/s, of what is really handed out.
    bool accept_if_it_fits(const VecX& z)
    {
        candidate_ = z.cwiseMax(dense_.lo).cwiseMin(dense_.hi);
        lambda_ = candidate_.cwiseProduct(dense_.scale);
        if (!(natural_residual(mlcp_, lambda_) <= settings_.tolerance * size_of_numbers(mlcp_, lambda_)))
            return false;
        const VecX w = dense_.A * candidate_ + dense_.q;
        if (found_++ == 0) {
            best_ = candidate_;
            best_w_ = w;
            return true;
        }
        const Real size = std::max(numbers_, best_.cwiseAbs().maxCoeff());
        if ((candidate_ - best_).cwiseAbs().maxCoeff() > 1e-7 * size) lambda_differs_ = true;
        if ((w - best_w_).cwiseAbs().maxCoeff() > 1e-7 * size) w_differs_ = true;
        return true;
    }

    //! [family]
    /// A set with a singular block fits: are there other answers in its family?  Along each null direction
    /// ask for a member a little to either side.
    void look_around()
    {
        const VecX here = candidate_;
        const MatX null = lu_.kernel();
        const Index k = null.rows();
        MatX moves_w = MatX::Zero(mlcp_.size(), null.cols());
        for (Index r = 0; r < k; ++r) moves_w += dense_.A.col(free_at(r)) * null.row(r);
        const Real step = 1e-5 * std::max({numbers_, here.cwiseAbs().maxCoeff(), Real(1e-300)});
        const Family family(dense_, set_);
        for (const Real side : {step, -step}) {
            for (Index r = 0; r < k && !lambda_differs_; ++r)
                if (null.row(r).cwiseAbs().maxCoeff() > 1e-9)
                    if (const auto other = family.member_with_lambda(free_at(r), here[free_at(r)] + side))
                        accept_if_it_fits(*other);
            for (Index i = 0; i < mlcp_.size() && !w_differs_; ++i)
                if (set_[static_cast<std::size_t>(i)] != RowCase::between &&
                    moves_w.row(i).cwiseAbs().maxCoeff() > 1e-9) {
                    const Real w = dense_.A.row(i).dot(here) + dense_.q[i];
                    if (const auto other = family.member_with_w(i, w + side)) accept_if_it_fits(*other);
                }
        }
    }
    //! [family]

    Index free_at(Index r) const { return free_[static_cast<std::size_t>(r)]; }

    template <int Columns>
    using Small =
        Eigen::Matrix<Real, Eigen::Dynamic, Columns, 0, most_rows, Columns == 1 ? 1 : int(most_rows)>;

    const Mlcp& mlcp_;
    EnumerationSettings settings_;
    DenseMlcp dense_;
    std::vector<std::vector<RowCase>> cases_;
    std::vector<Index> choices_;  ///< rows with more than one case
    std::vector<RowCase> set_;

    std::array<Index, most_rows> free_{};
    Small<Eigen::Dynamic> block_;
    Small<1> right_, free_z_;
    Eigen::FullPivLU<Small<Eigen::Dynamic>> lu_;
    VecX z_, w_, sizes_, candidate_, lambda_;
    Real numbers_ = 0;

    VecX best_, best_w_;
    long tried_ = 0, found_ = 0;
    bool families_ = false, given_up_ = false, lambda_differs_ = false, w_differs_ = false;
};

/// All answers to an MLCP, by trying all sets of cases (or until the first fits, see EnumerationSettings).
///
/// `solved` with one of them, or `infeasible` if no set has any. `iterations` counts the sets.
/// \throws std::invalid_argument  for an invalid problem or one with too many sets
inline Solution enumerate(const Mlcp& mlcp, const EnumerationSettings& settings = {})
{
    return Enumerator(mlcp, settings).run();
}

}  // namespace rigid
