#include "common/program/table.hpp"

#include "common/text.hpp"

#include <algorithm>
#include <iostream>
#include <memory>
#include <optional>
#include <stdexcept>

namespace rigid {

Table::Table(const std::string& file, const Demo& scene, std::size_t methods)
    : file_(file), last_step_(methods, -1)
{
    if (file_ != "-") {
        stream_.open(file_, std::ios::binary | std::ios::trunc);
        if (!stream_)
            throw std::invalid_argument("the table \"" + file_ +
                                        "\" can't be written; it must be a file in a folder "
                                        "that exists");
    }
    std::string head = methods > 1 ? "step,t,method" : "step,t";
    for (const Column& column : scene.columns) head += ',' + column.name;
    out() << head << '\n';
}

std::ostream& Table::out() { return file_ == "-" ? std::cout : stream_; }

void Table::check()
{
    out().flush();
    if (!out())
        throw std::runtime_error("the table " +
                                 (file_ == "-" ? "on the standard output" : '"' + file_ + '"') +
                                 " can't be written any further; is the disk full?");
}

void Table::add(const std::vector<Track>& tracks)
{
    for (std::size_t i = 0; i < tracks.size(); ++i) {
        const Track& track = tracks[i];
        if (track.measured.empty() || track.steps == last_step_[i]) continue;
        last_step_[i] = track.steps;
        std::string row = std::to_string(track.steps) + ',' + shortest(track.time);
        if (tracks.size() > 1) row += ',' + track.method;
        for (const Real value : track.measured) row += ',' + shortest(value);
        out() << row << '\n';
    }
    check();  // row by row, so that what is there stays there whatever happens next
}

std::function<void(const Playback&, bool fresh)> table_of_show(const std::string& file)
{
    if (file.empty()) return {};
    const auto table = std::make_shared<std::optional<Table>>();
    return [file, table](const Playback& playback, bool fresh) {
        if (fresh) {
            table->reset();
            table->emplace(file, playback.scene(), playback.tracks().size());
        }
        (*table)->add(playback.tracks());
    };
}

std::string summary(const Program& program, const Playback& playback)
{
    std::string text = program.name + ", scene " + playback.scene().name + ": " +
                       std::to_string(playback.steps()) + " steps of " +
                       significant(playback.settings().h, 6) + " s\n";
    std::vector<std::vector<std::string>> lines;
    std::vector<std::string> head = {"column"};
    for (const Track& track : playback.tracks())
        head.push_back(track.method.empty() ? "value" : track.method);
    head.push_back("unit");
    lines.push_back(head);
    const auto add_line = [&](const std::string& name, const std::string& unit, const auto& value_of) {
        std::vector<std::string> line = {name};
        for (const Track& track : playback.tracks())
            line.push_back(track.measured.empty() && name != "t" ? "-" : significant(value_of(track), 6));
        line.push_back(unit);
        lines.push_back(line);
    };
    add_line("t", "s", [](const Track& track) { return track.time; });
    for (std::size_t i = 0; i < playback.scene().columns.size(); ++i) {
        const Column& column = playback.scene().columns[i];
        add_line(column.name, column.unit, [i](const Track& track) { return track.measured[i]; });
    }
    for (const auto& line : lines) {
        std::string row;
        for (std::size_t c = 0; c < line.size(); ++c) {
            std::size_t width = 0;
            for (const auto& other : lines) width = std::max(width, other[c].size());
            const std::string blank(c + 1 < line.size() ? width - line[c].size() : 0, ' ');
            const bool is_number = c > 0 && c + 1 < line.size();
            row += (c ? "  " : "  ") + (is_number ? blank + line[c] : line[c] + blank);
        }
        while (row.back() == ' ') row.pop_back();
        text += row + '\n';
    }
    return text;
}

}  // namespace rigid
