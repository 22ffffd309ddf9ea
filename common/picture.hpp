/// \file picture.hpp
/// What all painters of a canvas share: panes side by side, the way from metres to pixels, the
/// shape of an arrow's head.
///
/// Pixels count from the upper left corner, x to the right, y down.
#pragma once

#include "common/canvas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace rigid {

/// One picture among several that stand side by side, such as the same scene under another method.
struct Pane {
    std::string label;
    View view;
    Canvas canvas;
};

/// A part of a picture [pixels].
struct Rectangle {
    Real x = 0, y = 0, width = 0, height = 0;

    bool contains(const Vec2& p) const
    {
        return p.x() >= x && p.x() < x + width && p.y() >= y && p.y() < y + height;
    }
};

/// Shows a view in the middle of a rectangle, as large as it fits, circles as circles.
struct Projection {
    View view;
    Rectangle area;
    Real scale = 1;  ///< pixels per metre

    Projection(const View& shown, const Rectangle& where)
        : view(shown), area(where),
          scale(std::min(where.width / (2 * shown.half_size.x()), where.height / (2 * shown.half_size.y())))
    {
    }
    Vec2 to_pixel(const Vec2& p) const
    {
        return {area.x + area.width / 2 + scale * (p.x() - view.centre.x()),
                area.y + area.height / 2 - scale * (p.y() - view.centre.y())};
    }
    Vec2 to_world(const Vec2& p) const
    {
        return {view.centre.x() + (p.x() - area.x - area.width / 2) / scale,
                view.centre.y() - (p.y() - area.y - area.height / 2) / scale};
    }
};

/// Where the panes of a picture of its own (a file, not a window) stand.
struct PictureLayout {
    static constexpr Real label_height = 28, gap = 16;  ///< [pixels]

    Real width = 0, height = 0;
    std::vector<Rectangle> labels;  ///< of height zero where there is one pane only
    std::vector<Rectangle> areas;
};

/// The pixels per metre that pictures are designed for: 720 pixels along the longer side of the view.
/// In a file widths and letters are in these pixels; in a window they grow and shrink with the pane.
inline Real design_scale(const View& view) { return 720 / (2 * view.half_size.maxCoeff()); }

/// Up to three panes in a row, more in rows of two, each in the scale that it is designed for.
inline PictureLayout lay_out(const std::vector<Pane>& panes)
{
    constexpr Real narrowest = 240;
    PictureLayout layout;
    const std::size_t count = panes.size(), columns = count > 3 ? 2 : count;
    const Real label = count > 1 ? PictureLayout::label_height : 0;
    Real width = 0, height = 0;
    for (const Pane& pane : panes) {
        const Real scale = design_scale(pane.view);
        width = std::max({width, std::round(2 * scale * pane.view.half_size.x()), narrowest});
        height = std::max(height, std::round(2 * scale * pane.view.half_size.y()));
    }
    for (std::size_t i = 0; i < count; ++i) {
        const Real x = static_cast<Real>(i % columns) * (width + PictureLayout::gap);
        const Real y = static_cast<Real>(i / columns) * (height + label + PictureLayout::gap);
        layout.labels.push_back({x, y, width, label});
        layout.areas.push_back({x, y + label, width, height});
        layout.width = std::max(layout.width, x + width);
        layout.height = std::max(layout.height, y + label + height);
    }
    return layout;
}

/// The colour of the k-th pane's label and curves.
inline Colour pane_colour(std::size_t k)
{
    constexpr std::array colours = {Colour::blue, Colour::orange, Colour::green, Colour::purple};
    return colours[k % colours.size()];
}

/// Faint is ink that steps back.
inline Real seen_opacity(const Style& style)
{
    return std::clamp<Real>(style.opacity, 0, 1) * (style.colour == Colour::faint ? 0.4 : 1.0);
}

/// The dashes of a dashed line, in pixels: so long, so far apart.
inline constexpr Real dash_length = 6, dash_gap = 5;

/// An arrow in pixels: its shaft ends where its head begins.
struct ArrowShape {
    Vec2 shaft_end, tip, left, right;
};

inline ArrowShape arrow_shape(const Vec2& tail, const Vec2& tip, Real width)
{
    const Vec2 along = tip - tail;
    const Real length = along.norm();
    const Vec2 direction = length > 0 ? Vec2(along / length) : Vec2(1, 0);
    const Real head = std::min(5 + 3 * width, 0.7 * length), half = 0.42 * head;
    const Vec2 base = tip - head * direction;
    return {base + 0.2 * head * direction, tip, base + half * perpendicular(direction),
            base - half * perpendicular(direction)};
}

/// How far from the picture anything is painted [pixels]. What explodes goes farther than a painter
/// can count; the difference cannot be seen.
inline constexpr Real far_away = 1e5;

inline bool is_near(const Vec2& p) { return p.cwiseAbs().maxCoeff() <= far_away; }

/// The part of the segment that lies near; false if there is none.
inline bool cut_to_near(Vec2& from, Vec2& to)
{
    Real begin = 0, end = 1;  // of the way from `from` to `to`
    const Vec2 along = to - from;
    if (!along.allFinite()) return false;
    for (Index axis = 0; axis < 2; ++axis)
        for (const Real side : {-1.0, 1.0}) {
            const Real ahead = side * along[axis], room = far_away - side * from[axis];
            if (ahead > 0) end = std::min(end, room / ahead);
            else if (ahead < 0) begin = std::max(begin, room / ahead);
            else if (room < 0) return false;
        }
    if (begin >= end) return false;
    to = from + end * along;
    from += begin * along;
    return true;
}

/// A polyline in pixels as the pieces of it that lie near; one piece, untouched, in all usual cases.
inline std::vector<std::vector<Vec2>> near_pieces(std::vector<Vec2> points)
{
    if (std::all_of(points.begin(), points.end(), is_near)) return {std::move(points)};
    std::vector<std::vector<Vec2>> pieces;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        Vec2 from = points[i], to = points[i + 1];
        if (cut_to_near(from, to)) pieces.push_back({from, to});
    }
    return pieces;
}

/// The points of an item in pixels. Corners of polygons that are too far off are pulled nearer.
inline std::vector<Vec2> pixels_of(const DrawItem& item, const Projection& projection)
{
    std::vector<Vec2> points;
    for (const Vec2& p : item.points) {
        points.push_back(projection.to_pixel(p));
        if (item.kind == DrawItem::Kind::polygon)
            points.back() = points.back().cwiseMax(-far_away).cwiseMin(far_away);
    }
    if (item.kind == DrawItem::Kind::arrow && is_near(points[0]) && !is_near(points[1]))
        cut_to_near(points[0], points[1]);
    return points;
}

/// False for what makes no shape, has left the plane of finite numbers or is too far off to be seen:
/// painters leave it out.
inline bool is_paintable(const DrawItem& item, const Projection& projection)
{
    std::size_t needed = 1;
    if (item.kind == DrawItem::Kind::line || item.kind == DrawItem::Kind::arrow) needed = 2;
    if (item.kind == DrawItem::Kind::polygon) needed = 3;
    if (item.points.size() < needed || !std::isfinite(item.radius) || item.radius < 0) return false;
    if (!std::all_of(item.points.begin(), item.points.end(), [](const Vec2& p) { return p.allFinite(); }))
        return false;
    if (item.kind == DrawItem::Kind::line || item.kind == DrawItem::Kind::polygon) return true;
    return is_near(projection.to_pixel(item.points[0])) && projection.scale * item.radius <= far_away;
}

}  // namespace rigid
