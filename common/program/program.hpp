/// \file program.hpp
/// What a chapter's main.cpp says of itself; the shell does the rest.
///
/// A chapter lists its scenes, their methods, tunables and columns, and how a scene starts, draws,
/// measures and advances by one step. The shell reads the command line and runs a scene in a
/// window or without one; both call the same step().
#pragma once

#include "common/canvas.hpp"
#include "common/program/tunable_values.hpp"

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace rigid {

enum class Numbers { real, whole };
enum class OnChange { goes_on, restarts };
enum class Keys { none, up_and_down };

/// A number that the reader may change while the scene runs: --set name=value, a slider in the panel.
struct Tunable {
    std::string name;  ///< as in --set name=value
    std::string unit;  ///< "" for a pure number
    std::string help;  ///< one line
    Real value = 0, low = 0, high = 1;
    Numbers numbers = Numbers::real;         ///< whole: a count
    OnChange on_change = OnChange::goes_on;  ///< restarts: the scene starts again (a number of discs, say)
    Keys keys = Keys::none;                  ///< which keys change it too
    std::vector<std::string> names = {};  ///< of the values low, low + 1 and so on; none = they are numbers

    bool whole() const { return numbers == Numbers::whole; }
    bool restarts() const { return on_change == OnChange::restarts; }
    bool arrow_keys() const { return keys == Keys::up_and_down; }
    /// Of the values, in their order: `names`, or no and yes of what is 0 or 1; else none.
    std::vector<std::string> value_names() const
    {
        if (names.empty() && whole() && low == 0 && high == 1) return {"no", "yes"};
        return names;
    }
};

/// All that a run depends on.
struct Settings {
    std::string scene;
    std::string method;
    Real h = 0;  ///< time step [s]
    std::uint64_t seed = 1;
    TunableValues tunables;

    /// The value of a tunable. Throws std::out_of_range for a name that the scene did not list.
    Real operator[](std::string_view name) const { return tunables.at(name); }
};

/// What the reader's hand does during a step. Without a window it follows a seeded path in scenes
/// that the pointer steers, and is absent in the others.
struct Input {
    Vec2 pointer = {0, 0};  ///< world coordinates [m]
    bool present = false;   ///< the pointer is over the picture
    bool pressed = false;   ///< the button is held: pull the body under it
};

/// Whether a column has a live plot in the panel, of its numbers or of their log10.
enum class Plot { none, linear, logarithmic };

/// A number that is measured after each step: a column of the table, a live plot.
struct Column {
    std::string name;  ///< letters, digits and _ : the head of a CSV column
    std::string unit;
    std::string help;
    Plot plot = Plot::none;
    std::string beside =
        {};  ///< its curve stands, grey, in the plot of the column of this name; "" = in its own

    bool plotted() const { return plot != Plot::none; }
    bool has_own_plot() const { return plotted() && beside.empty(); }
    bool logarithmic() const { return plot == Plot::logarithmic; }
};

/// Thrown by Run::step() when the run can't go on; its text says what and which body. The shell
/// adds the number of the step and ends with exit code 3.
struct StepFailure : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Is told the name of a part of a step.
using PartListener = std::function<void(std::string_view)>;

/// One scene under one method, alive.
class Run {
public:
    virtual ~Run() = default;
    /// Advances by settings.h. Depends on nothing but the state, the settings and the input.
    virtual void step(const Settings& settings, const Input& input) = 0;
    virtual void draw(Canvas& canvas) const = 0;
    /// What the picture depends on and the steps do not (from where a solid is seen): before each picture, also while
    /// the run is paused.
    virtual void look(const Settings&, const Input&) {}
    /// One number for each column of the scene, in their order.
    virtual std::vector<Real> measure() const = 0;
    /// From here on each step tells the listener which part of it begins, and "" at its end. A run without parts tells
    /// nothing. Whoever listens must not change the run.
    virtual void tell_parts(PartListener) {}
};

struct Demo {
    std::string name;     ///< as in --scene name
    std::string summary;  ///< one line
    View view;
    Real h = 1.0 / 60;  ///< default time step [s]
    Real h_low = 1e-4, h_high = 0.1;
    std::vector<std::string> methods;  ///< the first is the default
    std::vector<Tunable> tunables;
    std::vector<Column> columns;
    bool steered = false;  ///< the pointer steers it all the time (not only while pressed)
    std::string held = "pulls what is under it";  ///< what the pointer does while its button is held
    /// Methods that the window shows at first, most_panes of them at most; empty = the default one.
    std::vector<std::string> side_by_side;
    /// Throws std::invalid_argument with a sentence for settings that make no sense.
    std::function<std::unique_ptr<Run>(const Settings&)> start;

    // Scenes are made and handed on in each program: what that takes is compiled once, in program.cpp.
    Demo();
    Demo(const Demo&);
    Demo(Demo&&) noexcept;
    Demo& operator=(const Demo&);
    Demo& operator=(Demo&&) noexcept;
    ~Demo();
};

inline constexpr std::size_t most_panes = 4;  ///< methods side by side in a window

/// A file of the program's own that is written instead of running a scene, by an option of its own (--wav FILE).
struct OwnFile {
    std::string option;  ///< "--wav"
    std::string help;    ///< one line
    std::function<void(std::ostream&)> write;
};

struct Program {
    std::string name;          ///< of the executable, 01_euler_integration
    std::string title;         ///< "Chapter 1. Euler integration"
    std::vector<Demo> scenes;  ///< the first is the default
    /// For chapters that solve a problem from a file (--problem FILE --method NAME): does it, prints
    /// the answer and returns the exit code. `problem_methods` are the names that it takes, the default one first.
    std::function<int(const std::string& file, const std::string& method)> solve_problem;
    std::vector<std::string> problem_methods = {};
    std::vector<OwnFile> own_files = {};  ///< empty but where a chapter has some
};

}  // namespace rigid

extern template class std::vector<rigid::Tunable>;
extern template class std::vector<rigid::Column>;
extern template class std::vector<rigid::Demo>;

namespace rigid {

/// The whole of main(): returns the exit code (0 well, 2 bad input, 3 a run that couldn't go on, or an output that
/// couldn't be written). The program is made inside, so that what is thrown on the way becomes a sentence too.
int run_program(const std::function<Program()>& make, int argc, char** argv);

/// The settings that a scene starts with when nothing was typed.
Settings default_settings(const Demo& scene);

/// What an exception says to the reader: its own sentence, or one about memory where it has none.
std::string sentence_of(const std::exception& error);

}  // namespace rigid
