/// The stability matrix: each stress at five levels, each method, sixteen perturbations a cell.
///
///     stress [--quick] [--csv FILE] [--only STRESS] [--method NAME]
///
/// Writes a table as it goes; a table that is there already is gone on with, so an interrupted run loses nothing.

#include "common/program/interrupt.hpp"
#include "common/program/progress.hpp"
#include "common/text.hpp"
#include "tests/stress/stresses.hpp"

#include <CLI/CLI.hpp>
#include <fstream>
#include <iostream>
#include <set>

using namespace rigid;
using namespace rigid::stress;

namespace {

/// A cell of the table: the first three columns name it.
std::string cell_name(const Stress& stress, int level, const Method& method)
{
    return stress.name + "," + std::to_string(level + 1) + "," + method.name;
}

constexpr const char* header = "stress,level,method,chapter,value,score,lowest,seeds";

/// The names of the cells that a table already has. Throws if it is not such a table.
std::set<std::string> done_cells(const std::string& file)
{
    std::set<std::string> names;
    std::ifstream table(file);
    std::string line;
    if (!table || !std::getline(table, line)) return names;
    if (line != header)
        throw std::invalid_argument("\"" + file + "\" begins with \"" + line +
                                    "\"; a table of this program begins with \"" + header + "\"");
    while (std::getline(table, line)) {
        std::size_t end = 0;
        for (int commas = 0; commas < 3 && end != std::string::npos; ++commas) end = line.find(',', end + 1);
        names.insert(line.substr(0, end));
    }
    return names;
}

/// The row of a cell, or nothing where the stress does not apply to the method.
std::string cell(const Stress& stress, int level, const Method& method, int seeds)
{
    int sum = 0, lowest = accurate;
    for (int seed = 1; seed <= seeds; ++seed) {
        const std::optional<int> score = stress.run(method, level, static_cast<std::uint64_t>(seed));
        if (!score)
            return cell_name(stress, level, method) + "," + std::to_string(method.chapter) + ",\"" +
                   stress.values[static_cast<std::size_t>(level)] + "\",,,0\n";
        sum += *score;
        lowest = std::min(lowest, *score);
    }
    return cell_name(stress, level, method) + "," + std::to_string(method.chapter) + ",\"" +
           stress.values[static_cast<std::size_t>(level)] + "\"," +
           fixed(static_cast<Real>(sum) / (3 * seeds), 3) + "," + std::to_string(lowest) + "," +
           std::to_string(seeds) + "\n";
}

int run(const std::string& file, bool quick, const std::string& only, const std::string& one_method)
{
    const int seeds = quick ? 2 : 16;
    const std::set<std::string> done = done_cells(file);
    std::ofstream table;
    if (!file.empty()) table.open(file, std::ios::app);
    std::ostream& out = file.empty() ? std::cout : table;
    if (done.empty()) out << header << '\n';

    std::vector<std::pair<const Stress*, int>> rows;
    const std::vector<Stress> all = stresses();
    const std::vector<Method> columns = methods();
    for (const Stress& stress : all)
        for (int level = 0; level < levels; ++level)
            if ((only.empty() || stress.name == only) && (!quick || stress.quick))
                rows.emplace_back(&stress, level);

    InterruptGuard guard;
    Progress progress(static_cast<long>(rows.size() * columns.size()));
    long count = 0;
    for (const auto& [stress, level] : rows)
        for (const Method& method : columns) {
            progress.show(count++);
            if (InterruptGuard::interrupted()) return 130;
            if (!one_method.empty() && method.name != one_method) continue;
            if (done.count(cell_name(*stress, level, method))) continue;
            out << cell(*stress, level, method, seeds) << std::flush;
        }
    return out ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("The stability matrix of the book");
    std::string file, only, method;
    bool quick = false;
    app.add_option("--csv", file, "the table; it is gone on with if it exists");
    app.add_option("--only", only, "one stress");
    app.add_option("--method", method, "one method");
    app.add_flag("--quick", quick, "two perturbations a cell instead of sixteen, and no long runs");
    CLI11_PARSE(app, argc, argv);
    try {
        return run(file, quick, only, method);
    } catch (const std::exception& error) {
        std::cerr << "stress: " << error.what() << '\n';
        return 2;
    }
}
