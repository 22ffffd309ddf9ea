/// \file enumeration.hpp
/// The plainest exact way: guess for each row which of its cases holds, solve, look whether it fits, and try
/// all guesses. Slow, and the reference that every later solver is compared with.
///
///     A_FF λ_F = −(q_F + A_FB λ_B)     F the rows between their bounds, B those at a bound
///
/// (3.14b). An answer counts only by its natural residual; of a singular block the whole family is examined; how
/// many answers there are is decided by comparing those that were found. \cite cottle1992
#pragma once

#include "chapters/02_velocity_constraints/solve_rows.hpp"
#include "chapters/03_mlcp_formulation/case_conditions.hpp"
#include "chapters/03_mlcp_formulation/cases.hpp"

#include "common/text.hpp"

#include <Eigen/LU>
#include <array>
#include <string>
#include <vector>

namespace rigid {

struct EnumerationSettings {
    /// take the first set that fits; nothing is then said about uniqueness
    bool stop_at_first = false;
    /// the guess to begin with, of all rows or empty; the others follow by how many
    /// rows differ
    std::vector<BoundState> first;
    /// of the natural residual, relative to the numbers in the problem
    Real tolerance = 1e-10;
    /// 3¹⁶: a problem with more sets is refused; with stop_at_first, give up after so many.
    long most_sets = 43'046'721;
};

inline constexpr Index most_rows = 32;  ///< that an enumeration takes

class Enumerator {
public:
    /// The problem must outlive it.
    Enumerator(const Mlcp& mlcp, const EnumerationSettings& settings)
        : mlcp_(checked(mlcp)), settings_(settings), sets_(mlcp, settings.first),
          dense_(mlcp), answers_(mlcp_, dense_, settings.tolerance), z_(mlcp.size())
    {
        require_share(settings.tolerance);
        if (mlcp.size() > 0)
            given_ = (dense_.q.cwiseAbs() +
                      dense_.A.cwiseAbs() * answers_.lambda_scaled().cwiseAbs())
                         .maxCoeff();
        if (mlcp.size() > 0)
            reach_ = 1 + dense_.A.cwiseAbs().rowwise().sum().maxCoeff();
        if (is_spread(dense_)) answers_.leave_count_open();
        if (!settings.stop_at_first &&
            sets_.count() > static_cast<Real>(settings.most_sets))
            throw std::invalid_argument(
                "the " + std::to_string(mlcp.size()) + " rows have " +
                readable(sets_.count()) +
                " sets of cases; enumeration looks at no more than " +
                std::to_string(settings.most_sets));
    }

    Solution run()
    {
        try_all();
        if (answers_.count() == 0 && !given_up_ && settings_.stop_at_first) {
            // perhaps one is another member of a singular set's family
            families_ = true;
            try_all();
        }
        Solution solution;
        solution.iterations = static_cast<int>(tried_);
        solution.lambda = answers_.lambda();
        solution.residual = natural_residual(mlcp_, solution.lambda);
        solution.status = answers_.count() > 0  ? Status::solved
                          : given_up_           ? Status::iteration_limit
                          : answers_.doubtful() ? Status::singular
                                                : Status::infeasible;
        if (!settings_.stop_at_first) solution.uniqueness = answers_.uniqueness();
        return solution;
    }

private:
    static const Mlcp& checked(const Mlcp& mlcp)
    {
        require_valid(mlcp);
        if (mlcp.size() > most_rows)
            throw std::invalid_argument(
                "the problem has " + std::to_string(mlcp.size()) +
                " rows; enumeration takes at most " + std::to_string(most_rows));
        return mlcp;
    }

    void try_all()
    {
        sets_.visit_all([this] {
            try_set(sets_.now());
            return given_up_ || answers_.w_differs() ||
                   (settings_.stop_at_first && answers_.count() > 0);
        });
    }

    //! [set]
    /// (3.14b): the rows that are between their bounds make a linear system; the
    /// others are known.
    void try_set(const std::vector<BoundState>& set)
    {
        if (settings_.stop_at_first && tried_ >= settings_.most_sets) {
            given_up_ = true;
            return;
        }
        ++tried_;
        const Index n = mlcp_.size();
        Index k = 0;
        for (Index i = 0; i < n; ++i) {
            const BoundState here = set[static_cast<std::size_t>(i)];
            if (here == BoundState::between)
                free_[static_cast<std::size_t>(k++)] = i;
            z_[i] = here == BoundState::at_lo   ? dense_.lo[i]
                    : here == BoundState::at_hi ? dense_.hi[i]
                                                : 0;
        }
        w_ = dense_.q;
        sizes_ = dense_.q.cwiseAbs();
        for (Index j = 0; j < n; ++j)
            if (z_[j] < 0 || z_[j] > 0) {
                w_ += dense_.A.col(j) * z_[j];
                sizes_ += dense_.A.col(j).cwiseAbs() * std::abs(z_[j]);
            }
        // the measure for what is small in this system
        numbers_ = n > 0 ? std::max(given_, sizes_.maxCoeff()) : 0;

        bool singular = false;
        if (k > 0) {
            block_.resize(k, k);
            right_.resize(k);
            for (Index r = 0; r < k; ++r) {
                for (Index c = 0; c < k; ++c)
                    block_(r, c) = dense_.A(free_at(r), free_at(c));
                right_[r] = -w_[free_at(r)];
            }
            lu_.setThreshold(rank_tolerance);
            lu_.compute(block_);
            const Index rank = lu_.rank();
            singular = rank < k;
            // it had its say in the first round
            if (families_ && !singular) return;
            free_z_ = lu_.solve(right_);
            const auto pivots = lu_.matrixLU().diagonal().cwiseAbs();
            least_pivot_ =
                rank > 0 && pivots[0] > 0 ? pivots[rank - 1] / pivots[0] : 1;
            if (singular) {
                // Too small for a pivot and too large for rounding; a misfit
                // neither large nor small.
                if (pivots[rank] > 1e-14 * pivots[0]) answers_.doubt();
                const Real misfit =
                    (block_ * free_z_ - right_).cwiseAbs().maxCoeff();
                if (!(misfit <= 1e-9 * numbers_)) {  // no λ at all gives w = 0
                    if (!(misfit > rounding(free_z_.cwiseAbs().maxCoeff())) ||
                        (misfit <= 1e-4 * numbers_ &&
                         !is_contradiction(block_, right_, numbers_)))
                        answers_.doubt();
                    return;
                }
            }
            for (Index r = 0; r < k; ++r) {
                z_[free_at(r)] = free_z_[r];
                w_ += dense_.A.col(free_at(r)) * free_z_[r];
            }
        } else if (families_) {
            return;
        }
        if (families_) return ask_family(set);
        const Real miss = violation(dense_, set, z_, w_);
        if (miss <= 1e-7 * numbers_ && answers_.accept(z_)) {
            if (singular && !settings_.stop_at_first)
                look_around(dense_, set, lu_.kernel(), free_, numbers_, answers_);
            return;
        }
        // Refuted, unless the miss may be the rounding of this system.
        if (singular) {
            if (!settings_.stop_at_first) ask_family(set);
        } else if (!(miss > rounding(z_.cwiseAbs().maxCoeff()))) {
            answers_.doubt();
        }
    }
    //! [set]

    /// What rounding may have done to the λ and w of the present set.
    Real rounding(Real largest_z) const
    {
        return 1e3 * std::numeric_limits<Real>::epsilon() *
               (numbers_ + reach_ * largest_z / least_pivot_);
    }

    /// Is some other member of a singular set's family an answer?
    void ask_family(const std::vector<BoundState>& set)
    {
        const Family family(dense_, set);
        if (const auto member = family.member()) {
            if (!answers_.accept(*member)) answers_.doubt();
            else if (!settings_.stop_at_first)
                look_around(dense_, set, lu_.kernel(), free_, numbers_, answers_);
        }
        if (family.unsure()) answers_.doubt();
    }

    Index free_at(Index r) const { return free_[static_cast<std::size_t>(r)]; }

    template <int Columns>
    using Small = Eigen::Matrix<Real, Eigen::Dynamic, Columns, 0, most_rows,
                                Columns == 1 ? 1 : int(most_rows)>;

    const Mlcp& mlcp_;
    EnumerationSettings settings_;
    CaseSets sets_;
    DenseMlcp dense_;
    Answers answers_;
    std::array<Index, most_rows> free_{};
    Small<Eigen::Dynamic> block_;
    Small<1> right_, free_z_;
    Eigen::FullPivLU<Small<Eigen::Dynamic>> lu_;
    VecX z_, w_, sizes_;
    Real numbers_ = 0;
    /// numbers_ at the point of the bounds that is nearest to zero
    Real given_ = 0;
    Real reach_ = 1;        ///< what a unit of λ can add to any row
    Real least_pivot_ = 1;  ///< of the present block, beside its largest
    long tried_ = 0;
    bool families_ = false, given_up_ = false;
};

/// All answers to an MLCP, by trying all sets of cases (or until the first fits, see EnumerationSettings).
///
/// `solved` with one of them, or `infeasible` if no set has any; `singular` if rounding leaves that open. Then, and
/// where it leaves open whether two answers are one, nothing is said about uniqueness. `iterations` counts the sets.
/// \throws std::invalid_argument  for an invalid problem or one with too many sets
inline Solution enumerate(const Mlcp& mlcp,
                          const EnumerationSettings& settings = {})
{
    return Enumerator(mlcp, settings).run();
}

}  // namespace rigid
