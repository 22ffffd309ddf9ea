/// \file window.hpp
/// The window: panes side by side, and a panel with everything that the reader may change.
#pragma once

#include "common/program/command_line.hpp"

#include <optional>
#include <string>

namespace rigid {

/// Runs until the window is closed, or --steps are done, and returns the exit code. Nothing, with the
/// reason, if no window can be opened. Throws std::invalid_argument for what the scene refuses.
std::optional<int> run_window(const Program& program, const Options& options, std::string& reason);

}  // namespace rigid
