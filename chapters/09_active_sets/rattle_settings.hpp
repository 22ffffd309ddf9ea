/// \file rattle_settings.hpp
/// How exactly RATTLE meets its positions, and which of them it does not ask for.
#pragma once

#include "chapters/03_mlcp_formulation/step_data.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {

struct RattleSettings {
    /// C is to be met to this [ℓ]; never less than what rounding makes
    Real tolerance = 1e-12;
    int max_iterations = 50;  ///< of Newton's method in a sub-step
};

/// Throws std::invalid_argument, naming the setting and its value, unless both make sense.
inline void require_valid(const RattleSettings& settings)
{
    if (!(settings.tolerance > 0) || !std::isfinite(settings.tolerance))
        throw std::invalid_argument("the tolerance of the positions is " +
                                    shortest(settings.tolerance) +
                                    "; it must be positive and finite");
    if (settings.max_iterations < 1)
        throw std::invalid_argument("max_iterations of the positions is " +
                                    std::to_string(settings.max_iterations) +
                                    "; it must be 1 or more");
}

//! [turns_too_far]
/// A contact of a body that turns by more than a radian in the (sub-)step: its
/// corner comes by the surface more than once, and a λ that puts it there after the
/// step may do any work. Such a row keeps to its velocity. (Discs do not turn.)
template <int Dof>
bool turns_too_far(const Row<Dof>& row, ConstraintKind kind,
                   const StepData<Dof>& now)
{
    constexpr int angles = Dof == 2 ? 0 : Dof / 2;
    const auto turn = [&now](Index k) -> Real {
        if (k == world) return 0;
        return now.h * now.u_star.template segment<Dof>(Dof * k)
                           .template tail<angles>()
                           .norm();
    };
    return kind == ConstraintKind::unilateral &&
           std::max(turn(row.a), turn(row.b)) > 1;
}
//! [turns_too_far]

}  // namespace rigid
