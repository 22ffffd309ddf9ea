/// \file outputs.hpp
/// The files that a run leaves behind: whether they can be written, and how frames are called.
#pragma once

#include <string>

namespace rigid {

/// Throws std::invalid_argument, naming the file, unless it can be written. Leaves what is in it.
void require_writable(const std::string& what, const std::string& file);

/// Makes the folder if need be. Throws std::invalid_argument, naming it, unless files can be written there.
void require_folder(const std::string& folder);

/// frame_000000.png
std::string frame_name(long frame, const std::string& extension);

}  // namespace rigid
