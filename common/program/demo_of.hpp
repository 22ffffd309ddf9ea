/// \file demo_of.hpp
/// A scene of a program from what sets it up and what runs it.
#pragma once

#include "common/program/program.hpp"

#include <functional>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// A scene that a `Runner` runs: it is made from what the settings set up, and the settings.
template <class Runner, class Setup>
Demo demo_of(const std::string& name, const std::string& summary, const View& view, Real h,
             std::vector<std::string> methods, std::vector<Tunable> tunables,
             std::function<Setup(const Settings&)> setup)
{
    Demo scene;
    scene.name = name;
    scene.summary = summary;
    scene.view = view;
    scene.h = h;
    scene.methods = std::move(methods);
    scene.tunables = std::move(tunables);
    scene.start = [setup = std::move(setup)](const Settings& settings) {
        return std::make_unique<Runner>(setup(settings), settings);
    };
    return scene;
}

}  // namespace rigid
