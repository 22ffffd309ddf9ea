/// \file outputs.hpp
/// The files that a run leaves behind: whether they can be written, and how frames are called.
#pragma once

#include "common/program/command_line.hpp"

#include <string>

namespace rigid {

/// Throws std::invalid_argument, naming the file, unless it can be written. Leaves what is in it.
void require_writable(const std::string& what, const std::string& file);

/// Makes the folder if need be. Throws std::invalid_argument, naming it, unless files can be written there.
void require_folder(const std::string& folder);

/// Throws std::invalid_argument, naming both options, if two of them write to one file: the second would destroy what
/// the first has written. Devices such as /dev/null take any number.
void require_different_files(const Options& options);

/// frame_000000.png
std::string frame_name(long frame, const std::string& extension);

}  // namespace rigid
