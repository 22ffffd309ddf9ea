/// \file scene_drawing.hpp
/// The pieces that pictures of scenes are made of: colours, walls, links, discs, the hand, gravity.
#pragma once

#include "chapters/03_mlcp_formulation/program/columns.hpp"
#include "common/canvas.hpp"
#include "common/text.hpp"

#include <string>
#include <vector>

namespace rigid::paint {

inline constexpr Style label = {Colour::ink, 1.5, 1};
inline constexpr Style axis = {Colour::ink, 1, 1};
inline constexpr Style grid = {Colour::faint, 0.7, 0.6};
inline constexpr Style body = {Colour::blue, 1.5, 0.3, Paint::filled};
inline constexpr Style fixed_body = {Colour::ink, 1.5, 0.5, Paint::filled};
inline constexpr Style wall = {Colour::ink, 2, 1};
inline constexpr Style impulse = {Colour::red, 2.5, 1};
inline constexpr Style link = {Colour::ink, 3, 1};
inline constexpr Style pull = {Colour::green, 2, 1};
inline constexpr Style theory = {Colour::ink, 1.5, 1, Paint::dashed};

/// Where body k is in the picture.
inline Vec2 shown(const SceneState& state, Index k)
{
    return state.zoom * state.scene.bodies.position(k);
}

/// A wall of a scene: it ends where the walls across it stand; a lone one goes `reach` to either side [m].
/// \param zoom  from metres to the units of the picture
inline void draw_wall(Canvas& canvas, const HalfSpace& plane,
                      const std::vector<HalfSpace>& all, Real zoom, Real reach)
{
    const Vec2 along = perpendicular(plane.normal),
               middle = plane.normal * plane.offset;
    Real from = -reach, to = reach;
    for (const HalfSpace& other : all) {
        const Real slope = other.normal.dot(along);
        if (std::abs(slope) < 0.5) continue;
        (slope > 0 ? from : to) = (other.offset - other.normal.dot(middle)) / slope;
    }
    canvas.segment(zoom * (middle + from * along), zoom * (middle + to * along),
                   wall);
}

inline void draw_walls(Canvas& canvas, const SceneState& state, Real reach)
{
    for (const HalfSpace& half : state.scene.walls)
        draw_wall(canvas, half, state.scene.walls, state.zoom, reach);
    for (const Segment& segment : state.scene.segments) {
        canvas.segment(state.zoom * segment.p, state.zoom * segment.q, wall);
        if (segment.radius <= 0) continue;
        const Vec2 side =
            segment.radius * perpendicular((segment.q - segment.p).normalized());
        canvas.polygon(
            {state.zoom * (segment.p - side), state.zoom * (segment.q - side),
             state.zoom * (segment.q + side), state.zoom * (segment.p + side)},
            fixed_body);
        for (const Vec2& end : {segment.p, segment.q})
            canvas.disc(state.zoom * end, state.zoom * segment.radius, fixed_body);
    }
}

/// \param style_of  Style (const Link&)
template <class StyleOf>
void draw_links(Canvas& canvas, const SceneState& state, const StyleOf& style_of)
{
    for (const Link& rod : state.scene.links)
        canvas.segment(shown(state, rod.a), shown(state, rod.b), style_of(rod));
}

/// \param style_of  Style (Index)
template <class StyleOf>
void draw_discs(Canvas& canvas, const SceneState& state, const StyleOf& style_of)
{
    for (Index k = 0; k < state.scene.bodies.count(); ++k)
        canvas.disc(shown(state, k), state.zoom * state.scene.radius[k],
                    style_of(k));
}

/// From the disc that the hand pulls to the hand.
inline void draw_hand(Canvas& canvas, const SceneState& state)
{
    if (state.step.pulled != world)
        canvas.arrow(shown(state, state.step.pulled), state.zoom * state.step.hand,
                     pull);
}

inline void draw_gravity(Canvas& canvas, const SceneState& state)
{
    const Vec2 g = state.scene.gravity;
    canvas.arrow({0, 0}, 0.02 * g, {Colour::green, 2.5, 1});
    // Beyond the head, wherever it points.
    canvas.text(0.0255 * g - Vec2(0, 0.012), "g", 14, {Colour::green, 1.5, 1},
                Align::centre);
}

/// Line number `line` of what stands in the upper left corner.
/// \param from    where the first line begins, in halves of the picture's size
/// \param height  of a line, in halves of its larger side
inline void draw_line_of_text(Canvas& canvas, const SceneState& state,
                              const Vec2& from, Real height, int line,
                              const std::string& text, const Style& style = label)
{
    const Vec2 corner = state.view.centre + from.cwiseProduct(state.view.half_size);
    canvas.text(corner - line * Vec2(0, height * state.view.half_size.maxCoeff()),
                text, 14, style);
}

}  // namespace rigid::paint
