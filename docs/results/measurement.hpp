/// \file measurement.hpp
/// What is measured: cases, each a method on a scene, and the table that their numbers go into.
///
/// A case prepares a task; the task is run, as often as a clock needs it, and judged once. Only `run` is timed and
/// counted: scenes are built and errors are computed outside of it.
#pragma once

#include "common/text.hpp"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rigid::results {

/// What came out of a task.
struct Result {
    std::optional<std::int64_t> work;  ///< counted, in the case's unit; none for a program that does not tell
    std::optional<std::int64_t> sweeps;
    Real error = infinity;  ///< against the case's reference
    std::string status;
};

struct Task {
    std::function<void()> run;  ///< the whole of what is measured; each call does the same again
    std::function<Result()> judge;
    std::function<Real()> seconds;  ///< empty, or the time of the last run() as it measured itself [s]
};

struct Case {
    std::string chapter;     ///< number of the chapter that teaches the method; "peer" for other programs
    std::string method;      ///< snake_case
    std::string scene;       ///< snake_case; cases of one scene have the same reference and the same error
    std::string parameters;  ///< of the scene and the method, "key=value key=value"
    Real h = 0;              ///< time step [s]; 0 = the method has none
    bool quick = false;      ///< part of the short run
    std::function<Task()> prepare;
};

/// All cases, in the order of the table.
class Registry {
public:
    void add(Case one) { cases_.push_back(std::move(one)); }
    const std::vector<Case>& cases() const { return cases_; }

private:
    std::vector<Case> cases_;
};

/// What a row of the table is known by: its first five fields, which no other row shares.
inline std::string name_of(const Case& one)
{
    return one.chapter + ',' + one.method + ',' + one.scene + ',' + one.parameters + ',' +
           (one.h > 0 ? shortest(one.h) : "");
}

inline const char* const table_head =
    "chapter,method,scene,parameters,h,sweeps,work,instructions,time_ratio,error,status";

/// One row of the table. What was not measured is left empty.
struct TableRow {
    std::string name;  ///< see name_of()
    std::string sweeps, work, instructions, time_ratio, error, status;

    std::string line() const
    {
        return name + ',' + sweeps + ',' + work + ',' + instructions + ',' + time_ratio + ',' + error + ',' +
               status;
    }
};

inline TableRow row_of(const Case& one, const Result& result)
{
    TableRow row;
    row.name = name_of(one);
    if (result.sweeps) row.sweeps = std::to_string(*result.sweeps);
    if (result.work) row.work = std::to_string(*result.work);
    row.error = result.error < infinity ? significant(result.error, 4) : "inf";
    row.status = result.status;
    return row;
}

/// A row from its line; nothing for a line that is not whole.
inline std::optional<TableRow> parse_row(const std::string& line)
{
    std::vector<std::string> field(1);
    for (const char c : line) {
        if (c == ',') field.emplace_back();
        else field.back() += c;
    }
    if (field.size() != 11) return std::nullopt;
    TableRow row;
    row.name = field[0] + ',' + field[1] + ',' + field[2] + ',' + field[3] + ',' + field[4];
    row.sweeps = field[5];
    row.work = field[6];
    row.instructions = field[7];
    row.time_ratio = field[8];
    row.error = field[9];
    row.status = field[10];
    return row;
}

}  // namespace rigid::results
