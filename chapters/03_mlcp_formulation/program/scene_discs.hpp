/// \file scene_discs.hpp
/// The ten discs, solved exactly, with a live picture of A.
#pragma once

#include "chapters/03_mlcp_formulation/program/cases_from_last.hpp"
#include "chapters/03_mlcp_formulation/program/scene_drawing.hpp"
#include "chapters/03_mlcp_formulation/program/scene_run.hpp"

#include <string>
#include <vector>

namespace rigid {

namespace ten_discs_picture {

using State = RunState<CasesFromLastMethod>;

inline constexpr Style link_style = {Colour::purple, 4, 1};
inline constexpr Style active_style = {Colour::red, 4, 1};
inline constexpr Style idle_style = {Colour::ink, 2.5, 1};

inline const Style& style_of(const State& state, std::size_t row)
{
    return state.is(row, Source::Of::link) ? link_style
           : state.lambda(row) > 0         ? active_style
                                           : idle_style;
}

/// A square for each entry of A that is not zero; the colours show what the rows do.
inline void draw_matrix(Canvas& canvas, const State& state)
{
    const Mlcp& mlcp = state.method.solver.by_matrix.mlcp;
    const Vec2 corner(0.95, 0.42);
    const Real side = 0.92;
    const auto rows =
        static_cast<Real>(std::max<std::size_t>(state.now.rows.size(), 12));
    const Real cell = side / rows;
    canvas.text({0.95, 0.455}, "A: which rows meet", 14, paint::label);
    for (Index i = 0; i < mlcp.size(); ++i) {
        for (SparseMatrix::InnerIterator entry(mlcp.A, i); entry; ++entry) {
            const Colour colours[] = {
                style_of(state, static_cast<std::size_t>(i)).colour,
                style_of(state, static_cast<std::size_t>(entry.col())).colour};
            const auto either = [&](Colour colour) {
                return colours[0] == colour || colours[1] == colour;
            };
            const Style style = {either(Colour::ink)   ? Colour::ink
                                 : either(Colour::red) ? Colour::red
                                                       : Colour::purple,
                                 0, entry.col() == i ? 1 : 0.55, Paint::filled};
            const Vec2 middle =
                corner + cell * Vec2(static_cast<Real>(entry.col()) + 0.5,
                                     -static_cast<Real>(i) - 0.5);
            canvas.box(middle, Vec2::Constant(0.42 * cell), 0, style);
        }
    }
    canvas.box(corner + Vec2(side, -side) / 2, Vec2::Constant(side / 2), 0,
               {Colour::faint, 1, 1});
    const Real y = corner.y() - side - 0.05;
    canvas.text({0.95, y}, "link", 13, {Colour::purple, 1.5, 1});
    canvas.text({1.05, y}, "contact that pushes", 13, {Colour::red, 1.5, 1});
    canvas.text({1.89, y}, "idle contact", 13, {Colour::ink, 1.5, 1}, Align::right);
}

inline void draw(Canvas& canvas, const State& state)
{
    canvas.box({0, 0}, {0.75, 0.5}, 0, paint::wall);
    paint::draw_discs(canvas, state, [&](Index k) {
        const Real inverse_mass = state.scene.bodies.inverse_mass[2 * k];
        return Style{Colour::blue, 1.5, 0.35 + 0.1 / std::sqrt(inverse_mass),
                     Paint::filled};
    });
    paint::draw_links(canvas, state, [](const Link&) { return link_style; });
    for (std::size_t i = 0; i < state.now.sources.size(); ++i) {
        if (!state.is(i, Source::Of::contact)) continue;
        const Contact& contact =
            state.now
                .contacts[static_cast<std::size_t>(state.now.sources[i].index)];
        const Vec2 b = state.scene.bodies.position(contact.b);
        const Vec2 on_b = b - state.scene.radius[contact.b] * contact.normal;
        canvas.segment(on_b - 0.035 * contact.normal, on_b + 0.035 * contact.normal,
                       style_of(state, i));
    }
    paint::draw_gravity(canvas, state);
    draw_matrix(canvas, state);
}

}  // namespace ten_discs_picture

inline Demo ten_discs_scene()
{
    using State = RunState<CasesFromLastMethod>;
    Demo demo;
    demo.name = "ten_discs";
    demo.summary = "Ten discs solved exactly; beside them the matrix A and which "
                   "rows are active";
    set_up_ten_discs(demo);
    demo.view = {{0.58, 0}, {1.4, 0.56}};
    demo.methods = {"schur", "enumerate"};
    demo.tunables = ten_discs_tunables();
    const Measured<State> active = {
        {"active", "", "contacts that push", Plot::linear}, [](const State& s) {
            Real sum = 0;
            for (std::size_t i = 0; i < s.now.sources.size(); ++i)
                sum += s.is(i, Source::Of::contact) && s.lambda(i) > 0;
            return sum;
        }};
    const Measured<State> pairs = {
        {"pairs", "", "pairs of rows that were multiplied for A"},
        [](const State& s) {
            return static_cast<Real>(s.method.solver.by_matrix.scratch.pairs);
        }};
    run_scene<CasesFromLastMethod>(
        demo,
        {columns::contacts().plotted(), active,
         columns::iterations("sets", "sets of cases that were tried")
             .plotted(Plot::logarithmic),
         pairs, columns::residual(), columns::link_error(),
         columns::penetration().plotted(Plot::none), columns::kinetic(),
         columns::energy()},
        [](const Settings&) {
            SceneSetup<CasesFromLastMethod> setup;
            setup.scene = ten_discs();
            setup.pointer = Pointer::steers;
            setup.tune = [](const Settings& settings, State& state) {
                state.method.solver.links_too = settings.method == "enumerate";
            };
            setup.draw = ten_discs_picture::draw;
            return setup;
        });
    return demo;
}

}  // namespace rigid
