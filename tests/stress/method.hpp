/// \file method.hpp
/// A method as the stability matrix sees it: something that takes a scene one step further.
#pragma once

#include "common/scenes.hpp"

#include <functional>
#include <string>
#include <vector>

namespace rigid::stress {

/// What a stress may ask a method for. A method that has no such thing is not asked.
struct Wish {
    Real beta = -1;         ///< share of the position error that a step repays; below zero = the method's own
    Real restitution = -1;  ///< below zero = none
};

/// Takes one step of h seconds. Throws std::invalid_argument for bad input and std::runtime_error for an answer
/// that calls itself solved and isn't.
using Step = std::function<void(DiscScene&, Real h)>;

struct Method {
    int chapter = 0;
    std::string name;    ///< as in a table
    std::string budget;  ///< what it may spend in a step, for the reader
    bool has_beta = false, has_restitution = false;
    Index most_rows = 1'000'000;  ///< beyond that a step would take seconds: the cell stays empty
    std::function<Step(const Wish&)> start;
};

/// Every method of every chapter that advances a scene, with the switches that its chapter teaches.
std::vector<Method> methods();

}  // namespace rigid::stress
