/// \file stepping.hpp
/// A method of the one step as a column of the stability matrix, and which of its settings can be spoilt.
#pragma once

#include "chapters/07_baumgarte/corrected_method.hpp"
#include "chapters/09_active_sets/rattle.hpp"
#include "tests/stress/columns.hpp"

namespace rigid::stress {

inline void add_settings(std::vector<Setting>& all, LeaveErrors& c)
{
    all.push_back({"restitution", &c.restitution});
    all.push_back(or_infinity("threshold", &c.threshold));
}

inline void add_settings(std::vector<Setting>& all, Correction& c)
{
    all.push_back({"restitution", &c.restitution});
    all.push_back(or_infinity("threshold", &c.threshold));
    all.push_back({"beta", &c.beta});
    all.push_back({"slop", &c.slop});
    all.push_back({"bilateral_slop", &c.bilateral_slop});
    all.push_back(or_infinity("max_correction_speed", &c.max_correction_speed));
    all.push_back(or_infinity("correction tolerance", &c.tolerance));
}

inline void add_settings(std::vector<Setting>& all, Rattle& c)
{
    all.push_back({"restitution", &c.restitution});
    all.push_back(or_infinity("threshold", &c.threshold));
    all.push_back({"position tolerance", &c.tolerance});
}

/// All settings of a method that are numbers.
template <class Scene, class Solving>
std::vector<Setting> settings_of(Scene& scene, StepSettings& settings, Solving& by)
{
    std::vector<Setting> all = step_settings(scene, settings);
    if constexpr (requires { add_settings(all, by.correction); }) add_settings(all, by.correction);
    if constexpr (requires { by.start.factor; }) all.push_back({"warm start factor", &by.start.factor});
    if constexpr (requires { by.solver.sweeps.tolerance; })
        all.push_back(or_infinity("tolerance", &by.solver.sweeps.tolerance));
    if constexpr (requires { by.solver.find.settings.tolerance; })
        all.push_back(or_infinity("exactness", &by.solver.find.settings.tolerance));
    if constexpr (requires { by.contacts.slack; }) all.push_back({"slack", &by.contacts.slack});
    if constexpr (requires { by.contacts.stay; }) {
        all.push_back({"stay", &by.contacts.stay});
        all.push_back({"skin", &by.contacts.finder.skin});
    }
    return all;
}

/// \param by        the method as it is before the wish
/// \param substeps  of each step
/// \param honest    honest(by, now) throws SilentError for an answer that calls itself solved and isn't
/// \tparam Scene    whatever a stress has; Inner: the part of it that the method steps
template <class Scene = DiscScene, class Inner = Scene, class Solving, class Honest>
MethodOf<Scene> stepping(int chapter, const std::string& name, const std::string& budget, const Solving& by,
                         int substeps, const Honest& honest)
{
    MethodOf<Scene> method;
    method.chapter = chapter;
    method.name = name;
    method.budget = budget;
    method.has_restitution = requires { by.correction.restitution; };
    if constexpr (requires {
                      by.correction.beta;
                      by.correction.method;
                  })
        method.has_beta = by.correction.method != Stabilizer::none;
    {
        Scene scene;
        StepSettings settings;
        Solving names = by;
        method.settings = names_of(settings_of(scene, settings, names));
    }
    method.start = [=](const std::shared_ptr<const Wish>& wish) {
        struct Memory {
            Solving by;
            StepData<Scene::dof> now;
            Honest honest;
        };
        const auto memory = std::make_shared<Memory>(Memory{by, {}, honest});
        return checked<Scene>([=](Scene& scene, Real h) {
            const GravityGuard guard(scene);
            StepSettings settings{.h = h, .substeps = substeps};
            Solving& solving = memory->by;
            if constexpr (requires { solving.correction.restitution; })
                solving.correction.restitution = std::max(Real{0}, wish->restitution);
            if constexpr (requires {
                              solving.correction.beta;
                              solving.correction.method;
                          })
                solving.correction.beta = wish->beta >= 0 ? wish->beta : by.correction.beta;
            const std::vector<Setting> all = settings_of(scene, settings, solving);
            std::vector<Real> before;
            for (const Setting& setting : all) before.push_back(*setting.value);
            spoil(*wish, all, settings);
            if constexpr (Scene::dof == 6) settings.pulled = world;  // which space refuses by itself
            try {
                step(static_cast<Inner&>(scene), settings, solving, memory->now);
            } catch (...) {  // the next step is to find the settings as they were
                for (std::size_t i = 0; i < all.size(); ++i) *all[i].value = before[i];
                throw;
            }
            for (std::size_t i = 0; i < all.size(); ++i) *all[i].value = before[i];
            memory->honest(solving, memory->now);
        });
    };
    return method;
}

/// How a method spends its sweeps.
struct Spending {
    Stabilizer correction = Stabilizer::baumgarte;
    int sweeps = 10, correcting = 0, substeps = 1;
    Real max_correction_speed = infinity;  ///< [m/s]
    Real beta = 0.2;
};

inline Correction correction_of(const Spending& spending)
{
    Correction correction;
    correction.method = spending.correction;
    correction.beta = spending.beta;
    correction.max_correction_speed = spending.max_correction_speed;
    correction.correction_sweeps = spending.correcting;
    return correction;
}

inline std::string budget(const Spending& s)
{
    std::string words = std::to_string(s.sweeps * s.substeps);
    if (s.correcting > 0) words += " + " + std::to_string(s.correcting * s.substeps);
    words += " sweeps";
    return s.substeps > 1 ? words + " in " + std::to_string(s.substeps) + " substeps" : words;
}

}  // namespace rigid::stress
