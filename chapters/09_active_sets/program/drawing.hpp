/// \file drawing.hpp
/// What this chapter's pictures share: the mark of a row.
#pragma once

#include "chapters/04_pgs/program/drawing.hpp"

namespace rigid::paint {

inline constexpr Style active = {Colour::red, 1.5, 1, Paint::filled};
inline constexpr Style open = {Colour::ink, 1.5, 1};
inline constexpr Style wrong_guess = {Colour::orange, 3, 1};

/// A dot for a row that the guess holds at w = 0, an empty ring for one that rests at its bound; a second ring
/// around what contradicts the guess and will change.
inline void row_mark(Canvas& canvas, const Vec2& p, Real radius, bool is_active,
                     bool is_wrong)
{
    canvas.disc(p, radius, is_active ? active : open);
    if (is_wrong) canvas.disc(p, 1.9 * radius, wrong_guess);
}

}  // namespace rigid::paint
