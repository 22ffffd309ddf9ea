/// \file scene_picture.hpp
/// The picture of a scene of discs: walls, links, discs the darker the heavier, the forces of the rows, and what the step
/// cost.
#pragma once

#include "chapters/03_mlcp_formulation/program/scene_drawing.hpp"

#include <algorithm>
#include <string>

namespace rigid::paint {

inline Real mass_of(const SceneState& state, Index k)
{
    const Real inverse = state.scene.bodies.inverse_mass[2 * k];
    return inverse > 0 ? 1 / inverse : 0;
}

/// Each row's force |λ|/h, to scale with the weight of all: arrows at contacts where the pointer steers, else bars across
/// the normal.
inline void draw_impulses(Canvas& canvas, const SceneState& state)
{
    if (state.now.solution.lambda.size() !=
        static_cast<Index>(state.now.rows.size()))
        return;
    const bool steered = state.pointer == Pointer::steers;
    Real weight = 0;
    for (Index k = 0; k < state.scene.bodies.count(); ++k)
        weight += 9.81 * mass_of(state, k);
    const Real unit = (state.scene.links.empty() || steered ? 0.5 : 0.25) /
                      (weight * state.step.h);
    for (std::size_t i = 0; i < state.now.rows.size(); ++i) {
        const Row<2>& row = state.now.rows[i];
        const Vec2 normal = row.Jb.transpose();
        const Real length = std::min(Real{0.6}, unit * std::abs(state.lambda(i)));
        if (length < 0.004) continue;
        const Vec2 touch = state.zoom * (state.scene.bodies.position(row.b) -
                                         normal * state.scene.radius[row.b]);
        if (!steered) {
            canvas.segment(touch - length * perpendicular(normal),
                           touch + length * perpendicular(normal),
                           {Colour::red, 4, 0.9});
        } else if (state.is(i, Source::Of::contact)) {
            canvas.arrow(touch, touch + length * normal, impulse);
            if (row.a != world)
                canvas.arrow(touch, touch - length * normal, impulse);
        }
    }
}

/// What the step cost and what is wrong with its answer.
/// \param counted  what the solver counts
inline void draw_caption(Canvas& canvas, const SceneState& state,
                         const std::string& counted)
{
    const Solution& solution = state.now.solution;
    if (!std::isfinite(solution.residual)) return;
    std::string text = std::to_string(solution.iterations) + " " + counted +
                       ", residual " + significant(solution.residual, 2) + " m/s";
    if (solution.status != Status::solved)
        text += ": " + std::string(to_string(solution.status));
    const auto line = [&](int number, const std::string& words,
                          const Style& style) {
        draw_line_of_text(canvas, state, {-0.93, 0.92}, 0.056, number, words,
                          style);
    };
    line(0, text, solution.status == Status::solved ? label : impulse);
    const Real off = 1000 * std::max(largest_link_error(state.scene),
                                     deepest_penetration(state.scene));
    line(1, "links and contacts off by " + significant(off, 2) + " mm", label);
    if (state.pointer == Pointer::steers) draw_gravity(canvas, state);
}

inline void draw_scene(Canvas& canvas, const SceneState& state,
                       const std::string& counted = "sweeps")
{
    draw_walls(canvas, state, 1 / state.zoom);
    draw_links(canvas, state, [](const Link&) { return link; });
    Real heaviest = 0;
    for (Index k = 0; k < state.scene.bodies.count(); ++k)
        heaviest = std::max(heaviest, mass_of(state, k));
    draw_discs(canvas, state, [&](Index k) {
        const Real mass = mass_of(state, k);
        Style style = mass > 0 ? body : fixed_body;
        if (mass > 0) style.opacity = 0.15 + 0.55 * std::sqrt(mass / heaviest);
        return style;
    });
    draw_impulses(canvas, state);
    draw_caption(canvas, state, counted);
    draw_hand(canvas, state);
}

}  // namespace rigid::paint
