// The functions of shallow_water.hpp.
#include "chapters/29_waves/shallow_water.hpp"

#include "chapters/29_waves/water_faces.hpp"

#include <algorithm>

namespace rigid {
namespace {

void require_cells(Index cells)
{
    if (cells < 2)
        throw std::invalid_argument("the water has " + std::to_string(cells) +
                                    " cells; it must have two or more");
}

Real mean_depth(const ShallowWater& water, Index face)
{
    return (water.depth[face - 1] + water.depth[face]) / 2;
}

/// So many columns are moved at once by step(), with the three to each side that their
/// velocities and depths come from.
constexpr Index window_cells = 512;
constexpr int beside = 3;

/// Whether what a step changes still makes sense (the first step looks at all there is),
/// and no wave passes a whole cell. A root for each column is only taken where the fastest
/// water and the deepest together would be too fast.
void require_fits(ShallowWater& water, Real h)
{
    const Index n = water.cells();
    const bool sized = water.looked_at && n > 1 && water.dx > 0 && water.g > 0 &&
                       water.bed.size() == n && water.level.size() == n &&
                       water.u.size() == n + 1 && water.part.size() == n + 1 &&
                       (water.damping.size() == 0 || water.damping.size() == n + 1);
    if (!sized) require_valid(water);
    water.looked_at = true;
    const Real fastest =
        largest(water.u, -infinity) + std::sqrt(water.g * largest(water.depth, 0));
    if (h * fastest <= water.dx) return;
    if (!(fastest < infinity)) require_valid(water);
    require_shorter(h, stable_step(water));
}

}  // namespace

ShallowWater::ShallowWater(Index cells, Real length, Real still_depth)
{
    require_cells(cells);
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
    u = carried = flux = VecX::Zero(cells + 1);
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
    require_positive("the width of a cell", water.dx, " m");
    require_positive("gravity", water.g, " m/s²");
    require_positive("the density of the water", water.density, " kg/m²");
    const Index n = water.cells();
    require_cells(n);
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
    if (water.damping.size() > 0) sized(water.damping, n + 1, "damping");
    sized(water.part, n + 1, "part");
    for (Index i = 0; i < n; ++i)
        if (water.depth[i] < 0)
            throw std::invalid_argument("depth[" + std::to_string(i) + "] is " +
                                        shortest(water.depth[i]) +
                                        " m; it must be zero or positive");
    for (Index i = 0; i < water.damping.size(); ++i)
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

void push_water(ShallowWater& water, Real h)
{
    const Real gain = h * water.g / water.dx;
    const CellRow all{water.bed.data(), water.depth.data(), water.level.data()};
    const CellRow behind{all.bed + 1, all.depth + 1, all.level + 1};
    const Index faces = water.cells() - 1;
    const Real* const part = water.part.data() + 1;
    Real* const u = water.u.data() + 1;
    if (water.damping.size() == 0)
        push_faces<false>(faces, all, behind, gain, part, h, nullptr, u);
    else
        push_faces<true>(faces, all, behind, gain, part, h,
                         water.damping.data() + 1, u);
}

//! [carry]
void carry_water(ShallowWater& water, Real h)
{
    const Index n = water.cells();
    const Real lambda = h / water.dx;
    water.flux.resize(n + 1), water.carried.resize(n + 1), water.giving.resize(n);
    Real *__restrict r = water.depth.data(), *__restrict u = water.u.data(),
                     *__restrict q = water.flux.data(),
                     *__restrict P = water.carried.data(),
                     *__restrict give = water.giving.data();
    // how deep the water is that leaves a cell: none gives more than it has
    for (Index i = 0; i < n; ++i) {
        const Real parting = lambda * (outwards(u[i + 1]) + outwards(-u[i]));
        give[i] = parting > 1 ? parting : 1;
    }
    // a quotient costs more than all else here, and nearly always each divisor is one
    if (water.giving.maxCoeff() > 1)
        for (Index i = 0; i < n; ++i) give[i] = r[i] / give[i];
    else
        for (Index i = 0; i < n; ++i) give[i] = r[i];
    // through a wall that moves, water of the depth beside it comes or goes
    q[0] = u[0] * give[0];
    for (Index f = 1; f < n; ++f) q[f] = flow_through(u[f], give[f - 1], give[f]);
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
    for (Index f = 1; f < n; ++f) u[f] = velocity_of(P[f], r[f - 1], r[f]);
}
//! [carry]

void level_water(ShallowWater& water)
{
    for (Index i = 0; i < water.cells(); ++i)
        water.level[i] = water.bed[i] + water.depth[i];
}

//! [windows]
/// Goes over the memory once: some columns at a time are moved as if they were all there
/// are, by copies that stay in the cache; the three at either end are not kept.
void step(ShallowWater& water, Real h)
{
    require_step(h);
    require_fits(water, h);
    const Index n = water.cells(), size = window_cells + 2 * beside;
    if (n <= size) {
        water.part.setOnes();
        level_water(water), push_water(water, h), carry_water(water, h);
        level_water(water);
        return;
    }
    if (water.window.empty()) water.window.emplace_back(size, 1, 0);
    ShallowWater& w = water.window.front();
    w.dx = water.dx, w.g = water.g;
    Vec<beside> old_depth,
        old_u;  // of those before `first`, which have moved already
    for (Index first = 0; first < n; first += window_cells) {
        const Index kept = std::min(window_cells, n - first),
                    from = std::clamp(first - beside, Index{0}, n - size),
                    at = first - from;
        w.bed = water.bed.segment(from, size);
        w.depth = water.depth.segment(from, size);
        w.u = water.u.segment(from, size + 1);
        if (water.damping.size() == 0) w.damping.resize(0);
        else w.damping = water.damping.segment(from, size + 1);
        if (first > 0) {
            w.depth.segment<beside>(at - beside) = old_depth;
            w.u.segment<beside>(at - beside) = old_u;
        }
        old_depth = w.depth.segment<beside>(at + kept - beside);
        old_u = w.u.segment<beside>(at + kept - beside);
        level_water(w), push_water(w, h), carry_water(w, h);
        water.depth.segment(first, kept) = w.depth.segment(at, kept);
        water.u.segment(first, kept) = w.u.segment(at, kept);
        water.level.segment(first, kept) =
            w.bed.segment(at, kept) + w.depth.segment(at, kept);
    }
}
//! [windows]

DamBreak dam_break(Real left, Real right, Real g, Real x, Real t)
{
    if (!(right >= 0 && right < left && left < infinity && t > 0))
        throw std::invalid_argument(
            "a dam between depths of " + shortest(left) + " m and " +
            shortest(right) + " m is looked at after " + shortest(t) +
            " s; the left one must be larger, the right one zero or more, and the "
            "time positive");
    require_positive("gravity", g, " m/s²");
    if (!std::isfinite(x))
        throw std::invalid_argument("a dam is looked at from x = " + shortest(x) +
                                    " m; it must be finite");
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
