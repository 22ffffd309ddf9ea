/// \file skipping_picture.hpp
/// The picture of a scene most of which needs nothing: islands coloured, sleepers faded, counters in the corner.
#pragma once

#include "chapters/03_mlcp_formulation/program/scene_drawing.hpp"
#include "chapters/10_skipping_work/skipping_world.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace rigid {

using SkippingState = RunState<SkippingMethod>;

/// Of each body: the lowest body of the island that it was in when it was awake last, −1 for one that touches none.
using IslandOf = std::vector<int>;

/// \param island_of  as it was after the step before; K
inline void note_islands(const SkippingState& state, IslandOf& island_of)
{
    const Islands& islands = state.method.solver.islands;
    for (int i = 0; !state.now.active.empty() && i < islands.count(); ++i)
        for (const int k : islands.bodies_of(i))
            island_of[static_cast<std::size_t>(k)] =
                islands.rows_of(i).empty() ? -1 : islands.bodies_of(i)[0];
}

/// Each island has a colour of its own; a disc that touches nothing is ink.
inline Colour colour_of_island(int island)
{
    constexpr std::array hues = {Colour::blue, Colour::orange, Colour::green,
                                 Colour::red,  Colour::purple, Colour::yellow};
    return island < 0 ? Colour::ink
                      : hues[static_cast<std::size_t>(island) * 2654435761u / 7 %
                             hues.size()];
}

inline void draw_skipping(Canvas& canvas, const SkippingState& state,
                          const IslandOf& island_of)
{
    const DiscScene& scene = state.scene;
    const View& view = state.view;
    for (const HalfSpace& wall : scene.walls)
        paint::draw_wall(canvas, wall, {}, 1, 2 * view.half_size.maxCoeff());
    paint::draw_links(canvas, state, [](const Link&) {
        return Style{Colour::ink, 1, 0.5};
    });
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Activity activity =
            state.method.contacts.set.activity[static_cast<std::size_t>(k)];
        const Vec2 at = scene.bodies.position(k) - view.centre;
        if (activity == Activity::gone ||
            std::abs(at.x()) > view.half_size.x() + scene.radius[k] ||
            std::abs(at.y()) > view.half_size.y() + scene.radius[k])
            continue;
        Style style = {colour_of_island(island_of[static_cast<std::size_t>(k)]), 1,
                       0.65, Paint::filled};
        if (activity == Activity::fixed)
            style = {Colour::ink, 1, 0.3, Paint::filled};
        if (activity == Activity::asleep) style.opacity = 0.12;
        canvas.disc(scene.bodies.position(k), scene.radius[k], style);
    }
    const SkippingCounters c = counters_of(state.method, state.now);
    const auto line = [&](int i, const std::string& text) {
        const Real size = view.half_size.maxCoeff();
        canvas.text(view.centre +
                        Vec2(-0.96 * view.half_size.x(),
                             view.half_size.y() - size * (0.05 + 0.05 * i)),
                    text, 14);
    };
    line(0, std::to_string(c.awake) + " awake, " + std::to_string(c.islands) +
                " islands, " + std::to_string(c.rows) + " rows");
    line(1, std::to_string(c.tested) + " pairs tested, " +
                std::to_string(c.visits) + " row visits");
    paint::draw_hand(canvas, state);
}

}  // namespace rigid
