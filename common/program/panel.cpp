#include "common/program/panel.hpp"

#include "common/program/panel_rows.hpp"
#include "common/text.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace rigid {
namespace {

constexpr Real text_size = 15, small_size = 10.5;  // of a line of Dear ImGui, of an em

/// For printf-like formats of sliders: % stands for itself.
std::string escaped(const std::string& text)
{
    std::string result;
    for (const char c : text) result += c == '%' ? std::string("%%") : std::string(1, c);
    return result;
}

ImVec4 vector_of(ImU32 colour) { return ImGui::ColorConvertU32ToFloat4(colour); }

/// All that draws one panel, so that its parts need no long lists of arguments.
class Panel {
public:
    Panel(Show& show, PanelState& state, const Theme& theme, const Fonts& fonts, Real scale)
        : show_(show), state_(state), theme_(theme), fonts_(fonts), scale_(scale)
    {
    }

    void draw()
    {
        // The end of the panel stays where it is; what stands above scrolls if it must.
        const float footer = 2 * ImGui::GetFrameHeightWithSpacing() + units(10);
        ImGui::BeginChild("upper", {0, -footer}, false, ImGuiWindowFlags_NoBackground);
        title();
        scene_and_methods();
        buttons();
        sliders();
        plots();
        part_times();
        if (ImGui::CollapsingHeader("Keys and mouse")) keys();
        ImGui::EndChild();
        bottom();
    }

private:
    float units(Real pixels) const { return static_cast<float>(scale_ * pixels); }
    std::string shown(const std::string& text) const { return fonts_.shown(text); }
    ImU32 dim() const { return theme_.colour(Colour::ink, 0.62); }

    void dim_text(const std::string& text, bool wrapped = false)
    {
        ImGui::PushStyleColor(ImGuiCol_Text, dim());
        if (wrapped) ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(shown(text).c_str());
        if (wrapped) ImGui::PopTextWrapPos();
        ImGui::PopStyleColor();
    }

    void tooltip(const std::string& text)
    {
        if (text.empty() || state_.recording) return;  // it would be in the pictures
        if (!ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled)) return;
        ImGui::BeginTooltip();
        ImGui::PushTextWrapPos(units(320));
        ImGui::TextUnformatted(shown(text).c_str());
        ImGui::PopTextWrapPos();
        ImGui::EndTooltip();
    }

    void gap() { ImGui::Dummy({0, units(3)}); }

    void title()
    {
        ImGui::PushFont(fonts_.nearest(scale_ * 16.3));
        ImGui::PushTextWrapPos(0);
        ImGui::TextUnformatted(shown(show_.program().title).c_str());
        ImGui::PopTextWrapPos();
        ImGui::PopFont();
        gap();
    }

    void scene_and_methods()
    {
        const std::vector<Demo>& scenes = show_.program().scenes;
        ImGui::SetNextItemWidth(-1);
        if (ImGui::BeginCombo("##scene", show_.scene().name.c_str())) {
            for (std::size_t i = 0; i < scenes.size(); ++i) {
                if (ImGui::Selectable(scenes[i].name.c_str(), &scenes[i] == &show_.scene()))
                    show_.choose_scene(i);
                tooltip(scenes[i].summary);
            }
            if (state_.close_list) ImGui::CloseCurrentPopup();
            ImGui::EndCombo();
        }
        state_.close_list = false;
        dim_text(show_.scene().summary, true);
        const std::string to_do = what_to_do(show_.scene());
        if (!to_do.empty()) dim_text(to_do, true);
        const std::vector<std::string>& methods = show_.scene().methods;
        if (methods.size() < 2) return;
        gap();
        std::size_t pane = 0;
        const float space = ImGui::GetStyle().ItemSpacing.x + ImGui::GetStyle().ItemInnerSpacing.x;
        const float right = ImGui::GetCursorPosX() + ImGui::GetContentRegionAvail().x;
        float x = ImGui::GetCursorPosX();
        for (std::size_t i = 0; i < methods.size(); ++i) {
            const float width = ImGui::GetFrameHeight() + ImGui::CalcTextSize(methods[i].c_str()).x + space;
            if (i > 0 && x + width <= right) ImGui::SameLine(x);
            else x = ImGui::GetCursorPosX();
            x += width;
            bool on = show_.shows_method(i);
            // The colour of the pane that shows it.
            if (on) ImGui::PushStyleColor(ImGuiCol_CheckMark, theme_.colour(pane_colour(pane++)));
            const bool changed = ImGui::Checkbox(methods[i].c_str(), &on);
            if (show_.shows_method(i)) ImGui::PopStyleColor();
            if (changed) show_.choose_method(i, on);
            if (changed) break;
        }
    }

    /// Buttons that share the width of the panel.
    bool button(const char* label, int count, bool lit = false)
    {
        const float space = ImGui::GetStyle().ItemSpacing.x;
        const float all = ImGui::GetWindowContentRegionMax().x - ImGui::GetWindowContentRegionMin().x;
        const float width = (all - space * static_cast<float>(count - 1)) / static_cast<float>(count);
        if (lit) {
            ImGui::PushStyleColor(ImGuiCol_Button, theme_.colour(Colour::blue));
            ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme_.colour(Colour::blue, 0.85));
            ImGui::PushStyleColor(ImGuiCol_Text, theme_.card());
        }
        const bool pressed = ImGui::Button(label, {width, 0});
        if (lit) ImGui::PopStyleColor(3);
        return pressed;
    }

    void buttons()
    {
        gap();
        if (button(show_.paused ? "Run##pause" : "Pause##pause", 3, show_.paused))
            show_.paused = !show_.paused;
        tooltip("Space");
        ImGui::SameLine();
        if (button("Step", 3)) state_.single_step = true;
        tooltip("One time step: S or the right arrow");
        ImGui::SameLine();
        if (button("Reset", 3)) show_.restart();
        tooltip("Start the scene again: R");

        ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {units(3), ImGui::GetStyle().ItemSpacing.y});
        ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, {units(2), ImGui::GetStyle().FramePadding.y});
        for (std::size_t i = 0; i < speeds.size(); ++i) {
            if (i > 0) ImGui::SameLine();
            if (button(speeds[i].second, static_cast<int>(speeds.size()), show_.speed == speeds[i].first))
                show_.speed = speeds[i].first;
            tooltip("Seconds of the scene per second");
        }
        ImGui::PopStyleVar(2);
    }

    /// A label at the left, and room for a slider at the right.
    void begin_row(const std::string& label, const std::string& help)
    {
        const float all = ImGui::GetContentRegionAvail().x, left = ImGui::GetCursorPosX();
        ImGui::AlignTextToFramePadding();
        // A long name is cut: the tooltip has it whole.
        std::string name = shown(label);
        const float room = 0.40f * all;
        if (ImGui::CalcTextSize(name.c_str()).x > room) {
            while (name.size() > 1 && ImGui::CalcTextSize((name + "..").c_str()).x > room) name.pop_back();
            name += "..";
        }
        ImGui::TextUnformatted(name.c_str());
        tooltip(label + (help.empty() ? "" : ": " + help));
        ImGui::SameLine(left + 0.42f * all);
        ImGui::SetNextItemWidth(-1);
    }

    /// True if the reader has changed the value.
    bool slider(const SliderRow& row, Real& value)
    {
        ImGui::PushID(row.name.c_str());
        begin_row(row.label, row.help + " (right click)");
        std::string format = row.format + (row.unit.empty() ? "" : " " + escaped(shown(row.unit)));
        if (!row.names.empty())
            format = escaped(row.names.at(static_cast<std::size_t>(std::lround(value - row.low))));
        ImGuiSliderFlags flags = ImGuiSliderFlags_AlwaysClamp;
        if (row.logarithmic) flags |= ImGuiSliderFlags_Logarithmic;
        const bool changed = ImGui::SliderScalar("##value", ImGuiDataType_Double, &value, &row.low, &row.high,
                                                 format.c_str(), flags);
        tooltip(row.help + " (right click)");
        ImGui::PopID();
        return changed;
    }

    void sliders()
    {
        gap();
        ImGui::Separator();
        gap();
        const Demo& scene = show_.scene();
        for (const Tunable& one : scene.tunables) {
            const SliderRow row = slider_row(one);
            Real value = show_.settings()[one.name];
            if (slider(row, value)) show_.set_tunable(one, value);
            if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) show_.set_tunable(one, one.value);
        }
        const SliderRow row = time_step_row(scene);
        Real h = show_.settings().h;
        if (slider(row, h)) show_.set_h(h);
        if (ImGui::IsItemClicked(ImGuiMouseButton_Right)) show_.set_h(scene.h);

        begin_row("seed", "Of all that is random. Starts the scene again");
        std::uint64_t seed = show_.settings().seed;
        const std::uint64_t one = 1;
        if (ImGui::InputScalar("##seed", ImGuiDataType_U64, &seed, &one, nullptr, "%llu",
                               ImGuiInputTextFlags_EnterReturnsTrue))
            show_.set_seed(seed);
        if (scene.steered) {
            bool scripted = show_.is_scripted();
            if (ImGui::Checkbox("a seeded path steers", &scripted)) show_.set_script(scripted);
            tooltip("Instead of the mouse: the path that runs without a window follow");
        }
    }

    // ---- plots --------------------------------------------------------------------------------

    void plots()
    {
        const Demo& scene = show_.scene();
        if (!show_.playback() || std::none_of(scene.columns.begin(), scene.columns.end(),
                                              [](const Column& c) { return c.has_own_plot(); }))
            return;
        gap();
        ImGui::Separator();
        gap();
        span_ = plot_span(show_, state_.whole_run);
        for (std::size_t c = 0; c < scene.columns.size(); ++c)
            if (scene.columns[c].has_own_plot()) plot(c);
        plot_times();
    }

    /// From when to when the plots reach, and the choice between the last steps and the whole run.
    void plot_times()
    {
        std::string text = "t = " + significant(span_.begin, 4) + " to " + significant(span_.end, 4) + " s";
        ImGui::AlignTextToFramePadding();
        dim_text(text);
        const char* label = "whole run";
        const float width =
            ImGui::GetFrameHeight() + ImGui::CalcTextSize(label).x + ImGui::GetStyle().ItemInnerSpacing.x;
        ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - width);
        ImGui::Checkbox(label, &state_.whole_run);
        tooltip("Plots of the whole run instead of the last " + std::to_string(History::recent_steps) +
                " steps");
    }

    /// A name at the left, a value of each track in the colour of its pane at the right.
    /// \param grey  stands behind the name
    void line_of_values(const std::string& name, const std::string& help, const std::string& grey,
                        const std::vector<std::string>& values)
    {
        const float right = ImGui::GetWindowContentRegionMax().x, left = ImGui::GetCursorPosX();
        ImGui::TextUnformatted(shown(name).c_str());
        tooltip(help);
        float name_end = left + ImGui::GetItemRectSize().x;
        if (!grey.empty()) {
            ImGui::SameLine();
            dim_text(grey);
            name_end += ImGui::GetStyle().ItemSpacing.x + ImGui::GetItemRectSize().x;
        }
        float wanted = 0;
        ImGui::PushFont(fonts_.nearest(scale_ * (values.size() > 2 ? 12 : text_size)));
        for (const std::string& value : values) wanted += ImGui::CalcTextSize(value.c_str()).x + units(12);
        float x = right - wanted;
        bool same_line = x > name_end;
        if (!same_line) x = std::max(left, x);
        for (std::size_t k = 0; k < values.size(); ++k) {
            if (same_line) ImGui::SameLine(x + units(12));
            else ImGui::SetCursorPosX(x + units(12));
            same_line = true;
            ImGui::PushStyleColor(ImGuiCol_Text, theme_.colour(pane_colour(k)));
            ImGui::TextUnformatted(values[k].c_str());
            ImGui::PopStyleColor();
            x += ImGui::CalcTextSize(values[k].c_str()).x + units(12);
        }
        ImGui::PopFont();
    }

    /// Where the time of a step goes, for runs that tell their parts.
    void part_times()
    {
        const PartWatch* watch = state_.watch;
        if (!watch || watch->tracks() == 0 || watch->parts(0).empty()) return;
        gap();
        if (!ImGui::CollapsingHeader("Time of a step")) return;
        const auto line = [&](const std::string& name, const auto& seconds_of) {
            std::vector<std::string> values;
            for (std::size_t k = 0; k < watch->tracks(); ++k)
                values.push_back(significant(1e6 * seconds_of(watch->parts(k)), 3));
            line_of_values(name + " [µs]", "Mean of the last steps, by the clock of this machine", "",
                           values);
        };
        for (const PartTimes::Part& part : watch->parts(0))
            line(part.name, [&](const auto& parts) { return seconds_of(parts, part.name); });
        line("all", [](const auto& parts) { return seconds_of(parts); });
    }

    void plot(std::size_t c)
    {
        const Column& column = show_.scene().columns[c];
        const std::vector<Track>& tracks = show_.playback()->tracks();

        std::vector<std::string> values;
        for (const Track& track : tracks)
            values.push_back(track.measured.empty() ? "-" : plot_value(track.measured[c], tracks.size()));
        line_of_values(plot_title(column), column.help, grey_curves(show_.scene(), column), values);

        // The area.
        const ImVec2 size = {ImGui::GetContentRegionAvail().x, units(58)};
        const ImVec2 corner = ImGui::GetCursorScreenPos();
        ImGui::PushID(static_cast<int>(c));
        ImGui::InvisibleButton("plot", size);
        ImGui::PopID();
        const bool hovered = ImGui::IsItemHovered();
        ImDrawList& list = *ImGui::GetWindowDrawList();
        const ImVec2 opposite = {corner.x + size.x, corner.y + size.y};
        list.AddRectFilled(corner, opposite, theme_.card(), units(3));

        if (const std::optional<LivePlot> plot = plot_of(show_, c, span_, state_.whole_run)) {
            curves(*plot, list, corner, size);
            limits(*plot, list, corner, size);
            if (hovered) read_off(c, list, corner, size);
        }
        list.AddRect(corner, opposite, theme_.edge(), units(3));
        gap();
    }

    float margin() const { return units(5); }
    float gutter() const { return units(47); }  ///< at the left of a plot: the numbers of its range

    void curves(const LivePlot& plot, ImDrawList& list, const ImVec2& corner, const ImVec2& size)
    {
        const Real width = static_cast<Real>(size.x - 2 * margin()),
                   height = static_cast<Real>(size.y - 2 * margin());
        if (plot.low < 0 && plot.high > 0) {  // where zero is
            const float y =
                corner.y + margin() + static_cast<float>(height * plot.high / (plot.high - plot.low));
            list.AddLine({corner.x + gutter(), y}, {corner.x + size.x, y}, theme_.edge());
        }
        list.PushClipRect(corner, {corner.x + size.x, corner.y + size.y}, true);
        const auto draw = [&](const LivePlot::Pieces& pieces, ImU32 colour) {
            for (const std::vector<Vec2>& piece : pieces) {
                std::vector<ImVec2> points;
                for (const Vec2& p : piece)
                    points.push_back({corner.x + gutter() + static_cast<float>(p.x() * width),
                                      corner.y + margin() + static_cast<float>((1 - p.y()) * height)});
                if (points.size() > 1)
                    list.AddPolyline(points.data(), static_cast<int>(points.size()), colour, 0, units(1.5));
            }
        };
        for (const LivePlot::Pieces& pieces : plot.beside) draw(pieces, theme_.colour(Colour::ink, 0.4));
        for (std::size_t k = plot.curves.size(); k-- > 0;)
            draw(plot.curves[k], theme_.colour(pane_colour(k)));
        list.PopClipRect();
    }

    /// The numbers at the upper and the lower end.
    void limits(const LivePlot& plot, ImDrawList& list, const ImVec2& corner, const ImVec2& size)
    {
        const Real right = static_cast<Real>(corner.x + gutter()) - 5 * scale_,
                   top = static_cast<Real>(corner.y);
        const auto put = [&](const std::string& text, Real baseline) {
            fonts_.paint(list, {right, baseline}, text, scale_ * small_size, dim(), Align::right);
        };
        put(plot.high_text, top + 12 * scale_);
        put(plot.low_text, top + static_cast<Real>(size.y) - 4 * scale_);
        list.AddLine({corner.x + gutter() - units(2), corner.y},
                     {corner.x + gutter() - units(2), corner.y + size.y}, theme_.edge());
    }

    /// The values under the mouse.
    void read_off(std::size_t c, ImDrawList& list, const ImVec2& corner, const ImVec2& size)
    {
        const float mouse =
            std::clamp(ImGui::GetIO().MousePos.x, corner.x + gutter(), corner.x + size.x - margin());
        const Real part = static_cast<Real>((mouse - corner.x - gutter()) / (size.x - gutter() - margin()));
        const Real t = span_.begin + part * (span_.end - span_.begin);
        list.AddLine({mouse, corner.y}, {mouse, corner.y + size.y}, dim());
        ImGui::BeginTooltip();
        ImGui::Text("t = %s s", significant(t, 4).c_str());
        const Column& column = show_.scene().columns[c];
        for (std::size_t k = 0; k < show_.playback()->tracks().size(); ++k) {
            Sample nearest{infinity, 0};
            each_sample(show_, k, c, state_.whole_run, [&](const Sample& sample) {
                if (std::abs(sample.t - t) < std::abs(nearest.t - t)) nearest = sample;
            });
            if (!std::isfinite(nearest.t)) continue;
            const std::string& method = show_.playback()->tracks()[k].method;
            ImGui::TextColored(vector_of(theme_.colour(pane_colour(k))), "%s%s%s", method.c_str(),
                               method.empty() ? "" : ": ",
                               shown(with_unit(significant(nearest.value, 5), column.unit)).c_str());
        }
        ImGui::EndTooltip();
    }

    // ---- the end of the panel -------------------------------------------------------------------

    void bottom()
    {
        ImGui::Separator();
        gap();
        if (button(state_.recording ? "Stop##record" : "Record##record", 3, state_.recording))
            state_.toggle_recording = true;
        tooltip("Numbered pictures of the panes into a folder");
        ImGui::SameLine();
        if (button("Picture", 3)) state_.save_picture = true;
        tooltip("Save as SVG and PNG: P");
        ImGui::SameLine();
        if (button(state_.dark ? "Light" : "Dark", 3)) state_.dark = !state_.dark;
        tooltip("The colours of the room: D");
        // One line, so that nothing moves: the last event, or the recording, or how fast all is.
        if (!state_.message.empty()) {
            dim_text(state_.message);
            tooltip(state_.message);
            return;
        }
        if (state_.recording) {
            dim_text(std::to_string(state_.frames_recorded) + " pictures in " + state_.record_folder);
            tooltip(state_.record_folder);
            return;
        }
        if (show_.playback() && show_.is_over() && show_.playback()->failures().empty()) {
            dim_text("step " + std::to_string(show_.playback()->steps()) + ", the end; R begins again");
            return;
        }
        std::string line = fixed(state_.frames_per_second, 0) + " frames/s";
        if (show_.playback()) line += "   step " + std::to_string(show_.playback()->steps());
        dim_text(line);
        if (!show_.falls_behind()) return;
        ImGui::SameLine();
        ImGui::PushStyleColor(ImGuiCol_Text, theme_.colour(Colour::orange));
        ImGui::TextUnformatted("too slow");
        ImGui::PopStyleColor();
        tooltip("More steps are due than there is time for: the scene runs slower than set");
    }

    void keys()
    {
        const auto line = [&](const std::string& key, const std::string& what) {
            ImGui::TextUnformatted(key.c_str());
            ImGui::SameLine(units(78));
            dim_text(what);
        };
        for (const KeyRow& row : key_rows(show_.scene())) line(row.key, row.what);
        line("N, B", "next scene, the one before");
        line("Wheel, + -", "closer and farther");
        line("", "middle button, Shift + arrows:");
        line("", "another place; 0: as at first");
        line("P", "picture as SVG and PNG");
        line("D", "dark or light");
        line("Tab", "hide or show this panel");
        line("Esc", "close a list; quit");
        line("Sliders", "Ctrl + click: type a number");
        line("", "right click: as at first");
    }

    Show& show_;
    PanelState& state_;
    const Theme& theme_;
    const Fonts& fonts_;
    Real scale_;
    TimeSpan span_;
};

}  // namespace

Real panel_width(Real scale) { return 316 * scale; }

void draw_panel(Show& show, PanelState& state, const Theme& theme, const Fonts& fonts, Real scale,
                Real height)
{
    ImGui::SetNextWindowPos({0, 0});
    ImGui::SetNextWindowSize({static_cast<float>(panel_width(scale)), static_cast<float>(height)});
    ImGui::PushFont(fonts.nearest(scale * text_size));
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoCollapse |
                     ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoScrollbar |
                     ImGuiWindowFlags_NoScrollWithMouse);
    Panel(show, state, theme, fonts, scale).draw();
    ImGui::End();
    ImGui::PopFont();
}

void set_style(const Theme& theme, Real scale)
{
    ImGuiStyle style;
    theme.dark ? ImGui::StyleColorsDark(&style) : ImGui::StyleColorsLight(&style);
    style.WindowRounding = 0;
    style.WindowBorderSize = 0;
    style.WindowPadding = {14, 12};
    style.FrameRounding = 4;
    style.GrabRounding = 3;
    style.PopupRounding = 4;
    style.ScrollbarRounding = 4;
    style.ScrollbarSize = 10;
    style.FramePadding = {7, 3};
    style.ItemSpacing = {7, 5};
    style.GrabMinSize = 12;
    const auto set = [&](ImGuiCol which, ImU32 colour) { style.Colors[which] = vector_of(colour); };
    set(ImGuiCol_Text, theme.colour(Colour::ink));
    set(ImGuiCol_WindowBg, theme.ground());
    set(ImGuiCol_PopupBg, theme.card());
    set(ImGuiCol_FrameBg, theme.card());
    set(ImGuiCol_FrameBgHovered, theme.colour(Colour::blue, 0.18));
    set(ImGuiCol_FrameBgActive, theme.colour(Colour::blue, 0.28));
    set(ImGuiCol_SliderGrab, theme.colour(Colour::blue, 0.45));
    set(ImGuiCol_SliderGrabActive, theme.colour(Colour::blue, 0.65));
    set(ImGuiCol_CheckMark, theme.colour(Colour::blue));
    set(ImGuiCol_Button, theme.card());
    set(ImGuiCol_ButtonHovered, theme.colour(Colour::blue, 0.25));
    set(ImGuiCol_ButtonActive, theme.colour(Colour::blue, 0.45));
    set(ImGuiCol_Header, theme.colour(Colour::blue, 0.16));
    set(ImGuiCol_HeaderHovered, theme.colour(Colour::blue, 0.25));
    set(ImGuiCol_HeaderActive, theme.colour(Colour::blue, 0.35));
    set(ImGuiCol_Border, theme.edge());
    set(ImGuiCol_Separator, theme.edge());
    set(ImGuiCol_ScrollbarBg, theme.ground());
    set(ImGuiCol_ScrollbarGrab, theme.edge());
    style.FrameBorderSize = theme.dark ? 0.0f : 1.0f;
    style.ScaleAllSizes(static_cast<float>(scale));
    ImGui::GetStyle() = style;
}

}  // namespace rigid
