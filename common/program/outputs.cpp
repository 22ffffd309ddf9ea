#include "common/program/outputs.hpp"

#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>
#include <utility>

namespace rigid {

namespace fs = std::filesystem;

void require_writable(const std::string& what, const std::string& file)
{
    std::error_code ignored;
    const bool was_there = fs::exists(fs::symlink_status(file, ignored));  // a link to nothing is there
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
    fs::path probe = fs::path(folder) / ".writable";
    for (int i = 2; fs::exists(fs::symlink_status(probe, error)) && i < 1000; ++i)  // another's
        probe = fs::path(folder) / (".writable" + std::to_string(i));
    const bool writable = !fs::exists(fs::symlink_status(probe, error)) && std::ofstream(probe).good();
    if (writable) fs::remove(probe, error);
    if (!writable)
        throw std::invalid_argument("the folder \"" + folder +
                                    "\" can't be written to; --record must name a folder "
                                    "that is there or can be made");
}

void require_different_files(const Options& options)
{
    const std::pair<const char*, const std::string*> outputs[] = {
        {"--csv", &options.csv}, {"--svg", &options.svg}, {"--png", &options.png}};
    const auto is_one = [](const std::string& a, const std::string& b) {
        std::error_code error;
        if (a.empty() || b.empty() || fs::is_other(a, error)) return false;  // other: a device, a pipe
        if (fs::equivalent(a, b, error)) return true;
        return fs::weakly_canonical(fs::absolute(a), error) == fs::weakly_canonical(fs::absolute(b), error);
    };
    for (const auto& first : outputs)
        for (const auto& second : outputs) {
            const bool printed = std::string(first.first) == "--csv" && *first.second == "-";
            if (&first < &second && !printed && is_one(*first.second, *second.second))
                throw std::invalid_argument(std::string(first.first) + " and " + second.first +
                                            " both write to \"" + *second.second +
                                            "\"; each must have a file of its own");
        }
}

std::string frame_name(long frame, const std::string& extension)
{
    std::string digits = std::to_string(frame);
    if (digits.size() < 6) digits.insert(0, 6 - digits.size(), '0');
    return "frame_" + digits + extension;
}

}  // namespace rigid
