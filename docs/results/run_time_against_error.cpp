// Every method of every chapter on common scenes: error, and what it costs.
//
//   results --csv FILE             measures what FILE does not have yet, and goes on where it was stopped
//   results --quick                the short run
//   results --work-only            counted work and errors, no times: the same on every machine
//   results --check FILE           compares the counted work with FILE's, and fails where it is not the same
//   results --instructions         adds what callgrind counts
#include "docs/results/cases.hpp"
#include "docs/results/instructions.hpp"
#include "docs/results/timing.hpp"

#include "common/program/interrupt.hpp"

#include <CLI/CLI.hpp>

#include <chrono>
#include <iostream>
#include <unistd.h>

using namespace rigid;
using namespace rigid::results;

namespace {

struct Options {
    std::string csv = "results.csv", check, only;
    bool quick = false, work_only = false, instructions = false, again = false;
};

/// One line on a terminal, and nothing where there is none.
void tell(std::size_t done, std::size_t all, const std::string& what)
{
    if (isatty(2)) std::cerr << "\r" << done << " of " << all << ": " << what << "\x1b[K" << std::flush;
}

std::vector<Case> chosen(const Options& options)
{
    std::vector<Case> cases;
    const Registry registry = all_cases();
    for (const Case& one : registry.cases())
        if ((one.quick || !options.quick) && name_of(one).find(options.only) != std::string::npos)
            cases.push_back(one);
    std::vector<std::string> names;
    for (const Case& one : cases) names.push_back(name_of(one));
    std::sort(names.begin(), names.end());
    const auto twice = std::adjacent_find(names.begin(), names.end());
    if (twice != names.end()) throw std::logic_error("two cases have the name " + *twice);
    return cases;
}

std::map<std::string, TableRow> read_table(const std::string& file)
{
    std::map<std::string, TableRow> rows;
    std::ifstream stream(file);
    std::string line;
    std::getline(stream, line);
    if (line != table_head) return rows;
    while (std::getline(stream, line))
        if (const auto row = parse_row(line)) rows[row->name] = *row;
    return rows;
}

/// What a time ratio of 1 is on this machine: a last line of the table, written again when something was measured.
const std::string yardstick = "0,baseline,baseline,microseconds=";

std::string yardstick_line(const std::map<std::string, TableRow>& rows)
{
    if (least_baseline() < infinity)
        return yardstick + significant(1e6 * least_baseline(), 3) +
               " unit=row_visit reference=none,,,1000,,1,0,finished\n";
    const auto before = rows.lower_bound(yardstick);
    const bool known = before != rows.end() && before->first.rfind(yardstick, 0) == 0;
    return known ? before->second.line() + '\n' : "";
}

/// The whole table, in the order of the cases, by way of a second file: never half a table.
void write_table(const std::string& file, const std::vector<Case>& cases,
                 const std::map<std::string, TableRow>& rows)
{
    {
        std::ofstream stream(file + ".new");
        stream << table_head << '\n';
        for (const Case& one : cases)
            if (const auto row = rows.find(name_of(one)); row != rows.end())
                stream << row->second.line() << '\n';
        stream << yardstick_line(rows);
        if (!stream.flush()) throw std::runtime_error("cannot write " + file + ".new");
    }
    std::filesystem::rename(file + ".new", file);
}

/// A method that gives up by an exception has failed, and says why by its status.
TableRow failed(const Case& one, const std::exception& fault)
{
    std::cerr << "\n" << name_of(one) << ": " << fault.what() << '\n';
    return row_of(one, {{}, {}, infinity, "gave up"});
}

TableRow measure(const Case& one, const Options& options)
try {
    const Task task = one.prepare();
    const auto start = std::chrono::steady_clock::now();
    task.run();
    const std::chrono::duration<Real> passed = std::chrono::steady_clock::now() - start;
    TableRow row = row_of(one, task.judge());
    if (!options.work_only) row.time_ratio = significant(time_ratio(task, passed.count(), options.quick), 4);
    return row;
} catch (const std::runtime_error& fault) {
    return failed(one, fault);
}

/// Callgrind takes fifty times as long: longer runs than this are left to the clock [time units].
constexpr Real longest_counted = 3000;

/// Is measured, short enough, and not counted yet?
bool wants_count(const std::map<std::string, TableRow>& rows, const Case& one)
{
    const auto row = rows.find(name_of(one));
    if (row == rows.end() || !row->second.instructions.empty()) return false;
    const auto time = parse_real(row->second.time_ratio);
    return time && *time <= longest_counted;
}

/// Callgrind looks at as many cases at a time as can be lost when it is interrupted.
bool count_instructions(const std::string& program, const Options& options, const std::vector<Case>& cases,
                        std::map<std::string, TableRow>& rows)
{
    if (!can_count_instructions()) {
        std::cerr << "instructions are not counted: valgrind or its header was not found\n";
        return true;  // the table is whole without them
    }
    const Registry registry = all_cases();
    std::map<std::string, std::size_t> number;
    for (std::size_t i = 0; i < registry.cases().size(); ++i) number[name_of(registry.cases()[i])] = i;
    const auto folder = std::filesystem::path(options.csv + ".callgrind");
    constexpr std::size_t at_a_time = 100;
    std::vector<std::size_t> wanted;
    for (const Case& one : cases)
        if (wants_count(rows, one)) wanted.push_back(number.at(name_of(one)));
    for (std::size_t i = 0; i < wanted.size() && !InterruptGuard::interrupted(); i += at_a_time) {
        const std::size_t end = std::min(i + at_a_time, wanted.size());
        tell(i, wanted.size(), "counting instructions");
        if (!run_under_callgrind(program, {wanted.data() + i, end - i}, folder)) return false;
        for (const auto& [which, count] : read_counts(folder))
            if (const auto row = rows.find(name_of(registry.cases()[which])); row != rows.end())
                row->second.instructions = count;
        write_table(options.csv, cases, rows);
    }
    std::filesystem::remove_all(folder);
    return true;
}

/// The same numbers but for the last digits that another compiler may round otherwise?
bool same_error(const std::string& a, const std::string& b)
{
    const auto x = parse_real(a), y = parse_real(b);
    if (!x || !y) return a == b;
    // Below 1e-9 an error is made of roundings; above, 5 % is more than they do and less than a method's loss.
    return std::abs(*x - *y) <= 0.05 * std::max(*x, *y) || (*x < 1e-9 && *y < 1e-9);
}

/// Holds the counted work against the committed one. \return  how many cases differ
int check(const Options& options, const std::vector<Case>& cases, const std::map<std::string, TableRow>& rows)
{
    const auto committed = read_table(options.check);
    if (committed.empty()) throw std::invalid_argument(options.check + " is no table of this program");
    int faults = 0;
    for (const Case& one : cases) {
        const TableRow& now = rows.at(name_of(one));
        const auto before = committed.find(name_of(one));
        const auto fault = [&](const std::string& what) {
            std::cout << name_of(one) << ": " << what << '\n';
            ++faults;
        };
        if (before == committed.end()) {
            fault("is not in " + options.check);
            continue;
        }
        const TableRow& then = before->second;
        if (now.work != then.work) fault("its work is " + now.work + ", it was " + then.work);
        if (now.sweeps != then.sweeps) fault("it takes " + now.sweeps + " sweeps, it took " + then.sweeps);
        if (now.status != then.status)
            fault("it ends as '" + now.status + "', it ended as '" + then.status + "'");
        if (!same_error(now.error, then.error)) fault("its error is " + now.error + ", it was " + then.error);
    }
    for (const auto& row : committed)
        if (const std::string& name = row.first;
            std::none_of(cases.begin(), cases.end(), [&](const Case& one) { return name_of(one) == name; })) {
            std::cout << name << ": is in " << options.check << " and not measured any more\n";
            ++faults;
        }
    if (faults > 0)
        std::cout << faults
                  << " differences. If they are meant (less work at the same error is), make the file "
                     "again: ./book bench --work\n";
    return faults;
}

/// The other side of --instructions: this process runs under callgrind.
int count_cases(const std::vector<std::size_t>& numbers)
{
    const Registry registry = all_cases();
    for (const std::size_t i : numbers) try {
            count_task(registry.cases().at(i).prepare(), i);
        } catch (const std::runtime_error&) {
            // It has failed in the table already.
        }
    return 0;
}

int run(const std::string& program, const Options& options)
{
    const std::vector<Case> cases = chosen(options);
    std::map<std::string, TableRow> rows;
    if (!options.again && options.check.empty()) rows = read_table(options.csv);
    InterruptGuard guard;
    auto last_write = std::chrono::steady_clock::now();
    for (std::size_t i = 0; i < cases.size() && !InterruptGuard::interrupted(); ++i) {
        const auto known = rows.find(name_of(cases[i]));
        if (known != rows.end() &&
            (options.work_only || !known->second.time_ratio.empty() || known->second.status == "gave up"))
            continue;
        tell(i + 1, cases.size(), cases[i].method + " on " + cases[i].scene);
        TableRow row = measure(cases[i], options);
        if (known != rows.end()) row.instructions = known->second.instructions;
        rows[name_of(cases[i])] = row;
        const auto now = std::chrono::steady_clock::now();
        if (options.check.empty() && now - last_write > std::chrono::seconds(2)) {
            write_table(options.csv, cases, rows);
            last_write = now;
        }
    }
    if (!options.check.empty()) return check(options, cases, rows) == 0 ? 0 : 1;
    write_table(options.csv, cases, rows);
    bool whole = !InterruptGuard::interrupted();
    if (whole && options.instructions) whole = count_instructions(program, options, cases, rows);
    if (isatty(2)) std::cerr << "\r\x1b[K";
    const auto there = std::count_if(cases.begin(), cases.end(),
                                     [&](const Case& one) { return rows.count(name_of(one)) > 0; });
    std::cerr << there << " of " << cases.size() << " cases are in " << options.csv << '\n';
    return whole && !InterruptGuard::interrupted() ? 0 : 3;
}

}  // namespace

int main(int argc, char** argv)
{
    Options options;
    std::vector<std::size_t> under_callgrind;
    CLI::App app("Run time against error of every method of the book");
    app.add_option("--csv", options.csv, "the table; what it has is kept, what is missing is measured");
    app.add_option("--only", options.only, "only cases whose name has this in it");
    app.add_flag("--quick", options.quick, "the short run");
    app.add_flag("--work-only", options.work_only, "counted work and errors, no times");
    app.add_flag("--instructions", options.instructions, "count instructions too, with callgrind");
    app.add_flag("--again", options.again, "measure again what the table has");
    app.add_option("--check", options.check, "hold the counted work against this table's");
    app.add_option("--count-under-callgrind", under_callgrind, "used by --instructions")
        ->expected(-1)
        ->group("");
    CLI11_PARSE(app, argc, argv);
    try {
        if (!under_callgrind.empty()) return count_cases(under_callgrind);
        return run(std::filesystem::read_symlink("/proc/self/exe").string(), options);
    } catch (const std::exception& fault) {
        std::cerr << "results: " << fault.what() << '\n';
        return 2;
    }
}
