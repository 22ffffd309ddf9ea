#include "common/program/panes.hpp"

#include <algorithm>

namespace rigid {

std::vector<Rectangle> pane_grid(const Rectangle& area, std::size_t count, const View& view, Real label,
                                 Real gap)
{
    constexpr Real smallest = 4;  // [pixels]
    std::vector<Rectangle> best;
    Real best_scale = -1;
    for (std::size_t columns = 1; columns <= count; ++columns) {
        const std::size_t rows = (count + columns - 1) / columns;
        const Real c = static_cast<Real>(columns), r = static_cast<Real>(rows);
        // Of a minimised window nothing is left, and still each pane has its place.
        const Real width = std::max((area.width - (c - 1) * gap) / c, smallest);
        const Real height = std::max((area.height - (r - 1) * gap) / r, label + smallest);
        const Real scale = std::min(width / view.half_size.x(), (height - label) / view.half_size.y());
        if (scale <= 0.75 * best_scale) continue;
        best_scale = std::max(best_scale, scale);
        best.clear();
        for (std::size_t i = 0; i < count; ++i)
            best.push_back({area.x + static_cast<Real>(i % columns) * (width + gap),
                            area.y + static_cast<Real>(i / columns) * (height + gap), width, height});
    }
    return best;
}

void Zoom::by(Real factor, const Vec2& held, const View& view)
{
    const Real after = std::clamp(factor_ * factor, farthest, closest);
    const Vec2 from_centre = held - (view.centre + moved_);
    moved_ += (1 - factor_ / after) * from_centre;
    factor_ = after;
}

void Hand::read(const std::vector<Projection>& panes, const Vec2& mouse, bool down, bool elsewhere)
{
    const bool clicked = down && !was_down_;
    was_down_ = down;
    if (!down) pulled_.reset();
    input_.present = input_.pressed = false;
    if ((!pulled_ && elsewhere) || !mouse.allFinite()) return;
    for (std::size_t i = 0; i < panes.size(); ++i) {
        if (pulled_ ? *pulled_ != i : !panes[i].area.contains(mouse)) continue;
        if (clicked) pulled_ = i;
        const View& view = panes[i].view;
        const Rectangle& area = panes[i].area;
        const Vec2 half(area.width / 2 / panes[i].scale, area.height / 2 / panes[i].scale);
        input_.pointer = panes[i].to_world(mouse).cwiseMax(view.centre - half).cwiseMin(view.centre + half);
        input_.present = true;
        input_.pressed = pulled_.has_value();
        pane_ = i;
        return;
    }
}

std::optional<Vec2> Hand::mark(const Show& show, std::size_t pane) const
{
    if (!show.playback()) return std::nullopt;
    if (show.scene().steered && show.is_scripted() && !input_.pressed)
        return ScriptedPointer(show.settings().seed, show.scene().view).at(show.playback()->time());
    if (input_.pressed || (show.scene().steered && input_.present && pane_ != pane)) return input_.pointer;
    return std::nullopt;
}

}  // namespace rigid
