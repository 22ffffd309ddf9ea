/// \file rest_conditions.hpp
/// What a rest depends on besides the bodies themselves. When one of these numbers changes, all wake.
#pragma once

#include "chapters/07_baumgarte/stabilization.hpp"
#include "chapters/10_skipping_work/sleeping.hpp"

#include <tuple>

namespace rigid {

/// What determines which bodies are at rest, besides the settings of rest. When one of these numbers changes, all wake.
struct RestConditions {
    Vec2 gravity = {0, 0};
    Real stiffness = 0, damping = 0;
    RestSettings rest;
    StabilizerSettings correction;
    bool sleep = true;
};

/// True if bodies at rest under the conditions `a` are so under `b`. (The step h is not compared: rest is a balance of
/// forces. Nor is what says how the balance is found.)
inline bool same_rest(const RestConditions& a, const RestConditions& b)
{
    const auto correction = [](const StabilizerSettings& s) {
        return std::tuple(s.method, s.beta, s.slop, s.bilateral_slop,
                          s.max_correction_speed);
    };
    return a.gravity == b.gravity && a.stiffness == b.stiffness &&
           a.damping == b.damping &&
           correction(a.correction) == correction(b.correction) &&
           a.rest == b.rest && a.sleep == b.sleep;
}

}  // namespace rigid
