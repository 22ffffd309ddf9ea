/// \file web_show.hpp
/// What a page shows of a program: panes, plots and the hand over them, as data. Knows no browser, so the tests run it
/// without one; web_program.cpp hands it to the page.
///
/// Sizes and places are in the page's own pixels.
#pragma once

#include "common/draw_list.hpp"
#include "common/program/panel_rows.hpp"
#include "common/program/panes.hpp"

#include <vector>

namespace rigid {

class WebShow {
public:
    /// Throws std::invalid_argument if the scene refuses the options.
    WebShow(const Program& program, const Options& options) : show_(program, options) {}

    Show& show() { return show_; }

    /// The height that the panes fill at this width, if they may have at most `most`.
    Real height(Real width, Real most) const;
    /// The panes. The hand then is over these.
    const DrawList& picture(Real width, Real height);
    /// The plot of a column.
    const DrawList& plot(std::size_t column, Real width, Real height, bool whole_run);

    /// Where the pointer is. A seeded path that steers ends when the reader's hand comes.
    void point(const Vec2& where, bool present, bool down);
    bool pressed() const { return hand_.input().pressed; }
    void advance(Real seconds);
    void single_step() { show_.single_step(hand_.input()); }

private:
    void pane(const Rectangle& place, const Pane& pane, const Track& track, std::size_t i, bool several);

    Show show_;
    Hand hand_;
    std::vector<Projection> projections_;
    DrawList list_;
};

/// The seed that a page gives as a number. Throws std::invalid_argument unless it is whole and from 0 to 2⁵³, as far as
/// doubles know each number.
std::uint64_t seed_of(Real number);

/// What a run without a window measures (--headless --csv): for each step and method the step, the time and the columns.
std::vector<Real> rows_of_run(const Demo& scene, const Settings& settings,
                              const std::vector<std::string>& methods, long steps);

}  // namespace rigid
