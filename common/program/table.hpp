/// \file table.hpp
/// The table of a run: CSV, one row for each step and method.
///
///     step,t,energy,drift                    or, with several methods,   step,t,method,energy,drift
///     0,0,9.81,0                             0,0,rk4,9.81,0
///     1,0.016666666666666666,9.8087,1.2e-09  0,0,verlet,9.81,0
///
/// Each number is the shortest text that reads back as the same bits, with a decimal point whatever
/// the locale. With several methods each step has a row for each of them. A row is in the file as soon as it was
/// measured: nothing waits in memory, and nothing is lost however a run ends.
/// Units are in --help: a CSV column is a name and numbers.
#pragma once

#include "common/program/playback.hpp"

#include <fstream>
#include <functional>
#include <iosfwd>
#include <string>
#include <vector>

namespace rigid {

class Table {
public:
    /// Opens the file ("-" is the standard output) and writes the head. Throws std::invalid_argument,
    /// naming the file, if that can't be done.
    Table(const std::string& file, const Demo& scene, std::size_t methods);

    /// Adds what the tracks measured last, for those that moved since the last call. Throws
    /// std::runtime_error if it can't be written.
    void add(const std::vector<Track>& tracks);

private:
    std::ostream& out();
    void check();

    std::string file_;
    std::ofstream stream_;
    std::vector<long> last_step_;  ///< of each method, -1 = none yet
};

/// Writes the table of a window's run, where its file is named: what is shown again is written again.
std::function<void(const Playback&, bool fresh)> table_of_show(const std::string& file);

/// The last row of each track, with units, for a reader.
std::string summary(const Program& program, const Playback& playback);

}  // namespace rigid
