/// \file method.hpp
/// A method as the stability matrix sees it: something that takes a scene one step further.
#pragma once

#include "common/scenes.hpp"

#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace rigid::stress {

/// What a stress may ask a method for, before or in the middle of a run. A method that has no such thing is not asked.
struct Wish {
    Real beta = -1;         ///< share of the position error that a step repays; below zero = the method's own
    Real restitution = -1;  ///< below zero = none
    int setting = -1;       ///< the number of one of the method's own settings that is to be spoilt
    Real spoilt = 0;        ///< what is written there
};

/// Takes one step of h seconds. Throws std::invalid_argument for bad input and SilentError for an answer that calls
/// itself solved and isn't.
template <class Scene>
using StepOf = std::function<void(Scene&, Real h)>;
using Step = StepOf<DiscScene>;

/// An answer that says it is right and isn't.
struct SilentError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A method that cannot go on, and says so.
struct Stopped : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A number that a method lets its caller set.
struct Setting {
    std::string name;
    Real* value = nullptr;
    bool may_be_infinite = false;  ///< +∞ means something: no limit
};

/// A setting whose +∞ means something: no limit.
inline Setting or_infinity(std::string name, Real* value)
{
    return {.name = std::move(name), .value = value, .may_be_infinite = true};
}

template <class Scene>
struct MethodOf {
    int chapter = 0;
    std::string name;    ///< as in a table
    std::string budget;  ///< what it may spend in a step, for the reader
    bool has_beta = false, has_restitution = false;
    bool links_only = false;        ///< it knows no contacts
    bool walls_only = false;        ///< bodies touch walls and never each other
    bool friction = false;          ///< it knows friction
    bool joints = true;             ///< it knows joints
    bool springs = true;            ///< of joints
    bool motors = true;             ///< of joints
    Index most_rows = 1'000'000;    ///< beyond that a step would take seconds: the cell stays empty
    std::vector<Setting> settings;  ///< their values point nowhere: only names
    std::function<StepOf<Scene>(std::shared_ptr<const Wish>)> start;
};
using Method = MethodOf<DiscScene>;

/// Every method of every chapter that advances a scene, with the switches that its chapter teaches.
/// \param sweeps  that a step of those which sweep may make: 10 in the matrix
std::vector<Method> methods(int sweeps = 10);

}  // namespace rigid::stress
