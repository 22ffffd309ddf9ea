/// \file tunable_values.hpp
/// The numbers that a reader may change, by name.
#pragma once

#include "common/math.hpp"

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rigid {

/// Numbers by name. A scene has about ten and each step reads some, so they are searched one after the other: most names
/// differ from the one that is looked for in their length alone, and no string is made of it.
class TunableValues {
public:
    struct Value {
        std::string name;
        Real number = 0;
        bool operator==(const Value&) const = default;
    };
    TunableValues() = default;
    TunableValues(std::initializer_list<Value> list) : list_(list) {}

    bool contains(std::string_view name) const { return find(name) != nullptr; }
    /// Throws std::out_of_range for a name that is not there.
    Real at(std::string_view name) const
    {
        const Value* found = find(name);
        if (found == nullptr) throw std::out_of_range("there is no tunable \"" + std::string(name) + '"');
        return found->number;
    }
    /// A name that is not there is added, as 0.
    Real& operator[](std::string_view name)
    {
        const Value* found = find(name);
        if (found != nullptr) return list_[static_cast<std::size_t>(found - list_.data())].number;
        return list_.emplace_back(Value{std::string(name), 0}).number;
    }
    bool operator==(const TunableValues&) const = default;

private:
    const Value* find(std::string_view name) const
    {
        for (const Value& one : list_)
            if (one.name.size() == name.size() && std::equal(name.begin(), name.end(), one.name.begin()))
                return &one;
        return nullptr;
    }
    std::vector<Value> list_;
};

}  // namespace rigid
