/// \file instructions.hpp
/// How many instructions a task takes, counted by Valgrind's callgrind: the same number on each run of the same
/// program.
///
/// The program starts itself again under callgrind, which looks on only while a task runs and leaves a file for
/// each case.
#pragma once

#include "docs/results/measurement.hpp"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <span>
#include <string>

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#define RIGID_HAS_CALLGRIND
#endif

namespace rigid::results {

inline bool can_count_instructions()
{
#ifdef RIGID_HAS_CALLGRIND
    return std::system("valgrind --version >/dev/null 2>&1") == 0;
#else
    return false;
#endif
}

/// Under callgrind: runs the task once while it looks on. \param number  of the case, written into its file
inline void count_task(const Task& task, std::size_t number)
{
    task.run();  // memory and tables that a first run asks for are not what is counted
#ifdef RIGID_HAS_CALLGRIND
    const std::string name = std::to_string(number);
    CALLGRIND_START_INSTRUMENTATION;
    CALLGRIND_ZERO_STATS;
    task.run();
    CALLGRIND_DUMP_STATS_AT(name.c_str());
    CALLGRIND_STOP_INSTRUMENTATION;
#else
    (void)number;
#endif
}

/// The counts that callgrind left in a folder, by the number of the case.
inline std::map<std::size_t, std::string> read_counts(const std::filesystem::path& folder)
{
    std::map<std::size_t, std::string> counts;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::ifstream file(entry.path());
        const std::string trigger = "desc: Trigger: Client Request: ", totals = "totals: ";
        std::string line, number;
        while (std::getline(file, line)) {
            if (line.rfind(trigger, 0) == 0) number = line.substr(trigger.size());
            if (line.rfind(totals, 0) == 0 && !number.empty())
                counts[std::stoul(number)] = line.substr(totals.size());
        }
    }
    return counts;
}

/// Starts this program under callgrind for the cases of these numbers.
/// \param folder  for its files: it is emptied
/// \return  false if that failed
inline bool run_under_callgrind(const std::string& program, std::span<const std::size_t> numbers,
                                const std::filesystem::path& folder)
{
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    std::string command = "valgrind -q --tool=callgrind --instr-atstart=no --callgrind-out-file='" +
                          (folder / "count").string() + "' '" + program + "' --count-under-callgrind";
    for (const std::size_t number : numbers) command += ' ' + std::to_string(number);
    command += " >/dev/null 2>&1";
    return std::system(command.c_str()) == 0;
}

}  // namespace rigid::results
