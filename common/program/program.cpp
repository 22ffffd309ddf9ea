#include "common/program/program.hpp"

#include <algorithm>
#include <new>
#include <stdexcept>

namespace rigid {

const TunableValues::Value* TunableValues::find(std::string_view name) const
{
    for (const Value& one : list_)
        if (one.name.size() == name.size() && std::equal(name.begin(), name.end(), one.name.begin()))
            return &one;
    return nullptr;
}

Real TunableValues::at(std::string_view name) const
{
    const Value* found = find(name);
    if (found == nullptr) throw std::out_of_range("there is no tunable \"" + std::string(name) + '"');
    return found->number;
}

Real& TunableValues::operator[](std::string_view name)
{
    const Value* found = find(name);
    if (found != nullptr) return list_[static_cast<std::size_t>(found - list_.data())].number;
    return list_.emplace_back(Value{std::string(name), 0}).number;
}

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
