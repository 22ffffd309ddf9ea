#include "common/program/program.hpp"

#include <new>
#include <stdexcept>

template class std::vector<rigid::Tunable>;
template class std::vector<rigid::Column>;
template class std::vector<rigid::Demo>;

namespace rigid {

Demo::Demo() = default;
Demo::Demo(const Demo&) = default;
Demo::Demo(Demo&&) noexcept = default;
Demo& Demo::operator=(const Demo&) = default;
Demo& Demo::operator=(Demo&&) noexcept = default;
Demo::~Demo() = default;

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
