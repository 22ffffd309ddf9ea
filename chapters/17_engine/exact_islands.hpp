/// \file exact_islands.hpp
/// The islands of a step that are solved exactly, and what they need not be solved for.
///
///     u = u* + M⁻¹ Jᵀ λ_old,     r(λ_old, u) ≤ 5 · 10⁻¹⁰ ℓ/s in each of them     then λ = λ_old
///
/// The exact solver takes a λ that is as good as that for an answer, too. Where all rest nothing is eliminated, factored or
/// guessed.
#pragma once

#include "chapters/17_engine/island_rescue.hpp"

namespace rigid {

struct ExactIslands : TreePart {
    std::vector<int> all;   ///< of the islands of the step
    bool answered = false;  ///< by their old impulses, in the last sub-step

    void clear()
    {
        all.clear();
        part.clear();
        answered = false;
    }
    void add(const Islands& islands, int island)
    {
        all.push_back(island);
        part.add(islands.rows_of(island), islands.bodies_of(island));
    }

    //! [answered]
    /// \param enough  the tolerance to which others settle [m/s]
    void solve(const Islands& islands, Real enough, Bodies<3>& bodies,
               StepData<3>& now)
    {
        const Real good = std::min(solver.tolerance * now.length / 2, enough);
        residuals_.resize(static_cast<std::size_t>(islands.count()));
        answered = !all.empty();
        bodies_ = &bodies;
        for (const int i : all) {
            const std::span<const int> rows = islands.rows_of(i);
            push(now, rows, islands.bodies_of(i), bodies);
            now.visits += static_cast<std::int64_t>(rows.size());
            const Real r = natural_residual(now, rows, bodies.u);
            residuals_[static_cast<std::size_t>(i)] = r;
            answered = r <= good;
            if (!answered) break;
        }
        is_fresh_ = !answered;
        if (!answered) TreePart::solve(bodies, now);
    }
    //! [answered]

    /// The residual of an island that is answered [m/s]
    Real residual(int island) const
    {
        return residuals_[static_cast<std::size_t>(island)];
    }

    /// Another problem on the same rows needs their factors.
    void refresh(const StepData<3>& now)
    {
        if (is_fresh_ || !bodies_ || part.empty()) return;
        part.gather(*bodies_, now);
        solver.factor_again(part.local, part.now);
        is_fresh_ = true;
    }
    void factor_again(const Bodies<3>& bodies, const StepData<3>& now)
    {
        refresh(now);
        TreePart::factor_again(bodies, now);
    }

private:
    std::vector<Real> residuals_;
    const Bodies<3>* bodies_ = nullptr;  ///< of the sub-step under way
    bool is_fresh_ = false;              ///< part and factors are of this sub-step
};

}  // namespace rigid
