/// \file canvas.hpp
/// What a program draws on: a list of simple shapes in world coordinates (metres, y up).
///
/// A canvas is data. Physics has nothing of it, and it does not depend on what will paint it: an SVG
/// file (svg_canvas.hpp), an OpenGL window (gl_canvas.hpp) or, later, a web page.
#pragma once

#include "common/elementary.hpp"
#include "common/math.hpp"

#include <cmath>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// The colours by what they mean, so that each painter can choose what reads well on its ground.
/// The six hues stay apart for colour-blind readers.
enum class Colour { ink, faint, blue, orange, green, red, purple, yellow };

/// Discs, boxes and polygons that are filled: the inside is painted with the opacity of their style. Their outline is drawn
/// too, with √opacity, so that a faint inside keeps an edge that can be seen; width = 0 leaves it out.
enum class Paint { outline, filled, dashed };

struct Style {
    Colour colour = Colour::ink;
    Real width = 1.5;  ///< of a line, in pixels of a picture 720 wide
    Real opacity = 1;  ///< 0 … 1
    Paint paint = Paint::outline;

    bool filled() const { return paint == Paint::filled; }
    bool dashed() const { return paint == Paint::dashed; }
};

/// Which end of a text stands at its point.
enum class Align { left, centre, right };

struct DrawItem {
    enum class Kind { disc, polygon, line, arrow, text } kind = Kind::line;
    std::vector<Vec2> points;  ///< disc: centre · polygon, line: corners · arrow: tail, head · text: where
    Real radius = 0;           ///< of a disc [m]
    std::string text;
    Real size = 14;  ///< of text, in pixels of a picture 720 wide
    Style style;
    Align align = Align::left;  ///< of text
};

/// The part of the world that a picture shows: centre ± half_size [m].
struct View {
    Vec2 centre = {0, 0};
    Vec2 half_size = {1, 1};
};

class Canvas {
public:
    void disc(const Vec2& centre, Real radius, Style style = {})
    {
        items_.push_back({DrawItem::Kind::disc, {centre}, radius, {}, 14, style, Align::left});
    }
    /// A box with the given half sizes, turned by the angle [rad].
    void box(const Vec2& centre, const Vec2& half_size, Real angle, Style style = {})
    {
        const Vec2 side = half_size.x() * Vec2(cos(angle), sin(angle));
        const Vec2 up = half_size.y() * Vec2(-sin(angle), cos(angle));
        polygon({centre - side - up, centre + side - up, centre + side + up, centre - side + up}, style);
    }
    void polygon(std::vector<Vec2> corners, Style style = {})
    {
        items_.push_back({DrawItem::Kind::polygon, std::move(corners), 0, {}, 14, style, Align::left});
    }
    void segment(const Vec2& from, const Vec2& to, Style style = {}) { polyline({from, to}, style); }
    void polyline(std::vector<Vec2> points, Style style = {})
    {
        items_.push_back({DrawItem::Kind::line, std::move(points), 0, {}, 14, style, Align::left});
    }
    void arrow(const Vec2& tail, const Vec2& head, Style style = {})
    {
        items_.push_back({DrawItem::Kind::arrow, {tail, head}, 0, {}, 14, style, Align::left});
    }
    /// Text that begins at a point (its baseline's left end), or is centred on it, or ends there. UTF-8.
    void text(const Vec2& where, std::string words, Real size = 14, Style style = {},
              Align align = Align::left)
    {
        items_.push_back({DrawItem::Kind::text, {where}, 0, std::move(words), size, style, align});
    }

    void clear() { items_.clear(); }
    const std::vector<DrawItem>& items() const { return items_; }

private:
    std::vector<DrawItem> items_;
};

}  // namespace rigid
