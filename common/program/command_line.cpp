#include "common/program/command_line.hpp"

#include "common/text.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cctype>
#include <optional>
#include <set>
#include <stdexcept>

namespace rigid {
namespace {

[[noreturn]] void refuse(const std::string& sentence) { throw std::invalid_argument(sentence); }

std::string in_quotes(const std::string& text) { return '"' + text + '"'; }

template <class List>
std::vector<std::string> names_of(const List& list)
{
    std::vector<std::string> names;
    for (const auto& one : list) names.push_back(one.name);
    return names;
}

bool is_among(const std::string& name, const std::vector<std::string>& names)
{
    return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_word(const std::string& text, const std::string& more)
{
    return !text.empty() && std::all_of(text.begin(), text.end(), [&](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || more.find(c) != std::string::npos;
    });
}

std::string range(Real low, Real high, const std::string& unit)
{
    return "between " + readable(low) + " and " + with_unit(readable(high), unit);
}

/// A whole number for an option such as --steps.
std::uint64_t whole(const std::string& option, const std::string& text, std::uint64_t low, std::uint64_t high)
{
    const auto value = parse_whole(text);
    if (!value || *value < low || *value > high)
        refuse(option + " is " + in_quotes(text) + "; it must be a whole number between " +
               std::to_string(low) + " and " + std::to_string(high));
    return *value;
}

/// Limits are shown with ten digits, 0.01666666667 for 1/60: what is typed as it is shown means the limit itself.
std::optional<Real> parse_within(const std::string& text, Real low, Real high)
{
    const auto value = parse_real(text);
    for (const Real limit : {low, high})
        if (value && *value == parse_real(readable(limit))) return limit;
    return value;
}

Real time_step(const Demo& scene, const std::string& text)
{
    const auto h = parse_within(text, scene.h_low, scene.h_high);
    const std::string right =
        "it must be a number " + range(scene.h_low, scene.h_high, "s") + " in scene " + scene.name;
    if (!h) refuse("the time step --h is " + in_quotes(text) + "; " + right);
    if (*h < scene.h_low || *h > scene.h_high) refuse("the time step --h is " + text + " s; " + right);
    return *h;
}

void set_tunable(const Demo& scene, Settings& settings, const std::string& assignment)
{
    const std::size_t equals = assignment.find('=');
    if (equals == std::string::npos || equals == 0)
        refuse("--set is " + in_quotes(assignment) + "; it must be name=value");
    const std::string name = assignment.substr(0, equals), text = assignment.substr(equals + 1);

    const auto tunable = std::find_if(scene.tunables.begin(), scene.tunables.end(),
                                      [&](const Tunable& one) { return one.name == name; });
    if (tunable == scene.tunables.end())
        refuse("scene " + scene.name + " has no tunable " + in_quotes(name) +
               (scene.tunables.empty() ? "; it has none" : "; it has: " + joined(names_of(scene.tunables))));
    const std::string right = std::string("it must be a ") + (tunable->whole() ? "whole " : "") + "number " +
                              range(tunable->low, tunable->high, tunable->unit);
    const std::vector<std::string> names = tunable->value_names();
    const auto called = std::find(names.begin(), names.end(), text);
    if (called != names.end()) {
        settings.tunables[name] = tunable->low + static_cast<Real>(called - names.begin());
        return;
    }
    const auto value = parse_within(text, tunable->low, tunable->high);
    if (!value) refuse("the tunable " + name + " is " + in_quotes(text) + "; " + right);
    if (*value < tunable->low || *value > tunable->high || (tunable->whole() && *value != std::round(*value)))
        refuse("the tunable " + name + " is " + with_unit(text, tunable->unit) + "; " + right);
    settings.tunables[name] = *value;
}

/// The words of all --method options: each a name or several with commas between.
std::vector<std::string> split_methods(const std::vector<std::string>& given)
{
    std::vector<std::string> methods;
    for (const std::string& list : given) {
        std::size_t begin = 0;
        for (std::size_t comma = 0; comma != std::string::npos; begin = comma + 1) {
            comma = list.find(',', begin);
            methods.push_back(list.substr(begin, comma == std::string::npos ? comma : comma - begin));
        }
    }
    return methods;
}

std::vector<std::string> checked_methods(const Demo& scene, const std::vector<std::string>& given)
{
    const std::vector<std::string> methods = split_methods(given);
    for (std::size_t i = 0; i < methods.size(); ++i) {
        if (scene.methods.empty())
            refuse("--method is " + in_quotes(methods[i]) + "; scene " + scene.name +
                   " has only one and takes no name");
        if (!is_among(methods[i], scene.methods))
            refuse("scene " + scene.name + " has no method " + in_quotes(methods[i]) +
                   "; it has: " + joined(scene.methods));
        if (is_among(methods[i], {methods.begin(), methods.begin() + static_cast<std::ptrdiff_t>(i)}))
            refuse("--method names " + in_quotes(methods[i]) + " twice; each method can stand there once");
    }
    return methods;
}

std::string padded(std::string text, std::size_t width)
{
    // Bytes that continue a UTF-8 character take no place on the screen.
    const auto seen = static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xC0) != 0x80; }));
    if (seen < width) text.append(width - seen, ' ');
    return text;
}

std::string list_of_scenes(const Program& program)
{
    std::size_t width = 0;
    for (const Demo& scene : program.scenes) width = std::max(width, scene.name.size());
    std::string text;
    for (const Demo& scene : program.scenes) text += padded(scene.name, width) + "  " + scene.summary + '\n';
    return text;
}

std::string help_of_scenes(const Program& program)
{
    std::string text = "\nScenes (the first one is the default):\n";
    for (const Demo& scene : program.scenes) {
        text += "\n  " + scene.name + ": " + scene.summary + '\n';
        text += "    --h " + readable(scene.h) + " s, " + range(scene.h_low, scene.h_high, "s") + '\n';
        if (!scene.methods.empty())
            text += "    --method " + joined(scene.methods) + " (default " + scene.methods.front() + ")\n";
        for (const Tunable& one : scene.tunables)
            text += "    --set " + padded(one.name + '=' + with_unit(readable(one.value), one.unit), 24) +
                    "  " + one.help + "; " + (one.whole() ? "whole number " : "") +
                    range(one.low, one.high, one.unit) + (one.restarts() ? "; restarts the scene" : "") +
                    '\n';
        for (const Column& column : scene.columns)
            text += "    column " +
                    padded(column.name + (column.unit.empty() ? "" : " [" + column.unit + ']'), 23) + "  " +
                    column.help + '\n';
    }
    if (program.solve_problem)
        text += "\nMethods for --problem: " + joined(program.problem_methods) + " (default " +
                program.problem_methods.front() + ")\n";
    return text;
}

/// CLI11's own complaints, each as one sentence.
std::string sentence(const CLI::ParseError& error)
{
    const std::string text = error.what(), name = text.substr(0, text.find(':'));
    const std::string rest = name.size() + 2 < text.size() ? text.substr(name.size() + 2) : "";
    if (dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr)
        return "there is no option " + in_quotes(rest) + "; --help lists all that there are";
    if (dynamic_cast<const CLI::ArgumentMismatch*>(&error) != nullptr && name.rfind("--", 0) == 0) {
        if (rest.find("missing") != std::string::npos) return name + " has no value; one must follow it";
        return name + " is given several times; it must be given once";
    }
    std::string line = text;
    std::replace(line.begin(), line.end(), '\n', ' ');
    return line + "; --help lists all options";
}

}  // namespace

void require_consistent(const Program& program)
{
    if (program.scenes.empty() && !program.solve_problem)
        refuse("the program " + in_quotes(program.name) + " has 0 scenes; it must have at least one");
    if (program.solve_problem && program.problem_methods.empty())
        refuse("the program " + in_quotes(program.name) + " has 0 methods for problems; it must have one");
    std::set<std::string> scenes;
    for (const Demo& scene : program.scenes) {
        const std::string where = "scene " + in_quotes(scene.name) + ": ";
        if (!is_word(scene.name, "_-")) refuse(where + "its name must be of letters, digits, _ and -");
        if (!scenes.insert(scene.name).second)
            refuse(where + "there are two of this name; each must have its own");
        if (!scene.start) refuse(where + "it has no function start");
        if (!scene.view.centre.allFinite() || !scene.view.half_size.allFinite() ||
            !(scene.view.half_size.minCoeff() > 0))
            refuse(where + "its view shows nothing; both half sizes must be positive and finite");
        if (!(scene.h_low > 0) || !(scene.h_low <= scene.h) || !(scene.h <= scene.h_high) ||
            !std::isfinite(scene.h_high))
            refuse(where + "h is " + readable(scene.h) + " s; it must lie " +
                   range(scene.h_low, scene.h_high, "s") + ", and both must be positive");
        std::set<std::string> names;
        for (const std::string& method : scene.methods) {
            if (!is_word(method, "_-+."))
                refuse(where + "the method " + in_quotes(method) + " must be of letters, digits and _ - + .");
            if (!names.insert(method).second)
                refuse(where + "it lists the method " + in_quotes(method) + " twice");
        }
        if (scene.side_by_side.size() > most_panes)
            refuse(where + "side_by_side names " + std::to_string(scene.side_by_side.size()) +
                   " methods; a window shows " + std::to_string(most_panes) + " at most");
        for (const std::string& method : scene.side_by_side)
            if (!is_among(method, scene.methods))
                refuse(where + "side_by_side names " + in_quotes(method) +
                       ", which is not among its methods");
        names.clear();
        for (const Tunable& one : scene.tunables) {
            if (!is_word(one.name, "_-"))
                refuse(where + "the tunable " + in_quotes(one.name) + " must be of letters, digits, _ and -");
            if (!names.insert(one.name).second) refuse(where + "it has two tunables " + in_quotes(one.name));
            if (!(one.low <= one.value) || !(one.value <= one.high) || !std::isfinite(one.low) ||
                !std::isfinite(one.high))
                refuse(where + "the tunable " + one.name + " is " + readable(one.value) + "; it must lie " +
                       range(one.low, one.high, one.unit));
            if (one.whole() && one.value != std::round(one.value))
                refuse(where + "the tunable " + one.name + " is " + readable(one.value) +
                       "; it must be whole");
            if (!one.names.empty() &&
                (!one.whole() || one.high - one.low + 1 != static_cast<Real>(one.names.size())))
                refuse(where + "the tunable " + one.name + " has " + std::to_string(one.names.size()) +
                       " names; each whole number " + range(one.low, one.high, one.unit) + " must have one");
        }
        names = {"step", "t", "method"};
        for (const Column& column : scene.columns) {
            if (!is_word(column.name, "_"))
                refuse(where + "the column " + in_quotes(column.name) + " must be of letters, digits and _");
            if (!names.insert(column.name).second)
                refuse(where + "the column " + in_quotes(column.name) +
                       " is there twice (step, t and method always are)");
        }
        for (const Column& column : scene.columns) {
            const auto host = std::find_if(scene.columns.begin(), scene.columns.end(),
                                           [&](const Column& one) { return one.name == column.beside; });
            if (!column.beside.empty() && (host == scene.columns.end() || !host->has_own_plot()))
                refuse(where + "the column " + column.name + " stands beside " + in_quotes(column.beside) +
                       ", which has no plot of its own");
        }
    }
}

Options parse_command_line(const Program& program, int argc, const char* const* argv)
{
    Options options;
    std::string scene_name, h_text, steps_text, seed_text, every_text;
    std::vector<std::string> assignments, methods;
    bool list_scenes = false, help = false;

    CLI::App app(program.title, program.name);
    app.set_help_flag();
    app.add_flag("-h,--help", help, "Say this and end");
    if (!program.scenes.empty()) {
        app.add_option("--scene", scene_name, "What to run; see below")->type_name("NAME");
        app.add_flag("--list-scenes", list_scenes, "List the scenes and end");
        app.add_option("--set", assignments, "Tunables of the scene, one or several; see below")
            ->type_name("NAME=VALUE");
    }
    app.add_option("--method", methods, "Which method; several with commas between stand side by side")
        ->type_name("NAME");
    if (!program.scenes.empty()) {
        app.add_option(
               "--steps", steps_text,
               "How many time steps (without a window 300 if not said; a window then closes by itself)")
            ->type_name("N");
        app.add_option("--h", h_text, "Time step in seconds")->type_name("S");
        app.add_option("--seed", seed_text, "Seed of all that is random (1)")->type_name("N");
    }
    app.add_flag("--headless", options.headless, "Run without a window");
    if (!program.scenes.empty()) {
        app.add_option("--csv", options.csv, "Write a table, one row for each step; - is the standard output")
            ->type_name("FILE");
        app.add_option("--svg", options.svg, "Write the last picture as SVG")->type_name("FILE");
        app.add_option("--png", options.png,
                       "Write the last picture as PNG, with the panel if there is a window")
            ->type_name("FILE");
        app.add_option("--record", options.record, "Write numbered pictures into this folder")
            ->type_name("DIR");
        app.add_option("--every", every_text, "Steps between two recorded pictures (1)")->type_name("N");
        app.add_flag("--dark", options.dark, "Dark colours in the window, in --png and in --record");
    }
    if (program.solve_problem)
        app.add_option("--problem", options.problem,
                       "Solve the problem in this file instead of running a scene")
            ->type_name("FILE");
    std::vector<std::string> own_names(program.own_files.size());
    for (std::size_t i = 0; i < own_names.size(); ++i)
        app.add_option(program.own_files[i].option, own_names[i], program.own_files[i].help)
            ->type_name("FILE");

    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        refuse(sentence(error));
    }

    if (help) {
        options.answer = app.help();
        if (!program.scenes.empty()) options.answer += help_of_scenes(program);
        return options;
    }
    if (list_scenes) {
        options.answer = list_of_scenes(program);
        return options;
    }
    const auto require_no_scene = [&](const std::string& option, const std::string& file, const char* right) {
        if (file.empty()) refuse(option + " is \"\"; it must be a file name");
        for (const char* name : {"--scene", "--set", "--steps", "--h", "--seed", "--csv", "--svg", "--png",
                                 "--record", "--every", "--dark"})
            if (const CLI::Option* one = app.get_option_no_throw(name); one != nullptr && one->count() > 0)
                refuse(std::string(name) + " is for scenes; with " + option + right);
    };
    for (std::size_t i = 0; i < own_names.size(); ++i) {
        const std::string& option = program.own_files[i].option;
        if (app.count(option) == 0) continue;
        require_no_scene(option, own_names[i], " no other option can stand");
        if (!methods.empty() || !options.problem.empty() || options.own_file != nullptr)
            refuse(option + " writes a file and ends; no other option can stand beside it");
        options.own_file = &program.own_files[i], options.own_name = own_names[i];
    }
    if (options.own_file != nullptr) return options;
    if (program.solve_problem && app.count("--problem") > 0) {
        require_no_scene("--problem", options.problem, " only --method can stand");
        const std::vector<std::string> words = split_methods(methods);
        if (words.size() > 1)
            refuse("--method names " + std::to_string(words.size()) +
                   " methods; with --problem it must name one");
        if (!words.empty() && !is_among(words.front(), program.problem_methods))
            refuse("--problem has no method " + in_quotes(words.front()) +
                   "; it has: " + joined(program.problem_methods));
        if (!words.empty()) options.problem_method = words.front();
        else options.problem_method = program.problem_methods.front();
        return options;
    }
    if (program.scenes.empty()) refuse("--problem is missing; this program has no scenes and solves a file");

    options.scene = &program.scenes.front();
    if (app.count("--scene") > 0) {
        const auto found = std::find_if(program.scenes.begin(), program.scenes.end(),
                                        [&](const Demo& scene) { return scene.name == scene_name; });
        if (found == program.scenes.end())
            refuse("there is no scene " + in_quotes(scene_name) +
                   "; there are: " + joined(names_of(program.scenes)));
        options.scene = &*found;
    }
    const Demo& scene = *options.scene;
    options.settings = default_settings(scene);
    std::set<std::string> assigned;
    for (const std::string& assignment : assignments) {
        set_tunable(scene, options.settings, assignment);
        const std::string name = assignment.substr(0, assignment.find('='));
        if (!assigned.insert(name).second)
            refuse("the tunable " + name + " is set twice, the second time by " + in_quotes(assignment));
    }
    if (app.count("--h") > 0) options.settings.h = time_step(scene, h_text);
    if (app.count("--seed") > 0) options.settings.seed = whole("--seed", seed_text, 0, UINT64_MAX);
    if (app.count("--steps") > 0)
        options.steps = static_cast<long>(whole("--steps", steps_text, 0, 1'000'000'000));
    if (app.count("--every") > 0) {
        if (options.record.empty())
            refuse("--every is " + in_quotes(every_text) +
                   " but --record is missing; it must say the folder");
        options.every = static_cast<long>(whole("--every", every_text, 1, 1'000'000'000));
    }
    if (options.dark && options.headless && app.count("--png") + app.count("--record") == 0)
        refuse("--dark is for a window, --png or --record; with --headless one of those two must be there "
               "(an --svg reads on light and on dark)");
    for (const char* name : {"--csv", "--svg", "--png", "--record"})
        if (app.count(name) > 0 && app.get_option(name)->results().front().empty())
            refuse(std::string(name) + " is \"\"; it must be a file name");

    options.methods_given = !methods.empty();
    options.methods = checked_methods(scene, methods);
    if (!options.headless && options.methods.size() > most_panes)
        refuse("--method names " + std::to_string(options.methods.size()) + " methods; a window shows " +
               std::to_string(most_panes) + " at most (--headless takes any number)");
    if (options.methods.empty()) options.methods = {options.settings.method};
    options.settings.method = options.methods.front();
    return options;
}

}  // namespace rigid
