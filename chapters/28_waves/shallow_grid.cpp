// The functions of shallow_grid.hpp.
#include "chapters/28_waves/shallow_grid.hpp"

#include "chapters/28_waves/water_rows.hpp"
#include "common/elementary.hpp"

#include <algorithm>
#include <utility>

namespace rigid {
namespace {

using water_rows::Side;

/// The row j of what belongs to cells, to faces across x, across z.
Real* row(VecX& v, Index j, Index length) { return v.data() + j * length; }
const Real* row(const VecX& v, Index j, Index length)
{
    return v.data() + j * length;
}

void prepare(ShallowGrid& water)
{
    const auto n = static_cast<std::size_t>(water.nx);
    ShallowGrid::Rows& rows = water.rows;
    if (rows.level.size() == n) return;
    for (std::vector<Real>* r :
         {&rows.level_low, &rows.level, &rows.depth_before, &rows.carried,
          &rows.centre, &rows.middle, &rows.next})
        r->assign(n, 0);
    rows.through.assign(n + 1, 0);
    for (int k = 0; k < 2; ++k) {
        rows.giving[k].assign(n, 0);
        rows.corner[k].assign(n, 0);
        rows.along[k].assign(n + 1, 0);
        rows.across[k].assign(n, 0);
    }
}

void find_level(const ShallowGrid& water, Index j, std::vector<Real>& into)
{
    const Real* __restrict bed = row(water.bed, j, water.nx);
    const Real* __restrict depth = row(water.depth, j, water.nx);
    Real* __restrict level = into.data();
    for (Index i = 0; i < water.nx; ++i) level[i] = bed[i] + depth[i];
}

/// Pushes u of row j, and w between the rows j − 1 and j; the row before has been here.
void push_row(ShallowGrid& water, Index j, Real slope_to_speed)
{
    const Index n = water.nx;
    ShallowGrid::Rows& rows = water.rows;
    std::swap(rows.level_low, rows.level);
    find_level(water, j, rows.level);
    const Side here{row(water.bed, j, n), row(water.depth, j, n),
                    rows.level.data()};
    const Side next{here.bed + 1, here.depth + 1, here.level + 1};
    water_rows::push_faces(n - 1, slope_to_speed, here, next,
                           row(water.u, j, n + 1) + 1);
    if (j == 0) return;
    const Side before{row(water.bed, j - 1, n), row(water.depth, j - 1, n),
                      rows.level_low.data()};
    water_rows::push_faces(n, slope_to_speed, before, here, row(water.w, j, n));
}

/// What the cells of row j may give.
void find_giving(const ShallowGrid& water, Index j, Real lambda,
                 std::vector<Real>& into)
{
    using water_rows::outwards;
    const Index n = water.nx;
    const Real* __restrict r = row(water.depth, j, n);
    const Real* __restrict u = row(water.u, j, n + 1);
    const Real* __restrict w = row(water.w, j, n);
    const Real* __restrict w_high = row(water.w, j + 1, n);
    Real* __restrict give = into.data();
    for (Index i = 0; i < n; ++i) {
        const Real out = (outwards(u[i + 1]) + outwards(-u[i])) +
                         (outwards(w_high[i]) + outwards(-w[i]));
        give[i] = water_rows::giving(r[i], lambda * out);
    }
}

/// q through the faces across x of row j. Through an end that moves, water of the depth beside it comes or goes.
void find_along(const ShallowGrid& water, Index j, const std::vector<Real>& give,
                std::vector<Real>& q)
{
    water_rows::fluxes(water.nx - 1, row(water.u, j, water.nx + 1) + 1, give.data(),
                       give.data() + 1, q.data() + 1);
    const auto n = static_cast<std::size_t>(water.nx);
    q[0] = water.u[water.face_x(0, j)] * give[0];
    q[n] = water.u[water.face_x(water.nx, j)] * give[n - 1];
}

/// Row j is carried: r, u, then w between j − 1 and j. rows.along and rows.across are those of this row and before it,
/// rows.corner what u the row before gave up through the corners between.
void carry_row(ShallowGrid& water, Index j, Real lambda)
{
    using water_rows::carried;
    ShallowGrid::Rows& rows = water.rows;
    const Index n = water.nx;
    const bool first = j == 0, last = j == water.nz - 1;
    Real* __restrict r = row(water.depth, j, n);
    Real* __restrict u = row(water.u, j, n + 1);
    const Real* u_next = row(water.u, last ? j : j + 1, n + 1);
    const Real* __restrict q = rows.along[1].data();
    const Real* __restrict p = rows.across[0].data();       // between j − 1 and j
    const Real* __restrict p_high = rows.across[1].data();  // between j and j + 1

    // momentum along x, before depths change: what passes the middles of cells and
    // the corners between this row and the next
    Real* __restrict P = rows.next.data();  // of the face on the left of cell i
    Real* __restrict middle = rows.middle.data();
    Real* __restrict corner = rows.corner[0].data();
    const Real* __restrict below = rows.corner[1].data();
    water_rows::carry(n, q, q + 1, u, u + 1, middle);
    water_rows::carry(n - 1, p_high, p_high + 1, u + 1, u_next + 1, corner + 1);
    for (Index i = 1; i < n; ++i)
        P[i] = (r[i - 1] + r[i]) / 2 * u[i] -
               lambda * ((middle[i] - middle[i - 1]) + (corner[i] - below[i]));
    std::swap(rows.corner[0], rows.corner[1]);
    // momentum along z that passes the middle of each cell
    Real* __restrict centre = rows.carried.data();
    const Real* w_high = row(water.w, j + 1, n);
    Real* w = row(water.w, j, n);
    water_rows::carry(n, p, p_high, w, w_high, centre);
    // (28.16)
    Real* __restrict before = rows.depth_before.data();  // of row j − 1
    Real* __restrict mean = rows.giving[0].data();       // free by now
    for (Index i = 0; i < n; ++i) {
        mean[i] = (before[i] + r[i]) / 2;
        before[i] = r[i];
        const Real left = r[i] - lambda * ((q[i + 1] - q[i]) + (p_high[i] - p[i]));
        r[i] = left > 0 ? left : 0;
    }
    for (Index i = 1; i < n; ++i)
        u[i] = water_rows::velocity(P[i], (r[i - 1] + r[i]) / 2);
    if (!first) {
        const Real* __restrict r_before = row(water.depth, j - 1, n);
        const Real* __restrict q_before = rows.along[0].data();
        const Real* __restrict beneath = rows.centre.data();
        Real* __restrict Q = rows.next.data();
        // through the corners on the left of cells; at the walls nothing passes
        Real* __restrict through = rows.through.data();
        water_rows::carry(n - 1, q_before + 1, q + 1, w, w + 1, through + 1);
        for (Index i = 0; i < n; ++i)
            Q[i] = mean[i] * w[i] - lambda * ((centre[i] - beneath[i]) +
                                              (through[i + 1] - through[i]));
        for (Index i = 0; i < n; ++i)
            w[i] = water_rows::velocity(Q[i], (r_before[i] + r[i]) / 2);
    }
    std::swap(rows.carried, rows.centre);
}

/// One pass through the rows; `push` before it is carried, or it has been.
template <bool pushes>
void pass(ShallowGrid& water, Real h)
{
    prepare(water);
    ShallowGrid::Rows& rows = water.rows;
    const Real lambda = h / water.dx, slope_to_speed = h * water.g / water.dx;
    std::fill(rows.corner[1].begin(), rows.corner[1].end(), 0.0);
    std::fill(rows.across[1].begin(), rows.across[1].end(), 0.0);
    std::fill(rows.depth_before.begin(), rows.depth_before.end(), 0.0);
    const auto push = [&](Index j) {
        if (pushes && j < water.nz) push_row(water, j, slope_to_speed);
    };
    push(0), push(1);
    find_giving(water, 0, lambda, rows.giving[1]);
    for (Index j = 0; j < water.nz; ++j) {
        push(j + 2);
        std::swap(rows.giving[0], rows.giving[1]);  // 0: of row j
        std::swap(rows.along[0], rows.along[1]);    // 1: of row j
        std::swap(rows.across[0], rows.across[1]);
        find_along(water, j, rows.giving[0], rows.along[1]);
        if (j + 1 < water.nz) {
            find_giving(water, j + 1, lambda, rows.giving[1]);
            water_rows::fluxes(water.nx, row(water.w, j + 1, water.nx),
                               rows.giving[0].data(), rows.giving[1].data(),
                               rows.across[1].data());
        } else std::fill(rows.across[1].begin(), rows.across[1].end(), 0.0);
        carry_row(water, j, lambda);
    }
}

}  // namespace

ShallowGrid::ShallowGrid(Index nx_, Index nz_, Real side, Real still_depth)
    : nx(nx_), nz(nz_), dx(side)
{
    if (nx < 2 || nz < 2)
        throw std::invalid_argument("the water has " + std::to_string(nx) + " by " +
                                    std::to_string(nz) +
                                    " cells; it must have two or more each way");
    if (!(still_depth >= 0) || !std::isfinite(still_depth))
        throw std::invalid_argument("the depth of the water is " +
                                    shortest(still_depth) +
                                    " m; it must be zero or positive and finite");
    bed = VecX::Zero(nx * nz);
    depth = VecX::Constant(nx * nz, still_depth);
    u = VecX::Zero((nx + 1) * nz);
    w = VecX::Zero(nx * (nz + 1));
    require_valid(*this);
}

void require_valid(const ShallowGrid& water)
{
    const auto positive = [](const char* name, Real value, const char* unit) {
        if (!(value > 0) || !std::isfinite(value))
            throw std::invalid_argument(std::string(name) + " is " +
                                        shortest(value) + unit +
                                        "; it must be positive and finite");
    };
    positive("the side of a cell", water.dx, " m");
    positive("gravity", water.g, " m/s²");
    positive("the density of the water", water.density, " kg/m³");
    const auto sized = [&](const VecX& v, Index wanted, const char* name) {
        if (v.size() != wanted)
            throw std::invalid_argument(
                std::string(name) + " has " + std::to_string(v.size()) +
                " entries; water of " + std::to_string(water.nx) + " by " +
                std::to_string(water.nz) + " cells needs " +
                std::to_string(wanted));
        require_finite(v, name);
    };
    sized(water.bed, water.nx * water.nz, "bed");
    sized(water.depth, water.nx * water.nz, "depth");
    sized(water.u, (water.nx + 1) * water.nz, "u");
    sized(water.w, water.nx * (water.nz + 1), "w");
    for (Index c = 0; c < water.depth.size(); ++c)
        if (water.depth[c] < 0)
            throw std::invalid_argument("depth[" + std::to_string(c) + "] is " +
                                        shortest(water.depth[c]) +
                                        " m; it must be zero or positive");
}

Real volume(const ShallowGrid& water)
{
    Real sum = 0;
    for (Index c = 0; c < water.depth.size(); ++c) sum += water.depth[c];
    return sum * water.dx * water.dx;
}

Vec2 momentum(const ShallowGrid& water)
{
    Vec2 sum(0, 0);
    for (Index j = 0; j < water.nz; ++j)
        for (Index i = 0; i < water.nx; ++i) {
            const Index c = water.at(i, j);
            if (i > 0)
                sum.x() += (water.depth[c - 1] + water.depth[c]) / 2 *
                           water.u[water.face_x(i, j)];
            if (j > 0)
                sum.y() += (water.depth[c - water.nx] + water.depth[c]) / 2 *
                           water.w[water.face_z(i, j)];
        }
    return water.density * water.dx * water.dx * sum;
}

Real energy(const ShallowGrid& water)
{
    Real kinetic = 0, potential = 0;
    for (Index j = 0; j < water.nz; ++j)
        for (Index i = 0; i < water.nx; ++i) {
            const Index c = water.at(i, j);
            const Real r = water.depth[c], u = water.u[water.face_x(i, j)],
                       w = water.w[water.face_z(i, j)];
            if (i > 0) kinetic += (water.depth[c - 1] + r) / 2 * u * u;
            if (j > 0) kinetic += (water.depth[c - water.nx] + r) / 2 * w * w;
            potential += r * (r + 2 * water.bed[c]);
        }
    return water.density * water.dx * water.dx * (kinetic + water.g * potential) /
           2;
}

Real stable_step(const ShallowGrid& water)
{
    const Index n = water.nx;
    constexpr Index block = 256;
    Real speed[block];
    Real fastest = 0;
    for (Index j = 0; j < water.nz; ++j)
        for (Index start = 0; start < n; start += block) {
            const Index count = std::min(block, n - start);
            const Real* __restrict r = row(water.depth, j, n) + start;
            const Real* __restrict u = row(water.u, j, n + 1) + start;
            const Real* __restrict w = row(water.w, j, n) + start;
            const Real* __restrict w_high = row(water.w, j + 1, n) + start;
            for (Index i = 0; i < count; ++i) speed[i] = 2 * water.g * r[i];
            Eigen::Map<Eigen::ArrayXd> root(speed, count);
            root = root.sqrt();  // rounded correctly by IEEE 754
            for (Index i = 0; i < count; ++i)
                speed[i] += water_rows::larger_size(u[i], u[i + 1]) +
                            water_rows::larger_size(w[i], w_high[i]);
            const Real most = water_rows::largest(count, speed);
            fastest = most > fastest ? most : fastest;
        }
    return water.dx / fastest;
}

void push_water(ShallowGrid& water, Real h)
{
    prepare(water);
    for (Index j = 0; j < water.nz; ++j) push_row(water, j, h * water.g / water.dx);
}

void carry_water(ShallowGrid& water, Real h) { pass<false>(water, h); }

void step(ShallowGrid& water, Real h)
{
    require_step(h);
    const Real longest = stable_step(water);
    if (h > longest * (1 + 1e-12))
        throw std::invalid_argument(
            "the time step is " + shortest(h) +
            " s; water and waves pass as much of a cell as is stable in " +
            shortest(longest) + " s");
    pass<true>(water, h);
}

void add_mound(ShallowGrid& water, Real x, Real z, Real radius, Real height)
{
    if (!(radius > 0) || !std::isfinite(radius) || !std::isfinite(height) ||
        !std::isfinite(x) || !std::isfinite(z))
        throw std::invalid_argument(
            "a mound at (" + shortest(x) + ", " + shortest(z) +
            ") m has the radius " + shortest(radius) + " m and the height " +
            shortest(height) + " m; they must be finite, the radius positive");
    for (Index j = 0; j < water.nz; ++j)
        for (Index i = 0; i < water.nx; ++i) {
            const Real a = water.x_of(i) - x, b = water.z_of(j) - z;
            const Real s = std::sqrt(a * a + b * b) / radius;
            if (!(s < 1)) continue;
            Real& r = water.depth[water.at(i, j)];
            r = std::max(r + height / 2 * (1 + cos(pi * s)), 0.0);
        }
}

RadialWater::RadialWater(Index rings, Real radius, Real still_depth)
    : dr(radius / static_cast<Real>(rings)),
      depth(VecX::Constant(rings, still_depth)), u(VecX::Zero(rings + 1)), flux(u),
      carried(u)
{
    if (rings < 2 || !(radius > 0) || !std::isfinite(radius) ||
        !(still_depth >= 0) || !std::isfinite(still_depth))
        throw std::invalid_argument(
            std::to_string(rings) + " rings of water have the radius " +
            shortest(radius) + " m and the depth " + shortest(still_depth) +
            " m; there must be two or more, a positive radius and no negative "
            "depth");
}

void step(RadialWater& water, Real h)
{
    require_step(h);
    const Index n = water.depth.size();
    VecX &r = water.depth, &u = water.u, &q = water.flux, &P = water.carried;
    // the area of a ring over 2π, and the length of a circle over 2π
    const auto area = [&](Index i) { return water.radius_of(i) * water.dr; };
    const auto circle = [&](Index f) { return water.dr * static_cast<Real>(f); };
    const auto whole = [&](Index f) {  // of the two half rings beside a circle
        return (area(f - 1) * r[f - 1] + area(f) * r[f]) / 2;
    };
    for (Index f = 1; f < n; ++f) {
        u[f] -= h * water.g * (r[f] - r[f - 1]) / water.dr;
        q[f] = circle(f) * u[f] * r[u[f] >= 0 ? f - 1 : f];
    }
    for (Index f = 1; f < n; ++f)
        P[f] = whole(f) * u[f] -
               h * (water_rows::carried(q[f], q[f + 1], u[f], u[f + 1]) -
                    water_rows::carried(q[f - 1], q[f], u[f - 1], u[f]));
    for (Index i = 0; i < n; ++i)
        r[i] = std::max(r[i] - h * (q[i + 1] - q[i]) / area(i), 0.0);
    for (Index f = 1; f < n; ++f) u[f] = water_rows::velocity(P[f], whole(f));
}

}  // namespace rigid
