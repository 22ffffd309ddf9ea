/// \file svg_canvas.hpp
/// Paints canvases as an SVG picture without a background, in colours that read on light and on
/// dark pages. The same canvases give the same bytes.
#pragma once

#include "common/picture.hpp"

#include <string>
#include <vector>

namespace rigid {

/// `#4477AA` for blue, and so on; `#808080` for ink.
std::string svg_colour(Colour colour);

/// The whole text of an SVG file with the panes side by side; labels stand above the panes if there
/// are several. Throws std::invalid_argument for no pane at all, or a view that shows nothing.
std::string to_svg(const std::vector<Pane>& panes);

/// Writes to_svg() into a file. Throws std::runtime_error, naming the file, if that can't be done.
void write_svg(const std::string& file, const std::vector<Pane>& panes);

}  // namespace rigid
