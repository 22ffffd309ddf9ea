/// \file drawing.hpp
/// What this chapter's pictures share beside the pieces of chapter 3: a chart with a logarithmic axis.
#pragma once

#include "chapters/03_mlcp_formulation/program/scene_drawing.hpp"
#include "common/elementary.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace rigid::paint {

inline constexpr Style error = {Colour::blue, 2, 1};
inline constexpr Style residual = {Colour::orange, 2, 1};

/// A chart of positive numbers against sweeps 0 … last, on decades low … high, in a box of the picture.
class LogChart {
public:
    LogChart(Canvas& canvas, const Vec2& corner, const Vec2& size, int low,
             int high, Real last)
        : canvas_(canvas), corner_(corner), size_(size), low_(low), high_(high),
          last_(std::max(last, Real{1}))
    {
        for (int decade = low; decade <= high; ++decade) {
            const Real y = at(0, pow(10.0, decade)).y();
            canvas_.segment({corner.x(), y}, {corner.x() + size.x(), y},
                            decade == low ? axis : grid);
            if ((decade - low) % 3 == 0)
                canvas_.text({corner.x() - 0.02, y - 0.012}, "10" + raised(decade),
                             13, label, Align::right);
        }
        canvas_.segment(corner, corner + Vec2(0, size.y()), axis);
        const Real step = std::max(Real{1}, pow(10.0, std::floor(log10(last_))) /
                                                (last_ < 20 ? 2 : 1));
        for (Real k = 0; k <= last_;
             k += std::floor(step) * (last_ / step > 5 ? 2 : 1)) {
            const Vec2 tick(at(k, 1).x(), corner.y());
            canvas_.segment(tick, tick - Vec2(0, 0.012), axis);
            canvas_.text(tick - Vec2(0, 0.055), fixed(k, 0), 13, label,
                         Align::centre);
        }
    }

    Vec2 at(Real sweep, Real value) const
    {
        const Real decade = std::clamp(log10(std::max(value, Real{1e-300})),
                                       Real(low_), Real(high_));
        return corner_ + Vec2(size_.x() * sweep / last_,
                              size_.y() * (decade - low_) / (high_ - low_));
    }

    /// values[k] after k sweeps, as dots.
    void dots(const std::vector<Real>& values, Style style)
    {
        style.paint = Paint::filled;
        const std::size_t every = std::max<std::size_t>(1, values.size() / 40);
        for (std::size_t k = 0; k < values.size(); k += every)
            if (inside(values[k]))
                canvas_.disc(at(static_cast<Real>(k), values[k]), 0.009, style);
    }
    /// A straight line from the first value, at 0 sweeps, to the second, at `last`.
    void line(const std::array<Real, 2>& ends, Real last, const Style& style)
    {
        const Real bottom = pow(10.0, low_);
        Real end = last;  // where it leaves the chart
        if (ends[1] < bottom)
            end = last * log(ends[0] / bottom) / log(ends[0] / ends[1]);
        canvas_.polyline({at(0, ends[0]), at(end, std::max(ends[1], bottom))},
                         style);
    }

private:
    bool inside(Real value) const
    {
        return std::isfinite(value) && log10(value) >= low_;
    }
    static std::string raised(int exponent)
    {
        static const char* const digits[] = {"⁰", "¹", "²", "³", "⁴",
                                             "⁵", "⁶", "⁷", "⁸", "⁹"};
        std::string text = exponent < 0 ? "⁻" : "";
        for (const char digit : std::to_string(std::abs(exponent)))
            text += digits[digit - '0'];
        return text;
    }

    Canvas& canvas_;
    Vec2 corner_, size_;
    int low_, high_;
    Real last_;
};

}  // namespace rigid::paint
