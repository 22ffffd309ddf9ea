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

/// {"name": value, …}; the values are JSON.
std::string object(const std::vector<std::pair<const char*, std::string>>& members)
{
    std::string text;
    for (const auto& [name, value] : members) text += (text.empty() ? "" : ",") + json(name) + ':' + value;
    return '{' + text + '}';
}

std::string slider(const SliderRow& row)
{
    return object({{"name", json(row.name)},
                   {"label", json(row.label)},
                   {"help", json(row.help)},
                   {"unit", json(row.unit)},
                   {"format", json(row.format)},
                   {"low", number(row.low)},
                   {"high", number(row.high)},
                   {"first", number(row.first)},
                   {"whole", truth(row.whole)},
                   {"logarithmic", truth(row.logarithmic)}});
}

std::string scene(const Demo& demo)
{
    std::vector<SliderRow> sliders;
    for (const Tunable& one : demo.tunables) sliders.push_back(slider_row(one));
    sliders.push_back(time_step_row(demo));
    std::vector<std::string> plots;
    for (std::size_t c = 0; c < demo.columns.size(); ++c)
        if (demo.columns[c].plotted)
            plots.push_back(object({{"column", std::to_string(c)},
                                    {"title", json(plot_title(demo.columns[c]))},
                                    {"help", json(demo.columns[c].help)},
                                    {"unit", json(demo.columns[c].unit)}}));
    return object({{"name", json(demo.name)},
                   {"summary", json(demo.summary)},
                   {"steered", truth(demo.steered)},
                   {"methods", array_of(demo.methods, json)},
                   {"sliders", array_of(sliders, slider)},
                   {"plots", array_of(plots, as_it_is)},
                   {"keys", array_of(key_rows(demo), [](const KeyRow& row) {
                        return '[' + json(row.key) + ',' + json(row.what) + ']';
                    })}});
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
    return object({{"name", json(program.name)},
                   {"title", json(program.title)},
                   {"speeds", array_of(speeds,
                                       [](const auto& speed) {
                                           return object({{"value", number(speed.first)},
                                                          {"text", json(speed.second)}});
                                       })},
                   {"scenes", array_of(program.scenes, scene)}});
}

std::string state_of(const Show& show)
{
    const Demo& demo = show.scene();
    const Playback* playback = show.playback();
    std::vector<bool> on;
    for (std::size_t i = 0; i < demo.methods.size(); ++i) on.push_back(show.shows_method(i));
    std::vector<std::string> sentences, values;
    if (!playback) sentences.push_back(show.refusal());
    else sentences = playback->failures();
    for (std::size_t c = 0; playback && c < demo.columns.size(); ++c) {
        if (!demo.columns[c].plotted) continue;
        const int digits = playback->tracks().size() > 2 ? 3 : 4;
        values.push_back(array_of(playback->tracks(), [&](const Track& track) {
            return json(track.measured.empty() ? std::string("-") : significant(track.measured[c], digits));
        }));
    }
    std::vector<Real> settings;
    for (const Tunable& one : demo.tunables) settings.push_back(show.settings()[one.name]);
    settings.push_back(show.settings().h);
    const auto scenes = show.program().scenes.begin();
    return object({{"scene", std::to_string(std::find_if(scenes, show.program().scenes.end(),
                                                         [&](const Demo& one) { return &one == &demo; }) -
                                            scenes)},
                   {"on", array_of(on, truth)},
                   {"settings", array_of(settings, number)},
                   {"step", std::to_string(playback ? playback->steps() : 0)},
                   {"time", json(playback ? fixed(playback->time(), 2) : std::string("0.00"))},
                   {"paused", truth(show.paused)},
                   {"over", truth(show.is_over())},
                   {"slow", truth(show.falls_behind())},
                   {"scripted", truth(show.is_scripted())},
                   {"speed", number(show.speed)},
                   {"values", array_of(values, as_it_is)},
                   {"sentences", array_of(sentences, json)}});
}

}  // namespace rigid
