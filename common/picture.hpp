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

namespace rigid
{

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
    Real scale = 1; ///< pixels per metre

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
    static constexpr Real label_height = 28, gap = 16; ///< [pixels]

    Real width = 0, height = 0;
    std::vector<Rectangle> labels; ///< of height zero where there is one pane only
    std::vector<Rectangle> areas;
};

/// Up to three panes in a row, more in rows of two; each of them 720 pixels along its longer side.
inline PictureLayout lay_out(const std::vector<Pane>& panes)
{
    constexpr Real longest = 720, narrowest = 240;
    PictureLayout layout;
    const std::size_t count = panes.size(), columns = count > 3 ? 2 : count;
    const Real label = count > 1 ? PictureLayout::label_height : 0;
    Real width = 0, height = 0;
    for (const Pane& pane : panes) {
        const Real scale = longest / (2 * pane.view.half_size.maxCoeff());
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

/// False for what has left the plane of finite numbers, or makes no shape: painters leave it out.
inline bool is_paintable(const DrawItem& item)
{
    std::size_t needed = 1;
    if (item.kind == DrawItem::Kind::line || item.kind == DrawItem::Kind::arrow) needed = 2;
    if (item.kind == DrawItem::Kind::polygon) needed = 3;
    return item.points.size() >= needed && std::isfinite(item.radius) && item.radius >= 0 &&
           std::all_of(item.points.begin(), item.points.end(), [](const Vec2& p) { return p.allFinite(); });
}

} // namespace rigid
