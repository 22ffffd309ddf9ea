/// \file positive.hpp
/// What waves and water refuse alike: a number that is not positive and finite.
#pragma once

#include "common/text.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace rigid {

/// Throws std::invalid_argument, with what it is of and its value.
inline void require_positive(const std::string& what, Real value, const char* unit)
{
    if (!(value > 0) || !std::isfinite(value))
        throw std::invalid_argument(what + " is " + shortest(value) + unit +
                                    "; it must be positive and finite");
}

}  // namespace rigid
