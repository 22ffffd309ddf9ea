#include "common/program/program.hpp"

#include <new>
#include <stdexcept>

namespace rigid {

Settings default_settings(const Demo& scene)
{
    Settings settings;
    settings.scene = scene.name;
    settings.method = scene.methods.empty() ? "" : scene.methods.front();
    settings.h = scene.h;
    for (const Tunable& one : scene.tunables) settings.tunables[one.name] = one.value;
    return settings;
}

std::string sentence_of(const std::exception& error)
{
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr ||
        dynamic_cast<const std::length_error*>(&error) != nullptr)
        return "there is not enough memory for this";
    return error.what();
}

}  // namespace rigid
