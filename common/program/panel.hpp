/// \file panel.hpp
/// The panel beside the panes: chooser, buttons, sliders, live plots.
#pragma once

#include "common/gl_canvas.hpp"
#include "common/program/part_watch.hpp"
#include "common/program/show.hpp"

#include <string>

namespace rigid {

/// What the panel requests of the window, and shows of it.
struct PanelState {
    // asked
    bool single_step = false, save_picture = false, toggle_recording = false;
    // asked of the panel
    bool close_list = false;
    // the reader's taste
    bool visible = true, dark = false, whole_run = false;
    // told
    bool recording = false;
    std::string record_folder;
    long frames_recorded = 0;
    Real frames_per_second = 0;
    const PartWatch* watch = nullptr;  ///< of the steps; null = no clock is read
    std::string message;               ///< what happened in the last seconds, such as a picture saved
};

/// The width that the panel takes [units of ImGui].
Real panel_width(Real scale);

/// Draws the panel at the left edge of the window, and changes the show as the reader sets it.
void draw_panel(Show& show, PanelState& state, const Theme& theme, const Fonts& fonts, Real scale,
                Real height);

/// Colours, distances and corners of all that Dear ImGui draws.
void set_style(const Theme& theme, Real scale);

}  // namespace rigid
