#include "common/program/outputs.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

namespace rigid {

namespace fs = std::filesystem;

void require_writable(const std::string& what, const std::string& file)
{
    std::error_code ignored;
    const bool was_there = fs::exists(file, ignored);
    const bool writable = !fs::is_directory(file, ignored) && std::ofstream(file, std::ios::app).good();
    if (!was_there) fs::remove(file, ignored);
    if (!writable)
        throw std::invalid_argument(what + " \"" + file +
                                    "\" can't be written; it must be a file in a folder that "
                                    "exists");
}

void require_folder(const std::string& folder)
{
    std::error_code error;
    fs::create_directories(folder, error);
    const fs::path probe = fs::path(folder) / ".writable";
    const bool writable = std::ofstream(probe).good();
    fs::remove(probe, error);
    if (!writable)
        throw std::invalid_argument("the folder \"" + folder +
                                    "\" can't be written to; --record must name a folder "
                                    "that is there or can be made");
}

std::string frame_name(long frame, const std::string& extension)
{
    std::string digits = std::to_string(frame);
    if (digits.size() < 6) digits.insert(0, 6 - digits.size(), '0');
    return "frame_" + digits + extension;
}

}  // namespace rigid
