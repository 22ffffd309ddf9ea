/// \file gl_canvas.hpp
/// Paints canvases with OpenGL, by way of Dear ImGui's draw lists: anti-aliased shapes and text in
/// the window and in pictures made without one.
#pragma once

#include "common/picture.hpp"

#include <imgui.h>

#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// The colours of a light or a dark room.
struct Theme {
    bool dark = false;

    ImU32 colour(Colour colour, Real opacity = 1) const;
    ImU32 ground() const;  ///< behind everything
    ImU32 card() const;    ///< behind a pane or a plot
    ImU32 edge() const;    ///< around it
};

/// A typeface of the system, or the plain one inside Dear ImGui where none is found. Letters are
/// rasterised at a few sizes; the nearest one is scaled.
class Fonts {
public:
    /// Fills the current context's atlas.
    /// \param scale    units of a draw list for one pixel of a design at 96 dpi
    /// \param density  pixels of the framebuffer for one unit of a draw list
    Fonts(Real scale, Real density);

    /// The typeface for letters of this size [units of a draw list].
    ImFont* nearest(Real size) const;
    /// Text as this typeface can show it: "lambda" for λ where there are no Greek letters.
    std::string shown(const std::string& text) const;
    /// Paints text with its baseline at a point, and returns its width. The size is that of SVG and CSS.
    Real paint(ImDrawList& list, const Vec2& baseline, const std::string& text, Real size, ImU32 colour,
               Align align = Align::left) const;

private:
    bool knows(const std::string& letter) const;

    std::vector<ImFont*> fonts_;
    Real density_;
    std::vector<std::pair<std::string, std::string>> missing_;  ///< letters, and what stands for them
};

/// Paints a canvas into the projection's area; nothing goes beyond it.
/// \param line_scale  how many units of the list a pixel of the canvas is (HiDPI)
/// \param words       false: no text, where the picture is so small that lines would lie over each other
void paint(ImDrawList& list, const Canvas& canvas, const Projection& projection, const Theme& theme,
           const Fonts& fonts, Real line_scale = 1, bool words = true);

/// Paints a whole picture, as in a file of its own.
void paint_picture(ImDrawList& list, const std::vector<Pane>& panes, const PictureLayout& layout,
                   const Theme& theme, const Fonts& fonts);

/// Saves a part of the framebuffer that is bound for reading; y counts from below. Throws
/// std::runtime_error, naming the file, if it can't be written.
void save_framebuffer(const std::string& file, int x, int y, int width, int height);

}  // namespace rigid
