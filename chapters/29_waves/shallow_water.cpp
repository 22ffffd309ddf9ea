// The functions of shallow_water.hpp.
#include "chapters/29_waves/shallow_water.hpp"

#include <algorithm>

namespace rigid {
namespace {

/// Below it there is no water that could have a velocity: a face of less is at rest [m].
constexpr Real dry = 1e-12;

Real mean_depth(const ShallowWater& water, Index face)
{
    return (water.depth[face - 1] + water.depth[face]) / 2;
}

Real outwards(Real u) { return u > 0 ? u : 0; }

/// What a flow carries at the velocity of the face it comes from.
Real carried_by(Real flow, Real left, Real right)
{
    return flow * (flow >= 0 ? left : right);
}

}  // namespace

ShallowWater::ShallowWater(Index cells, Real length, Real still_depth)
{
    if (cells < 2)
        throw std::invalid_argument("the water has " + std::to_string(cells) +
                                    " cells; it must have two or more");
    if (!(length > 0) || !std::isfinite(length))
        throw std::invalid_argument(
            "the water is " + shortest(length) +
            " m long; its length must be positive and finite");
    if (!(still_depth >= 0) || !std::isfinite(still_depth))
        throw std::invalid_argument("the depth of the water is " +
                                    shortest(still_depth) +
                                    " m; it must be zero or positive and finite");
    dx = length / static_cast<Real>(cells);
    bed = VecX::Zero(cells);
    depth = level = VecX::Constant(cells, still_depth);
    u = damping = carried = flux = VecX::Zero(cells + 1);
    giving = VecX::Zero(cells);
    part = VecX::Ones(cells + 1);
}

Index ShallowWater::cell_at(Real x) const
{
    const Real i = std::floor((x - origin) / dx);
    return static_cast<Index>(
        std::clamp(i, Real{0}, static_cast<Real>(cells() - 1)));
}

void require_valid(const ShallowWater& water)
{
    const auto positive = [](const char* name, Real value, const char* unit) {
        if (!(value > 0) || !std::isfinite(value))
            throw std::invalid_argument(std::string(name) + " is " +
                                        shortest(value) + unit +
                                        "; it must be positive and finite");
    };
    positive("the width of a cell", water.dx, " m");
    positive("gravity", water.g, " m/s²");
    positive("the density of the water", water.density, " kg/m²");
    const Index n = water.cells();
    const auto sized = [n](const VecX& v, Index wanted, const char* name) {
        if (v.size() != wanted)
            throw std::invalid_argument(std::string(name) + " has " +
                                        std::to_string(v.size()) +
                                        " entries; water of " + std::to_string(n) +
                                        " cells needs " + std::to_string(wanted));
        require_finite(v, name);
    };
    sized(water.bed, n, "bed");
    sized(water.depth, n, "depth");
    sized(water.level, n, "level");
    sized(water.u, n + 1, "u");
    sized(water.damping, n + 1, "damping");
    sized(water.part, n + 1, "part");
    for (Index i = 0; i < n; ++i)
        if (water.depth[i] < 0)
            throw std::invalid_argument("depth[" + std::to_string(i) + "] is " +
                                        shortest(water.depth[i]) +
                                        " m; it must be zero or positive");
    for (Index i = 0; i <= n; ++i)
        if (water.damping[i] < 0)
            throw std::invalid_argument("damping[" + std::to_string(i) + "] is " +
                                        shortest(water.damping[i]) +
                                        " 1/s; it must be zero or positive");
}

Real volume(const ShallowWater& water)
{
    Real sum = 0;
    for (Index i = 0; i < water.cells(); ++i) sum += water.depth[i];
    return sum * water.dx;
}

Real momentum(const ShallowWater& water)
{
    Real sum = 0;
    for (Index f = 1; f < water.cells(); ++f)
        sum += mean_depth(water, f) * water.u[f];
    return water.density * sum * water.dx;
}

Real energy(const ShallowWater& water)
{
    Real kinetic = 0, potential = 0;
    for (Index f = 1; f < water.cells(); ++f)
        kinetic += mean_depth(water, f) * water.u[f] * water.u[f];
    for (Index i = 0; i < water.cells(); ++i)
        potential += water.depth[i] * (water.depth[i] + 2 * water.bed[i]);
    return water.density * water.dx * (kinetic + water.g * potential) / 2;
}

Real stable_step(const ShallowWater& water)
{
    const Index n = water.cells();
    const auto u = water.u.array().abs();
    const auto fastest =
        u.head(n).max(u.tail(n)) + (water.g * water.depth.array()).sqrt();
    return water.dx / fastest.maxCoeff();
}

// In the loops of a step each entry has one result and no branch, so that a compiler
// makes lanes of them; the bits are the same with lanes of any width. What is divided
// by infinity is zero: at a face without water nothing moves.

//! [push]
void push_water(ShallowWater& water, Real h)
{
    const Real slope_to_speed = h * water.g / water.dx;
    const Real *bed = water.bed.data(), *depth = water.depth.data(),
               *level = water.level.data(), *part = water.part.data(),
               *damping = water.damping.data();
    Real* __restrict u = water.u.data();
    for (Index r = 1; r < water.cells(); ++r) {  // of the face left of cell r
        const Index l = r - 1;
        const Real pushed =
            u[r] - slope_to_speed * part[r] * (level[r] - level[l]);  // (29.11)
        Real held = 1 + h * damping[r];
        // water on one side, and on the other a dry bed that is higher: a shore
        held = ((depth[r] <= dry) & (bed[r] >= level[l])) ? infinity : held;
        held = ((depth[l] <= dry) & (bed[l] >= level[r])) ? infinity : held;
        held = (depth[l] + depth[r]) / 2 > dry ? held : infinity;
        u[r] = pushed / held;
    }
}
//! [push]

//! [carry]
void carry_water(ShallowWater& water, Real h)
{
    const Index n = water.cells();
    const Real lambda = h / water.dx;
    Real *__restrict r = water.depth.data(), *__restrict u = water.u.data(),
                     *__restrict q = water.flux.data(),
                     *__restrict P = water.carried.data(),
                     *__restrict give = water.giving.data();
    // how deep the water is that leaves a cell: none gives more than it has
    for (Index i = 0; i < n; ++i) {
        const Real parting = lambda * (outwards(u[i + 1]) + outwards(-u[i]));
        give[i] = parting > 1 ? parting : 1;
    }
    for (Index i = 0; i < n; ++i) give[i] = r[i] / give[i];
    // through a wall that moves, water of the depth beside it comes or goes
    q[0] = u[0] * give[0];
    for (Index f = 1; f < n; ++f) q[f] = u[f] * (u[f] >= 0 ? give[f - 1] : give[f]);
    q[n] = u[n] * give[n - 1];
    // (29.13): momentum goes with the water, at the speed of where it comes from
    Real* __restrict middle = give;  // whose depths are used by now
    for (Index i = 0; i < n; ++i)
        middle[i] = carried_by((q[i] + q[i + 1]) / 2, u[i], u[i + 1]);
    for (Index f = 1; f < n; ++f)
        P[f] = (r[f - 1] + r[f]) / 2 * u[f] - lambda * (middle[f] - middle[f - 1]);
    for (Index i = 0; i < n; ++i) {  // (29.12)
        const Real left = r[i] - lambda * (q[i + 1] - q[i]);
        r[i] = left > 0 ? left : 0;
    }
    for (Index f = 1; f < n; ++f) {
        const Real mean = (r[f - 1] + r[f]) / 2;
        u[f] = P[f] / (mean > dry ? mean : infinity);
    }
}
//! [carry]

void level_water(ShallowWater& water)
{
    for (Index i = 0; i < water.cells(); ++i)
        water.level[i] = water.bed[i] + water.depth[i];
}

void step(ShallowWater& water, Real h)
{
    require_step(h);
    const Real longest = stable_step(water);
    if (h > longest * (1 + 1e-12))
        throw std::invalid_argument("the time step is " + shortest(h) +
                                    " s; a wave passes a whole cell in " +
                                    shortest(longest) + " s");
    level_water(water);
    push_water(water, h);
    carry_water(water, h);
    level_water(water);
}

DamBreak dam_break(Real left, Real right, Real g, Real x, Real t)
{
    if (!(right >= 0 && right < left && left < infinity && t > 0))
        throw std::invalid_argument(
            "a dam between depths of " + shortest(left) + " m and " +
            shortest(right) + " m is looked at after " + shortest(t) +
            " s; the left one must be larger, the right one zero or more, and the "
            "time positive");
    const Real c = std::sqrt(g * left), s = x / t;
    // the fan: u + 2√(gr) is that of the water at rest, and u − √(gr) = x/t
    const auto fan = [&] {
        const Real u = 2 * (c + s) / 3;
        return DamBreak{(c - u / 2) * (c - u / 2) / g, u};
    };
    if (s <= -c) return {left, 0};
    if (right == 0) return s >= 2 * c ? DamBreak{0, 0} : fan();
    // between fan and bore: u = 2 (c − √(gm)), and the bore's own balance of mass and momentum
    const auto behind = [&](Real m) { return 2 * (c - std::sqrt(g * m)); };
    const auto bore = [&](Real m) {
        return (m - right) * std::sqrt(g * (m + right) / (2 * m * right));
    };
    Real low = right, high = left;
    for (int i = 0; i < 100; ++i) {  // the two cross once; 53 bits need fewer
        const Real m = (low + high) / 2;
        (bore(m) < behind(m) ? low : high) = m;
    }
    const Real u = behind(low), speed = low * u / (low - right);
    if (s <= u - std::sqrt(g * low)) return fan();
    return s < speed ? DamBreak{low, u} : DamBreak{right, 0};
}

}  // namespace rigid
