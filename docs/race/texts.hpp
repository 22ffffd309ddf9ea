/// \file texts.hpp
/// Numbers and vectors as JSON, and what a page's functions hand out: a text that stays until the next one, and a sentence.
#pragma once

#include "common/program/web_description.hpp"
#include "common/text.hpp"

#include <exception>
#include <string>
#include <utility>

namespace rigid::race {

/// JSON has no infinity: null.
inline std::string number(Real value) { return std::isfinite(value) ? shortest(value) : "null"; }

inline std::string list(std::initializer_list<Real> numbers)
{
    std::string text;
    for (const Real one : numbers) text += (text.empty() ? "" : ",") + number(one);
    return '[' + text + ']';
}

/// Elements of a list, one by one.
class Listed {
public:
    void add(const std::string& one) { text_ += (text_.empty() ? "" : ",") + one; }
    std::string text() const { return '[' + text_ + ']'; }

private:
    std::string text_;
};

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

/// 0, or 1 and a sentence.
template <class Do>
int attempt(const Do& what)
{
    try {
        what();
        return 0;
    } catch (const std::exception& error) {
        last_said().sentence = error.what();
        return 1;
    }
}

}  // namespace rigid::race

#define RIGID_PAGE(name) extern "C" __attribute__((export_name(#name), used))
