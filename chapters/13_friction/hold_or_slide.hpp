/// \file hold_or_slide.hpp
/// Two coefficients: μ_s for a contact that holds, μ_k for one that slides.
///
///     |λ_t| ≤ μ λ_n,   μ = μ_s if it held in the step before,   μ = μ_k if it slid                    (13.15)
///     slides: |w_t| > creep  and  |λ_t − w_t / A_tt| ≥ μ λ_n                                          (13.16)
///
/// The law has a memory, and so has this: for each contact, by its key, whether it slid. What slid and would turn around
/// passes through rest, where μ_s counts: then the step is solved once more.
#pragma once

#include "chapters/08_warm_starting/warm_start.hpp"
#include "chapters/13_friction/surfaces.hpp"

namespace rigid {

/// A contact whose friction depends on whether it slides.
struct Slider {
    ImpulseKey key;
    std::size_t row = 0;  ///< its tangent row
    bool slides = false;
    Real before = 0;  ///< how fast it slid before the impulses [m/s]
};

//! [hold_or_slide]
/// A solver stage that chooses between μ_s and μ_k; the rest is left to `Solver`.
template <class Solver>
struct HoldOrSlide : Solver {
    static constexpr bool knows_sliding = true;

    /// what is slower than this is at rest [ℓ/s]: exact answers leave 1e-10 of it,
    /// sweeps that are not finished a good deal more
    Real creep = Solver::is_exact ? 1e-8 : 1e-4;

    std::vector<Slider> sliders, known;  ///< of this step, and of the one before

    void require_valid() const
    {
        Solver::require_valid();
        if (!(creep >= 0 && creep < infinity))
            throw std::invalid_argument(
                "the speed of creeping is " + shortest(creep) +
                " lengths of the scene a second; it must be zero or positive, and "
                "finite");
    }

    template <int Dof>
    void solve(Bodies<Dof>& bodies, StepData<Dof>& now)
    {
        // RATTLE solves twice in a sub-step
        const bool begins = now.substep == 0 && !now.second_half;
        if (begins) list_sliders(bodies, now);
        for (Slider& slider : sliders)
            slider.before = now.rows[slider.row].velocity(bodies.u);
        // one that is solved again counts once
        const int failed = begins ? 0 : this->unsolved;
        set_coefficients(now);
        Solver::solve(bodies, now);
        // Each round has one slider less that slides, so this ends.
        while (some_turn_around(bodies, now)) {
            this->unsolved = failed;
            set_coefficients(now);
            Solver::solve(bodies, now);
        }
        for (Slider& slider : sliders) slider.slides = slides(slider, bodies, now);
    }
    //! [hold_or_slide]

private:
    /// The sliders of this step. One that was there before is what it was; a new one
    /// slides if its surfaces do.
    template <int Dof>
    void list_sliders(const Bodies<Dof>& bodies, const StepData<Dof>& now)
    {
        std::swap(sliders, known);
        sliders.clear();
        const auto ascending = [](const Slider& a, const Slider& b) {
            return a.key < b.key;
        };
        if (!std::is_sorted(known.begin(), known.end(), ascending))
            std::sort(known.begin(), known.end(), ascending);
        for (std::size_t i = 0; i < now.constraints.size(); ++i) {
            if (!(now.constraints[i].weakening > 0)) continue;
            Slider slider{key_of(now.sources[i], now.contacts), i};
            const auto old =
                std::lower_bound(known.begin(), known.end(), slider, ascending);
            slider.slides =
                old != known.end() && old->key == slider.key
                    ? old->slides
                    : std::abs(now.rows[i].velocity(bodies.u)) > creep * now.length;
            sliders.push_back(slider);
        }
    }

    /// (13.15)
    template <int Dof>
    void set_coefficients(StepData<Dof>& now) const
    {
        for (const Slider& slider : sliders) {
            const Constraint<Dof>& c = now.constraints[slider.row];
            now.rows[slider.row].friction =
                c.friction - (slider.slides ? c.weakening : 0);
        }
    }

    /// Whether something that slid slides the other way now: it is at rest between.
    template <int Dof>
    bool some_turn_around(const Bodies<Dof>& bodies, const StepData<Dof>& now)
    {
        bool some = false;
        for (Slider& slider : sliders) {
            if (!slider.slides) continue;
            const Real after = now.rows[slider.row].velocity(bodies.u);
            if (!(std::abs(after) > creep * now.length &&
                  (after > 0) != (slider.before > 0) && slider.before != 0))
                continue;
            slider.slides = false;
            some = true;
        }
        return some;
    }

    /// (13.16): by the λ and the w of the answer.
    template <int Dof>
    bool slides(const Slider& slider, const Bodies<Dof>& bodies,
                const StepData<Dof>& now) const
    {
        const Row<Dof>& row = now.rows[slider.row];
        const VecX& lambda = now.solution.lambda;
        const Real w = row.velocity(bodies.u), A = row.diagonal();
        const Real points =
            lambda[static_cast<Index>(slider.row)] - (A > 0 ? w / A : 0);
        return std::abs(w) > creep * now.length &&
               std::abs(points) >= bounds_of(row, lambda).second;
    }
};

/// Throws std::invalid_argument where the method does not know whether a contact slides.
inline void refuse_kinetic_friction(const RoughScene& scene)
{
    if (has_kinetic_friction(scene))
        throw std::invalid_argument(
            "a surface has another friction coefficient while it slides; of the "
            "solvers only HoldOrSlide takes it, the methods of chapter 13");
}

}  // namespace rigid
