/// \file draw_list.hpp
/// A canvas as a list of numbers, for a painter that knows neither Canvas nor C++: the 2D context of a page
/// (docs/web/painter.js), or an SVG made from the same list.
///
/// Each command is
///
///     kind, colour, opacity, edge, width, dash, count, … count numbers …
///
/// | kind | numbers | |
/// |---|---|---|
/// | 0 disc | x, y, radius | |
/// | 1 polygon | x, y, x, y, … | closed |
/// | 2 line | x, y, x, y, … | |
/// | 3 text | x, y, size, align, bold | its words are the next line of words() |
/// | 4 clip | x, y, width, height | until the next 5 |
/// | 5 unclip | | |
/// | 6 card | x, y, width, height, corner | a rounded rectangle |
///
/// All in pixels, y down. `opacity` is that of the inside (0 = none), `edge` that of the outline, `width` and `dash`
/// (0 = none) the outline's. Colours are those of Colour, and then ground, card, rim.
#pragma once

#include "common/picture.hpp"

#include <string>
#include <vector>

namespace rigid {

class DrawList {
public:
    enum class Kind { disc, polygon, line, text, clip, unclip, card };
    /// What is no Colour of a canvas: behind everything, behind a pane, around it.
    static constexpr int ground = 8, card_colour = 9, rim = 10;

    void clear();
    /// Paints a canvas into the projection's area; nothing goes beyond it.
    /// \param line_scale  pixels for one pixel of the canvas's widths and letters
    void paint(const Canvas& canvas, const Projection& projection, Real line_scale = 1);
    /// What stands behind a pane.
    void card(const Rectangle& place, Real corner);
    void square(const Rectangle& place, Colour colour);
    void line(const std::vector<Vec2>& points, int colour, Real opacity, Real width);
    void ring(const Vec2& centre, Real radius, Real width);
    void text(const Vec2& where, const std::string& words, Real size, int colour, Real opacity, Align align,
              bool bold);
    void clip(const Rectangle& place);
    void unclip();

    const std::vector<float>& numbers() const { return numbers_; }
    /// The words of the texts, a line each.
    const std::string& words() const { return words_; }

private:
    struct Pen {
        int colour = 0;
        Real opacity = 0, edge = 0, width = 0, dash = 0;
    };
    void begin(Kind kind, const Pen& pen, std::size_t count);
    void put(Real value) { numbers_.push_back(static_cast<float>(value)); }
    void put(const std::vector<Vec2>& points);
    void paint(const DrawItem& item, const Projection& projection, Real line_scale);

    Vec2 line_above_ = {0, 0};  ///< where the canvas has the last text of the pane
    Real end_of_block_ = 0;     ///< and how far down it was painted
    std::vector<float> numbers_;
    std::string words_;
};

}  // namespace rigid
