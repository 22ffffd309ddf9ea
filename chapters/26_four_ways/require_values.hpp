/// \file require_values.hpp
/// The doors of this chapter for numbers that have to be positive, or must not be negative.
#pragma once

#include "common/math.hpp"
#include "common/text.hpp"

#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <utility>

namespace rigid {

/// Throws std::invalid_argument for the first of some values that is negative or not finite, naming it and the value.
inline void
require_not_negative(std::initializer_list<std::pair<const char*, Real>> named)
{
    for (const auto& [name, value] : named)
        if (!(value >= 0) || !std::isfinite(value))
            throw std::invalid_argument(
                std::string(name) + " is " + shortest(value) +
                "; it must be zero or positive, and finite");
}

/// The same for what must not be zero either.
inline void
require_positive(std::initializer_list<std::pair<const char*, Real>> named)
{
    for (const auto& [name, value] : named)
        if (!(value > 0) || !std::isfinite(value))
            throw std::invalid_argument(std::string(name) + " is " +
                                        shortest(value) +
                                        "; it must be positive and finite");
}

}  // namespace rigid
