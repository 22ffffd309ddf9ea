/// \file drawing.hpp
/// Small helpers of this chapter's pictures.
#pragma once

#include "common/canvas.hpp"
#include "common/text.hpp"

#include <deque>
#include <string>
#include <vector>

namespace rigid {

/// The colours of this chapter: each kind of velocity and impulse has its own.
namespace paint {
inline constexpr Style body = {Colour::blue, 1.5, 0.35, Paint::filled};
inline constexpr Style fixed = {Colour::ink, 1.5, 0.5, Paint::filled};
inline constexpr Style wire = {Colour::ink, 1.5, 1};
inline constexpr Style guide = {Colour::faint, 1, 1, Paint::dashed};
/// the velocity before the rows: u*
inline constexpr Style wanted = {Colour::orange, 2, 1};
/// the velocity after them: u
inline constexpr Style allowed = {Colour::blue, 2.5, 1};
/// what a row takes away or gives
inline constexpr Style impulse = {Colour::red, 2.5, 1};
/// J, a normal
inline constexpr Style direction = {Colour::green, 2, 1};
inline constexpr Style label = {Colour::ink, 1.5, 1};
}  // namespace paint

/// An arrow with its name behind its head, a little further on.
inline void labelled_arrow(Canvas& canvas, const Vec2& tail, const Vec2& vector,
                           const std::string& name, const Style& style,
                           Real gap = 0.06)
{
    if (vector.norm() < 1e-9) return;
    const Vec2 head = tail + vector, direction = vector.normalized();
    canvas.arrow(tail, head, style);
    const Align align = direction.x() > 0.35    ? Align::left
                        : direction.x() < -0.35 ? Align::right
                                                : Align::centre;
    canvas.text(head + gap * direction - Vec2(0, 0.35 * gap), name, 15, style,
                align);
}

/// The places where something has been, the newest last; the older fall off.
class Trail {
public:
    explicit Trail(std::size_t longest = 400) : longest_(longest) {}

    void add(const Vec2& p)
    {
        points_.push_back(p);
        if (points_.size() > longest_) points_.pop_front();
    }
    void draw(Canvas& canvas, const Style& style) const
    {
        if (points_.size() > 1)
            canvas.polyline({points_.begin(), points_.end()}, style);
    }
    void clear() { points_.clear(); }

private:
    std::size_t longest_;
    std::deque<Vec2> points_;
};

}  // namespace rigid
