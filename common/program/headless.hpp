/// \file headless.hpp
/// A run without a window: a table for each step, pictures, a summary.
#pragma once

#include "common/program/command_line.hpp"

namespace rigid {

/// Returns the exit code: 0 well, 3 a step that couldn't be done, 130 interrupted. Throws
/// std::invalid_argument for settings that the scene refuses and files that can't be written.
int run_headless(const Program& program, const Options& options);

}  // namespace rigid
