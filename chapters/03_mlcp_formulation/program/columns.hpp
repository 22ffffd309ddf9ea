/// \file columns.hpp
/// The state of a run, and the numbers that programs measure of it: each is defined once, and a program picks from them.
#pragma once

#include "chapters/03_mlcp_formulation/step.hpp"
#include "common/measure.hpp"
#include "common/program/program.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// What the pointer does in a scene.
enum class Pointer {
    pulls,   ///< pressed, a disc
    steers,  ///< and gravity points to it: the ten discs
    ignored
};

inline Real mechanical_energy(const DiscScene& scene)
{
    return kinetic_energy(scene.bodies) +
           potential_energy(scene.bodies, scene.gravity);
}

/// All of a run that has nothing to do with its method.
struct SceneState {
    struct Start {
        VecX x;
        Vec2 gravity = {0, 0};
        Real energy = 0;
    };

    DiscScene scene;
    View view;      ///< what the picture shows
    Real zoom = 1;  ///< from metres to the units of the picture
    Pointer pointer = Pointer::pulls;
    StepSettings step;  ///< as the reader has set it
    StepData<2> now;    ///< what the last step found on its way
    int steps = 0;      ///< taken so far
    /// of these, steps whose answer did not meet the tolerance
    int unsolved = 0;
    std::int64_t visits = 0;   ///< rows visited so far
    Real highest = -infinity;  ///< highest centre so far [m]
    Start start;               ///< how it was before the first step

    Real t() const { return static_cast<Real>(steps) * step.h; }
    /// Row i comes from this kind of constraint.
    bool is(std::size_t row, Source::Of of) const
    {
        return now.sources[row].of == of;
    }
    /// λ of row i; 0 where the step found none.
    Real lambda(std::size_t row) const
    {
        const auto i = static_cast<Index>(row);
        return i < now.solution.lambda.size() ? now.solution.lambda[i] : 0;
    }
    /// The force of joint number `joint` in the last step [N].
    Real force_of_joint(int joint) const
    {
        for (std::size_t i = 0; i < now.sources.size(); ++i)
            if (is(i, Source::Of::joint) && now.sources[i].index == joint)
                return lambda(i) / step.h;
        return 0;
    }
};

template <class Method>
struct RunState : SceneState {
    Method method;
    /// what the text foretells; may be empty
    std::function<Real(const RunState&)> theory;
};

/// A column, and where its number comes from.
template <class State>
struct Measured {
    Column column;
    std::function<Real(const State&)> value;

    Measured(Column head, std::function<Real(const State&)> of)
        : column(std::move(head)), value(std::move(of))
    {
    }
    /// What is measured of any scene is measured of this one.
    template <class Base>
    requires(std::is_base_of_v<Base, State> && !std::is_same_v<Base, State>)
        Measured(const Measured<Base>& other)
        : column(other.column), value(other.value)
    {
    }

    /// The same column with a plot, or without one.
    Measured plotted(Plot plot = Plot::linear) const
    {
        Measured copy = *this;
        copy.column.plot = plot;
        return copy;
    }
};

namespace columns {

using Any = Measured<SceneState>;  ///< of a scene, whatever its method

/// What the solver counts.
inline Any iterations(const std::string& name, const std::string& help)
{
    return {{name, "", help, Plot::linear},
            [](const SceneState& s) { return Real(s.now.solution.iterations); }};
}
inline Any residual()
{
    return {{"residual", "m/s",
             "natural residual of the step's answer; 0 = not looked at",
             Plot::logarithmic},
            [](const SceneState& s) {
                return std::isfinite(s.now.solution.residual)
                           ? s.now.solution.residual
                           : 0;
            }};
}
inline Any row_visits()
{
    return {{"row_visits", "",
             "rows visited in the step: sweeps, residuals, corrections"},
            [](const SceneState& s) { return Real(s.now.visits); }};
}
inline Any rows()
{
    return {{"rows", "", "links and contacts"},
            [](const SceneState& s) { return Real(s.now.rows.size()); }};
}
inline Any contacts()
{
    return {{"contacts", "", "contacts that have a row"},
            [](const SceneState& s) { return Real(s.now.contacts.size()); }};
}
inline Any unsolved()
{
    return {{"unsolved", "", "steps so far that did not meet the tolerance"},
            [](const SceneState& s) { return Real(s.unsolved); }};
}
inline Any link_error()
{
    return {{"link_error", "m", "largest difference of a link from its length",
             Plot::logarithmic},
            [](const SceneState& s) { return largest_link_error(s.scene); }};
}
inline Any penetration()
{
    return {{"penetration", "m", "deepest overlap", Plot::logarithmic},
            [](const SceneState& s) { return deepest_penetration(s.scene); }};
}
inline Any kinetic()
{
    return {{"kinetic", "J", "kinetic energy", Plot::linear},
            [](const SceneState& s) { return kinetic_energy(s.scene.bodies); }};
}
inline Any energy()
{
    return {{"energy", "J", "kinetic energy and that of the weight"},
            [](const SceneState& s) { return mechanical_energy(s.scene); }};
}
inline Any energy_gained()
{
    return {{"energy", "J",
             "kinetic energy and that of the weight, less than at the start",
             Plot::linear},
            [](const SceneState& s) {
                return mechanical_energy(s.scene) - s.start.energy;
            }};
}
/// The same where the pointer may turn gravity: energies are compared in the gravity of the start.
inline Any energy_gained_in_gravity_of_start()
{
    return {energy_gained().column, [](const SceneState& s) {
                return kinetic_energy(s.scene.bodies) +
                       potential_energy(s.scene.bodies, s.start.gravity) -
                       s.start.energy;
            }};
}
inline Any speed()
{
    return {{"speed", "m/s", "greatest speed of a body", Plot::linear},
            [](const SceneState& s) {
                Real speed = 0;
                for (Index k = 0; k < s.scene.bodies.count(); ++k)
                    speed = std::max(speed, s.scene.bodies.velocity(k).norm());
                return speed;
            }};
}
inline Any highest()
{
    return {{"highest", "m", "highest centre so far"},
            [](const SceneState& s) { return s.highest; }};
}
/// How far the last body is above where it began.
inline Any last_rise()
{
    return {{"last_rise", "m", "how far the last body is above where it began",
             Plot::linear},
            [](const SceneState& s) {
                const Index last = s.scene.bodies.count() - 1;
                return s.scene.bodies.position(last).y() - s.start.x[2 * last + 1];
            }};
}
/// What the text foretells for the scene.
template <class Method>
Measured<RunState<Method>> theory(const std::string& unit, const std::string& help)
{
    return {{"theory", unit, help}, [](const RunState<Method>& s) {
                return s.theory ? s.theory(s) : Real{0};
            }};
}
/// A coordinate of one body: its position, or its velocity.
inline Any position(const std::string& name, const std::string& help,
                    Index coordinate, Plot plot)
{
    return {{name, "m", help, plot}, [coordinate](const SceneState& s) {
                return s.scene.bodies.x[coordinate];
            }};
}
inline Any velocity(const std::string& name, const std::string& help,
                    Index coordinate)
{
    return {{name, "m/s", help, Plot::linear}, [coordinate](const SceneState& s) {
                return s.scene.bodies.u[coordinate];
            }};
}
inline Any joint_force(const std::string& name, const std::string& help, int joint)
{
    return {{name, "N", help, Plot::linear},
            [joint](const SceneState& s) { return s.force_of_joint(joint); }};
}

}  // namespace columns

}  // namespace rigid
