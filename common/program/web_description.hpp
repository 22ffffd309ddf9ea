/// \file web_description.hpp
/// A program as JSON, for the panel that a page builds from it: the same rows as the window's (panel_rows.hpp).
///
///     {"name": …, "title": …, "speeds": [{"value": 1, "text": "x 1"}, …],
///      "scenes": [{"name": …, "summary": …, "steered": false, "methods": […],
///                  "sliders": [{"name": …, "label": …, "help": …, "unit": …, "format": …, "low": …, "high": …,
///                               "first": …, "whole": false, "names": […], "logarithmic": false}, …],
///                  "plots": [{"column": 0, "title": …, "grey": …, "help": …, "unit": …}, …],
///                  "keys": [["Space", "pause and run"], …]}, …]}
#pragma once

#include "common/program/panel_rows.hpp"

#include <string>

namespace rigid {

std::string description_of(const Program& program);

/// What changes from frame to frame: the step, the time, whether it can go on, its values, its sentences.
std::string state_of(const Show& show);

/// A text as JSON writes it, in quotes.
std::string json(const std::string& text);

}  // namespace rigid
