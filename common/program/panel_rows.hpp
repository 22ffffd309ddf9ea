/// \file panel_rows.hpp
/// What the panel of a scene holds, as data: the window's panel (panel.cpp) and the one of a page
/// (web_description.cpp) are both made from it, so they have the same sliders, ranges, words and keys.
#pragma once

#include "common/program/show.hpp"

#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// A slider with its label.
struct SliderRow {
    std::string name;    ///< of the tunable; "h" of the time step
    std::string label;   ///< in words
    std::string help;    ///< what it is, from where to where, what it is at first
    std::string unit;    ///< "" for a pure number
    std::string format;  ///< of printf, without the unit
    Real low = 0, high = 1, first = 0;
    bool whole = false, logarithmic = false;
    std::vector<std::string> names;  ///< shown for low, low + 1 and so on; none = the number is shown
};

SliderRow slider_row(const Tunable& tunable);
SliderRow time_step_row(const Demo& scene);

/// "drift [m]": what stands above the plot of a column.
std::string plot_title(const Column& column);

/// "grey: exact": the curves that stand beside a column's own in its plot; "" = none.
std::string grey_curves(const Demo& scene, const Column& column);

/// Seconds of the scene per second, and how they are written.
inline constexpr std::array<std::pair<Real, const char*>, 6> speeds = {
    {{0.125, "1/8"}, {0.25, "1/4"}, {0.5, "1/2"}, {1.0, "x 1"}, {2.0, "x 2"}, {4.0, "x 4"}}};

struct KeyRow {
    std::string key, what;
};

/// The keys that every panel knows, for this scene.
std::vector<KeyRow> key_rows(const Demo& scene);

/// One line that says what the reader's hand can do to this scene beside pulling; "" = nothing more.
std::string what_to_do(const Demo& scene);

/// From when to when a plot reaches [s].
struct TimeSpan {
    Real begin = 0, end = 0;
};

/// Of the last steps, or of the whole run.
TimeSpan plot_span(const Show& show, bool whole_run);

/// The curves of one column.
struct LivePlot {
    Real low = 0, high = 0;                         ///< its range; powers of ten if the column is logarithmic
    std::string low_text, high_text;                ///< what stands at both ends
    using Pieces = std::vector<std::vector<Vec2>>;  ///< of one curve, in the unit square, y up
    std::vector<Pieces> curves;                     ///< of each track
    std::vector<Pieces> beside;  ///< of each track and each column that stands beside this one
};

/// Nothing if there is nothing to show.
std::optional<LivePlot> plot_of(const Show& show, std::size_t column, const TimeSpan& span, bool whole_run);

/// What a plot shows of a track's column, in the order of time.
template <class Visit>
void each_sample(const Show& show, std::size_t track, std::size_t column, bool whole_run, const Visit& visit)
{
    const History& history = show.history(track, column);
    if (!whole_run) {
        for (const Sample& sample : history.recent()) visit(sample);
        return;
    }
    for (const Sample& sample : history.whole()) visit(sample);
    if (!history.recent().empty()) visit(history.recent().back());  // what thinning left out
}

/// The present value beside a plot: four digits, three where several tracks share the line.
std::string plot_value(Real value, std::size_t tracks);

/// As many digits as six characters have room for: 0.0496, 1.4e-13.
std::string narrow(Real value);

}  // namespace rigid
