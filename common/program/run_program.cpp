#include "common/program/command_line.hpp"
#include "common/program/headless.hpp"
#include "common/program/outputs.hpp"
#include "common/program/program.hpp"
#ifdef RIGID_HAS_WINDOW
#include "common/program/window.hpp"
#endif

#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <stdexcept>

namespace rigid {
namespace {

/// Empty if a window can be tried, else the reason why not.
std::string no_window_reason()
{
#ifndef RIGID_HAS_WINDOW
    return "This program was built without a window";
#elif defined(__linux__)
    const auto is_set = [](const char* name) {
        const char* value = std::getenv(name);
        return value != nullptr && *value != '\0';
    };
    if (!is_set("DISPLAY") && !is_set("WAYLAND_DISPLAY"))
        return "There is no display (neither DISPLAY nor WAYLAND_DISPLAY is set)";
#endif
    return {};
}

/// The reader expected a window: leave a picture and a table instead, and say where.
int run_in_place_of_window(const Program& program, Options options, const std::string& reason)
{
    const std::string stem = program.name + '_' + options.scene->name;
    if (options.csv.empty()) options.csv = stem + ".csv";
    if (options.svg.empty() && options.png.empty()) options.svg = stem + ".svg";
    std::cerr << reason << ": running without one.\n";
    const int code = run_headless(program, options);
    const auto tell = [](const char* what, const std::string& file) {
        if (!file.empty() && file != "-")
            std::cerr << what << ": " << std::filesystem::absolute(file).string() << '\n';
    };
    tell("picture", options.svg);
    tell("picture", options.png);
    tell("table", options.csv);
    return code;
}

int solve(const Program& program, const Options& options)
{
    std::error_code ignored;
    if (std::filesystem::is_directory(options.problem, ignored) || !std::ifstream(options.problem))
        throw std::invalid_argument("the problem \"" + options.problem +
                                    "\" can't be read; it must be a file");
    return program.solve_problem(options.problem, options.problem_method);
}

int write_own_file(const OwnFile& own, const std::string& name)
{
    require_writable("the file of " + own.option, name);
    std::ofstream file(name, std::ios::binary);
    own.write(file);
    if (!file.flush()) throw std::runtime_error(name + " can't be written any further; is the disk full?");
    return 0;
}

int run(const Program& program, const Options& options)
{
    if (!options.answer.empty()) {
        std::cout << options.answer << std::flush;
        return 0;
    }
    if (options.own_file != nullptr) return write_own_file(*options.own_file, options.own_name);
    if (!options.problem.empty()) return solve(program, options);
    require_different_files(options);
    if (options.headless) return run_headless(program, options);
    std::string reason = no_window_reason();
#ifdef RIGID_HAS_WINDOW
    if (reason.empty())
        if (const auto code = run_window(program, options, reason)) return *code;
#endif
    return run_in_place_of_window(program, options, reason);
}

/// What was printed may wait in a buffer: a full disk shows here at the latest.
void require_printed()
{
    if (!std::cout.flush())
        throw std::runtime_error("the standard output can't be written to; is the disk full?");
}

}  // namespace

int run_program(const std::function<Program()>& make, int argc, char** argv)
{
    try {
        const Program program = make();
        require_consistent(program);
        const int code = run(program, parse_command_line(program, argc, argv));
        require_printed();
        return code;
    } catch (const std::invalid_argument& error) {
        std::cerr << error.what() << '\n';
        return 2;
    } catch (const std::exception& error) {
        std::cerr << sentence_of(error) << '\n';
        return 3;
    }
}

}  // namespace rigid
