/// \file tasks.hpp
/// What the stresses of all matrices are made of: values with their units, and tasks.
#pragma once

#include "common/text.hpp"
#include "tests/stress/stresses.hpp"

namespace rigid::stress {

using Values = std::array<Real, levels>;
using Seeds = std::array<int, levels>;

inline std::array<std::string, levels> with_units(const Values& values, const std::string& unit)
{
    std::array<std::string, levels> words;
    for (std::size_t i = 0; i < levels; ++i) words[i] = with_unit(readable(values[i]), unit);
    return words;
}
/// The steps that are taken so often in a second.
inline std::array<std::string, levels> steps_of(const Values& per_second)
{
    std::array<std::string, levels> words;
    for (std::size_t i = 0; i < levels; ++i) words[i] = "1/" + readable(per_second[i]) + " s";
    return words;
}

/// A stress that builds its scene from the value of a level.
/// \param run  std::optional<Verdict>(const MethodOf<Scene>&, Real value, std::uint64_t seed)
template <class Scene, class Run>
StressOf<Scene> stress_over(const std::string& name, const std::string& what, const Values& values,
                            const std::string& unit, const Seeds& seeds, const Run& run)
{
    StressOf<Scene> stress{name, what, with_units(values, unit),
                           [=](const MethodOf<Scene>& method, int level, std::uint64_t seed) {
                               return run(method, values[static_cast<std::size_t>(level)], seed);
                           }};
    stress.seeds = seeds;
    return stress;
}

inline Task standing_on(Real size = 1)
{
    Task task;
    task.size = size;
    task.upright = true;
    return task;
}

inline Task moving(Real size = 1)
{
    Task task;
    task.size = size;
    task.rests = false;
    return task;
}

}  // namespace rigid::stress
