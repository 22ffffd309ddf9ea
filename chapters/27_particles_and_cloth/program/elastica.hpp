/// \file elastica.hpp
/// A strip of unit length and EI = 1 that is clamped level and does not stretch, under its own weight or a load at its end: the
/// curve that strips of squares are held to. Solved by shooting, as accurate as its steps are fine.
///
///     θ'' = −q(s) cos θ,   θ(0) = 0,   θ'(1) = 0,   q = Γ (1 − s) or the load;   x' = cos θ,   y' = sin θ
#pragma once

#include "common/elementary.hpp"
#include "common/math.hpp"

#include <vector>

namespace rigid {

struct Elastica {
    /// Points of it from the wall to its end: how far out, how far down [m].
    std::vector<Vec2> points;

    const Vec2& tip() const { return points.back(); }
    /// How far its end hangs below the wall over how far it reaches out.
    Real height_over_width() const { return tip().y() / tip().x(); }
};

/// \param load  Γ = q L³/EI of the weight, or P L²/EI of the load at its end; positive
/// \param steps  of the classical Runge-Kutta method: the error falls with their fourth power
inline Elastica elastica(Real load, bool at_the_end, int steps = 400)
{
    struct State {
        Real theta, curvature, x, y;
    };
    const Real h = Real(1) / steps;
    const auto derivative = [=](Real s, const State& at) -> State {
        const Real c = cos(at.theta);
        return {at.curvature, -(at_the_end ? load : load * (1 - s)) * c, c,
                sin(at.theta)};
    };
    const auto along = [](const State& at, Real part, const State& by) -> State {
        return {at.theta + part * by.theta, at.curvature + part * by.curvature,
                at.x + part * by.x, at.y + part * by.y};
    };
    Elastica found;
    const auto shoot = [&](Real curvature) {
        State at{0, curvature, 0, 0};
        found.points.assign(1, Vec2(0, 0));
        for (int i = 0; i < steps; ++i) {
            const Real s = i * h;
            const State a = derivative(s, at),
                        b = derivative(s + h / 2, along(at, h / 2, a)),
                        c = derivative(s + h / 2, along(at, h / 2, b)),
                        d = derivative(s + h, along(at, h, c));
            at = along(along(along(along(at, h / 6, a), h / 3, b), h / 3, c), h / 6,
                       d);
            found.points.emplace_back(at.x, at.y);
        }
        return at.curvature;
    };
    // at the wall it is bent by less than the moment of a load at a straight strip
    Real low = 0, high = at_the_end ? load : load / 2;
    for (int i = 0; i < 60; ++i) {
        const Real middle = (low + high) / 2;
        (shoot(middle) < 0 ? low : high) = middle;
    }
    shoot(low);
    return found;
}

}  // namespace rigid
