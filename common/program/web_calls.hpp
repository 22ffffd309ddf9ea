/// \file web_calls.hpp
/// What a page calls: RIGID_PAGE makes a function that JavaScript finds by its name. A text that it hands out stays until the
/// next one. A function that can fail returns 0, or 1 and a sentence.
#pragma once

#include "common/program/program.hpp"

#include <exception>
#include <string>
#include <utility>

namespace rigid {

struct Said {
    std::string text, sentence;
};

inline Said& last_said()
{
    static Said one;
    return one;
}

inline const char* said(std::string text)
{
    last_said().text = std::move(text);
    return last_said().text.c_str();
}

/// 0, or 1 with the sentence of what went wrong.
template <class Do>
int attempt(const Do& what)
{
    try {
        what();
        return 0;
    } catch (const std::exception& error) {
        last_said().sentence = sentence_of(error);
        return 1;
    }
}

}  // namespace rigid

#define RIGID_PAGE(name) extern "C" __attribute__((export_name(#name), used))
