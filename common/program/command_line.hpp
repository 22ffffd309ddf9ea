/// \file command_line.hpp
/// What the reader typed, checked against what the program offers.
#pragma once

#include "common/program/program.hpp"

#include <optional>
#include <string>
#include <vector>

namespace rigid {

struct Options {
    std::string answer;  ///< not empty: print this and end (--help, --list-scenes)

    const Demo* scene = nullptr;
    Settings settings;                 ///< of the run; its method is the first one
    std::vector<std::string> methods;  ///< at least one; several = side by side
    bool methods_given = false;        ///< by --method
    std::optional<long> steps;
    bool headless = false;
    bool dark = false;          ///< the colours of window, png and record
    std::string csv, svg, png;  ///< files; csv may be "-"
    std::string record;         ///< a folder
    long every = 1;             ///< steps between two recorded frames

    std::string problem;  ///< a file
    std::string problem_method;

    const OwnFile* own_file = nullptr;  ///< not null: write it as `own_name` and end
    std::string own_name;
};

/// Throws std::invalid_argument with one sentence that names the thing, its value and what would be right.
Options parse_command_line(const Program& program, int argc, const char* const* argv);

/// Throws std::invalid_argument if the program contradicts itself: two scenes of one name, a tunable
/// whose value is out of its range, a column whose name is no word, a view that shows nothing …
void require_consistent(const Program& program);

}  // namespace rigid
