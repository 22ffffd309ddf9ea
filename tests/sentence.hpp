/// \file sentence.hpp
/// The sentence by which bad input is refused.
#pragma once

#include <functional>
#include <stdexcept>
#include <string>

/// What the std::invalid_argument says that the call throws; "accepted" if it throws nothing.
inline std::string sentence_of(const std::function<void()>& act)
{
    try {
        act();
    } catch (const std::invalid_argument& refused) {
        return refused.what();
    }
    return "accepted";
}
