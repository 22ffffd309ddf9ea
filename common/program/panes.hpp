/// \file panes.hpp
/// Panes side by side on a screen, and the reader's hand over them: the same in the window and in a page.
#pragma once

#include "common/picture.hpp"
#include "common/program/show.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace rigid {

/// Splits an area into a grid of panes of one view: nearly as large as they can be, rather beside
/// each other than above. There are `count` of them, with some pixels of picture each, however small the area is.
/// \param label  height of the line above each picture
std::vector<Rectangle> pane_grid(const Rectangle& area, std::size_t count, const View& view, Real label,
                                 Real gap);

/// How much closer the reader looks than the scene's view, and where: the same for all panes.
class Zoom {
public:
    static constexpr Real closest = 1000, farthest = 0.1;

    /// What a pane shows instead of its view.
    View of(const View& view) const { return {view.centre + moved_, view.half_size / factor_}; }
    Real factor() const { return factor_; }
    bool is_off() const { return factor_ == 1 && moved_ == Vec2(0, 0); }

    /// Closer (factor > 1) or farther, between `farthest` and `closest`.
    /// \param held  the point of the world that stays where it is on the screen [m]
    void by(Real factor, const Vec2& held, const View& view);
    /// The picture follows the hand. \param way  of the hand, in the world [m]
    void drag(const Vec2& way) { moved_ -= way; }
    void reset() { *this = {}; }

private:
    Real factor_ = 1;
    Vec2 moved_ = {0, 0};  ///< from the centre of the view [m]
};

/// Where the pointer is in the world of the pane under it. A pull goes on when it leaves the pane.
class Hand {
public:
    /// \param mouse      [pixels of the projections]
    /// \param down       the button is held
    /// \param elsewhere  the pointer is over something else, such as the panel
    void read(const std::vector<Projection>& panes, const Vec2& mouse, bool down, bool elsewhere);

    const Input& input() const { return input_; }

    /// Where a ring stands for the hand in a pane: where the seeded path is, where a pull goes to, and in each pane
    /// where another one's pointer steers.
    std::optional<Vec2> mark(const Show& show, std::size_t pane) const;

private:
    Input input_;
    std::size_t pane_ = 0;
    std::optional<std::size_t> pulled_;
    bool was_down_ = false;
};

}  // namespace rigid
