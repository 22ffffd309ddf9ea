/// \file definitions.hpp
/// What goes into a world, and what its settings are: numbers only, in metres, kilograms, seconds and radians.
///
/// A body, a joint and a wall are named by an id that stays valid until the thing is removed, and is refused ever after:
/// its place may be used again, its generation is not.
#pragma once

#include "chapters/10_skipping_work/collision_filter.hpp"
#include "chapters/10_skipping_work/sleeping.hpp"
#include "chapters/14_joints/joint.hpp"
#include "chapters/18_islands/solving.hpp"

#include <compare>
#include <cstdint>
#include <functional>
#include <optional>

namespace rigid {

//! [id]
/// Names a thing of a world. A default one names nothing; as a body, the world.
template <class Thing>
struct Id {
    std::uint32_t place = 0;
    std::uint32_t generation = 0;  ///< of the things that had this place; 0 = none

    explicit operator bool() const { return generation > 0; }
    auto operator<=>(const Id&) const = default;
};
using BodyId = Id<struct BodyTag>;
using JointId = Id<struct JointTag>;
using WallId = Id<struct WallTag>;
//! [id]

/// What may change how a body moves.
enum class BodyKind : std::uint8_t {
    fixed,      ///< nothing pushes it, and it stands
    kinematic,  ///< nothing pushes it; the velocity that it has it keeps
    dynamic     ///< forces and contacts push it: it has a mass
};
const char* to_string(BodyKind kind);

//! [body]
struct BodyDefinition {
    /// convex, counterclockwise, with a radius; its centroid, or that of all
    /// shapes, goes to `position` [m]
    Polygon shape = box(1, 1);
    Vec2 position = {0, 0};  ///< of the centroid [m]
    Real angle = 0;          ///< [rad]
    Vec2 velocity = {0, 0};  ///< of the centroid [m/s]
    Real spin = 0;           ///< [rad/s]
    /// [kg/m²]; 0: nothing pushes it, and a velocity that it has it keeps
    Real density = 1;
    /// in place of a density: mass and inertia, about this centroid of the shape
    std::optional<Mass> mass = {};
    bool fixed_rotation = false;  ///< nothing turns it: its inertia is infinite
    Real gravity_scale = 1;       ///< its weight is so many times m g
    Real linear_damping = 0;   ///< d: u falls to u / (1 + h d) in each step [1/s]
    Real angular_damping = 0;  ///< the same of the spin [1/s]
    /// friction μ, restitution e, belt speed, rolling arm: see surfaces.hpp
    Surface surface{0.6, 0, 0, 0};
    Filter filter = {};
    /// pushes nothing and reports what overlaps it; its density must be 0
    bool sensor = false;
    /// stopped where it first touches, however fast, though it hangs on joints or
    /// the world does not stop others
    bool bullet = false;
    std::uint64_t user = 0;  ///< anything of the caller's
};
//! [body]

//! [shape]
/// Another shape of a body, in the axes of the first one. It has a name of its own,
/// and a surface, a filter and a caller's number.
struct ShapeDefinition {
    Polygon shape = box(1, 1);
    /// [kg/m²]; none: that of the body, and of a sensor 0. Where the mass of the
    /// body is given it must be none
    std::optional<Real> density = {};
    Surface surface{0.6, 0, 0, 0};
    Filter filter = {};
    /// pushes nothing, goes with the body and reports what overlaps it
    bool sensor = false;
    std::uint64_t user = 0;
};
//! [shape]

//! [settings]
/// Safe as they are, for bodies of about a metre: of another size, set `length`.
struct WorldSettings {
    Vec2 gravity = {0, -9.81};  ///< [m/s²]
    /// ℓ, the size of an ordinary body that moves, to a factor of ten: margins, slop and
    /// speeds of rest are measured in it [m]
    Real length = 1;
    int substeps = 1;  ///< of a step; contacts are found once
    /// a contact gets its row when its gap is below this [ℓ]
    Real margin = 0.02;
    Real slop = 0.005;  ///< an overlap that is left alone [ℓ]
    bool sleep = true;
    RestSettings rest = {};  ///< when bodies fall asleep
    Solving solving = Solving::by_island;
    int sweeps = 60;        ///< over an island, at most
    Real tolerance = 1e-4;  ///< sweeps end at this residual [ℓ/s]
    /// rows with bounds of an island that is solved exactly, at most
    int most_exact = 4000;
    /// bodies that move farther than half their inner radius in a step stop where
    /// they first touch; those on joints only if they are bullets
    bool stop_fast = true;
    Real hit_speed = 1;  ///< slower contacts are no hits [ℓ/s]
};
//! [settings]

/// Throws std::invalid_argument, naming the setting and its value, unless all of them make sense.
void require_valid(const WorldSettings& settings);

//! [work]
/// What the last step has done, counted.
struct StepWork {
    int bodies = 0;  ///< in the world
    int awake = 0;
    int islands = 0;  ///< of those that are awake, single bodies included
    int exact = 0;    ///< islands solved exactly
    int swept = 0;    ///< islands that have rows and were swept
    /// of those, solved exactly after all, because sweeps did not get there
    int rescued = 0;
    /// heaps that moved, by small steps of their own: what is left of their residual is
    /// in `residual`, and is no failure
    int stepped = 0;
    /// other islands whose residual is above the tolerance; of those with more than 64
    /// rows with bounds that move, above a thirtieth of what gravity gives a body in the
    /// step. At least as many as have joints that cannot all be met: one of them is
    /// open by more than the slop
    int unsolved = 0;
    /// bodies whose numbers overflowed and that were put back, at rest
    int held = 0;
    int contacts = 0;  ///< points
    int rows = 0;
    std::int64_t visits = 0;   ///< rows visited, whatever for
    std::int64_t entries = 0;  ///< of matrices, looked at by exact solves
    std::int64_t tested = 0;   ///< boxes compared in search of pairs
    /// bodies, pairs, joints and touches passed because something was changed, woke or
    /// fell asleep, and touches of what is awake
    std::int64_t walked = 0;
    int sweeps = 0;                  ///< of the island that needed the most
    int stopped = 0;                 ///< fast bodies that were stopped on their way
    int woken = 0, fell_asleep = 0;  ///< bodies
    /// the largest natural residual of a row [m/s]; infinite where numbers overflowed
    Real residual = 0;
    /// what is solved exactly was not: the impulses of the step before were the answer
    bool answered = false;
    bool skipped =
        false;  ///< all slept and nothing was changed: no step was needed

    /// What it cost, by (18.2) and (18.3) [entries, about a nanosecond each]
    std::int64_t price() const { return entries + visit_price * visits; }
    static constexpr int visit_price = price::visit;
};
//! [work]

//! [stages]
/// The parts of a step: rows, solver and positions once for each sub-step.
enum class Stage : std::uint8_t {
    contacts,   ///< what is awake, and what touches
    start,      ///< impulses of the step before: found, and kept
    rows,       ///< forces, constraints, biases
    solver,     ///< impulses and velocities
    positions,  ///< moved, and errors taken out of them
    report      ///< events, sensors, counters
};
const char* to_string(Stage stage);

/// Is told which stage begins. It must not call the world, nor throw.
using StageListener = std::function<void(Stage)>;
//! [stages]

}  // namespace rigid
