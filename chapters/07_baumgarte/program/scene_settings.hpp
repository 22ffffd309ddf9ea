/// \file scene_settings.hpp
/// What all scenes of discs of this chapter share: what the reader may change, what is measured, and a budget of row
/// visits that all ways to correct share.
#pragma once

#include "chapters/03_mlcp_formulation/program/columns.hpp"
#include "chapters/04_pgs/program/tunables.hpp"
#include "chapters/07_baumgarte/corrected_method.hpp"

#include <algorithm>
#include <string>
#include <vector>

namespace rigid {

inline std::vector<std::string> stabilizer_names()
{
    return {"baumgarte", "none", "relaxation", "split_impulse", "projection"};
}

inline Stabilizer stabilizer_named(const std::string& name)
{
    for (const Stabilizer method :
         {Stabilizer::none, Stabilizer::relaxation, Stabilizer::split_impulse,
          Stabilizer::projection})
        if (name == to_string(method)) return method;
    return Stabilizer::baumgarte;
}

/// What the reader may change in every scene of discs.
inline std::vector<Tunable> stabilizer_tunables(Real sweeps)
{
    return {tunables::beta(0.2, 2.5, Keys::up_and_down),
            tunables::whole(
                "sweeps",
                "sweeps of a step in total; substeps and the correction share them",
                sweeps, 1, 512),
            tunables::substeps(128),
            tunables::number(
                "factor", "",
                "part of the impulses that the next substep starts from", 0, 0, 1),
            tunables::slop(),
            tunables::number("correction_speed", "m/s",
                             "an error is corrected at this speed at most", 1000,
                             0.01, 1000),
            tunables::margin(0),
            tunables::row_order()};
}

/// The settings of a step and its method. A budget of S sweeps a step is spent on n substeps of S/n sweeps, and half
/// of those correct positions where that takes sweeps of its own; each gets one at least.
inline void stabilized_settings(const Settings& settings, StepSettings& step,
                                CorrectedMethod& method)
{
    step.h = settings.h;
    step.margin = settings["margin"];
    step.substeps = static_cast<int>(settings["substeps"]);
    method.start.factor = settings["factor"];
    method.solver.ordering =
        static_cast<Order>(static_cast<int>(settings["order"]));
    Correction& correction = method.correction;
    correction.method = stabilizer_named(settings.method);
    correction.beta = settings["beta"];
    correction.slop = settings["slop"];
    correction.max_correction_speed = settings["correction_speed"];
    const int passes = correction.method == Stabilizer::none ||
                               correction.method == Stabilizer::baumgarte
                           ? 1
                           : 2;
    const int sweeps =
        static_cast<int>(settings["sweeps"]) / (step.substeps * passes);
    method.solver.sweeps.max_sweeps = correction.correction_sweeps =
        std::max(1, sweeps);
}

inline std::vector<Measured<RunState<CorrectedMethod>>> stabilized_columns()
{
    return {columns::link_error(),
            columns::penetration(),
            columns::theory<CorrectedMethod>(
                "m",
                "what a formula of this chapter foretells for the scene; 0 = none"),
            columns::highest(),
            columns::speed(),
            columns::energy_gained(),
            columns::contacts(),
            columns::row_visits()};
}

}  // namespace rigid
