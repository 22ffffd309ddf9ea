// The functions of floating.hpp.
#include "chapters/29_waves/floating.hpp"

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
    if (!(lid >= 0 && lid <= 0.95))
        refuse("the part of a hull that lifts the surface", lid, "from 0 to 0.95");
    if (!(drag >= 0) || !std::isfinite(drag))
        refuse("the drag", drag, "zero or positive and finite");
    if (!(friction >= 0) || !std::isfinite(friction))
        refuse("the friction of the water", friction,
               "zero or positive and finite");
}

void Floating::place_outlines(const RigidScene& scene)
{
    const auto K = static_cast<std::size_t>(scene.bodies.count());
    own_.resize(K), placed_.resize(K), made_of_.resize(K);
    for (std::size_t k = 0; k < K; ++k) {
        const Polygon& shape = scene.shapes[k];
        Polygon& known = made_of_[k];
        if (known.vertices != shape.vertices || known.radius != shape.radius) {
            own_[k] = shape.radius > 0
                          ? rounded_outline(shape.vertices, shape.radius)
                          : shape.vertices;
            known = shape;
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

//! [levels]
/// One round of Newton's method for (29.15). Returns the largest change [m].
Real Floating::solve_levels(ShallowWater& water)
{
    const Real sigma = settings.lid;
    Real most = 0;
    for (Index i = 0; i < water.cells(); ++i) {
        const Real free = water.bed[i] + water.depth[i];
        Real next = free;
        if (under_[i] > 0 && water.depth[i] > 0) {
            const Real off = free + sigma * under_[i] - water.level[i];
            // bodies may overlap: no waterline is wider than its cell
            next = water.level[i] + off / (1 - sigma * std::min(width_[i], 1.0));
            // b is at most the depth below the surface
            next =
                std::clamp(next, free, free + water.depth[i] * sigma / (1 - sigma));
        }
        most = std::max(most, std::abs(next - water.level[i]));
        water.level[i] = next;
    }
    return most;
}
//! [levels]

void Floating::find(const RigidScene& scene, ShallowWater& water)
{
    settings.require_valid();
    place_outlines(scene);
    rounds = 0;
    do {
        find_slices(scene, water);
        ++rounds;
        // two at least, so that slices are those of the levels: pushed by those of a
        // step ago, a body would gain energy
    } while ((solve_levels(water) > 1e-9 || rounds < 2) && rounds < 10);
    find_edges(scene, water);

    // what each has of the slope at a face: together the whole depth there
    share_.setZero(water.cells() + 1);
    for (Index f = 1; f < water.cells(); ++f) {
        const Real under = (under_[f - 1] + under_[f]) / 2;
        water.part[f] = 1;
        if (!(under > 0) || !is_open(water, f)) continue;
        const Real depth = (water.depth[f - 1] + water.depth[f]) / 2;
        const Real whole = (water.level[f - 1] - water.bed[f - 1] + water.level[f] -
                            water.bed[f]) /
                           2;
        const Real pushed = std::min(under, whole);
        share_[f] = pushed / under;
        water.part[f] = (whole - pushed) / depth;
    }
}

void Floating::displace(const RigidScene& scene, ShallowWater& water)
{
    settings.require_valid();
    level_water(water);
    place_outlines(scene);
    find_slices(scene, water);
    for (Index i = 0; i < water.cells(); ++i) {
        const Real displaced = settings.lid * under_[i];
        if (displaced > 0 && !(displaced < water.depth[i]))
            throw std::invalid_argument(
                "bodies displace " + shortest(displaced) + " m of the " +
                shortest(water.depth[i]) + " m of water at x = " +
                shortest(water.x_of(i)) + " m; some must be left");
    }
    for (Index i = 0; i < water.cells(); ++i)
        water.depth[i] -= settings.lid * under_[i];
}

void Floating::find_edges(const RigidScene& scene, const ShallowWater& water)
{
    edges.clear();
    wet_length_.setZero(scene.bodies.count());
    wet_in_cell_.setZero(water.cells());
    const Real end = water.origin + water.dx * static_cast<Real>(water.cells());
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
                else  // beyond the walls is no water
                    keep(a.x() - water.origin, d.x()), keep(end - a.x(), -d.x());
                keep(water.level[cell] - a.y(), -d.y());
                const Real length = (to - from) * d.norm();
                if (!(length > 0)) continue;
                edges.push_back({k, cell, a + (from + to) / 2 * d,
                                 -perpendicular(d) / d.norm(), length});
                wet_length_[k] += length;
                wet_in_cell_[cell] += length;
            }
        }
    }
}

//! [push_bodies]
void Floating::push_bodies(RigidScene& scene, const ShallowWater& water,
                           Real h) const
{
    const Real weight = h * water.density * water.g;
    const auto rise = [&](Index f) {
        return is_open(water, f)
                   ? share_[f] * (water.level[f] - water.level[f - 1]) / water.dx
                   : 0;
    };
    for (const Slice& slice : slices) {
        const Real slope = (rise(slice.cell) + rise(slice.cell + 1)) / 2;
        push_at(scene.bodies, slice.body, slice.below.centroid,
                weight * slice.below.area * Vec2(-slope, 1));
    }
}
//! [push_bodies]

//! [drag]
/// What the water gives to a body at one edge, (29.25): drag across it, friction
/// along it.
Vec2 Floating::drag_on(const WetEdge& edge, const Bodies<3>& bodies,
                       const ShallowWater& water, Real h) const
{
    const Index b = edge.body, cell = edge.cell;
    const Real cell_mass = water.density * water.depth[cell] * water.dx;
    if (!(cell_mass > 0)) return {0, 0};
    const Vec2 flow((water.u[cell] + water.u[cell + 1]) / 2, 0);
    const Vec2 v = velocity_at(bodies, b, edge.middle) - flow;
    const Vec2 along = perpendicular(edge.normal);
    const Vec2 arm = edge.middle - bodies.position(b).head<2>();
    const Real light =
        wet_length_[b] * (bodies.inverse_mass[3 * b] +
                          bodies.inverse_mass[3 * b + 2] * arm.squaredNorm()) +
        wet_in_cell_[cell] / cell_mass;
    const auto braked = [&](Real coefficient, Real speed) {
        const Real k = water.density / 2 * coefficient * std::abs(speed);
        return h * k * speed * edge.length / (1 + h * k * light);
    };
    const Real vn = std::max(v.dot(edge.normal), 0.0), vt = v.dot(along);
    return -braked(settings.drag, vn) * edge.normal -
           braked(settings.friction, vt) * along;
}

void Floating::drag(RigidScene& scene, ShallowWater& water, Real h)
{
    given_.clear();
    for (const WetEdge& edge : edges)
        given_.push_back(drag_on(edge, scene.bodies, water, h));
    for (std::size_t i = 0; i < edges.size(); ++i) {
        const Vec2& J = given_[i];
        push_at(scene.bodies, edges[i].body, edges[i].middle, J);
        // the water gets the opposite, half at each face of the cell; of one that is
        // closed the wall takes it
        const Index l = edges[i].cell, r = l + 1;
        for (const Index f : {l, r})
            if (is_open(water, f))
                water.u[f] -= J.x() / (water.density * water.dx *
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
    push_water(water, h);
    push_bodies(scene, water, h);
}

Real Floating::stable_step(const ShallowWater& water) const
{
    Real fastest = 0;
    for (Index i = 0; i < water.cells(); ++i) {
        const Real flow = std::max(std::abs(water.u[i]), std::abs(water.u[i + 1]));
        const bool covered = i < under_.size() && under_[i] > 0;
        const Real lifted =
            covered ? 1 - settings.lid * std::min(width_[i], 1.0) : 1;
        fastest =
            std::max(fastest, flow + std::sqrt(water.g * water.depth[i] / lifted));
    }
    return water.dx / fastest;
}

}  // namespace rigid
