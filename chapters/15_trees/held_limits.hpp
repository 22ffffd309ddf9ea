/// \file held_limits.hpp
/// Limits of joints that may not be overstepped while the joints alone are met.
#pragma once

#include "chapters/15_trees/newton_settings.hpp"

#include <limits>

namespace rigid {

//! [held]
/// A limb that goes back on its pin would turn through a limit that is near:
/// meanwhile the limit is a row without bounds, which pulls, too.
struct HeldLimits {
    static constexpr Real near = 0.1;  ///< limits nearer than this [rad]
    std::vector<int> rows;             ///< that are held

    template <class Scene>
    void hold(const Scene& scene, std::span<const int> of, StepData<3>& now)
    {
        for (const int i : of) {
            const auto at = static_cast<std::size_t>(i);
            Constraint<3>& c = now.constraints[at];
            if (c.kind != ConstraintKind::unilateral || !is_angle(c)) continue;
            c = constraint_at(scene, now, at, scene.bodies.x);
            const bool other =
                !rows.empty() && rows.back() == i - 1;  // of one joint
            if (c.C > near || other) continue;
            now.rows[at].lo = -infinity;
            rows.push_back(i);
        }
    }
    void let_go(StepData<3>& now)
    {
        for (const int i : rows) now.rows[static_cast<std::size_t>(i)].lo = 0;
        rows.clear();
    }
};
//! [held]

}  // namespace rigid
