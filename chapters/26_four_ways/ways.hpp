/// \file ways.hpp
/// The ways to say a constraint, by name, on any scene of chapter 14: one step each, or one sentence why not.
///
///     spring        f = −(k C + c dC/dt) at the start of the step          spring_forces.hpp
///     end spring    the same at its end: soft rows                         spring_forces.hpp, chapter 16
///     acceleration  d²C/dt² = 0, ≥ 0; order four between events            acceleration_level.hpp
///     single        impulses one at a time                                 single_impulses.hpp
///     impulses      J u + b = 0, ≥ 0, all at once: chapters 3 to 15        JointTrees
///     positions     C(x) = 0, ≥ 0, row by row: chapter 16                  XPBD
///     coordinates   C is not there                                         reduced_motion.hpp
#pragma once

#include "chapters/26_four_ways/way_scenes.hpp"

#include <memory>
#include <string_view>

namespace rigid {

//! [way]
enum class Way {
    spring,
    end_spring,
    acceleration,
    single,
    impulses,
    positions,
    coordinates
};
inline constexpr std::array all_ways{
    Way::spring,   Way::end_spring, Way::acceleration, Way::single,
    Way::impulses, Way::positions,  Way::coordinates};

constexpr std::string_view to_string(Way way)
{
    constexpr std::string_view names[] = {
        "spring",   "end_spring", "acceleration", "single",
        "impulses", "positions",  "coordinates"};
    return names[static_cast<std::size_t>(way)];
}
//! [way]

struct WaySettings {
    Real stiffness = 1e5;  ///< of springs [N/m]
    int sweeps = 20;       ///< of positions, in a step
};

/// Throws std::invalid_argument, naming the setting and its value, unless both make sense.
void require_valid(const WaySettings& settings);

/// One scene under one way, alive. Steps depend on nothing else.
class WayRun {
public:
    /// Throws std::invalid_argument with the sentence why the way cannot take this scene, or what makes no sense in it or in
    /// the settings.
    WayRun(Way way, const WayScene& scene, const WaySettings& settings);
    ~WayRun();
    WayRun(WayRun&&) noexcept;

    /// Advances by h seconds. Anything but `solved` says that the constraints have no answer by this way: the scene is where it
    /// was when that was found. Springs and positions solve nothing; they say `solved` as long as the state is finite.
    Status advance(Real h);

    const JointedScene& scene() const { return scene_; }

    /// What is behind it.
    struct Stepper;

private:
    JointedScene scene_;
    std::unique_ptr<Stepper> stepper_;
};

/// Why a way cannot take a scene, in its own sentence; empty: it can.
std::string refusal(Way way, const WayScene& scene);
inline bool can_take(Way way, const WayScene& scene)
{
    return refusal(way, scene).empty();
}

/// How far its constraints are from what they say: the largest over all joints and closed contacts.
struct WayDrift {
    Real C = 0;     ///< a joint's error, an overlap [m, rad]
    Real rate = 0;  ///< dC/dt of joints, an approach of contacts [m/s, rad/s]
};
WayDrift drift_of(const WayScene& way, const JointedScene& scene);

/// What a run of a scene came to.
struct WayResult {
    Real error = infinity;  ///< of WayScene::error
    WayDrift drift;         ///< at the end
    Real energy_gain =
        0;  ///< over what there was of kinetic and potential energy to lose at the start
    std::string why_not;  ///< the sentence; empty: it went through
};

/// Steps a run to the time of its scene, in so many steps. Returns the sentence why it could not, empty if it could.
/// \throws std::invalid_argument  for a time that is not positive, or no step
std::string advance_to_end(WayRun& run, const WayScene& scene, int steps);

/// What came of a scene that was run to its time.
/// \param end  its state there
/// \throws std::invalid_argument  if the scene does not say how its error is measured
WayResult result_of(const WayScene& scene, const JointedScene& end);

/// How many steps of h lead to the time of a scene, all a little shorter where h does not fit.
/// \throws std::invalid_argument  for a step or a time that is not positive, and for more than 10⁹ steps
int steps_of(const WayScene& scene, Real h);

/// Runs a scene to its time in steps of h.
WayResult run_way(Way way, const WayScene& scene, Real h,
                  const WaySettings& settings);

/// Its springs, and twenty sweeps.
inline WaySettings settings_of(const WayScene& scene)
{
    return {scene.stiffness, 20};
}

}  // namespace rigid
