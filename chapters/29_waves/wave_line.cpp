// The functions of wave_line.hpp.
#include "chapters/29_waves/wave_line.hpp"

#include "chapters/29_waves/positive.hpp"
#include "common/elementary.hpp"

namespace rigid {
namespace {

void require_intervals(Index intervals)
{
    if (intervals < 2)
        throw std::invalid_argument("the string has " + std::to_string(intervals) +
                                    " intervals; it must have two or more");
}

/// Of what would break a step what can be seen without a look at each mass.
void require_sound(const WaveLine& line)
{
    const bool sound = line.c > 0 && line.c < infinity && line.dx > 0 &&
                       line.dx < infinity && line.intervals() > 1 &&
                       line.v.size() == line.y.size() &&
                       line.damping.size() == line.y.size();
    if (!sound) require_valid(line);
}

/// The end i is not fixed; everything else is no end.
bool moves(const WaveLine& line, Index i)
{
    if (i == 0) return line.left != LineEnd::fixed;
    if (i == line.intervals()) return line.right != LineEnd::fixed;
    return true;
}

/// A sponge, and the damper of an open end: its impedance over half a mass, √(Tρ) / (ρ Δx / 2).
Real damping_of(const WaveLine& line, Index i)
{
    const bool open = (i == 0 && line.left == LineEnd::open) ||
                      (i == line.intervals() && line.right == LineEnd::open);
    return line.damping[i] + (open ? 2 * line.c / line.dx : 0);
}

/// The mass of a point over that of an inner one.
Real weight_of(const WaveLine& line, Index i)
{
    return i == 0 || i == line.intervals() ? 0.5 : 1.0;
}

}  // namespace

WaveLine::WaveLine(Index intervals, Real length, Real speed)
    : c(speed), y(VecX::Zero(std::max<Index>(intervals, 1) + 1)), v(y), damping(y)
{
    require_intervals(intervals);
    require_positive("the length of the string", length, " m");
    require_positive("the speed of its waves", speed, " m/s");
    dx = length / static_cast<Real>(intervals);
}

void require_valid(const WaveLine& line)
{
    require_positive("the distance of neighbours", line.dx, " m");
    require_positive("the speed of its waves", line.c, " m/s");
    if (line.v.size() != line.y.size() || line.damping.size() != line.y.size())
        throw std::invalid_argument(
            "the string has " + std::to_string(line.y.size()) + " places, " +
            std::to_string(line.v.size()) + " velocities and " +
            std::to_string(line.damping.size()) +
            " dampings; they must be as many");
    require_intervals(line.intervals());
    require_finite(line.y, "y");
    require_finite(line.v, "v");
    require_finite(line.damping, "damping");
    for (Index i = 0; i < line.damping.size(); ++i)
        if (line.damping[i] < 0)
            throw std::invalid_argument("damping[" + std::to_string(i) + "] is " +
                                        shortest(line.damping[i]) +
                                        " 1/s; it must be zero or positive");
}

void start_leapfrog(WaveLine& line, Real h)
{
    require_step(h);
    require_valid(line);
    for (Index i = 0; i < line.y.size(); ++i)
        if (moves(line, i)) line.v[i] -= h / 2 * acceleration(line, line.y, i);
}

//! [leapfrog]
void leapfrog(WaveLine& line, Real h)
{
    require_step(h);
    require_sound(line);
    // a rounding above 1 is still the step that is meant
    if (courant_number(line, h) > 1 + 1e-12)
        throw std::invalid_argument(
            "the time step is " + shortest(h) + " s; a wave goes " +
            shortest(courant_number(line, h)) +
            " intervals in it, and leapfrog is stable up to one");
    VecX &y = line.y, &v = line.v;
    const Index N = line.intervals();
    const Real k = line.c * line.c / (line.dx * line.dx);
    const auto push = [&](Index i, Real a, Real damping) {
        const Real s = h * damping / 2;  // on the mean of both velocities
        v[i] = ((1 - s) * v[i] + h * a) / (1 + s);
    };
    for (const Index end : {Index{0}, N})
        if (moves(line, end))
            push(end, acceleration(line, y, end), damping_of(line, end));
    for (Index i = 1; i < N; ++i)
        push(i, k * ((y[i - 1] - y[i]) + (y[i + 1] - y[i])), line.damping[i]);
    for (Index i = 0; i < line.y.size(); ++i)
        if (moves(line, i)) line.y[i] += h * line.v[i];
}
//! [leapfrog]

//! [leapfrog_energy]
Real leapfrog_energy(const WaveLine& line, Real h)
{
    const Index N = line.intervals();
    Real kinetic = 0, potential = 0;
    for (Index i = 0; i <= N; ++i)
        kinetic += weight_of(line, i) * line.v[i] * line.v[i];
    for (Index i = 0; i < N; ++i) {
        const Real stretch = line.y[i + 1] - line.y[i];
        const Real before = stretch - h * (line.v[i + 1] - line.v[i]);
        potential += before * stretch;
    }
    return line.dx * kinetic / 2 + line.c * line.c / line.dx * potential / 2;
}
//! [leapfrog_energy]

Real wave_energy(const WaveLine& line)
{
    Real kinetic = 0, potential = 0;
    for (Index i = 0; i < line.y.size(); ++i)
        kinetic += weight_of(line, i) * line.v[i] * line.v[i];
    for (Index i = 0; i < line.intervals(); ++i) {
        const Real stretch = line.y[i + 1] - line.y[i];
        potential += stretch * stretch;
    }
    return line.dx * kinetic / 2 + line.c * line.c / line.dx * potential / 2;
}

//! [theta]
void theta_step(WaveLine& line, Real h, Real theta, ThetaMemory& memory)
{
    require_step(h);
    require_sound(line);
    if (!(theta >= 0.5 && theta <= 1))
        throw std::invalid_argument("theta is " + shortest(theta) +
                                    "; it must be from 1/2 to 1");
    const Index N = line.intervals();
    const Real k = line.c * line.c / (line.dx * line.dx);
    const Real coupling = h * theta * h * theta * k;
    memory.diagonal.resize(N + 1);
    memory.right.resize(N + 1);
    // (1 + hθs − h²θ²L) d = h (L (y + θ h v) − s v),   v' = v + d,   y' = y + h (v + θ d)
    const auto ahead = [&](Index i) { return line.y[i] + theta * h * line.v[i]; };
    const auto pull = [&](Index i) {
        if (i == 0) return 2 * k * (ahead(1) - ahead(0));
        if (i == N) return 2 * k * (ahead(N - 1) - ahead(N));
        return k * ((ahead(i - 1) - ahead(i)) + (ahead(i + 1) - ahead(i)));
    };
    for (Index i = 0; i <= N; ++i) {
        const bool free = moves(line, i);
        const Real s = damping_of(line, i);
        memory.diagonal[i] = free ? 1 + h * theta * s + 2 * coupling : 1;
        memory.right[i] = free ? h * (pull(i) - s * line.v[i]) : 0;
    }
    // Gauss: below row i stands −coupling, −2 coupling at a free end, 0 at a fixed one
    const auto above = [&](Index i) {  // entry (i, i+1)
        if (!moves(line, i)) return 0.0;
        return i == 0 ? -2 * coupling : -coupling;
    };
    const auto below = [&](Index i) {  // entry (i, i−1)
        if (!moves(line, i)) return 0.0;
        return i == N ? -2 * coupling : -coupling;
    };
    for (Index i = 1; i <= N; ++i) {
        const Real part = below(i) / memory.diagonal[i - 1];
        memory.diagonal[i] -= part * above(i - 1);
        memory.right[i] -= part * memory.right[i - 1];
    }
    for (Index i = N; i >= 0; --i) {
        Real d = memory.right[i];
        if (i < N) d -= above(i) * memory.right[i + 1];
        memory.right[i] = d / memory.diagonal[i];
    }
    for (Index i = 0; i <= N; ++i) {
        line.y[i] += h * (line.v[i] + theta * memory.right[i]);
        line.v[i] += memory.right[i];
    }
}
//! [theta]

void add_sponge(WaveLine& line, Index points, Real most, bool at_left,
                bool at_right)
{
    if (points < 1 || points > line.intervals())
        throw std::invalid_argument("the sponge has " + std::to_string(points) +
                                    " points; it must be 1 to " +
                                    std::to_string(line.intervals()));
    if (!(most >= 0) || !std::isfinite(most))
        throw std::invalid_argument("the damping of the sponge is " +
                                    shortest(most) +
                                    " 1/s; it must be zero or positive and finite");
    for (Index i = 0; i < points; ++i) {
        const Real in = static_cast<Real>(points - i) / static_cast<Real>(points);
        if (at_left) line.damping[i] += most * in * in;
        if (at_right) line.damping[line.intervals() - i] += most * in * in;
    }
}

}  // namespace rigid
