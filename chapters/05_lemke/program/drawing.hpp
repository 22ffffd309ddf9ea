/// \file drawing.hpp
/// What this chapter's pictures share: the tableau as a heat map, and the names of its variables.
#pragma once

#include "chapters/04_pgs/program/drawing.hpp"
#include "chapters/05_lemke/lemke.hpp"
#include "common/elementary.hpp"

#include <string>
#include <vector>

namespace rigid::paint {

inline std::string subscript(Index number)
{
    static const char* const digits[] = {"₀", "₁", "₂", "₃", "₄",
                                         "₅", "₆", "₇", "₈", "₉"};
    std::string text;
    for (const char digit : std::to_string(number)) text += digits[digit - '0'];
    return text;
}

inline std::string name_of(const Tableau& tableau, Index variable)
{
    if (variable == tableau.artificial()) return "z₀";
    return variable < tableau.n ? "z" + subscript(variable + 1)
                                : "w" + subscript(variable - tableau.n + 1);
}

inline Colour colour_of(const Tableau& tableau, Index variable)
{
    if (variable == tableau.artificial()) return Colour::red;
    return variable < tableau.n ? Colour::blue : Colour::green;
}

/// The heat map: orange is positive, blue is negative, and each tenfold is a shade. The frame shows the
/// column that enters and the row that leaves next.
inline void heat_map(Canvas& canvas, const Vec2& top_left, Real width,
                     const LemkeWalk& walk)
{
    const Tableau& tableau = walk.tableau;
    const Index n = tableau.n;
    const MatX T = tableau.entries();
    // a gap before the column r
    const Real cell = width / static_cast<Real>(n + 3);
    const auto centre = [&](Index row, Index c) {
        const Real gap = c > n ? 0.5 : 0;
        return Vec2(top_left + cell * Vec2(static_cast<Real>(c) + gap + 0.5,
                                           -static_cast<Real>(row) - 0.5));
    };
    const Real largest = T.leftCols(n + 1).cwiseAbs().maxCoeff();
    const Real largest_value = tableau.values().cwiseAbs().maxCoeff();
    const Vec2 half(0.46 * cell, 0.46 * cell);
    for (Index row = 0; row < n; ++row)
        for (Index c = 0; c < n + 2; ++c) {
            const Real entry = T(row, c), scale = c > n ? largest_value : largest;
            const Real size =
                scale > 0 ? log10(std::max(std::abs(entry) / scale, 1e-4)) / 4 + 1
                          : 0;
            if (size > 0)
                canvas.box(centre(row, c), half, 0,
                           {entry > 0 ? Colour::orange : Colour::blue, 0,
                            (c > n ? 0.35 : 1) * (0.15 + 0.85 * size),
                            Paint::filled});
            else canvas.box(centre(row, c), half, 0, {Colour::faint, 0.5, 0.3});
        }

    const bool words = n <= 16;
    const Real letters = std::clamp(120 * cell, Real{9}, Real{14});
    for (Index row = 0; words && row < n; ++row) {
        const Index variable = tableau.basic[static_cast<std::size_t>(row)];
        canvas.text(centre(row, 0) - Vec2(0.62 * cell, 0.15 * cell),
                    name_of(tableau, variable), letters,
                    {colour_of(tableau, variable), 1, 1}, Align::right);
        if (n <= 8)
            canvas.text(centre(row, n + 1) - Vec2(0, 0.12 * cell),
                        significant(T(row, n + 1), 3), letters - 1, label,
                        Align::centre);
    }
    for (Index c = 0; words && c < n + 2; ++c) {
        const bool value = c == n + 1;
        const Index variable =
            value ? 0 : tableau.nonbasic[static_cast<std::size_t>(c)];
        canvas.text(centre(0, c) + Vec2(0, 0.65 * cell),
                    value ? "r" : name_of(tableau, variable), letters,
                    {value ? Colour::ink : colour_of(tableau, variable), 1, 1},
                    Align::centre);
    }
    if (walk.place != LemkeWalk::Place::on_the_way) return;
    const Index c = tableau.column_of(walk.entering), row = walk.leaving_row();
    const Style frame = {Colour::red, 2, 1};
    const Real middle = static_cast<Real>(n - 1) / 2;
    canvas.box(Vec2(centre(0, c) - Vec2(0, middle * cell)),
               Vec2(0.5 * cell, 0.5 * cell * static_cast<Real>(n)), 0, frame);
    if (row < 0) return;
    const Vec2 from = centre(row, 0), to = centre(row, n + 1);
    canvas.box(Vec2((from + to) / 2),
               Vec2((to.x() - from.x() + cell) / 2, 0.5 * cell), 0, frame);
}

/// One line on where the walk is.
inline std::string told(const LemkeWalk& walk)
{
    const Tableau& tableau = walk.tableau;
    const std::string count =
        std::to_string(walk.pivots) + (walk.pivots == 1 ? " pivot" : " pivots");
    if (walk.place == LemkeWalk::Place::solution)
        return count + ": solved, no z₀ is needed";
    if (walk.place == LemkeWalk::Place::ray)
        return count + ": a ray, nothing stops " + name_of(tableau, walk.entering);
    const Index row = walk.leaving_row();
    return count + ": next enters " + name_of(tableau, walk.entering) +
           (row < 0 ? ", and nothing leaves"
                    : ", leaves " +
                          name_of(tableau,
                                  tableau.basic[static_cast<std::size_t>(row)]));
}

}  // namespace rigid::paint
