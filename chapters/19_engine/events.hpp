/// \file events.hpp
/// What a step reports, and what a question to a world is answered with.
#pragma once

#include "chapters/19_engine/definitions.hpp"

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace rigid {

//! [events]
/// Two shapes that touch, or a shape and a wall: then `a` is the world. (That of a
/// body of one shape has its name.)
struct Touch {
    BodyId a, b;
    WallId wall;

    auto operator<=>(const Touch&) const = default;
};

/// A touch that began with a blow, or a bounce of two that touch already: of each
/// pair the fastest of the step.
struct Hit {
    Touch touch;
    Vec2 point = {0, 0};   ///< [m]
    Vec2 normal = {0, 1};  ///< from a to b
    Real speed = 0;        ///< of approach, before the blow [m/s]
};

/// A body that is in a sensor, shape by shape.
struct Seen {
    BodyId sensor, body;

    auto operator<=>(const Seen&) const = default;
};

/// Of the last step. What begins has both bodies in the world; what ends may have
/// lost one.
struct Events {
    std::vector<Touch> began, ended;
    std::vector<Hit> hits;
    std::vector<Seen> entered, left;
    std::vector<JointId> broken;
    /// their numbers had overflowed: they are where they were, at rest
    std::vector<BodyId> held;
};
//! [events]

/// A point in which two bodies touch, or nearly.
struct ContactView {
    Touch touch;
    Vec2 point = {0, 0};   ///< [m]
    Vec2 normal = {0, 1};  ///< from a to b
    Real gap = 0;          ///< [m]; negative = overlap
    Real impulse = 0;      ///< along the normal, of the last sub-step [N s]
    Real friction = 0;     ///< on b along the normal turned by a quarter [N s]
};

//! [callbacks]
/// Is asked whether two bodies may touch, after filters and joints have let them:
/// in each step for each pair whose boxes overlap, in the order of their places,
/// and once more for bodies that are stopped on their way. An answer may depend
/// on the two bodies, on what the world says of them and on nothing else, and
/// must not change the world nor throw: then the same calls give the same bits.
using ContactFilter = std::function<bool(BodyId a, BodyId b)>;
/// Is asked in each step, before rows are made, whether a touch counts in it: with
/// the points that it would have, whose impulses are 0, in the order of the places,
/// first those with walls. May be asked twice in a step that wakes something. As
/// above.
using PreSolve =
    std::function<bool(const Touch& touch, std::span<const ContactView> points)>;
//! [callbacks]

//! [answers]
/// Where a ray or a shape on its way meets something first.
struct Met {
    BodyId body;  ///< the world: it is a wall
    WallId wall;
    Real part = 1;  ///< of the way
    Vec2 point = {0, 0};
    /// out of what was met; zero: it was there from the beginning
    Vec2 normal = {0, 0};
};
//! [answers]

}  // namespace rigid
