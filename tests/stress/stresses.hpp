/// \file stresses.hpp
/// What the methods are put through: each stress has five levels, from harmless to absurd.
#pragma once

#include "common/random.hpp"
#include "tests/stress/judge.hpp"

#include <array>
#include <optional>

namespace rigid::stress {

inline constexpr int levels = 5;

template <class Scene>
struct StressOf {
    std::string name;                        ///< as in a table
    std::string what;                        ///< the scene and what is raised, in a sentence
    std::array<std::string, levels> values;  ///< what is raised, level by level, with unit
    /// What becomes of a method at a level under a perturbation; nothing where it does not apply.
    std::function<std::optional<Verdict>(const MethodOf<Scene>&, int level, std::uint64_t seed)> run;
    std::array<int, levels> seeds = {16, 16, 16, 16, 16};  ///< perturbations a cell
    bool quick = true;                                     ///< part of --quick, with two of them
};
using Stress = StressOf<DiscScene>;

std::vector<Stress> stresses();

/// The last of them but one: NaN and infinity in every number that a caller sets.
Stress bad_input();

/// What one seed changes: masses by up to 5 %, velocities by up to 1 mm/s. One run without it misleads: symmetry
/// hides what a breath would topple.
void perturb(DiscScene& scene, std::uint64_t seed);

/// The two scenes of a well-known comparison, at four sweeps: a box of 1000 times the mass, and a chain.
DiscScene loaded_column();
Task standing();
DiscScene slanted_chain(Index count, Real end_mass);
Task swinging();

/// Scenes whose exact energy never changes, ten seconds in steps of h: linkages without contacts.
struct Conserving {
    std::string name, what;
    DiscScene scene;
    Task task;
};
std::vector<Conserving> conserving_scenes(Real h);

/// Masses alone, by up to 5 %: a velocity must stay one that the rods allow.
void vary_masses(DiscScene& scene, std::uint64_t seed);

}  // namespace rigid::stress
