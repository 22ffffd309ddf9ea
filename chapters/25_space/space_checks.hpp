/// \file space_checks.hpp
/// What is refused of a scene in space: a sentence names the thing and its value.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/25_space/joint_coordinates.hpp"
#include "chapters/25_space/space_contact.hpp"

namespace rigid {

/// Throws std::invalid_argument, naming the setting, unless the settings of a step make sense in space.
void require_valid(const StepSettings& settings, const Vec3& gravity, Index bodies);

/// What a step looks at each time. Throws std::invalid_argument, with a sentence that names the thing, unless it makes
/// sense.
void require_bodies(const SpaceScene& scene);

/// The same for what touches: walls and coefficients of friction.
void require_touching(const SpaceScene& scene);

}  // namespace rigid
