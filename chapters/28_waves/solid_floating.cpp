// The functions of solid_floating.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/28_waves/solid_floating.hpp"

#include <algorithm>

namespace rigid {
namespace {

/// An impulse on body k at a point; what cannot move takes none.
void push_at(Bodies<6>& bodies, Index k, const Vec3& at, const Vec3& impulse)
{
    const Vec3 arm = at - centre_of(bodies.x, k);
    Vec<6> P;
    P << impulse, rotation_of(bodies.x, k).transpose() * cross(arm, impulse);
    bodies.velocity(k) += bodies.apply_inverse_mass(k, P);
}

Vec3 velocity_at(const Bodies<6>& bodies, Index k, const Vec3& at)
{
    return Vec3(bodies.u.segment<3>(6 * k)) +
           cross(world_spin(bodies, k), Vec3(at - centre_of(bodies.x, k)));
}

Index cell_of(Real x, Real origin, Real dx, Index cells)
{
    const Real i = std::floor((x - origin) / dx);
    return static_cast<Index>(std::clamp(i, Real{0}, static_cast<Real>(cells - 1)));
}

/// Water enough on both sides that it may have a velocity.
bool is_wet(const ShallowGrid& water, Index a, Index b)
{
    return water.depth[a] + water.depth[b] > 2e-9;
}

}  // namespace

//! [wet_skin]
void WetSkin::add(const std::vector<Vec3>& piece, Real level, const Vec3& origin)
{
    for (std::size_t i = 1; i + 1 < piece.size(); ++i) {
        const Vec3 a = piece[0] - origin, b = piece[i] - origin,
                   c = piece[i + 1] - origin;
        // the area seen from below
        const Real S = ((b.x() - a.x()) * (c.z() - a.z()) -
                        (b.z() - a.z()) * (c.x() - a.x())) /
                       2;
        const Real f0 = level - piece[0].y(), f1 = level - piece[i].y(),
                   f2 = level - piece[i + 1].y(), f = f0 + f1 + f2;
        const Vec3 sum = a + b + c, mixed = f0 * a + f1 * b + f2 * c;
        volume += S * f / 3;
        area += S;
        area_moment += S / 3 * sum;
        Vec3 first = f * sum + mixed;
        // along y, from the level: that of a column from the skin to it
        first.y() = (f * f + (f0 * f0 + f1 * f1 + f2 * f2)) / -2;
        moment += S / 12 * first;
    }
}

SubmergedSolid WetSkin::below(Real level, const Vec3& origin) const
{
    SubmergedSolid found;
    if (!(volume > 0)) return found;
    found.volume = volume;
    found.centroid = origin + moment / volume;
    found.centroid.y() = level + moment.y() / volume;
    if (area > 0) {
        found.area = area;
        found.middle = origin + area_moment / area;
    }
    found.middle.y() = level;
    return found;
}
//! [wet_skin]

SubmergedSolid submerged(const Hull& hull, const Vec3& centre, const Mat3& R,
                         Real level)
{
    WetSkin skin;
    std::vector<Vec3> corners, wet;
    for (const std::vector<int>& face : hull.faces) {
        corners.clear();
        for (const int i : face)
            corners.push_back(centre +
                              R * hull.vertices[static_cast<std::size_t>(i)]);
        cut(corners, Keep::below, level, wet);
        skin.add(wet, level, centre);
    }
    return skin.below(level, centre);
}

//! [cut_body]
/// Each face of each hull of body k, column by column.
void SolidFloating::cut_body(const SpaceScene& scene, const ShallowGrid& water,
                             Index k)
{
    const Vec3 centre = centre_of(scene.bodies.x, k);
    const Mat3 R = rotation_of(scene.bodies.x, k);
    const std::vector<Hull>& hulls_of = scene.shapes[static_cast<std::size_t>(k)];
    const auto column = [&](Real x, Real origin, Index n) {
        return cell_of(x, origin, water.dx, n);
    };
    Vec3 least = Vec3::Constant(infinity), most = -least;
    for (const Hull& hull : hulls_of) {
        if (hull.radius > 0)
            throw std::invalid_argument(
                "body " + std::to_string(k) + " has a hull of the radius " +
                shortest(hull.radius) + " m; only hulls with flat faces float");
        for (const Vec3& p : hull.vertices) {
            const Vec3 at = centre + R * p;
            least = least.cwiseMin(at), most = most.cwiseMax(at);
        }
    }
    const Index i0 = column(least.x(), water.origin_x, water.nx),
                i1 = column(most.x(), water.origin_x, water.nx),
                j0 = column(least.z(), water.origin_z, water.nz),
                j1 = column(most.z(), water.origin_z, water.nz),
                across = i1 - i0 + 1;
    sums_.assign(static_cast<std::size_t>(across * (j1 - j0 + 1)), {});
    for (const Hull& hull : hulls_of)
        for (const std::vector<int>& face : hull.faces) {
            corners_.clear();
            Vec3 low = Vec3::Constant(infinity), high = -low;
            for (const int v : face) {
                corners_.push_back(centre +
                                   R * hull.vertices[static_cast<std::size_t>(v)]);
                low = low.cwiseMin(corners_.back());
                high = high.cwiseMax(corners_.back());
            }
            const Vec3 normal = cross(Vec3(corners_[1] - corners_[0]),
                                      Vec3(corners_[2] - corners_[1]))
                                    .normalized();
            const Index from = column(low.z(), water.origin_z, water.nz),
                        to = column(high.z(), water.origin_z, water.nz);
            for (Index j = from; j <= to; ++j) {
                const Real z = water.origin_z + water.dx * static_cast<Real>(j);
                cut(corners_, Keep::beyond, z, half_);
                cut(half_, Keep::before, z + water.dx, strip_);
                if (strip_.size() < 3) continue;
                Real left = infinity, right = -infinity;
                for (const Vec3& p : strip_)
                    left = std::min(left, p.x()), right = std::max(right, p.x());
                const Index begin = column(left, water.origin_x, water.nx),
                            end = column(right, water.origin_x, water.nx);
                for (Index i = begin; i <= end; ++i) {
                    const Real x = water.origin_x + water.dx * static_cast<Real>(i);
                    cut(strip_, Keep::right_of, x, half_);
                    cut(half_, Keep::left_of, x + water.dx, piece_);
                    const Index cell = water.at(i, j);
                    cut(piece_, Keep::below, level[cell], wet_);
                    if (wet_.size() < 3) continue;
                    sums_[static_cast<std::size_t>((j - j0) * across + i - i0)].add(
                        wet_, level[cell], centre);
                    Vec3 middle(0, 0, 0);
                    Real area = 0;
                    for (std::size_t c = 1; c + 1 < wet_.size(); ++c) {
                        const Vec3 p = wet_[c] - wet_[0], q = wet_[c + 1] - wet_[0];
                        const Real part = cross(p, q).norm() / 2;
                        area += part;
                        middle += part / 3 * (p + q);
                    }
                    if (!(area > 0)) continue;
                    faces.push_back(
                        {k, cell, wet_[0] + middle / area, normal, area});
                    wet_area_[k] += area;
                }
            }
        }
    // less than a hair's breadth is rounding
    const Real cell_area = water.dx * water.dx, least_volume = 1e-12 * cell_area;
    for (Index j = j0; j <= j1; ++j)
        for (Index i = i0; i <= i1; ++i) {
            const Index cell = water.at(i, j);
            const WetSkin& sum =
                sums_[static_cast<std::size_t>((j - j0) * across + i - i0)];
            if (!(sum.volume > least_volume)) continue;
            slices.push_back({k, cell, sum.below(level[cell], centre)});
            under_[cell] += sum.volume / cell_area;
            width_[cell] += slices.back().below.area / cell_area;
        }
}
//! [cut_body]

void SolidFloating::find(const SpaceScene& scene, const ShallowGrid& water)
{
    settings.require_valid();
    const Index cells = water.nx * water.nz;
    if (level.size() != cells || !settings.displace) {
        level.resize(cells);
        under_ = VecX::Zero(cells);
    }
    for (Index c = 0; c < cells; ++c)
        if (!(under_[c] > 0)) level[c] = water.level(c);
    under_.setZero(cells);
    width_.setZero(cells);
    wet_area_.setZero(scene.bodies.count());
    slices.clear(), faces.clear();
    for (Index k = 0; k < scene.bodies.count(); ++k) cut_body(scene, water, k);
    for (Index c = 0; c < cells; ++c)  // and where a hull has left the column
        if (!(under_[c] > 0)) level[c] = water.level(c);
}

void SolidFloating::displace(const SpaceScene& scene, ShallowGrid& water)
{
    level.resize(0);
    find(scene, water);
    if (!settings.displace) return;
    for (Index c = 0; c < level.size(); ++c) {
        if (under_[c] > 0 && !(under_[c] < water.depth[c]))
            throw std::invalid_argument("solids displace " + shortest(under_[c]) +
                                        " m of the " + shortest(water.depth[c]) +
                                        " m of water in column " +
                                        std::to_string(c) + "; some must be left");
        water.depth[c] -= under_[c];
    }
}

void SolidFloating::drag(SpaceScene& scene, ShallowGrid& water, Real h) const
{
    const Real cell_area = water.dx * water.dx;
    for (const WetFace& face : faces) {
        const Index c = face.cell, i = c % water.nx, j = c / water.nx;
        const Real cell_mass = water.density * water.depth[c] * cell_area;
        if (!(cell_mass > 0)) continue;
        const Index fx = water.face_x(i, j), fz = water.face_z(i, j);
        const Vec3 flow((water.u[fx] + water.u[fx + 1]) / 2, 0,
                        (water.w[fz] + water.w[fz + water.nx]) / 2);
        const Vec3 v = velocity_at(scene.bodies, face.body, face.middle) - flow;
        const Real vn = std::max(v.dot(face.normal), 0.0);
        const Vec3 along = v - v.dot(face.normal) * face.normal;
        const Real vt = along.norm();
        // as long as a step may be: no drag turns the motion round that it brakes
        const Real light =
            scene.bodies.inverse_mass[6 * face.body] * wet_area_[face.body] +
            face.area / cell_mass;
        const auto braked = [&](Real coefficient, Real speed) {
            const Real k = water.density / 2 * coefficient * speed;
            return h * k * face.area / (1 + h * k * light);
        };
        const Vec3 J = -braked(settings.drag, vn) * vn * face.normal -
                       braked(settings.friction, vt) * along;
        push_at(scene.bodies, face.body, face.middle, J);
        // the water gets the opposite, half at each face that is open
        const auto give = [&](VecX& u, Index low, Index high, Index cell_low,
                              Index cell_high, bool open_low, bool open_high,
                              Real momentum) {
            const Real each = momentum / (open_low && open_high ? 2 : 1);
            const auto at = [&](Index f, Index other) {
                u[f] += 2 * each /
                        (water.density * cell_area *
                         (water.depth[c] + water.depth[other]));
            };
            if (open_low) at(low, cell_low);
            if (open_high) at(high, cell_high);
        };
        give(water.u, fx, fx + 1, c - 1, c + 1, i > 0 && is_wet(water, c, c - 1),
             i + 1 < water.nx && is_wet(water, c, c + 1), -J.x());
        give(water.w, fz, fz + water.nx, c - water.nx, c + water.nx,
             j > 0 && is_wet(water, c, c - water.nx),
             j + 1 < water.nz && is_wet(water, c, c + water.nx), -J.z());
    }
}

/// Columns below hulls, and the faces around them.
void SolidFloating::find_between(const ShallowGrid& water)
{
    number_.assign(static_cast<std::size_t>(water.nx * water.nz), -1);
    wet_cells_.clear(), between_.clear();
    for (const SolidSlice& s : slices) {
        int& number = number_[static_cast<std::size_t>(s.cell)];
        if (number >= 0) continue;
        number = static_cast<int>(wet_cells_.size());
        wet_cells_.push_back(s.cell);
    }
    for (const Index c : wet_cells_) {
        const Index i = c % water.nx, j = c / water.nx;
        const auto add = [&](Index low, Index high, Index face, bool along_x) {
            if (!is_wet(water, low, high)) return;
            // a face between two wet columns is added by the one that follows it
            if (low == c && number_[static_cast<std::size_t>(high)] >= 0) return;
            between_.push_back({low, high, face, along_x,
                                along_x ? water.u[face] : water.w[face], 0});
        };
        if (i > 0) add(c - 1, c, water.face_x(i, j), true);
        if (i + 1 < water.nx) add(c, c + 1, water.face_x(i + 1, j), true);
        if (j > 0) add(c - water.nx, c, water.face_z(i, j), false);
        if (j + 1 < water.nz) add(c, c + water.nx, water.face_z(i, j + 1), false);
    }
}

void SolidFloating::find_levels(const SpaceScene& scene, const ShallowGrid& water,
                                Real h)
{
    const Real lambda = h / water.dx, cell_area = water.dx * water.dx;
    hulls.clear();
    for (const Index c : wet_cells_)
        hulls.cells.push_back(
            {level[c],
             HullLevels::repayable(water.depth[c] -
                                       (level[c] - water.bed[c] - under_[c]),
                                   level[c] - water.bed[c], water.g, h),
             0, std::min(width_[c], 1.0)});
    const auto own = [&](Index c) {
        return std::max(level[c] - water.bed[c] - under_[c], 0.0);
    };
    for (const Between& f : between_) {
        const Real rise = level[f.high] - level[f.low];
        const Real next = f.before - lambda * water.g * rise,
                   depth = water.depth[next >= 0 ? f.low : f.high],
                   mean = (water.depth[f.low] + water.depth[f.high]) / 2,
                   mine = (own(f.low) + own(f.high)) / 2;
        const int a = number_[static_cast<std::size_t>(f.low)],
                  b = number_[static_cast<std::size_t>(f.high)];
        hulls.faces.push_back(
            {a, b, lambda * lambda * water.g * mine / mean * depth, rise});
        const Real flow = lambda * depth * f.before;
        if (a >= 0) hulls.cells[static_cast<std::size_t>(a)].inflow -= flow;
        if (b >= 0) hulls.cells[static_cast<std::size_t>(b)].inflow += flow;
    }
    const Bodies<6>& bodies = scene.bodies;
    for (Index k = 0; k < bodies.count(); ++k) {
        HullLevels::Body body;
        const Real light = bodies.inverse_mass[6 * k];
        body.moves = light > 0;
        if (body.moves) {
            const Mat3 R = rotation_of(bodies.x, k);
            const Mat3 W = R *
                           Vec3(bodies.inverse_mass.segment<3>(6 * k + 3))
                               .cwiseMax(1e-30)
                               .asDiagonal() *
                           R.transpose();
            // of heave, and of the turns about x and z
            const Real det = W(0, 0) * W(2, 2) - W(0, 2) * W(2, 0);
            body.mass.setZero();
            body.mass(0, 0) = 1 / light;
            body.mass(1, 1) = W(2, 2) / det, body.mass(2, 2) = W(0, 0) / det;
            body.mass(1, 2) = body.mass(2, 1) = -W(0, 2) / det;
        }
        const Vec3 spin = world_spin(bodies, k);
        body.velocity = {bodies.u[6 * k + 1] +
                             (body.moves ? h * scene.gravity.y() : 0),
                         spin.x(), spin.z()};
        hulls.bodies.push_back(body);
    }
    for (const SolidSlice& s : slices) {
        const Vec3 arm = s.below.middle - centre_of(bodies.x, s.body);
        hulls.slices.push_back(
            {number_[static_cast<std::size_t>(s.cell)],
             static_cast<int>(s.body),
             s.below.volume,
             s.below.area / cell_area / std::max(width_[s.cell], 1.0),
             {1, -arm.z(), arm.x()}});
    }
    // what the skin's motion adds to a slice beside the rise of its waterline
    for (const WetFace& f : faces)
        if (const int c = number_[static_cast<std::size_t>(f.cell)]; c >= 0)
            hulls.cells[static_cast<std::size_t>(c)].inflow +=
                h / cell_area * f.area *
                velocity_at(bodies, f.body, f.middle).dot(f.normal);
    for (const HullLevels::Slice& s : hulls.slices) {
        const Vec3 spin = world_spin(bodies, s.body);
        hulls.cells[static_cast<std::size_t>(s.cell)].inflow +=
            h * s.width *
            (bodies.u[6 * s.body + 1] + s.rising[1] * spin.x() +
             s.rising[2] * spin.z());
    }
    hulls.solve(h, water.density * water.g, cell_area);
    for (std::size_t c = 0; c < wet_cells_.size(); ++c)
        level[wet_cells_[c]] = hulls.cells[c].level;
}

void SolidFloating::push(SpaceScene& scene, ShallowGrid& water, Real h)
{
    require_step(h);
    drag(scene, water, h);
    const Real cell_area = water.dx * water.dx;
    find_between(water);
    if (settings.displace) {
        find_levels(scene, water, h);
        for (const Index c : wet_cells_) under_[c] = 0;
        for (std::size_t s = 0; s < slices.size(); ++s)
            under_[slices[s].cell] += hulls.slices[s].volume / cell_area;
    }
    push_water(water, h);
    rise_.assign(wet_cells_.size(), Vec2(0, 0));
    for (Between& f : between_) {
        const Real slope = (level[f.high] - level[f.low]) / water.dx;
        f.rise = slope;
        if (settings.displace) {  // (28.20)
            const Real under = (under_[f.low] + under_[f.high]) / 2,
                       mean = (water.depth[f.low] + water.depth[f.high]) / 2,
                       whole = (level[f.low] - water.bed[f.low] + level[f.high] -
                                water.bed[f.high]) /
                               2,
                       pushed = std::min(under, whole);
            f.rise = under > 0 ? pushed / under * slope : 0;
            (f.along_x ? water.u : water.w)[f.face] =
                f.before - h * water.g * (whole - pushed) / mean * slope;
        }
        for (const Index c : {f.low, f.high})
            if (const int n = number_[static_cast<std::size_t>(c)]; n >= 0)
                rise_[static_cast<std::size_t>(n)][f.along_x ? 0 : 1] += f.rise / 2;
    }
    const Real weight = h * water.density * water.g;
    for (std::size_t s = 0; s < slices.size(); ++s) {
        const SolidSlice& slice = slices[s];
        const Vec2 rise = rise_[static_cast<std::size_t>(
            number_[static_cast<std::size_t>(slice.cell)])];
        const Vec3 up(-rise.x(), 1, -rise.y());
        const SubmergedSolid& below = slice.below;
        push_at(scene.bodies, slice.body, below.centroid,
                weight * below.volume * up);
        if (!settings.displace || !(below.area > 0)) continue;
        Vec3 at = below.middle;
        at.y() = level[slice.cell];
        push_at(scene.bodies, slice.body, at,
                weight * (hulls.slices[s].volume - below.volume) * up);
    }
    if (!settings.displace) return;
    // The next step cuts at these levels. The blow of a hull that hits the water is
    // no height: where hulls cover columns whole it is left out.
    Real low = infinity, high = -infinity;
    for (const Between& f : between_)
        for (const Index c : {f.low, f.high})
            if (number_[static_cast<std::size_t>(c)] < 0) {
                low = std::min(low, level[c]);
                high = std::max(high, level[c]);
            }
    for (const Index c : wet_cells_)
        if (width_[c] > 0.999 && low <= high) {
            const Real room = (high - water.bed[c]) / 4;
            level[c] = std::clamp(level[c], low - room, high + room);
        }
}

}  // namespace rigid
