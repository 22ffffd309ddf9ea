// The functions of cloth_self.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/28_cloth_that_touches/cloth_self.hpp"

#include "chapters/28_cloth_that_touches/cloth_contact.hpp"

#include <algorithm>

namespace rigid {

namespace cloth_self {

Vec3 at(const VecX& x, int p) { return x.segment<3>(3 * p); }

Vec3 mean_of(const VecX& way)
{
    Vec3 mean(0, 0, 0);
    for (Index k = 0; k < way.size() / 3; ++k) mean += way.segment<3>(3 * k);
    return mean / std::max(static_cast<Real>(way.size() / 3), Real{1});
}

/// The longest of all, less their mean.
Real farthest(const VecX& way)
{
    const Vec3 mean = mean_of(way);
    Real most = 0;
    for (Index k = 0; k < way.size() / 3; ++k)
        most = std::max(most, (way.segment<3>(3 * k) - mean).squaredNorm());
    return std::sqrt(most);
}

std::array<Vec3, 4> corners(const ClothParts& parts, const VecX& x)
{
    const auto& p = parts.p;
    return {at(x, p[0]), at(x, p[1]), at(x, p[2]), at(x, p[3])};
}

/// d of a row, or how fast it changes.
Vec3 row_value(const ClothSelfRow& row, const VecX& x)
{
    Vec3 d(0, 0, 0);
    for (std::size_t i = 0; i < 4; ++i) d += row.w[i] * at(x, row.parts.p[i]);
    return d;
}

/// Adds P along a row: [N s²] to places, [N s] to velocities.
void push(const TouchingCloth& cloth, const ClothSelfRow& row, const Vec3& P,
          VecX& x)
{
    for (std::size_t i = 0; i < 4; ++i) {
        const int p = row.parts.p[i];
        x.segment<3>(3 * p) += cloth.bodies.inverse_mass[3 * p] * row.w[i] * P;
    }
}

}  // namespace cloth_self

using namespace cloth_self;

//! [nearest]
ClothNear nearest(const std::array<Vec3, 4>& x, bool edges)
{
    ClothNear found;
    if (edges) {
        const auto [s, t] = nearest_of_edges(x[0], x[1] - x[0], x[2], x[3] - x[2]);
        found.w = {1 - s, s, t - 1, -t};
    } else {
        const auto w = nearest_of_triangle({x[1] - x[0], x[2] - x[0], x[3] - x[0]});
        found.w = {1, -w[0], -w[1], -w[2]};
    }
    for (std::size_t i = 0; i < 4; ++i) found.d += found.w[i] * x[i];
    return found;
}
//! [nearest]

void PointGrid::fill(const std::vector<Vec3>& points, Real cell)
{
    Vec3 high = Vec3::Constant(-infinity);
    low_ = Vec3::Constant(infinity);
    for (const Vec3& p : points) low_ = low_.cwiseMin(p), high = high.cwiseMax(p);
    Vec3 size = high - low_;
    // no points, or some that an unstable step has thrown beyond all numbers: one cell
    if (!size.allFinite()) low_.setZero(), size.setZero();
    // no more cells than four times the points
    cell_ = cell;
    const Real most = 4 * static_cast<Real>(points.size()) + 64;
    const auto cells = [&] {
        Real product = 1;
        for (int k = 0; k < 3; ++k) product *= std::floor(size[k] / cell_) + 1;
        return product;
    };
    while (cells() > most) cell_ *= 1.5;
    std::size_t total = 1;
    for (std::size_t k = 0; k < 3; ++k) {
        count_[k] =
            static_cast<int>(std::floor(size[static_cast<Index>(k)] / cell_)) + 1;
        total *= static_cast<std::size_t>(count_[k]);
    }
    first_.assign(total + 1, 0);
    cell_of_.resize(points.size());
    items_.resize(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vec3& p = points[i];
        const std::size_t c =
            cell_of(along(p.x(), 0), along(p.y(), 1), along(p.z(), 2));
        cell_of_[i] = static_cast<int>(c);
        ++first_[c + 1];
    }
    for (std::size_t c = 0; c < total; ++c) first_[c + 1] += first_[c];
    for (std::size_t i = points.size(); i-- > 0;)
        items_[static_cast<std::size_t>(
            --first_[static_cast<std::size_t>(cell_of_[i]) + 1])] =
            static_cast<int>(i);
    // each entry is now where its cell begins, one place too late
    for (std::size_t c = 0; c < total; ++c) first_[c] = first_[c + 1];
    first_[total] = static_cast<int>(points.size());
}

void ClothSelf::prepare(const TouchingCloth& cloth)
{
    triangles_ = cloth.triangles;
    edges_.clear();
    for (const auto& t : triangles_)
        for (std::size_t i = 0; i < 3; ++i)
            edges_.push_back(
                {std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
    std::sort(edges_.begin(), edges_.end());
    edges_.erase(std::unique(edges_.begin(), edges_.end()), edges_.end());
    shortest_ = infinity;
    for (const ClothSpring& s : cloth.springs)
        shortest_ = std::min(shortest_, s.length);
    if (cloth.springs.empty()) shortest_ = 4 * cloth.self_thickness;
    parts_count_ = cloth.count() + std::ssize(edges_) + std::ssize(triangles_);
    horizon_ = 0;  // no list yet
    pairs_.clear(), rows.clear();
}

template <std::size_t N>
ClothSelf::Part ClothSelf::part_of(const std::array<int, N>& p, const VecX& x,
                                   const VecX& way) const
{
    Part part;
    for (const int k : p) part.middle += at(x, k), part.way += at(way, k);
    part.middle /= static_cast<Real>(N), part.way /= static_cast<Real>(N);
    Real radius = 0, spread = 0;
    for (const int k : p) {
        radius = std::max(radius, (at(x, k) - part.middle).squaredNorm());
        spread = std::max(spread, (at(way, k) - part.way).squaredNorm());
    }
    part.radius = std::sqrt(radius), part.spread = std::sqrt(spread);
    return part;
}

/// Lists a pair unless (28.4) says that it stays apart by `extra`, seen from the way
/// of the first.
bool ClothSelf::add(const ClothParts& parts, const Part& a, const Part& b,
                    const VecX& x, Real extra)
{
    ++looks_;
    const Real reach = extra + (a.way - b.way).norm() + a.spread + b.spread,
               around = reach + a.radius + b.radius;
    if ((a.middle - b.middle).squaredNorm() > around * around) return false;
    const auto& p = parts.p;
    for (const std::size_t i : {0u, 1u})
        for (std::size_t j = parts.edges ? 2 : 1; j < 4; ++j)
            if ((i == 0 || parts.edges) && p[i] == p[j]) return false;
    ++tested;
    const ClothNear near = nearest(corners(parts, x), parts.edges);
    if (!(near.d.squaredNorm() <= reach * reach)) return false;
    pairs_.push_back(parts);
    near_.push_back(near);
    return true;
}

//! [find]
/// All pairs that may come within `extra` on these ways.
void ClothSelf::find(const VecX& x, const VecX& way, Real extra)
{
    ++found;
    pairs_.clear(), near_.clear();
    const auto K = static_cast<int>(x.size() / 3);
    const Vec3 mean = cloth_self::mean_of(way);
    if (!mean.allFinite()) looks_ = most_looks * parts_count_ + 1;
    const auto own = [&mean](const Part& part) {
        return (part.way - mean).norm() + part.spread;
    };
    // particles against triangles
    others_.clear(), points_.clear();
    Real fastest = 0;
    for (int k = 0; k < K; ++k) {
        others_.push_back(part_of(std::array{k}, x, way));
        points_.push_back(others_.back().middle);
        fastest = std::max(fastest, own(others_.back()));
    }
    const Real cell = 2 * shortest_ + extra + fastest;
    grid_.fill(points_, cell);
    for (const auto& t : triangles_) {
        if (beyond()) return;
        const Part here = part_of(t, x, way);
        const Vec3 around =
            Vec3::Constant(here.radius + extra + own(here) + fastest);
        grid_.near(here.middle - around, here.middle + around, [&](int k) {
            add({{k, t[0], t[1], t[2]}, false},
                others_[static_cast<std::size_t>(k)], here, x, extra);
        });
    }
    // edges against edges, by their middles
    parts_.clear(), points_.clear();
    Real longest = 0;
    for (const auto& e : edges_) {
        parts_.push_back(part_of(e, x, way));
        points_.push_back(parts_.back().middle);
        longest = std::max(longest, parts_.back().radius);
    }
    grid_.fill(points_, cell);
    for (std::size_t i = 0; i < edges_.size() && !beyond(); ++i) {
        const Part& here = parts_[i];
        const Vec3 around =
            Vec3::Constant(here.radius + longest + extra + own(here) + 2 * fastest);
        grid_.near(here.middle - around, here.middle + around, [&](int k) {
            const auto j = static_cast<std::size_t>(k);
            if (j > i)
                add({{edges_[i][0], edges_[i][1], edges_[j][0], edges_[j][1]},
                     true},
                    here, parts_[j], x, extra);
        });
    }
}
//! [find]

/// How far x is from where all were to go since the list was made, the most, less the
/// mean.
Real ClothSelf::strayed(const VecX& x)
{
    if (found_at_.size() != x.size() || age_ >= horizon_) return infinity;
    way_ = x - found_at_;
    way_ -= static_cast<Real>(age_ + 1) * planned_;
    return farthest(way_);
}

//! [begin]
void ClothSelf::begin(const TouchingCloth& cloth, const VecX& x0, const VecX& y)
{
    // A list is made for the ways of some sub-steps. It has all pairs that may come
    // near, as long as nothing strays from those by more than half of the slack.
    const Real near_by = 1.25 * cloth.self_thickness, slack = shortest_ / 6;
    ++age_, looks_ = 0, lost = false;
    if (!(3 * strayed(y) <= slack)) {
        found_at_ = x0, planned_ = y - x0, age_ = 0;
        horizon_ = 8 * farthest(planned_) < shortest_ / 4 ? 8 : 2;
        slack_ = slack;
        way_ = static_cast<Real>(horizon_) * planned_;
        find(x0, way_, near_by + slack);
    } else {
        near_.clear();
        for (const ClothParts& parts : pairs_)
            near_.push_back(nearest(corners(parts, x0), parts.edges));
    }
    rows.clear();
    if (beyond()) pairs_.clear(), near_.clear(), horizon_ = 0;
    for (std::size_t k = 0; k < pairs_.size(); ++k) {
        const ClothParts& parts = pairs_[k];
        const ClothNear& near = near_[k];
        const Real d = near.d.norm();
        if (!(d > 1e-9 * shortest_)) {
            ++unsure;
            continue;
        }
        ClothSelfRow row{parts, near.w, near.d / d, near.d};
        Vec3 to(0, 0, 0);
        for (std::size_t i = 0; i < 4; ++i) {
            to += near.w[i] * at(y, parts.p[i]);
            row.A +=
                near.w[i] * near.w[i] * cloth.bodies.inverse_mass[3 * parts.p[i]];
        }
        // what comes nearly as near as the thickness, if the rows did nothing
        if (row.A > 0 && row.normal.dot(to) < near_by) rows.push_back(row);
    }
}
//! [begin]

//! [visit]
void ClothSelf::visit(const TouchingCloth& cloth, VecX& x)
{
    for (ClothSelfRow& row : rows) {
        const Vec3 d = row_value(row, x);
        const Real C = row.normal.dot(d) - cloth.self_thickness;
        const Real next = std::max(Real{0}, row.lambda - C / row.A);
        Vec3 P = (next - row.lambda) * row.normal;
        row.lambda = next;
        if (cloth.self_friction > 0 && (next > 0 || !row.slide.isZero(0))) {
            Vec3 slid = d - row.from;
            slid -= row.normal.dot(slid) * row.normal;
            Vec3 slide = row.slide - slid / row.A;
            const Real size = slide.norm(), most = cloth.self_friction * next;
            if (size > most) slide *= most / size;
            P += slide - row.slide;
            row.slide = slide;
        }
        if (!P.isZero(0)) push(cloth, row, P, x);
    }
}
//! [visit]

void ClothSelf::rest_in_the_middle(TouchingCloth& cloth, Real h,
                                   const VecX& u0) const
{
    for (const ClothSelfRow& row : rows) {
        if (!(row.lambda > 0)) continue;
        const Vec3 bounce =
            (row_value(row, cloth.bodies.u) - row_value(row, u0)) / 2;
        push(cloth, row,
             taken_back(bounce, row.normal, row.lambda, row.slide, row.A, row.A,
                        cloth.self_friction * row.lambda, h),
             cloth.bodies.u);
    }
}

void ClothSelf::calm(TouchingCloth& cloth) const
{
    for (const ClothSelfRow& row : rows) {
        if (!(row.lambda > 0)) continue;
        Real parts = 0;
        for (std::size_t i = 0; i < 4; ++i)
            parts +=
                row.w[i] * row.normal.dot(cloth.bodies.velocity(row.parts.p[i]));
        if (parts > 0)
            push(cloth, row, -parts / row.A * row.normal, cloth.bodies.u);
    }
}

//! [free_part]
/// The part of its way that a pair may go: in steps of nine tenths of what (28.4) allows, until it is at its end or at a
/// tenth of the distance that it began with.
Real ClothSelf::free_part(const ClothParts& parts, const VecX& x0, const VecX& x)
{
    std::array<Vec3, 4> way;
    Vec3 mean(0, 0, 0);
    for (std::size_t i = 0; i < 4; ++i) {
        way[i] = at(x, parts.p[i]) - at(x0, parts.p[i]);
        mean += way[i] / 4;
    }
    std::array<Real, 2> r{0, 0};
    for (std::size_t i = 0; i < 4; ++i) {
        Real& side = r[i < (parts.edges ? 2u : 1u) ? 0 : 1];
        side = std::max(side, (way[i] - mean).norm());
    }
    const std::array<Vec3, 4> start_at = corners(parts, x0);
    std::array<Vec3, 4> here;
    Real s = 0, start = 0;
    for (int n = 0;; ++n) {
        ++looks_;
        for (std::size_t i = 0; i < 4; ++i) here[i] = start_at[i] + s * way[i];
        const Real d = nearest(here, parts.edges).d.norm();
        if (n == 0) start = d;
        if ((1 - s) * (r[0] + r[1]) < d) return 1;
        if (n > 0 && (d < 0.1 * start || n == 40)) return s;
        s += 0.9 * d / (r[0] + r[1]);
    }
}
//! [free_part]

//! [stop]
/// Stops pairs before they meet, until none of those that are listed is in danger.
/// \return  whether any has stopped
bool ClothSelf::halt_pairs(const TouchingCloth& cloth, const VecX& x0, VecX& x,
                           const Vec3& all)
{
    // of its way less a mean a particle goes a part; a pin goes all of it
    const auto halt = [&](int p, const Vec3& mean, Real part) {
        const Vec3 to = at(x0, p) + mean + part * (at(x, p) - at(x0, p) - mean);
        if (!(cloth.bodies.inverse_mass[3 * p] > 0) || to == at(x, p)) return false;
        halted_[static_cast<std::size_t>(p)] = 1;
        x.segment<3>(3 * p) = to;
        return true;
    };
    // A particle that stops takes another way than its other pairs were tested for: so
    // again. After eight passes those in danger only move with their mean, after
    // sixteen with that of all, and the passes end.
    bool any = false;
    for (int pass = 0;; ++pass) {
        looks_ += std::ssize(pairs_);
        if (beyond()) return true;
        int danger = 0;
        bool changed = false;
        for (std::size_t k = 0; k < pairs_.size(); ++k) {
            const ClothParts& parts = pairs_[k];
            // quick: seen from its first particle
            const Vec3 first = at(x, parts.p[0]) - at(x0, parts.p[0]);
            Real far = 0;
            for (std::size_t i = 1; i < 4; ++i)
                far = std::max(
                    far,
                    (at(x, parts.p[i]) - at(x0, parts.p[i]) - first).squaredNorm());
            const Real d = near_[k].d.squaredNorm();
            if ((parts.edges ? 4 : 1) * far < d || d == 0) continue;
            const Real part = free_part(parts, x0, x);
            if (!(part < 1)) continue;
            ++danger;
            Vec3 mean(0, 0, 0);
            for (const int p : parts.p) mean += (at(x, p) - at(x0, p)) / 4;
            for (const int p : parts.p)
                changed |= halt(p, pass < 16 ? mean : all, pass < 8 ? part : 0);
        }
        any = any || changed;
        if (danger > 0 && changed) continue;
        unsure += danger;
        return any;
    }
}

void ClothSelf::stop(const TouchingCloth& cloth, const VecX& x0, VecX& x)
{
    halted_.assign(static_cast<std::size_t>(cloth.count()), 0);
    way_ = x - x0;
    const Vec3 all = cloth_self::mean_of(way_);
    if (2 * strayed(x) <= slack_) {
        // the list has all that could meet; those that stop may stray farther
        halt_pairs(cloth, x0, x, all);
        if (!beyond() && 2 * strayed(x) <= slack_) return count_halted();
    }
    horizon_ = 0;  // the list is for this sub-step
    for (int round = 0;; ++round) {
        way_ = x - x0;
        find(x0, way_, 0);
        if (!beyond() && !halt_pairs(cloth, x0, x, all)) break;
        if (round < 8 && !beyond()) continue;
        lost = beyond();
        for (int p = 0; p < cloth.count(); ++p)  // all go with their mean
            if (cloth.bodies.inverse_mass[3 * p] > 0) {
                x.segment<3>(3 * p) = at(x0, p) + all;
                halted_[static_cast<std::size_t>(p)] = 1;
            } else {
                unsure += at(x, p) != at(x0, p) + all;  // a pin goes its own way
            }
        break;
    }
    count_halted();
}
//! [stop]

}  // namespace rigid
