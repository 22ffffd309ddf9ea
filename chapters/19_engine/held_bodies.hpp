/// \file held_bodies.hpp
/// The correction stage of the engine: chapter 15's, and a body whose state overflows is held where it was.
///
///     a number of x or u that is not finite, or above 10⁷⁵     →     x of before the sub-step, u = 0, no force and no impulses
///     an impulse that is not finite                            →     0
///
/// Sweeps that diverge, joints between masses too far apart, a velocity that a caller gave: a number may leave the range of
/// doubles. What is computed with it is NaN, and one NaN makes all of its island NaN in the next step. The fourth power of 10⁷⁵
/// is the largest that a contact or an inertia could make of it, and is finite.
#pragma once

#include "chapters/15_trees/geometric_stiffness.hpp"
#include "chapters/19_engine/driven_bodies.hpp"
#include "chapters/19_engine/kept_springs.hpp"

#include <algorithm>

namespace rigid {

//! [held]
struct HeldBodies : LoadedJoints {
    std::vector<int> held;  ///< in the last step, ascending
    DrivenBodies driven;    ///< of the next step

    template <class Scene>
    void rows(Scene& scene, const StepSettings& settings, StepData<3>& now)
    {
        if (now.substep == 0) held.clear();
        before_.resize(scene.bodies.x.size());
        for (const int k : now.active)
            before_.segment<3>(3 * k) = scene.bodies.position(k);
        driven.drive(scene.bodies, settings.substeps, now);
        LoadedJoints::rows(scene, settings, now);
        keep_springs(scene.bodies, settings.part(), now);
    }

    template <class Scene, class Solver>
    void move(Scene& scene, const StepSettings& settings, Solver& solver,
              StepData<3>& now)
    {
        LoadedJoints::move(scene, settings, solver, now);
        const std::size_t first = held.size();
        for (const int k : now.active) {
            if (is_in_range(scene.bodies, k)) continue;
            scene.bodies.position(k) = before_.segment<3>(3 * k);
            scene.bodies.velocity(k).setZero();
            scene.bodies.force(k).setZero();
            held.push_back(k);
        }
        if (held.size() == first && now.solution.lambda.allFinite()) return;
        forget_impulses(first, now);
        std::sort(held.begin(), held.end());
        held.erase(std::unique(held.begin(), held.end()), held.end());
    }
    //! [held]

private:
    static bool is_in_range(const Bodies<3>& bodies, Index k)
    {
        // false for NaN
        const auto small = [](const auto& v) {
            return (v.array().abs() <= largest_number).all();
        };
        return small(bodies.x.segment<3>(3 * k)) &&
               small(bodies.u.segment<3>(3 * k));
    }

    /// The next step would start from them. (A factor of joints between masses of 10¹²⁰ and 10⁻¹¹⁹ kg overflows,
    /// and leaves u as it was.)
    void forget_impulses(std::size_t first, StepData<3>& now) const
    {
        const auto is_held = [&](Index k) {
            return k != world &&
                   std::binary_search(held.begin() +
                                          static_cast<std::ptrdiff_t>(first),
                                      held.end(), static_cast<int>(k));
        };
        for (std::size_t i = 0; i < now.rows.size(); ++i) {
            Real& lambda = now.solution.lambda[static_cast<Index>(i)];
            if (is_held(now.rows[i].a) || is_held(now.rows[i].b) ||
                !std::isfinite(lambda))
                lambda = 0;
        }
    }

    VecX before_;  ///< x of the active bodies, before this sub-step
};

}  // namespace rigid
