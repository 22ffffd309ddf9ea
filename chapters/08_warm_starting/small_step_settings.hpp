/// \file small_step_settings.hpp
/// What small_steps() depends on, and which scenes it can step.
#pragma once

#include "chapters/03_mlcp_formulation/verification.hpp"
#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/08_warm_starting/best_multiple.hpp"
#include "common/forces.hpp"
#include "common/scenes.hpp"
#include "common/text.hpp"

#include <stdexcept>
#include <string>

namespace rigid {

struct SmallStepSettings {
    Real h = 1.0 / 60;  ///< time step [s]
    int substeps = 8;   ///< n
    int sweeps = 1;     ///< in each of them
    /// in the very first, which has no previous answer: at most, while a visit
    /// changes
    int first_sweeps = 1000;
    /// the velocity of its row by more than this [ℓ/s]
    Real first_tolerance = 1e-5;
    /// a contact gets its row when its gap is below this [ℓ]
    Real margin = 0.02;
    /// false: nothing ever touches, and no contact is looked for
    bool collides = true;
    /// neighbours in the order of the visits share no body
    bool coloured = true;
    /// Each substep starts from the best multiple of what the one before it left, or from nearly that: a pile that
    /// only just balances topples when all its loads change a little together.
    MultipleRule start = {0.2, 10};
    /// What corrects the error after the last substep: all of it (β = 1) beyond the slops. An overlap of half a
    /// millimetre is left alone: moving discs that nearly balance topples them.
    StabilizerSettings correction = {Stabilizer::projection, 1, 0.0005, 0, 3, 1, 0};
};

/// Throws std::invalid_argument, naming the setting or what the scene has, unless small_steps() can step this scene with
/// these settings.
inline void require_valid(const DiscScene& scene, const SmallStepSettings& settings)
{
    require_step(settings.h);
    require_bodies(scene);
    if (!scene.joints.empty())
        throw std::invalid_argument("the scene has " +
                                    std::to_string(scene.joints.size()) +
                                    " joints; small_steps() has none: take "
                                    "step() by WarmMethod with sub-steps");
    if (!scene.bends.empty())
        throw std::invalid_argument(
            "the scene has " + std::to_string(scene.bends.size()) +
            " bends; small_steps() has no torsional springs: take step() by "
            "WarmMethod with sub-steps");
    require_forces(scene.gravity, 0, 0, {0, 0});
    require_margin(settings.margin);
    require_valid(settings.correction);
    require_valid(settings.start);
    require_tolerance("the first sweeps", settings.first_tolerance);
    if (settings.substeps < 1 || settings.sweeps < 1)
        throw std::invalid_argument(
            "there are " + std::to_string(settings.substeps) + " substeps of " +
            std::to_string(settings.sweeps) + " sweeps; both must be 1 or more");
    if (settings.correction.method != Stabilizer::projection)
        throw std::invalid_argument(
            "the correction is " +
            std::string(to_string(settings.correction.method)) +
            "; small steps correct errors of position by projection alone");
    if (settings.correction.beta != 1)
        throw std::invalid_argument(
            "beta is " + shortest(settings.correction.beta) +
            "; small steps repay the whole error, so it must be 1");
    if (settings.correction.tolerance != 0)
        throw std::invalid_argument(
            "the tolerance of the corrections is " +
            shortest(settings.correction.tolerance) +
            "; small steps make all their correction sweeps, so it must be 0");
    if (!scene.segments.empty())
        throw std::invalid_argument("the scene has walls with ends; small steps "
                                    "take only half-spaces for walls, "
                                    "whose normals stay");
}

}  // namespace rigid
