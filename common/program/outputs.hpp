/// \file outputs.hpp
/// What a run leaves behind: the table, the last picture, a picture each N steps.
#pragma once

#include "common/program/command_line.hpp"
#include "common/program/table.hpp"

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace rigid {

/// Writes panes into a PNG file.
using PngWriter = std::function<void(const std::string& file, const std::vector<Pane>& panes)>;

/// Throws std::invalid_argument, naming the file, unless it can be written. Leaves what is in it.
void require_writable(const std::string& what, const std::string& file);

/// Makes the folder if need be. Throws std::invalid_argument, naming it, unless files can be written there.
void require_folder(const std::string& folder);

/// frame_000000.png
std::string frame_name(long frame, const std::string& extension);

}  // namespace rigid
