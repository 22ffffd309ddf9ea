/// \file kept_motion.hpp
/// A motion as a list of frames, of any engine, and what can be read of it that has to be kept.
///
///     kept = f(motion of the engine),    error = |kept − f(right motion)|
///
/// The same f for every engine, on poses and velocities in doubles, as the engine gives them to its user. Between two frames a
/// largest value is that of the parabola through three of them: of a free fall without an error.
#pragma once

#include "chapters/19_engine/world.hpp"
#include "common/elementary.hpp"
#include "tests/peers/poses.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

namespace rigid::kept {

inline constexpr Real frame = 1.0 / 60;  ///< of all engines [s]

struct Motion {
    World start;
    std::vector<Poses> x, u;  ///< of each frame, the start first
};

/// What is read of a motion.
using Read = std::function<Real(const Motion&)>;

/// One number of each frame: of the motion, and the frame.
using Number = std::function<Real(const Motion&, std::size_t)>;

/// Kinetic and potential energy of what can move [J].
inline Real energy(const Motion& m, std::size_t n)
{
    Real sum = 0;
    const std::vector<BodyId> ids = m.start.bodies();
    for (std::size_t k = 0; k < ids.size(); ++k) {
        const Real mass = m.start.mass(ids[k]);
        if (!(mass < infinity)) continue;
        const Vec<3>&x = m.x[n][k], &u = m.u[n][k];
        sum += mass * (u.head<2>().squaredNorm() / 2 -
                       m.start.settings().gravity.dot(x.head<2>())) +
               m.start.inertia(ids[k]) * u[2] * u[2] / 2;
    }
    return sum;
}

/// The mean energy of the last second above the lowest that is possible, as a part of that at the start.
inline Read energy_kept(Real lowest)
{
    return [=](const Motion& m) {
        const std::size_t last = m.x.size(), count = 60;
        Real sum = 0;
        for (std::size_t n = last - count; n < last; ++n) sum += energy(m, n);
        return (sum / count - lowest) / (energy(m, 0) - lowest);
    };
}

/// Whether a frame is a local maximum, and how large it is.
inline std::optional<Real> peak(const Motion& m, const Number& number,
                                std::size_t n)
{
    if (n == 0 || n + 1 >= m.x.size()) return {};
    const Real a = number(m, n - 1), b = number(m, n), c = number(m, n + 1);
    if (!(a < b && b >= c)) return {};
    return b - (c - a) * (c - a) / (8 * (a - 2 * b + c));
}

/// The largest local maximum in the frames from a time on; 0 if there is none.
inline Read largest(Number number, Real from)
{
    return [=](const Motion& m) {
        Real most = 0;
        for (auto n = static_cast<std::size_t>(from / frame); n < m.x.size(); ++n)
            most = std::max(most, peak(m, number, n).value_or(0));
        return most;
    };
}

/// The local maximum with a number from 1 on; 0 if there are not as many.
inline Read the_peak(Number number, int wanted)
{
    return [=](const Motion& m) {
        int found = 0;
        for (std::size_t n = 0; n < m.x.size(); ++n)
            if (const auto at = peak(m, number, n))
                if (++found == wanted) return *at;
        return Real{0};
    };
}

/// The number in the last frame.
inline Read at_end(Number number)
{
    return [=](const Motion& m) { return number(m, m.x.size() - 1); };
}

/// Of all frames the number that is farthest from a right one.
inline Read farthest_from(Number number, Real right)
{
    return [=](const Motion& m) {
        Real worst = right;
        for (std::size_t n = 0; n < m.x.size(); ++n)
            if (std::abs(number(m, n) - right) > std::abs(worst - right))
                worst = number(m, n);
        return worst;
    };
}

// ---- numbers of a frame --------------------------------------------------------------
/// The angle at which a body is seen from the origin, from straight down [rad].
inline Number angle_of(std::size_t k)
{
    return [=](const Motion& m, std::size_t n) {
        return rigid::atan2(m.x[n][k].x(), -m.x[n][k].y());
    };
}
inline Number swing_of(std::size_t k)
{
    return [angle = angle_of(k)](const Motion& m, std::size_t n) {
        return std::abs(angle(m, n));
    };
}
inline Number height_of(std::size_t k, Real above)
{
    return [=](const Motion& m, std::size_t n) { return m.x[n][k].y() - above; };
}
inline Number distance_of(std::size_t k)
{
    return
        [=](const Motion& m, std::size_t n) { return m.x[n][k].head<2>().norm(); };
}
inline Number speed_of(std::size_t k)
{
    return
        [=](const Motion& m, std::size_t n) { return m.u[n][k].head<2>().norm(); };
}
inline Number spin_of(std::size_t k)
{
    return [=](const Motion& m, std::size_t n) { return m.u[n][k][2]; };
}
/// How far a body has gone to the right, in the axes of another one or of the world [m]
inline Number way_of(std::size_t k, std::optional<std::size_t> seen_from = {})
{
    return [=](const Motion& m, std::size_t n) {
        const Real own = m.x[n][k].x() - m.x[0][k].x();
        return seen_from ? own - (m.x[n][*seen_from].x() - m.x[0][*seen_from].x())
                         : own;
    };
}

}  // namespace rigid::kept
