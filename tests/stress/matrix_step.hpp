/// \file matrix_step.hpp
/// Chapter 3's step with a solver of the whole MLCP, as a column of the stability matrix.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "tests/stress/columns.hpp"

namespace rigid::stress {

/// Spoils the settings of a solver; `first` of the method's settings are those of the step.
inline void spoil_solver(const Wish& wish, int first, const std::vector<Setting>& settings)
{
    if (wish.setting >= first)
        *settings.at(static_cast<std::size_t>(wish.setting - first)).value = wish.spoilt;
}

/// \param own       settings of the solver, their names
/// \param make      makes a solver: void(const Mlcp&, const Wish&, int first, Solution&)
template <class Make>
Method matrix_method(int chapter, const std::string& name, const std::string& budget,
                     const std::vector<Setting>& own, Make make)
{
    Method method;
    method.chapter = chapter;
    method.name = name;
    method.budget = budget;
    method.settings = step_setting_names();
    const int first = static_cast<int>(method.settings.size());
    method.settings.insert(method.settings.end(), own.begin(), own.end());
    method.start = [make, first](const std::shared_ptr<const Wish>& wish) {
        const auto now = std::make_shared<StepData<2>>();
        const auto solver = std::make_shared<decltype(make())>(make());
        return checked([=](DiscScene& scene, Real h) {
            const GravityGuard guard(scene);
            StepSettings settings{.h = h};
            if (wish->setting < first) spoil(*wish, step_settings(scene, settings), settings);
            const auto solve = [&](const Mlcp& mlcp, Solution& solution) {
                (*solver)(mlcp, *wish, first, solution);
            };
            auto by_solver = by_matrix(solve);
            step(scene, settings, by_solver, *now);
            require_honest(by_solver.solver.mlcp, now->solution);
        });
    };
    return method;
}

}  // namespace rigid::stress
