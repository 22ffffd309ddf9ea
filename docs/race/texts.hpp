/// \file texts.hpp
/// Numbers and vectors as JSON, and the scenes of a program as the page or beside.mjs asks for them.
#pragma once

#include "common/program/web_calls.hpp"
#include "common/program/web_description.hpp"
#include "common/text.hpp"

#include <array>
#include <string>

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

/// What is measured of a scene: how far a body has moved, how far a joint is open, how deep bodies overlap [m].
inline constexpr std::array<const char*, 3> measures = {"moved", "gap", "overlap"};

/// A scene of beside.mjs.
struct Measured {
    std::string name, title;
    std::string what;  ///< which of the measures are errors there, as letters: m, g, o
    int steps = 240;
    int driven = 0;  ///< so many of the first bodies are moved by hand

    bool by(char measure) const { return what.find(measure) != std::string::npos; }
};

inline std::string text_of(const Measured& scene)
{
    Listed errors;
    for (const char* const one : measures)
        if (scene.by(one[0])) errors.add(json(one));
    return "{\"name\":" + json(scene.name) + ",\"title\":" + json(scene.title) +
           ",\"errors\":" + errors.text() + ",\"steps\":" + std::to_string(scene.steps) +
           ",\"driven\":" + std::to_string(scene.driven) + '}';
}

/// \param scenes  each of them a Measured, or more
template <class Scenes>
std::string description_of(const std::string& name, const Scenes& scenes)
{
    Listed kinds, texts;
    for (const char* const one : measures) kinds.add(json(one));
    for (const Measured& scene : scenes) texts.add(text_of(scene));
    return "{\"name\":" + json(name) + ",\"measures\":" + kinds.text() + ",\"scenes\":" + texts.text() + '}';
}

}  // namespace rigid::race
