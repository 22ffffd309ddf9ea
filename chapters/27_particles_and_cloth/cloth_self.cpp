// The functions of cloth_self.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/27_particles_and_cloth/cloth_self.hpp"

#include <algorithm>

namespace rigid {

namespace cloth_self {

Vec3 at(const VecX& x, int p) { return x.segment<3>(3 * p); }

std::array<Vec3, 4> corners(const ClothParts& parts, const VecX& x)
{
    const auto& p = parts.p;
    return {at(x, p[0]), at(x, p[1]), at(x, p[2]), at(x, p[3])};
}

}  // namespace cloth_self

using cloth_self::at, cloth_self::corners;

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
    const Vec3 size = points.empty() ? Vec3(0, 0, 0) : Vec3(high - low_);
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

void ClothSelf::prepare(const ClothScene& cloth)
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
    found_at_.resize(0);
    pairs_.clear(), rows.clear();
}

//! [find]
void ClothSelf::find(const ClothScene& cloth, const VecX& x)
{
    ++found;
    pairs_.clear();
    const auto add = [&](const ClothParts& parts) {
        for (const int i :
             parts.edges ? std::array{0, 1, 0, 1} : std::array{0, 0, 0, 0})
            for (const int j : {1, 2, 3})
                if ((!parts.edges || j > 1) &&
                    parts.p[static_cast<std::size_t>(i)] ==
                        parts.p[static_cast<std::size_t>(j)])
                    return;
        ++tested;
        if (nearest(corners(parts, x), parts.edges).d.squaredNorm() <
            reach_ * reach_)
            pairs_.push_back(parts);
    };
    // particles against triangles
    points_.clear();
    for (int k = 0; k < cloth.count(); ++k) points_.push_back(at(x, k));
    const Real cell = 2 * shortest_ + reach_;
    grid_.fill(points_, cell);
    const Vec3 reach = Vec3::Constant(reach_);
    for (const auto& t : triangles_) {
        const Vec3 a = at(x, t[0]), b = at(x, t[1]), c = at(x, t[2]);
        const Vec3 low = a.cwiseMin(b).cwiseMin(c) - reach,
                   high = a.cwiseMax(b).cwiseMax(c) + reach;
        grid_.near(low, high, [&](int k) {
            const Vec3& p = points_[static_cast<std::size_t>(k)];
            if ((low.array() <= p.array()).all() &&
                (p.array() <= high.array()).all())
                add({{k, t[0], t[1], t[2]}, false});
        });
    }
    // edges against edges, by their middles
    points_.clear();
    Vec3 longest(0, 0, 0);  // half of the longest edge's box
    for (const auto& e : edges_) {
        points_.push_back((at(x, e[0]) + at(x, e[1])) / 2);
        longest = longest.cwiseMax((at(x, e[0]) - at(x, e[1])).cwiseAbs() / 2);
    }
    grid_.fill(points_, cell);
    for (std::size_t i = 0; i < edges_.size(); ++i) {
        const auto& e = edges_[i];
        const Vec3 half = (at(x, e[0]) - at(x, e[1])).cwiseAbs() / 2 + reach;
        const Vec3 &middle = points_[i], around = half + longest;
        grid_.near(middle - around, middle + around, [&](int k) {
            const auto j = static_cast<std::size_t>(k);
            if (j <= i) return;
            const auto& f = edges_[j];
            const Vec3 other = (at(x, f[0]) - at(x, f[1])).cwiseAbs() / 2;
            if (((points_[j] - middle).cwiseAbs().array() <= (half + other).array())
                    .all())
                add({{e[0], e[1], f[0], f[1]}, true});
        });
    }
    found_at_ = x;
}
//! [find]

namespace cloth_self {

Vec3 mean_way(const VecX& from, const VecX& to)
{
    Vec3 mean(0, 0, 0);
    const Index K = from.size() / 3;
    for (Index k = 0; k < K; ++k)
        mean +=
            (to.segment<3>(3 * k) - from.segment<3>(3 * k)) / static_cast<Real>(K);
    return mean;
}

/// The longest way from one to the other, less the mean of all.
Real farthest(const VecX& from, const VecX& to)
{
    const Vec3 mean = mean_way(from, to);
    Real most = 0;
    for (Index k = 0; k < from.size() / 3; ++k)
        most = std::max(
            most,
            (to.segment<3>(3 * k) - from.segment<3>(3 * k) - mean).squaredNorm());
    return std::sqrt(most);
}

}  // namespace cloth_self

using cloth_self::farthest;

//! [begin]
void ClothSelf::begin(const ClothScene& cloth, const VecX& x0, const VecX& y)
{
    // Pairs that are not listed stay farther apart than the thickness, as long as
    // nothing moves by more than half of the skin, seen from the mean of all.
    const Real thickness = cloth.self_thickness, step = farthest(x0, y);
    travelled_ = found_at_.size() == x0.size() ? farthest(found_at_, x0) : infinity;
    if (2 * (travelled_ + 1.5 * step) > reach_ - thickness) {
        reach_ = thickness +
                 std::max(4 * step, std::min(8 * step, shortest_) + shortest_ / 4);
        find(cloth, x0);
        travelled_ = 0;
    }
    rows.clear();
    near_.clear();
    for (const ClothParts& parts : pairs_) {
        const ClothNear near = nearest(corners(parts, x0), parts.edges);
        near_.push_back(near);
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
        // what comes nearer than twice the thickness, if its rows did nothing
        if (row.A > 0 && row.normal.dot(to) < 2 * thickness) rows.push_back(row);
    }
}
//! [begin]

//! [visit]
void ClothSelf::visit(const ClothScene& cloth, VecX& x)
{
    const VecX& inverse = cloth.bodies.inverse_mass;
    for (ClothSelfRow& row : rows) {
        const auto& p = row.parts.p;
        Vec3 d(0, 0, 0);
        for (std::size_t i = 0; i < 4; ++i) d += row.w[i] * at(x, p[i]);
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
        if (P.isZero(0)) continue;
        for (std::size_t i = 0; i < 4; ++i)
            x.segment<3>(3 * p[i]) += inverse[3 * p[i]] * row.w[i] * P;
    }
}
//! [visit]

void ClothSelf::calm(ClothScene& cloth) const
{
    for (const ClothSelfRow& row : rows) {
        if (!(row.lambda > 0)) continue;
        Real parts = 0;
        for (std::size_t i = 0; i < 4; ++i)
            parts +=
                row.w[i] * row.normal.dot(cloth.bodies.velocity(row.parts.p[i]));
        if (!(parts > 0)) continue;
        const Vec3 P = -parts / row.A * row.normal;
        for (std::size_t i = 0; i < 4; ++i)
            cloth.bodies.velocity(row.parts.p[i]) +=
                cloth.bodies.inverse_mass[3 * row.parts.p[i]] * row.w[i] * P;
    }
}

//! [free_part]
/// The part of its way that a pair may go: in steps of nine tenths of what (27.29) allows, until it is at its end or at a
/// tenth of the distance that it began with.
Real ClothSelf::free_part(const ClothParts& parts, const VecX& x0,
                          const VecX& x) const
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
void ClothSelf::stop(const ClothScene& cloth, const VecX& x0, VecX& x)
{
    halted_.assign(static_cast<std::size_t>(cloth.count()), 0);
    const Vec3 all = cloth_self::mean_way(x0, x);
    // of its way less a mean a particle goes a part; a pin goes all of it
    const auto halt = [&](int p, const Vec3& mean, Real part) {
        const Vec3 to = at(x0, p) + mean + part * (at(x, p) - at(x0, p) - mean);
        if (!(cloth.bodies.inverse_mass[3 * p] > 0) || to == at(x, p)) return false;
        halted_[static_cast<std::size_t>(p)] = 1;
        x.segment<3>(3 * p) = to;
        return true;
    };
    const Real most = (reach_ - cloth.self_thickness) / 2 - travelled_;
    for (int p = 0; p < cloth.count(); ++p)
        if (const Real way = (at(x, p) - at(x0, p) - all).norm(); way > most)
            unsure += !halt(p, all, most / way);
    // A particle that stops takes another way than its other pairs were tested for: so
    // again, until no pair is in danger. After eight passes those in danger only move
    // with their mean, after sixteen with that of all, and the passes end.
    for (int pass = 0;; ++pass) {
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
        if (danger > 0 && changed) continue;
        unsure += danger;
        break;
    }
    for (const char one : halted_) stopped += one;
}
//! [stop]

}  // namespace rigid
