/// \file stresses.hpp
/// What the methods are put through: each stress has five levels, from harmless to absurd.
#pragma once

#include "common/random.hpp"
#include "tests/stress/judge.hpp"

#include <array>
#include <optional>

namespace rigid::stress {

inline constexpr int levels = 5;

struct Stress {
    std::string name;                        ///< as in a table
    std::string what;                        ///< the scene and what is raised, in a sentence
    std::array<std::string, levels> values;  ///< what is raised, level by level, with unit
    /// The score of a method at a level under a perturbation; nothing where it does not apply.
    std::function<std::optional<int>(const Method&, int level, std::uint64_t seed)> run;
    bool quick = true;  ///< part of --quick
};

std::vector<Stress> stresses();

}  // namespace rigid::stress
