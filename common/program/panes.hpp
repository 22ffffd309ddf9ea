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
/// each other than above.
/// \param label  height of the line above each picture
std::vector<Rectangle> pane_grid(const Rectangle& area, std::size_t count, const View& view, Real label,
                                 Real gap);

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
