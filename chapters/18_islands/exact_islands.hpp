/// \file exact_islands.hpp
/// An island that is solved exactly, and what it need not be solved for.
///
///     u = u* + M⁻¹ Jᵀ λ_old,     r(λ_old, u) ≤ 5 · 10⁻¹⁰ ℓ/s     then λ = λ_old
///
/// The exact solver takes a λ that is as good as that for an answer, too. What rests is neither eliminated, factored nor
/// guessed.
#pragma once

#include "chapters/18_islands/island_rescue.hpp"

namespace rigid {

struct ExactIsland : TreePart {
    bool answered = false;  ///< by its old impulses, in the last sub-step
    Real residual = 0;      ///< then [m/s]

    //! [answered]
    /// \param enough  the tolerance to which others settle [m/s]
    void solve(Real enough, Bodies<3>& bodies, StepData<3>& now)
    {
        std::span<const int> members(bodies_of_island_);
        push(now, part.rows, members, bodies);
        part.visits += static_cast<std::int64_t>(part.rows.size());
        residual = natural_residual(now, part.rows, bodies.u);
        answered = residual <= std::min(solver.tolerance * now.length / 2, enough);
        is_fresh_ = !answered;
        if (!answered) TreePart::solve(bodies, now);
    }
    //! [answered]

    void take(const Islands& islands, int island, const StepData<3>& now,
              Index count, PartNumbers& numbers)
    {
        const std::span<const int> members = islands.bodies_of(island);
        bodies_of_island_.assign(members.begin(), members.end());
        part.take(islands.rows_of(island), members, now, count, numbers);
        answered = false;
    }

    /// Another problem on the same rows needs their factors.
    void refresh(const Bodies<3>& bodies, const StepData<3>& now)
    {
        if (is_fresh_) return;
        part.gather(bodies, now);
        solver.factor_again(part.local, part.now);
        is_fresh_ = true;
    }
    void factor_again(const Bodies<3>& bodies, const StepData<3>& now)
    {
        refresh(bodies, now);
        TreePart::factor_again(bodies, now);
    }

private:
    std::vector<int> bodies_of_island_;  ///< that can move
    bool is_fresh_ = false;              ///< part and factors are of this sub-step
};

}  // namespace rigid
