#include "common/program/panel_rows.hpp"

#include "common/elementary.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {
namespace {

std::string in_words(std::string name)
{
    std::replace(name.begin(), name.end(), '_', ' ');
    return name;
}

/// Digits behind the point that suit the range.
const char* digits(const Tunable& one)
{
    const Real span = one.high - one.low;
    return span >= 100 ? "%.1f" : span >= 1 ? "%.2f" : span >= 0.1 ? "%.3f" : "%.2e";
}

}  // namespace

SliderRow slider_row(const Tunable& one)
{
    SliderRow row;
    row.name = one.name;
    row.label = in_words(one.name);
    row.help = one.help + (one.help.empty() ? "" : ". ") + "From " + readable(one.low) + " to " +
               with_unit(readable(one.high), one.unit) + ", at first " +
               with_unit(readable(one.value), one.unit);
    if (one.restarts()) row.help += ". Starts the scene again";
    if (one.arrow_keys()) row.help += ". Up and down keys";
    row.unit = one.unit;
    row.low = one.low;
    row.high = one.high;
    row.first = one.value;
    row.whole = one.whole();
    row.names = one.value_names();
    row.logarithmic = one.low > 0 && one.high / one.low >= 1000;
    row.format = one.whole() ? "%.0f" : row.logarithmic ? "%.4g" : digits(one);
    return row;
}

SliderRow time_step_row(const Demo& scene)
{
    SliderRow row;
    row.name = "h";
    row.label = "time step";
    row.help = "The time step: from " + readable(scene.h_low) + " to " + readable(scene.h_high) +
               " s, at first " + significant(scene.h, 4) + " s";
    row.unit = "s";
    row.low = scene.h_low;
    row.high = scene.h_high;
    row.first = scene.h;
    row.logarithmic = scene.h_high / scene.h_low >= 50;
    row.format = "%.4g";
    return row;
}

std::string plot_title(const Column& column)
{
    return in_words(column.name) + (column.unit.empty() ? "" : " [" + column.unit + ']');
}

std::string grey_curves(const Demo& scene, const Column& column)
{
    std::string names;
    for (const Column& other : scene.columns)
        if (other.plotted() && other.beside == column.name)
            names += (names.empty() ? "grey: " : ", ") + in_words(other.name);
    return names;
}

std::vector<KeyRow> key_rows(const Demo& scene)
{
    std::vector<KeyRow> rows = {
        {"Space", "pause and run"}, {"S, Right", "one time step"}, {"R", "start again"}};
    const auto arrow = std::find_if(scene.tunables.begin(), scene.tunables.end(),
                                    [](const Tunable& one) { return one.arrow_keys(); });
    if (arrow != scene.tunables.end()) rows.push_back({"Up, Down", in_words(arrow->name)});
    rows.push_back({"Pointer", scene.steered ? "steers; held down: pulls" : "held down: " + scene.held});
    return rows;
}

std::string what_to_do(const Demo& scene)
{
    std::string line = scene.steered ? "Move the pointer over the picture: it steers." : "";
    const auto arrow = std::find_if(scene.tunables.begin(), scene.tunables.end(),
                                    [](const Tunable& one) { return one.arrow_keys(); });
    if (arrow != scene.tunables.end())
        line += std::string(line.empty() ? "" : " ") + "Arrows up and down: " + in_words(arrow->name) + ".";
    return line;
}

TimeSpan plot_span(const Show& show, bool whole_run)
{
    if (!show.playback()) return {};
    Real begin = infinity, end = -infinity;
    for (std::size_t k = 0; k < show.playback()->tracks().size(); ++k)
        for (std::size_t c = 0; c < show.scene().columns.size(); ++c)
            each_sample(show, k, c, whole_run, [&](const Sample& sample) {
                begin = std::min(begin, sample.t);
                end = std::max(end, sample.t);
            });
    return begin <= end ? TimeSpan{begin, end} : TimeSpan{};
}

std::optional<LivePlot> plot_of(const Show& show, std::size_t c, const TimeSpan& span, bool whole_run)
{
    if (!show.playback()) return std::nullopt;
    const bool logarithmic = show.scene().columns[c].logarithmic();
    const std::size_t tracks = show.playback()->tracks().size();

    // The range of all curves. Zero has no logarithm: it lies on the lower edge.
    Real low = infinity, high = -infinity;
    bool zero = false;
    const auto height_of = [&](Real value) { return !logarithmic ? value : value > 0 ? log10(value) : low; };
    const auto shows = [&](Real value) { return !logarithmic || value >= 0; };
    std::vector<std::size_t> columns = {c};
    for (std::size_t other = 0; other < show.scene().columns.size(); ++other) {
        const Column& column = show.scene().columns[other];
        if (column.plotted() && column.beside == show.scene().columns[c].name) columns.push_back(other);
    }
    const auto each_of_all = [&](const auto& visit) {
        for (const std::size_t column : columns)
            for (std::size_t k = 0; k < tracks; ++k) each_sample(show, k, column, whole_run, visit);
    };
    each_of_all([&](const Sample& sample) {
        zero = zero || (logarithmic && sample.value == 0);
        if (!shows(sample.value) || (logarithmic && sample.value == 0)) return;
        low = std::min(low, height_of(sample.value));
        high = std::max(high, height_of(sample.value));
    });
    const bool nothing_else = zero && !(low <= high);
    if (nothing_else) low = -1, high = 0;
    if (!(low <= high)) return std::nullopt;
    if (logarithmic) {
        low = std::floor(low);
        high = std::max(std::ceil(high), low + 1);
    } else if (high - low <= 1e-9 * std::max(std::abs(low), std::abs(high)) || high == low) {
        const Real around = high == 0 ? 1 : 0.1 * std::abs(high);
        low -= around;
        high += around;
    }

    LivePlot plot;
    plot.low = low;
    plot.high = high;
    plot.low_text = zero ? "0" : logarithmic ? "1e" + readable(low) : narrow(low);
    plot.high_text = nothing_else ? "" : logarithmic ? "1e" + readable(high) : narrow(high);
    const Real length = span.end - span.begin;
    for (const std::size_t column : columns)
        for (std::size_t k = 0; k < tracks; ++k) {
            LivePlot::Pieces& pieces = (column == c ? plot.curves : plot.beside).emplace_back(1);
            each_sample(show, k, column, whole_run, [&](const Sample& sample) {
                if (!shows(sample.value)) {
                    if (!pieces.back().empty()) pieces.emplace_back();
                    return;
                }
                pieces.back().push_back({length > 0 ? (sample.t - span.begin) / length : 1,
                                         (height_of(sample.value) - low) / (high - low)});
            });
        }
    return plot;
}

std::string plot_value(Real value, std::size_t tracks)
{
    if (std::abs(value) >= 1000 && std::abs(value) < 99999.5) return fixed(value, 0);
    return significant(value, tracks > 2 ? 3 : 4);
}

std::string narrow(Real value)
{
    if (std::abs(value) >= 100 && std::abs(value) < 99999.5) return fixed(value, 0);
    std::string text;
    for (int digits = 3; digits > 0; --digits) {
        text = significant(value, digits);
        const std::size_t zero = text.find("e-0");
        if (zero != std::string::npos) text.erase(zero + 2, 1);
        if (text.size() <= 6) break;
    }
    return text;
}

}  // namespace rigid
