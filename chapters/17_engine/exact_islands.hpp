/// \file exact_islands.hpp
/// The islands of a step that are solved exactly, but for those whose impulses of the step before are the answer again.
///
///     u = u* + M⁻¹ Jᵀ λ_old,     r(λ_old, u) ≤ 5 · 10⁻¹⁰ ℓ/s     then λ = λ_old
///
/// The exact solver takes a λ that is as good as that for an answer, too. What rests is answered so: nothing of it is
/// eliminated, factored or guessed.
#pragma once

#include "chapters/17_engine/island_rescue.hpp"

#include <limits>

namespace rigid {

struct ExactIslands : TreePart {
    std::vector<int> all;  ///< of the step's islands
    // Of the last sub-step.
    int answered = 0;         ///< of them
    std::vector<Real> known;  ///< residuals of those; of others NaN [m/s]

    /// Others than in the step before.
    void clear()
    {
        all.clear();
        known_ = false;
    }

    //! [open]
    /// \param enough  the tolerance to which others settle [m/s]
    void solve(const Islands& islands, Real enough, Bodies<3>& bodies,
               StepData<3>& now)
    {
        islands_ = &islands;
        bodies_ = &bodies;
        open_.clear();
        known.assign(static_cast<std::size_t>(islands.count()), nan);
        const Real good = std::min(solver.tolerance * now.length / 2, enough);
        for (const int i : all) {
            const std::span<const int> rows = islands.rows_of(i);
            push(now, rows, islands.bodies_of(i), bodies.u);
            now.visits += static_cast<std::int64_t>(rows.size());
            const Real r = natural_residual(now, rows, bodies.u);
            if (r <= good) known[static_cast<std::size_t>(i)] = r;
            else open_.push_back(i);
        }
        answered = static_cast<int>(all.size() - open_.size());
        take(open_, now);
        TreePart::solve(bodies, now);
    }
    //! [open]

    bool is_answered(int island) const
    {
        return !std::isnan(known[static_cast<std::size_t>(island)]);
    }

    /// Another problem on the same rows may be about any of them.
    void take_all(const StepData<3>& now)
    {
        if (is_part(all) || all.empty()) return;
        take(all, now);
        TreePart::factor_again(*bodies_, now);
    }

    /// The rows have another J.
    void factor_again(const Bodies<3>& bodies, const StepData<3>& now)
    {
        take(all, now);
        TreePart::factor_again(bodies, now);
    }

private:
    static constexpr Real nan = std::numeric_limits<Real>::quiet_NaN();

    bool is_part(const std::vector<int>& list) const
    {
        return known_ && taken_ == list;
    }
    /// These islands are the part.
    void take(const std::vector<int>& list, const StepData<3>& now)
    {
        if (is_part(list)) return;
        taken_ = list;
        known_ = true;
        solver.bounded.forget();  // it was of others
        solver.bounded_apart.forget();
        part.second.solution.lambda.setZero();
        part.clear();
        for (const int i : list)
            part.add(islands_->rows_of(i), islands_->bodies_of(i));
        part.number(now, bodies_->count());
    }

    std::vector<int> open_;
    std::vector<int> taken_;  ///< those of the part
    bool known_ = false;      ///< it is of islands of this step
    // of the step that is under way
    const Islands* islands_ = nullptr;
    const Bodies<3>* bodies_ = nullptr;
};

}  // namespace rigid
