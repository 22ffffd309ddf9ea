#include "common/draw_list.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace rigid {

void DrawList::clear()
{
    numbers_.clear();
    words_.clear();
}

void DrawList::begin(Kind kind, const Pen& pen, std::size_t count)
{
    put(static_cast<Real>(kind));
    put(pen.colour);
    put(pen.opacity);
    put(pen.width > 0 ? pen.edge : 0);
    put(pen.width);
    put(pen.dash);
    put(static_cast<Real>(count));
}

void DrawList::put(const std::vector<Vec2>& points)
{
    for (const Vec2& p : points) {
        put(p.x());
        put(p.y());
    }
}

void DrawList::paint(const Canvas& canvas, const Projection& projection, Real line_scale)
{
    clip(projection.area);
    line_above_ = {infinity, infinity};
    end_of_block_ = -infinity;
    for (const DrawItem& item : canvas.items())
        if (is_paintable(item, projection)) paint(item, projection, line_scale);
    unclip();
}

void DrawList::paint(const DrawItem& item, const Projection& projection, Real line_scale)
{
    const Style& style = item.style;
    const std::vector<Vec2> points = pixels_of(item, projection);
    const Real opacity = seen_opacity(style);
    Pen pen{static_cast<int>(style.colour), 0, opacity, line_scale * style.width,
            style.dashed() ? line_scale : 0};
    switch (item.kind) {
    case DrawItem::Kind::disc:
    case DrawItem::Kind::polygon:
        if (style.filled()) {
            pen.opacity = opacity;
            pen.edge = std::sqrt(opacity);
        }
        if (item.kind == DrawItem::Kind::polygon) {
            begin(Kind::polygon, pen, 2 * points.size());
            return put(points);
        }
        begin(Kind::disc, pen, 3);
        put(points);
        return put(projection.scale * item.radius);
    case DrawItem::Kind::line:
        for (const std::vector<Vec2>& piece : near_pieces(points)) {
            begin(Kind::line, pen, 2 * piece.size());
            put(piece);
        }
        return;
    case DrawItem::Kind::arrow: {
        if ((points[1] - points[0]).norm() < 0.5) return;  // no direction to be seen
        const ArrowShape shape = arrow_shape(points[0], points[1], line_scale * style.width);
        begin(Kind::line, pen, 4);
        put({points[0], shape.shaft_end});
        begin(Kind::polygon, {pen.colour, opacity, 0, 0, 0}, 6);
        return put({shape.left, shape.tip, shape.right});
    }
    case DrawItem::Kind::text: {
        // In a small pane letters do not shrink as much as distances: the next line of a block makes room.
        Vec2 where = points[0];
        const Real size = line_scale * item.size;
        if (std::abs(where.x() - line_above_.x()) < 1 && where.y() > line_above_.y() + 0.2 * size)
            where.y() = std::max(where.y(), end_of_block_ + 1.25 * size);
        line_above_ = points[0];
        end_of_block_ = where.y();
        text(where, item.text, size, pen.colour, opacity, item.align, false);
    }
    }
}

void DrawList::card(const Rectangle& place, Real corner)
{
    begin(Kind::card, {card_colour, 1, 0, 0, 0}, 5);
    for (const Real value : {place.x, place.y, place.width, place.height, corner}) put(value);
}

void DrawList::square(const Rectangle& place, Colour colour)
{
    begin(Kind::card, {static_cast<int>(colour), 1, 0, 0, 0}, 5);
    for (const Real value : {place.x, place.y, place.width, place.height, place.width / 5}) put(value);
}

void DrawList::line(const std::vector<Vec2>& points, int colour, Real opacity, Real width)
{
    begin(Kind::line, {colour, 0, opacity, width, 0}, 2 * points.size());
    put(points);
}

void DrawList::ring(const Vec2& centre, Real radius, Real width)
{
    begin(Kind::disc, {static_cast<int>(Colour::ink), 0, 0.5, width, 0}, 3);
    put({centre});
    put(radius);
}

void DrawList::text(const Vec2& where, const std::string& words, Real size, int colour, Real opacity,
                    Align align, bool bold)
{
    begin(Kind::text, {colour, opacity, 0, 0, 0}, 5);
    put({where});
    put(size);
    put(static_cast<Real>(align));
    put(bold ? 1 : 0);
    // One line each, whatever the text is.
    std::transform(words.begin(), words.end(), std::back_inserter(words_),
                   [](char c) { return static_cast<unsigned char>(c) < 0x20 ? ' ' : c; });
    words_ += '\n';
}

void DrawList::clip(const Rectangle& place)
{
    begin(Kind::clip, {}, 4);
    for (const Real value : {place.x, place.y, place.width, place.height}) put(value);
}

void DrawList::unclip() { begin(Kind::unclip, {}, 0); }

}  // namespace rigid
