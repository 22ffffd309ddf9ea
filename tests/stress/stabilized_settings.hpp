/// \file stabilized_settings.hpp
/// What a step of chapters 6 to 9 is told in the stability matrix, and which of it can be spoilt.
#pragma once

#include "chapters/07_baumgarte/stabilized_step.hpp"
#include "tests/stress/columns.hpp"

namespace rigid::stress {

inline std::vector<Setting> impulse_settings(ImpulseStepSettings& s)
{
    std::vector<Setting> all = step_settings(s);
    all.push_back({"restitution", &s.restitution, false});
    all.push_back({"threshold", &s.threshold, true});
    all.push_back({"tolerance", &s.sweeps.tolerance, true});
    return all;
}

inline std::vector<Setting> stabilized_settings(StabilizedStepSettings& s)
{
    std::vector<Setting> all = impulse_settings(s);
    all.push_back({"beta", &s.stabilizer.beta, false});
    all.push_back({"slop", &s.stabilizer.slop, false});
    all.push_back({"bilateral_slop", &s.stabilizer.bilateral_slop, false});
    all.push_back({"fastest", &s.stabilizer.fastest, true});
    all.push_back({"repaying tolerance", &s.stabilizer.tolerance, true});
    all.push_back({"carry", &s.carry, false});
    return all;
}

/// How a method spends its sweeps.
struct Spending {
    Stabilizer stabilizer = Stabilizer::baumgarte;
    int sweeps = 10, repaying = 0, substeps = 1;
    Real fastest = infinity;  ///< [m/s]
    Real beta = 0.2;
};

template <class Settings>
Settings settings_for(const DiscScene& scene, Real h, const Wish& wish, const Spending& spending)
{
    Settings settings;
    settings.h = h;
    settings.gravity = scene.gravity;
    settings.restitution = std::max(Real{0}, wish.restitution);
    settings.sweeps.max_sweeps = spending.sweeps;
    settings.stabilizer.method = spending.stabilizer;
    settings.stabilizer.beta = wish.beta >= 0 ? wish.beta : spending.beta;
    settings.stabilizer.fastest = spending.fastest;
    settings.stabilizer.repaying_sweeps = spending.repaying;
    settings.substeps = spending.substeps;
    return settings;
}

inline std::string budget(const Spending& s)
{
    std::string words = std::to_string(s.sweeps * s.substeps);
    if (s.repaying > 0) words += " + " + std::to_string(s.repaying * s.substeps);
    words += " sweeps";
    return s.substeps > 1 ? words + " in " + std::to_string(s.substeps) + " substeps" : words;
}

}  // namespace rigid::stress
