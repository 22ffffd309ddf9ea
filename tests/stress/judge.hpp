/// \file judge.hpp
/// How well a method held a scene: 3 within the accuracy tolerance; 2 the scene holds (gaps below 5 % of a size,
/// order kept); 1 finite and not above the energy of its start by more than 1 %, but the task failed; 0 not a number, an
/// explosion, a method that cannot go on, or an answer that calls itself right and isn't.
///
/// Where the exact motion keeps its energy both signs count: 3 within 1 %, 2 within 10 %, 1 more is lost, 0 more is
/// gained.
#pragma once

#include "common/measure.hpp"
#include "tests/stress/method.hpp"

#include <algorithm>
#include <cmath>
#include <type_traits>

namespace rigid {
struct RoughScene;
struct JointedScene;
struct SpaceScene;
}  // namespace rigid

namespace rigid::stress {

inline constexpr int lost = 0, failed = 1, held = 2, accurate = 3;

/// What a scene should do, and for how long it is watched.
struct Task {
    Real h = 1.0 / 60;       ///< [s]
    long steps = 120;        ///< two seconds at 60 Hz
    Real size = 0.2;         ///< of a disc or a link: gaps are measured by it [m]
    bool rests = true;       ///< it is to come to rest: no disc faster than 1 cm/s in the second half
    bool upright = false;    ///< the discs stand above each other in the order of their numbers
    Real energy = 0;         ///< by which a gain of energy is measured [J]; 0 = lifting()
    Real gap = 0;            ///< a gap that the scene itself makes unavoidable [m]
    bool conserves = false;  ///< the exact motion keeps its energy: a loss counts as a gain does
    Real from = 0.5;         ///< the part of the run after which gaps and speeds are looked at
    // Of bodies that turn alone.
    bool stays = false;  ///< every body is to stay where it is: how far it is from there is a gap
    /// no centroid is to leave this box about the origin, half its sides [m]
    Vec2 inside = {infinity, infinity};
    Real lift =
        0;  ///< energy that the scene cannot but gain, since its bodies have to make room for each other [J]
};

struct Verdict {
    int score = accurate;
    std::string why = "";  ///< why it is not more
    Real gap = 0;          ///< the largest one of the second half [m]
    Real gain = 0;         ///< of energy at worst, as a share of what it is measured by
    Real loss = 0;         ///< the same downwards
    bool through = false;  ///< a body left the place that it cannot leave
};

inline constexpr const char* silent = "silent error";
inline constexpr Real accurate_gap = 0.005, held_gap = 0.05;  ///< shares of the size
inline constexpr Real resting_speed = 0.01;  ///< [m/s]: a centimetre a second is seen as rest
inline constexpr Real energy_gain = 0.01;
inline constexpr Real accurate_energy = 0.01, held_energy = 0.1;  ///< where the exact motion keeps it

inline Real total_energy(const DiscScene& scene)
{
    return kinetic_energy(scene.bodies) + potential_energy(scene.bodies, scene.gravity);
}

/// m g times the height of the scene, summed: what the whole scene gains when it is lifted by its own size [J]. An
/// energy has no zero, so a gain of one per cent needs something to be a per cent of.
inline Real lifting(const DiscScene& scene)
{
    Real weight = 0, low = infinity, high = -infinity;
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        low = std::min(low, scene.bodies.position(k).y() - scene.radius[k]);
        high = std::max(high, scene.bodies.position(k).y() + scene.radius[k]);
        const Real inverse = scene.bodies.inverse_mass[2 * k];
        if (inverse > 0) weight += scene.gravity.norm() / inverse;
    }
    return weight * (high - low);
}

/// How far links and contacts are off [m].
inline Real largest_gap(const DiscScene& scene)
{
    return std::max(largest_link_error(scene), deepest_penetration(scene));
}

inline bool stands_in_order(const DiscScene& scene)
{
    for (Index k = 0; k + 1 < scene.bodies.count(); ++k)
        if (!(scene.bodies.position(k).y() < scene.bodies.position(k + 1).y())) return false;
    return true;
}

inline Real largest_speed(const DiscScene& scene, Real) { return scene.bodies.u.cwiseAbs().maxCoeff(); }

/// What a speed of the scene is seen as rest [m/s].
inline Real speed_of_rest(const DiscScene&, const Task&) { return resting_speed; }

/// What only bodies that turn are watched for: how far they are from their start, and whether they got out.
inline void watch(const DiscScene&, const VecX&, const Task&, Verdict&) {}

// The same of a scene of bodies that turn: turning_judge.cpp.
Real total_energy(const RoughScene& scene);
Real lifting(const RoughScene& scene);
Real largest_gap(const RoughScene& scene);
Real largest_gap(const JointedScene& scene);  ///< its joints' as well [m, rad]
bool stands_in_order(const RoughScene& scene);
Real largest_speed(const RoughScene& scene, Real size);  ///< of a centroid, or of a rim that turns [m/s]
Real speed_of_rest(const RoughScene& scene, const Task& task);
void watch(const RoughScene& scene, const VecX& start, const Task& task, Verdict& verdict);

// And of a scene in space: space_judge.cpp.
Real total_energy(const SpaceScene& scene);
Real lifting(const SpaceScene& scene);
Real largest_gap(const SpaceScene& scene);  ///< its joints' as well [m, rad]
bool stands_in_order(const SpaceScene& scene);
Real largest_speed(const SpaceScene& scene, Real size);
Real speed_of_rest(const SpaceScene& scene, const Task& task);
void watch(const SpaceScene& scene, const VecX& start, const Task& task, Verdict& verdict);

/// The change of the energy by a step, gained and lost: the smaller one of the end of the step and of its middle. The velocity
/// of symplectic Euler is that of the middle, and a pendulum looks at the end as if it gained and lost g h v/2 in turn; a
/// method that gains does so in both places.
struct EnergyChange {
    Real gain = 0, loss = 0;  ///< [J]
};
template <class Scene>
EnergyChange energy_change(const Scene& scene, Real h, Real start, Real little)
{
    const Real end = total_energy(scene) - start;
    Real middle = end;
    if constexpr (Scene::dof < 6)
        if (!(std::abs(end) <= little)) {
            Scene there = scene;
            there.bodies.x -= h / 2 * scene.bodies.u;
            middle = total_energy(there) - start;
        }
    return {std::min(end, middle), -std::max(end, middle)};
}

/// Runs a method on a scene. The second half of the run is what is judged; finiteness and energy, all of it.
template <class Scene>
Verdict judge(Scene scene, const Task& task, const StepOf<std::type_identity_t<Scene>>& step)
{
    const Real start = total_energy(scene) + task.lift;
    const VecX x = scene.bodies.x;
    const Real scale = task.energy > 0 ? task.energy : lifting(scene);
    Verdict verdict;
    Real speed = 0;
    const Real most_gain = task.conserves ? held_energy : energy_gain;
    // A look at the gaps tests all pairs; thirty looks are enough.
    const long look_every = std::max(1L, task.steps / 60);
    for (long n = 0; n < task.steps; ++n) {
        try {
            step(scene, task.h);
        } catch (const SilentError&) {
            return {lost, silent, infinity};
        } catch (const Stopped&) {
            return {lost, "stops", infinity};
        } catch (const std::invalid_argument&) {  // the state is not finite: the door says so
            return {lost, "not finite", infinity};
        }
        if (!scene.bodies.x.allFinite() || !scene.bodies.u.allFinite()) return {lost, "not finite", infinity};
        const EnergyChange change = energy_change(scene, task.h, start, accurate_energy * scale);
        verdict.gain = std::max(verdict.gain, change.gain / scale);
        verdict.loss = std::max(verdict.loss, change.loss / scale);
        if (!(change.gain <= most_gain * scale))
            return {lost, "energy", infinity, verdict.gain, verdict.loss};
        if (static_cast<Real>(n) < task.from * static_cast<Real>(task.steps)) continue;
        speed = std::max(speed, largest_speed(scene, task.size));
        if (n % look_every == 0 || n + 1 == task.steps) {
            verdict.gap = std::max(verdict.gap, largest_gap(scene));
            watch(scene, x, task, verdict);
        }
    }
    const Real gap = std::max(Real{0}, verdict.gap - task.gap);
    verdict.why = gap > accurate_gap * task.size                     ? "gap"
                  : task.rests && speed > speed_of_rest(scene, task) ? "unrest"
                                                                     : "";
    verdict.score = verdict.why.empty() ? accurate : gap <= held_gap * task.size ? held : failed;
    const Real change = std::max(verdict.gain, verdict.loss);
    if (task.conserves && change > accurate_energy && verdict.score > failed) {
        verdict.why = verdict.loss > verdict.gain ? "energy loss" : "energy gain";
        verdict.score = change <= held_energy ? held : failed;
    }
    if (task.upright && !stands_in_order(scene)) verdict.score = failed, verdict.why = "order";
    if (verdict.through) verdict.score = failed, verdict.why = "through";
    return verdict;
}

}  // namespace rigid::stress
