// The functions of membrane.hpp.
#include "chapters/29_waves/membrane.hpp"

#include "chapters/29_waves/positive.hpp"

#include <algorithm>

namespace rigid {
namespace {

/// y_left + y_right + y_below + y_above − 4 y of row j into a visit(i, that); beyond a free edge is the mirror.
template <class Visit>
void for_each_pull(const Membrane& m, Index j, const Visit& visit)
{
    const Index edge = m.fixed_edges ? 1 : 0, last = m.nx;
    const Real* row = m.y.data() + m.at(0, j);
    const Real* below = m.y.data() + m.at(0, j == 0 ? 1 : j - 1);
    const Real* above = m.y.data() + m.at(0, j == m.ny ? m.ny - 1 : j + 1);
    const auto across = [&](Index i) {
        return (below[i] - row[i]) + (above[i] - row[i]);
    };
    if (edge == 0) visit(0, 2 * (row[1] - row[0]) + across(0));
    for (Index i = 1; i < last; ++i)
        visit(i, (row[i - 1] - row[i]) + (row[i + 1] - row[i]) + across(i));
    if (edge == 0) visit(last, 2 * (row[last - 1] - row[last]) + across(last));
}

void require_intervals(const Membrane& m)
{
    if (m.nx < 2 || m.ny < 2)
        throw std::invalid_argument(
            "the membrane has " + std::to_string(m.nx) + " by " +
            std::to_string(m.ny) + " intervals; it must have two or more each way");
}

Real stiffness(const Membrane& m) { return m.c * m.c / (m.dx * m.dx); }

}  // namespace

Membrane::Membrane(Index nx_, Index ny_, Real interval, Real speed, bool fixed)
    : nx(nx_), ny(ny_), dx(interval), c(speed), fixed_edges(fixed)
{
    require_intervals(*this);
    y = v = VecX::Zero((nx + 1) * (ny + 1));
    require_valid(*this);
}

void require_valid(const Membrane& m)
{
    require_intervals(m);
    require_positive("the interval of the membrane", m.dx, " m");
    require_positive("the wave speed of the membrane", m.c, " m/s");
    if (!(m.damping >= 0) || !std::isfinite(m.damping))
        throw std::invalid_argument("the damping of the membrane is " +
                                    shortest(m.damping) +
                                    " 1/s; it must be zero or positive and finite");
    const Index points = (m.nx + 1) * (m.ny + 1);
    if (m.y.size() != points || m.v.size() != points)
        throw std::invalid_argument("the membrane has " + std::to_string(points) +
                                    " points, " + std::to_string(m.y.size()) +
                                    " places and " + std::to_string(m.v.size()) +
                                    " velocities; they must be as many");
    require_finite(m.y, "y");
    require_finite(m.v, "v");
}

void start_leapfrog(Membrane& m, Real h)
{
    require_step(h);
    require_valid(m);
    const Index edge = m.fixed_edges ? 1 : 0;
    for (Index j = edge; j <= m.ny - edge; ++j) {
        Real* v = m.v.data() + m.at(0, j);
        const Real gain = h / 2 * stiffness(m);
        for_each_pull(m, j, [&](Index i, Real pull) { v[i] -= gain * pull; });
    }
}

//! [membrane_step]
void leapfrog(Membrane& m, Real h)
{
    require_step(h);
    const Index points = (m.nx + 1) * (m.ny + 1);
    if (!(m.nx > 1 && m.ny > 1 && m.c > 0 && m.dx > 0 && m.damping >= 0 &&
          m.damping < infinity && m.y.size() == points && m.v.size() == points))
        require_valid(m);
    const Real C = m.c * h / m.dx;
    if (2 * C * C > 1 + 1e-12)
        throw std::invalid_argument(
            "the time step is " + shortest(h) + " s; a wave goes " + shortest(C) +
            " intervals in it, and on a grid leapfrog is stable up to 1/sqrt(2)");
    const Index edge = m.fixed_edges ? 1 : 0;
    const Real s = h * m.damping / 2;
    const Real kept = (1 - s) / (1 + s), gain = h * stiffness(m) / (1 + s);
    const auto move = [&](Index j) {
        Real *y = m.y.data() + m.at(0, j), *v = m.v.data() + m.at(0, j);
        for (Index i = edge; i <= m.nx - edge; ++i) y[i] += h * v[i];
    };
    for (Index j = edge; j <= m.ny - edge; ++j) {
        Real* v = m.v.data() + m.at(0, j);
        for_each_pull(
            m, j, [=](Index i, Real pull) { v[i] = kept * v[i] + gain * pull; });
        if (j > edge) move(j - 1);  // its old places are not needed any more
    }
    move(m.ny - edge);
}
//! [membrane_step]

Real leapfrog_energy(const Membrane& m, Real h)
{
    const auto half = [](Index i, Index last) {
        return i == 0 || i == last ? 0.5 : 1.0;
    };
    Real kinetic = 0, potential = 0;
    const auto link = [&](Index a, Index b, Real weight) {
        const Real stretch = m.y[b] - m.y[a];
        potential += weight * stretch * (stretch - h * (m.v[b] - m.v[a]));
    };
    for (Index j = 0; j <= m.ny; ++j)
        for (Index i = 0; i <= m.nx; ++i) {
            const Index k = m.at(i, j);
            kinetic += half(i, m.nx) * half(j, m.ny) * m.v[k] * m.v[k];
            if (i < m.nx) link(k, m.at(i + 1, j), half(j, m.ny));
            if (j < m.ny) link(k, m.at(i, j + 1), half(i, m.nx));
        }
    return (m.dx * m.dx * kinetic + m.c * m.c * potential) / 2;
}

void touch(Membrane& m, Real x, Real y, Real radius, Real depth)
{
    if (!(radius > 0) || !std::isfinite(radius) || !std::isfinite(depth) ||
        !std::isfinite(x) || !std::isfinite(y))
        throw std::invalid_argument(
            "a touch at (" + shortest(x) + ", " + shortest(y) +
            ") m has the radius " + shortest(radius) + " m and the depth " +
            shortest(depth) + " m; they must be finite, the radius positive");
    const Index edge = m.fixed_edges ? 1 : 0;
    Real taken = 0, weights = 0;
    for (Index j = edge; j <= m.ny - edge; ++j)
        for (Index i = edge; i <= m.nx - edge; ++i) {
            const Real a = static_cast<Real>(i) * m.dx - x,
                       b = static_cast<Real>(j) * m.dx - y,
                       near = 1 - (a * a + b * b) / (radius * radius);
            const Real weight = (i == 0 || i == m.nx ? 0.5 : 1.0) *
                                (j == 0 || j == m.ny ? 0.5 : 1.0);
            weights += weight;
            if (near <= 0) continue;
            m.y[m.at(i, j)] -= depth * near * near;
            taken += weight * depth * near * near;
        }
    if (!m.fixed_edges) m.y.array() += taken / weights;
}

}  // namespace rigid
