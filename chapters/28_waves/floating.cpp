// The functions of floating.hpp.
#include "chapters/28_waves/floating.hpp"

#include "chapters/11_rotation/rounded_outline.hpp"

#include <algorithm>

namespace rigid {
namespace {

/// An impulse on body k at a point; the world and what cannot move take none.
void push_at(Bodies<3>& bodies, Index k, const Vec2& at, const Vec2& impulse)
{
    const Vec2 arm = at - bodies.position(k).head<2>();
    const Vec<3> P(impulse.x(), impulse.y(), cross2(arm, impulse));
    bodies.velocity(k) += bodies.apply_inverse_mass(k, P);
}

/// What of the thickness of a cell is water's, as its level says.
Real thickness_of(const ShallowWater& water, Index cell)
{
    return water.level[cell] - water.bed[cell];
}

/// Between two walls, with water enough that it may have a velocity.
bool is_open(const ShallowWater& water, Index face)
{
    return face > 0 && face < water.cells() &&
           water.depth[face - 1] + water.depth[face] > 2e-9;
}

}  // namespace

void FloatSettings::require_valid() const
{
    const auto refuse = [](const char* name, Real value, const char* right) {
        throw std::invalid_argument(std::string(name) + " is " + shortest(value) +
                                    "; it must be " + right);
    };
    if (!(drag >= 0) || !std::isfinite(drag))
        refuse("the drag", drag, "zero or positive and finite");
    if (!(friction >= 0) || !std::isfinite(friction))
        refuse("the friction of the water", friction,
               "zero or positive and finite");
}

void Floating::place_outlines(const RigidScene& scene)
{
    const auto K = static_cast<std::size_t>(scene.bodies.count());
    own_.resize(K), placed_.resize(K), sized_.resize(K), radius_.resize(K, -1);
    for (std::size_t k = 0; k < K; ++k) {
        const Polygon& shape = scene.shapes[k];
        if (sized_[k] != shape.vertices.size() || radius_[k] != shape.radius) {
            own_[k] = shape.radius > 0
                          ? rounded_outline(shape.vertices, shape.radius)
                          : shape.vertices;
            sized_[k] = shape.vertices.size(), radius_[k] = shape.radius;
        }
        const Vec<3> at = scene.bodies.position(static_cast<Index>(k));
        const Real c = cos(at[2]), s = sin(at[2]);
        placed_[k].clear();
        for (const Vec2& r : own_[k])
            placed_[k].emplace_back(at[0] + c * r.x() - s * r.y(),
                                    at[1] + s * r.x() + c * r.y());
    }
}

//! [slices]
void Floating::find_slices(const RigidScene& scene, const ShallowWater& water)
{
    slices.clear();
    under_.setZero(water.cells());
    width_.setZero(water.cells());
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const std::vector<Vec2>& outline = placed_[static_cast<std::size_t>(k)];
        Real left = infinity, right = -infinity;
        for (const Vec2& p : outline)
            left = std::min(left, p.x()), right = std::max(right, p.x());
        const Index first = water.cell_at(left), last = water.cell_at(right);
        for (Index i = first; i <= last; ++i) {
            const Real x = water.origin + water.dx * static_cast<Real>(i);
            cut(outline, Keep::right_of, x, strip_);
            cut(strip_, Keep::left_of, x + water.dx, half_);
            cut(half_, Keep::below, water.level[i], wet_);
            const Submerged below = measure_below(wet_, water.level[i], memory_);
            if (!(below.area > 0)) continue;
            slices.push_back({k, i, below});
            under_[i] += below.area / water.dx;
            width_[i] += below.width / water.dx;
        }
    }
}
//! [slices]

void Floating::find(const RigidScene& scene, ShallowWater& water)
{
    settings.require_valid();
    place_outlines(scene);
    // below a hull the level is what the last step found; elsewhere that of the water
    for (Index i = 0; i < water.cells(); ++i)
        if (!settings.displace || i >= under_.size() || !(under_[i] > 0))
            water.level[i] = water.bed[i] + water.depth[i];
    find_slices(scene, water);
    for (Index i = 0; i < water.cells(); ++i)  // and where a hull has left the cell
        if (!(under_[i] > 0)) water.level[i] = water.bed[i] + water.depth[i];
    find_edges(scene, water);
}

void Floating::displace(const RigidScene& scene, ShallowWater& water)
{
    settings.require_valid();
    level_water(water);
    place_outlines(scene);
    find_slices(scene, water);
    for (Index i = 0; i < water.cells(); ++i) {
        const Real displaced = settings.displace ? under_[i] : 0;
        if (displaced > 0 && !(displaced < water.depth[i]))
            throw std::invalid_argument(
                "bodies displace " + shortest(displaced) + " m of the " +
                shortest(water.depth[i]) + " m of water at x = " +
                shortest(water.x_of(i)) + " m; some must be left");
        water.depth[i] -= displaced;
    }
}

void Floating::find_edges(const RigidScene& scene, const ShallowWater& water)
{
    edges.clear();
    wet_length_.setZero(scene.bodies.count());
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const std::vector<Vec2>& outline = placed_[static_cast<std::size_t>(k)];
        for (std::size_t i = 0; i < outline.size(); ++i) {
            const Vec2 &a = outline[i],
                       &b = outline[i + 1 < outline.size() ? i + 1 : 0];
            const Vec2 d = b - a;
            const Index first = water.cell_at(std::min(a.x(), b.x())),
                        last = water.cell_at(std::max(a.x(), b.x()));
            for (Index cell = first; cell <= last; ++cell) {
                const Real x = water.origin + water.dx * static_cast<Real>(cell);
                Real from = 0, to = 1;
                const auto keep = [&](Real start,
                                      Real slope) {  // start + t slope ≥ 0
                    if (slope > 0) from = std::max(from, -start / slope);
                    else if (slope < 0) to = std::min(to, -start / slope);
                    else if (start < 0) to = 0;
                };
                if (first != last)
                    keep(a.x() - x, d.x()), keep(x + water.dx - a.x(), -d.x());
                keep(water.level[cell] - a.y(), -d.y());
                const Real length = (to - from) * d.norm();
                if (!(length > 0)) continue;
                edges.push_back({k, cell, a + (from + to) / 2 * d,
                                 -perpendicular(d) / d.norm(), length});
                wet_length_[k] += length;
            }
        }
    }
}

//! [find_levels]
/// Writes what HullLevels needs to know, and takes levels and volumes from it.
void Floating::find_levels(const RigidScene& scene, ShallowWater& water, Real h)
{
    const Index n = water.cells();
    const Real lambda = h / water.dx;
    hulls.clear();
    number_.assign(static_cast<std::size_t>(n), -1);
    // the flow through a face before its slope pushes, and the depth that it has
    const auto depth_at = [&](Index f) {
        if (f == 0) return water.depth[0];
        if (f == n) return water.depth[n - 1];
        const Real next =
            water.u[f] - lambda * water.g * (water.level[f] - water.level[f - 1]);
        return water.depth[next >= 0 ? f - 1 : f];
    };
    for (Index i = 0; i < n; ++i) {
        if (!(under_[i] > 0)) continue;
        number_[static_cast<std::size_t>(i)] = static_cast<int>(hulls.cells.size());
        const Real thickness = water.level[i] - water.bed[i] - under_[i];
        const Real out =
            lambda * (depth_at(i + 1) * water.u[i + 1] - depth_at(i) * water.u[i]);
        hulls.cells.push_back(
            {water.level[i],
             HullLevels::repayable(water.depth[i] - thickness,
                                   thickness_of(water, i), water.g, h),
             -out, std::min(width_[i], 1.0)});
    }
    const auto own = [&](Index i) {
        return std::max(thickness_of(water, i) - under_[i], 0.0);
    };
    for (Index f = 1; f < n; ++f) {
        const int a = number_[static_cast<std::size_t>(f - 1)],
                  b = number_[static_cast<std::size_t>(f)];
        if ((a < 0 && b < 0) || !is_open(water, f)) continue;
        const Real mine = (own(f - 1) + own(f)) / 2,
                   mean = (water.depth[f - 1] + water.depth[f]) / 2;
        hulls.faces.push_back(
            {a, b, lambda * lambda * water.g * mine / mean * depth_at(f),
             water.level[f] - water.level[f - 1]});
    }
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Real light = scene.bodies.inverse_mass[3 * k + 1],
                   turns = scene.bodies.inverse_mass[3 * k + 2];
        HullLevels::Body body;
        body.moves = light > 0;
        if (body.moves)
            body.mass =
                Vec3(1 / light, turns > 0 ? 1 / turns : 1e30, 1).asDiagonal();
        const auto u = scene.bodies.velocity(k);
        // what moves falls in this step, too; others go where they are driven
        body.velocity = {u[1] + (body.moves ? h * scene.gravity.y() : 0), u[2], 0};
        hulls.bodies.push_back(body);
    }
    for (const Slice& s : slices)
        hulls.slices.push_back(
            {number_[static_cast<std::size_t>(s.cell)],
             static_cast<int>(s.body),
             s.below.area,
             s.below.width / water.dx / std::max(width_[s.cell], 1.0),
             {1, s.below.middle - scene.bodies.position(s.body)[0], 0}});
    // what the skin's motion adds to a slice beside the rise of its waterline: a hull
    // that goes ahead, or turns, comes into a column through its sides
    const auto cell_of = [&](Index i) -> HullLevels::Cell& {
        return hulls
            .cells[static_cast<std::size_t>(number_[static_cast<std::size_t>(i)])];
    };
    for (const WetEdge& e : edges)
        if (under_[e.cell] > 0)
            cell_of(e.cell).inflow +=
                h / water.dx * e.length *
                velocity_at(scene.bodies, e.body, e.middle).dot(e.normal);
    for (const HullLevels::Slice& s : hulls.slices) {
        const auto u = scene.bodies.velocity(s.body);
        hulls.cells[static_cast<std::size_t>(s.cell)].inflow +=
            h * s.width * (s.rising[0] * u[1] + s.rising[1] * u[2]);
    }
    hulls.solve(h, water.density * water.g, water.dx);
    for (Index i = 0; i < n; ++i)
        if (const int c = number_[static_cast<std::size_t>(i)]; c >= 0)
            water.level[i] = hulls.cells[static_cast<std::size_t>(c)].level;
}
//! [find_levels]

//! [push_bodies]
/// (28.18), and (28.20) for the water beside and below hulls.
void Floating::push_both(RigidScene& scene, ShallowWater& water, Real h)
{
    const Index n = water.cells();
    // the thickness of bodies at the end of the step
    under_.setZero(n);
    for (std::size_t s = 0; s < slices.size(); ++s)
        under_[slices[s].cell] += hulls.slices[s].volume / water.dx;
    rise_.setZero(n + 1), before_ = water.u;
    push_water(water, h);
    for (Index f = 1; f < n; ++f) {
        const Real under = (under_[f - 1] + under_[f]) / 2;
        if (number_[static_cast<std::size_t>(f - 1)] < 0 &&
            number_[static_cast<std::size_t>(f)] < 0)
            continue;
        if (!is_open(water, f)) continue;
        const Real mean = (water.depth[f - 1] + water.depth[f]) / 2,
                   whole = (water.level[f - 1] - water.bed[f - 1] + water.level[f] -
                            water.bed[f]) /
                           2,
                   pushed = std::min(under, whole),
                   slope = (water.level[f] - water.level[f - 1]) / water.dx;
        rise_[f] = under > 0 ? pushed / under * slope : 0;
        water.u[f] = (before_[f] - h * water.g * (whole - pushed) / mean * slope) /
                     (1 + h * water.damping[f]);
    }
    const Real weight = h * water.density * water.g;
    for (std::size_t s = 0; s < slices.size(); ++s) {
        const Slice& slice = slices[s];
        const Vec2 up(-(rise_[slice.cell] + rise_[slice.cell + 1]) / 2, 1);
        const Submerged& below = slice.below;
        push_at(scene.bodies, slice.body, below.centroid, weight * below.area * up);
        // what the waterline has risen by in this step
        const Real more = hulls.slices[s].volume - below.area;
        if (below.width > 0)
            push_at(scene.bodies, slice.body,
                    {below.middle, water.level[slice.cell]}, weight * more * up);
    }
    // The next step cuts at these levels. The blow of a hull that hits the water is
    // no height: where hulls cover cells whole it is left out.
    Real low = infinity, high = -infinity;
    for (Index f = 1; f < n; ++f) {
        const bool a = number_[static_cast<std::size_t>(f - 1)] < 0,
                   b = number_[static_cast<std::size_t>(f)] < 0;
        if (a == b) continue;
        const Real open = water.level[a ? f - 1 : f];
        low = std::min(low, open), high = std::max(high, open);
    }
    for (Index i = 0; i < n; ++i)
        if (number_[static_cast<std::size_t>(i)] >= 0 && width_[i] > 0.999 &&
            low <= high) {
            const Real room = (high - water.bed[i]) / 4;
            water.level[i] = std::clamp(water.level[i], low - room, high + room);
        }
}
//! [push_bodies]

//! [archimedes]
/// Bodies in water that takes no notice of them.
void Floating::push_bodies(RigidScene& scene, const ShallowWater& water,
                           Real h) const
{
    const Real weight = h * water.density * water.g;
    const auto rise = [&](Index f) {
        return is_open(water, f) ? (water.level[f] - water.level[f - 1]) / water.dx
                                 : 0;
    };
    for (const Slice& slice : slices) {
        const Real slope = (rise(slice.cell) + rise(slice.cell + 1)) / 2;
        push_at(scene.bodies, slice.body, slice.below.centroid,
                weight * slice.below.area * Vec2(-slope, 1));
    }
}
//! [archimedes]

//! [drag]
void Floating::drag(RigidScene& scene, ShallowWater& water, Real h) const
{
    for (const WetEdge& edge : edges) {
        const Index l = edge.cell, r = l + 1;
        const Real cell_mass = water.density * water.depth[l] * water.dx;
        if (!(cell_mass > 0)) continue;
        const Vec2 flow((water.u[l] + water.u[r]) / 2, 0);
        const Vec2 v = velocity_at(scene.bodies, edge.body, edge.middle) - flow;
        const Vec2 along = perpendicular(edge.normal);
        const Real vn = std::max(v.dot(edge.normal), 0.0), vt = v.dot(along);
        // as long as a step may be: no drag turns the motion round that it brakes
        const Real light =
            scene.bodies.inverse_mass[3 * edge.body] * wet_length_[edge.body] +
            edge.length / cell_mass;
        const auto braked = [&](Real coefficient, Real speed) {
            const Real k = water.density / 2 * coefficient * std::abs(speed);
            return h * k * speed * edge.length / (1 + h * k * light);
        };
        const Vec2 J = -braked(settings.drag, vn) * edge.normal -
                       braked(settings.friction, vt) * along;
        push_at(scene.bodies, edge.body, edge.middle, J);
        // the water gets the opposite, half at each face that is open
        const bool at_left = is_open(water, l), at_right = is_open(water, r);
        const Real each = -J.x() / (at_left && at_right ? 2 : 1);
        for (const Index f : {l, r})
            if (f == l ? at_left : at_right)
                water.u[f] += 2 * each /
                              (water.density * water.dx *
                               (water.depth[f - 1] + water.depth[f]));
    }
}
//! [drag]

void Floating::push(RigidScene& scene, ShallowWater& water, Real h)
{
    require_step(h);
    // first: a body that is held up already, and not yet pulled down by its weight,
    // would be braked at rest
    drag(scene, water, h);
    if (settings.displace) {
        find_levels(scene, water, h);
        push_both(scene, water, h);
    } else {
        push_water(water, h);
        push_bodies(scene, water, h);
    }
}

}  // namespace rigid
