/// The stability matrix: each stress at five levels, each method, sixteen perturbations a cell.
///
///     stress [--quick] [--csv FILE] [--only STRESS] [--method NAME] [--threads N] [--check FILE]
///     stress --turning [the same]                          bodies that turn
///     stress --joints [the same]                           bodies on joints
///     stress --space [the same]                            bodies in space
///     stress --mark [--csv FILE]
///     stress --energy [--csv FILE]
///
/// Writes a table as it goes; a table that is there already is gone on with, so an interrupted run loses nothing. The
/// table is the same for any number of threads.

#include "common/program/interrupt.hpp"
#include "common/program/progress.hpp"
#include "common/text.hpp"
#include "tests/stress/jointed.hpp"
#include "tests/stress/space.hpp"
#include "tests/stress/stresses.hpp"
#include "tests/stress/table.hpp"

#include <CLI/CLI.hpp>
#include <atomic>
#include <condition_variable>
#include <fstream>
#include <iostream>
#include <mutex>
#include <thread>

using namespace rigid;
using namespace rigid::stress;

namespace {

struct Options {
    std::string file, only, method, check;
    bool quick = false, mark = false, energy = false, turning = false, joints = false, space = false;
    int threads = 0;
};

template <class Scene>
struct Cell {
    const StressOf<Scene>* stress;
    int level;
    const MethodOf<Scene>* method;
};

template <class Scene>
Row row_of(const Cell<Scene>& cell, bool quick)
{
    const int seeds = quick ? 2 : cell.stress->seeds[static_cast<std::size_t>(cell.level)];
    Row row{cell.stress->name, cell.level + 1, cell.method->name, cell.method->chapter,
            cell.stress->values[static_cast<std::size_t>(cell.level)]};
    int sum = 0;
    for (int seed = 1; seed <= seeds; ++seed) {
        const std::optional<Verdict> verdict =
            cell.stress->run(*cell.method, cell.level, static_cast<std::uint64_t>(seed));
        if (!verdict) return row;
        sum += verdict->score;
        if (seed == 1 || verdict->score < row.lowest) row.lowest = verdict->score, row.why = verdict->why;
    }
    row.seeds = seeds;
    row.score = static_cast<Real>(sum) / (accurate * seeds);
    return row;
}

/// Fills rows with the cells in their order; whichever thread is free takes the next one. Stops early when interrupted.
class Workers {
public:
    template <class Scene>
    Workers(const std::vector<Cell<Scene>>& cells, const Options& options)
        : rows_(cells.size()), done_(cells.size())
    {
        const int count = options.threads > 0
                              ? options.threads
                              : std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
        for (int n = 0; n < count; ++n)
            threads_.emplace_back([this, &cells, quick = options.quick] {
                for (std::size_t i = next_++; i < cells.size() && !stop_; i = next_++) {
                    Row row = row_of(cells[i], quick);
                    const std::lock_guard lock(mutex_);
                    rows_[i] = std::move(row);
                    done_[i] = true;
                    changed_.notify_one();
                }
            });
    }
    ~Workers()
    {
        stop_ = true;
        for (std::thread& thread : threads_) thread.join();
    }
    Workers(const Workers&) = delete;
    Workers& operator=(const Workers&) = delete;

    /// Waits for cell i; nothing if the run is interrupted first.
    const Row* wait_for(std::size_t i)
    {
        std::unique_lock lock(mutex_);
        while (!done_[i]) {
            changed_.wait_for(lock, std::chrono::milliseconds(200));
            if (!done_[i] && InterruptGuard::interrupted()) return nullptr;
        }
        return &rows_[i];
    }

private:
    std::vector<Row> rows_;
    std::vector<bool> done_;
    std::atomic<std::size_t> next_ = 0;
    std::atomic<bool> stop_ = false;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::vector<std::thread> threads_;
};

void require_one_of(const std::string& name, const std::string& what, const std::vector<std::string>& names)
{
    if (name.empty() || std::find(names.begin(), names.end(), name) != names.end()) return;
    std::string sentence = "there is no " + what + " \"" + name + "\"; there are";
    for (const std::string& known : names) sentence += " \"" + known + "\"";
    throw std::invalid_argument(sentence);
}

/// A table that was gone on with has its cells in the order of the runs: puts them where a single run has them. Cells
/// of stresses and methods that are no more go.
template <class Scene>
void write_in_order(const std::string& file, const std::vector<Row>& table,
                    const std::vector<StressOf<Scene>>& all, const std::vector<MethodOf<Scene>>& columns)
{
    std::ofstream out(file);
    out << header << '\n';
    for (const auto& stress : all)
        for (int level = 0; level < levels; ++level)
            for (const auto& method : columns)
                if (const Row* row = find_row(table, stress.name, level + 1, method.name))
                    out << to_line(*row);
    if (!out) throw std::runtime_error("the table could not be written");
}

template <class Scene>
int run(const Options& options, const std::vector<StressOf<Scene>>& all,
        const std::vector<MethodOf<Scene>>& columns)
{
    std::vector<std::string> names;
    for (const auto& stress : all) names.push_back(stress.name);
    require_one_of(options.only, "stress", names);
    names.clear();
    for (const auto& method : columns) names.push_back(method.name);
    require_one_of(options.method, "method", names);

    std::vector<Row> table = read_table(options.file);
    std::vector<Cell<Scene>> cells;
    for (const auto& stress : all)
        for (int level = 0; level < levels; ++level)
            for (const auto& method : columns)
                if ((options.only.empty() || stress.name == options.only) &&
                    (options.method.empty() || method.name == options.method) &&
                    (!options.quick || stress.quick) && !find_row(table, stress.name, level + 1, method.name))
                    cells.push_back({&stress, level, &method});

    std::ofstream file;
    if (!options.file.empty()) file.open(options.file, std::ios::app);
    std::ostream& out = options.file.empty() ? std::cout : file;
    if (table.empty()) out << header << '\n';

    InterruptGuard guard;
    Progress progress(static_cast<long>(cells.size()));
    Workers workers(cells, options);
    for (std::size_t i = 0; i < cells.size(); ++i) {
        progress.show(static_cast<long>(i));
        const Row* row = workers.wait_for(i);
        if (!row) return 130;
        out << to_line(*row) << std::flush;
        table.push_back(*row);
    }
    progress.clear();
    if (!out) throw std::runtime_error("the table could not be written");
    file.close();
    if (!options.file.empty()) write_in_order(options.file, table, all, columns);

    int faults = complain_of_silence(table, std::cerr);
    if (!options.check.empty()) faults += complain_of_differences(table, options.check, std::cerr);
    return faults > 0 ? 3 : 0;
}

/// The two scenes of a well-known comparison, with four sweeps a step: gaps in metres.
int mark(const Options& options)
{
    std::ofstream file;
    if (!options.file.empty()) file.open(options.file);
    std::ostream& out = options.file.empty() ? std::cout : file;
    out << "method,chapter,budget,column score,column gap,chain score,chain gap\n";
    const auto wish = std::make_shared<const Wish>();
    const auto worst_of_16 = [&](const Method& method, const DiscScene& start, const Task& task) {
        Verdict worst;
        for (std::uint64_t seed = 1; seed <= 16; ++seed) {
            DiscScene scene = start;
            perturb(scene, seed);
            const Verdict verdict = judge(scene, task, method.start(wish));
            worst.score = std::min(worst.score, verdict.score);
            worst.gap = std::max(worst.gap, verdict.gap);
        }
        return std::to_string(worst.score) + "," +
               (std::isfinite(worst.gap) ? significant(worst.gap, 3) : "");
    };
    std::vector<Method> all = methods(4);
    for (const Method& method :
         methods())  // and the exact ones with the small steps that they have in the matrix
        if (method.chapter == 9 && method.budget.ends_with("16 substeps")) all.push_back(method);
    for (const Method& method : all) {
        if (method.most_rows < 1000 && !method.links_only) continue;
        out << method.name << "," << method.chapter << ",\"" << method.budget << "\","
            << (method.links_only ? "," : worst_of_16(method, loaded_column(), standing())) << ","
            << worst_of_16(method, slanted_chain(40, 1000), swinging()) << "\n";
    }
    if (!out) throw std::runtime_error("the table could not be written");
    return 0;
}

/// What each method gains and loses where the exact energy never changes: ten seconds of 1/60 s, in per cent.
int energy(const Options& options)
{
    std::ofstream file;
    if (!options.file.empty()) file.open(options.file);
    std::ostream& out = options.file.empty() ? std::cout : file;
    out << "method,chapter,budget";
    for (const Conserving& one : conserving_scenes(1.0 / 60))
        out << "," << one.name << " gain," << one.name << " loss";
    out << "\n";
    const auto wish = std::make_shared<const Wish>();
    for (const Method& method : methods()) {
        out << method.name << "," << method.chapter << ",\"" << method.budget << "\"";
        for (Conserving& one : conserving_scenes(1.0 / 60)) {
            Verdict worst;
            for (std::uint64_t seed = 1; seed <= 4; ++seed) {
                DiscScene scene = one.scene;
                vary_masses(scene, seed);
                const Verdict verdict = judge(scene, one.task, method.start(wish));
                worst.gain = std::max(worst.gain, verdict.score == lost ? infinity : verdict.gain);
                worst.loss = std::max(worst.loss, verdict.loss);
            }
            const auto percent = [](Real share) {
                return std::isfinite(share) ? significant(100 * share, 2) : std::string();
            };
            out << "," << percent(worst.gain) << "," << percent(worst.loss);
        }
        out << "\n" << std::flush;
    }
    if (!out) throw std::runtime_error("the table could not be written");
    return 0;
}

}  // namespace

int main(int argc, char** argv)
{
    CLI::App app("The stability matrix of the book");
    Options options;
    app.add_option("--csv", options.file, "the table; it is gone on with if it exists");
    app.add_option("--only", options.only, "one stress");
    app.add_option("--method", options.method, "one method");
    app.add_option("--threads", options.threads, "how many; as many as the machine has, if not said");
    app.add_option("--check", options.check, "a table that this one must agree with, cell by cell");
    app.add_flag("--quick", options.quick, "two perturbations a cell instead of sixteen, and no long runs");
    app.add_flag("--mark", options.mark, "two hard scenes with four sweeps a step: gaps in metres");
    app.add_flag("--energy", options.energy, "what is gained and lost where energy never changes: per cent");
    app.add_flag("--turning", options.turning, "bodies that turn, under the methods of chapters 11 to 13");
    app.add_flag("--joints", options.joints,
                 "bodies on joints, under the methods of chapters 14, 15, 16, 19 and 26");
    app.add_flag("--space", options.space, "bodies in space, under the methods of chapter 25");
    CLI11_PARSE(app, argc, argv);
    try {
        if (options.space) return run(options, space_stresses(), space_methods());
        if (options.joints) return run(options, jointed_stresses(), jointed_methods());
        if (options.turning) return run(options, turning_stresses(), turning_methods());
        return options.mark     ? mark(options)
               : options.energy ? energy(options)
                                : run(options, stresses(), methods());
    } catch (const std::exception& error) {
        std::cerr << "stress: " << error.what() << '\n';
        return 2;
    }
}
