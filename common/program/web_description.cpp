#include "common/program/web_description.hpp"

#include "common/text.hpp"

#include <algorithm>
#include <cmath>

namespace rigid {
namespace {

std::string truth(bool value) { return value ? "true" : "false"; }
std::string number(Real value) { return std::isfinite(value) ? shortest(value) : "null"; }
std::string as_it_is(const std::string& text) { return text; }

/// [one, two, …] of what `write` makes of each.
template <class List, class Write>
std::string array_of(const List& list, const Write& write)
{
    std::string text;
    for (const auto& one : list) text += (text.empty() ? "" : ",") + write(one);
    return '[' + text + ']';
}

/// {"name": value, …}
class Object {
public:
    /// The value is JSON already.
    Object& add(const char* name, const std::string& value)
    {
        text_ += text_.empty() ? "{\"" : ",\"";
        text_ += name;
        text_ += "\":";
        text_ += value;
        return *this;
    }
    Object& words(const char* name, const std::string& value) { return add(name, json(value)); }
    std::string text() const { return text_ + '}'; }

private:
    std::string text_;
};

std::string slider(const SliderRow& row)
{
    return Object()
        .words("name", row.name)
        .words("label", row.label)
        .words("help", row.help)
        .words("unit", row.unit)
        .words("format", row.format)
        .add("low", number(row.low))
        .add("high", number(row.high))
        .add("first", number(row.first))
        .add("whole", truth(row.whole))
        .add("names", array_of(row.names, json))
        .add("logarithmic", truth(row.logarithmic))
        .text();
}

std::string scene(const Demo& demo)
{
    std::vector<SliderRow> sliders;
    for (const Tunable& one : demo.tunables) sliders.push_back(slider_row(one));
    sliders.push_back(time_step_row(demo));
    std::vector<std::string> plots;
    for (std::size_t c = 0; c < demo.columns.size(); ++c)
        if (demo.columns[c].has_own_plot())
            plots.push_back(Object()
                                .add("column", std::to_string(c))
                                .words("title", plot_title(demo.columns[c]))
                                .words("grey", grey_curves(demo, demo.columns[c]))
                                .words("help", demo.columns[c].help)
                                .words("unit", demo.columns[c].unit)
                                .text());
    return Object()
        .words("name", demo.name)
        .words("summary", demo.summary)
        .add("steered", truth(demo.steered))
        .add("methods", array_of(demo.methods, json))
        .add("sliders", array_of(sliders, slider))
        .add("plots", array_of(plots, as_it_is))
        .add("keys",
             array_of(key_rows(demo),
                      [](const KeyRow& row) { return '[' + json(row.key) + ',' + json(row.what) + ']'; }))
        .text();
}

}  // namespace

std::string json(const std::string& text)
{
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += static_cast<unsigned char>(c) < 0x20 ? ' ' : c;
    }
    return result + '"';
}

std::string description_of(const Program& program)
{
    return Object()
        .words("name", program.name)
        .words("title", program.title)
        .add(
            "speeds",
            array_of(speeds,
                     [](const auto& speed) {
                         return Object().add("value", number(speed.first)).words("text", speed.second).text();
                     }))
        .add("scenes", array_of(program.scenes, scene))
        .text();
}

std::string state_of(const Show& show)
{
    const Demo& demo = show.scene();
    const Playback* playback = show.playback();
    std::vector<char> on;
    for (std::size_t i = 0; i < demo.methods.size(); ++i) on.push_back(show.shows_method(i));
    std::vector<std::string> sentences, values;
    if (!playback) sentences.push_back(show.refusal());
    else sentences = playback->failures();
    for (std::size_t c = 0; playback && c < demo.columns.size(); ++c) {
        if (!demo.columns[c].has_own_plot()) continue;
        values.push_back(array_of(playback->tracks(), [&](const Track& track) {
            return json(track.measured.empty() ? std::string("-")
                                               : plot_value(track.measured[c], playback->tracks().size()));
        }));
    }
    std::vector<Real> settings;
    for (const Tunable& one : demo.tunables) settings.push_back(show.settings()[one.name]);
    settings.push_back(show.settings().h);
    const auto scenes = show.program().scenes.begin();
    return Object()
        .add("scene", std::to_string(std::find_if(scenes, show.program().scenes.end(),
                                                  [&](const Demo& one) { return &one == &demo; }) -
                                     scenes))
        .add("on", array_of(on, truth))
        .add("settings", array_of(settings, number))
        .add("step", std::to_string(playback ? playback->steps() : 0))
        .words("time", playback ? fixed(playback->time(), 2) : std::string("0.00"))
        .add("paused", truth(show.paused))
        .add("over", truth(show.is_over()))
        .add("slow", truth(show.falls_behind()))
        .add("scripted", truth(show.is_scripted()))
        .add("speed", number(show.speed))
        .add("values", array_of(values, as_it_is))
        .add("sentences", array_of(sentences, json))
        .text();
}

}  // namespace rigid
