// The functions of fast_bodies.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/12_contact_manifolds/fast_bodies.hpp"

#include <algorithm>
#include <tuple>

namespace rigid {

namespace {

int number_of(const RigidScene& scene, const MovingShape& m)
{
    return static_cast<int>(m.shape - &scene.shapes[0]);
}

/// How far any point of it goes at most [m]
/// \param turning  from its centroid to its farthest vertex [m]
Real length_of_way(const MovingShape& m, Real turning)
{
    const Vec<3> way = m.way();
    if (way.isZero(0)) return 0;
    return hypot(way[0], way[1]) + std::abs(way[2]) * turning;
}

/// Whether two shapes have a row in this step that holds them: they are where it was found, and go no farther than they are
/// long. (What goes on alone, after the other one has been stopped, does not: its row counted on the other's way.)
struct HeldPairs {
    const RigidScene& scene;
    const VecX& x_found;
    const PlacedShapes& placed;
    const std::vector<TouchingPair>& touching;

    bool stays_near(const MovingShape& m) const
    {
        const int k = number_of(scene, m);
        const auto at = static_cast<std::size_t>(k);
        return m.from == x_found.segment<3>(3 * k) &&
               length_of_way(m, placed.turning[at]) <=
                   2 * std::max(placed.inner[at], placed.turning[at]);
    }
    bool operator()(const MovingShape& one, const MovingShape& other) const
    {
        if (!stays_near(one) || !stays_near(other)) return false;
        const auto [a, b] =
            std::minmax({number_of(scene, one), number_of(scene, other)});
        const auto at = first_from(touching, pair_key(a, b));
        return at != touching.end() && at->a == a && at->b == b;
    }
    bool operator()(const HalfSpace&, const MovingShape&) const
    {
        return false;  // asked only where rows do not look ahead
    }
};

}  // namespace

//! [fast]
void stop_fast_bodies(RigidScene& scene, const StepSettings& settings,
                      const StepData<3>& now, const PlacedShapes& placed,
                      const ChainEdges& edges, const PairFinder& finder,
                      const std::vector<TouchingPair>& touching, FastBodies& fast)
{
    const VecX& x_found = now.x_found;
    const HeldPairs is_held{scene, x_found, placed, touching};
    const Real margin = settings.margin * now.length;
    const auto K = static_cast<std::size_t>(scene.bodies.count());
    const auto motion = [&](Index k) {
        return MovingShape{&scene.shapes[static_cast<std::size_t>(k)],
                           x_found.segment<3>(3 * k), scene.bodies.position(k)};
    };
    const auto inner_of = [&](int k) {
        return placed.inner[static_cast<std::size_t>(k)];
    };
    const auto turning_of = [&](int k) {
        return placed.turning[static_cast<std::size_t>(k)];
    };
    // where the centroid of its shape is
    const auto middle_at = [&](const MovingShape& m, const Vec<3>& pose) -> Vec2 {
        if (scene.carried.empty()) return pose.head<2>();
        const auto shape = static_cast<std::size_t>(number_of(scene, m));
        const auto [s, c] = sine_and_cosine(pose[2]);
        const Vec2& r = scene.carried[shape].middle;
        return pose.head<2>() + c * r + s * perpendicular(r);
    };
    const auto how_far = [&](int k) {
        return length_of_way(motion(k), turning_of(k));
    };
    // most go less far even along the axes
    const auto goes_beyond = [&](int k, Real limit) {
        const Vec<3> way = motion(k).way().cwiseAbs();
        return way[0] + way[1] + way[2] * turning_of(k) > limit &&
               how_far(k) > limit;
    };
    const auto for_each_active = [&](const auto& visit) {
        for (const int body : now.active)
            scene.for_each_shape(
                body, [&](Index shape) { visit(static_cast<int>(shape)); });
    };
    fast.bodies.clear();
    fast.impacts = fast.rounds = 0;
    for_each_active([&](int k) {
        const auto at = static_cast<std::size_t>(k);
        // what nothing can move is not stopped either
        const bool goes_on =
            (at < fast.goes_on.size() && fast.goes_on[at]) || !finder.moves[at];
        if (!goes_on && goes_beyond(k, 0.5 * inner_of(k))) fast.bodies.push_back(k);
    });
    if (fast.bodies.empty()) return;
    fast.is_fast.assign(K, 0);
    for (const int k : fast.bodies) fast.is_fast[static_cast<std::size_t>(k)] = 1;

    // all that a body can reach on its way, however it turns
    const auto reached = [&](int k) {
        const MovingShape m = motion(k);
        const Vec2 from = m.from.head<2>(), to = m.to.head<2>();
        return grown(Box{from.cwiseMin(to), from.cwiseMax(to)},
                     turning_of(k) + m.shape->radius + margin);
    };
    Real others_move = 0;  // at most [m]
    for_each_active([&](int k) {
        if (!fast.is_fast[static_cast<std::size_t>(k)] &&
            goes_beyond(k, others_move))
            others_move = how_far(k);
    });
    fast.inner.assign(K, 0);
    fast.part.assign(K, 1);
    fast.swept.clear();
    for (const int k : fast.bodies) {
        fast.inner[static_cast<std::size_t>(k)] = inner_of(k);
        fast.swept.push_back(reached(k));
    }
    // all shapes of a body stop with the first of them
    const auto part_of = [&](int k) -> Real& {
        return fast.part[static_cast<std::size_t>(scene.carrier(k))];
    };
    const auto hold = [&](int k, const Impact& impact) {
        if (impact.hit) part_of(k) = std::min(part_of(k), impact.part);
    };
    // of what has its row, or is close already, only that it gets deeper than half its
    // inner radius, or than it is by an eighth
    const auto first_impact = [&](const auto& other, const MovingShape& moving,
                                  Real inner, bool edge = false) {
        const bool held = inner > 0 && !edge && is_held(other, moving);
        const Real target = held   ? -inner / 2
                            : edge ? -std::min(inner, margin) / 2
                                   : margin / 4;
        Impact impact =
            time_of_impact(other, moving, target,
                           target < 0 ? -target / 4 : margin / 4, fast.memory);
        fast.rounds += impact.rounds;
        if (!impact.close) return impact;
        // what has no inside must not get past the middle of its way to the other
        const Real start = impact.start,
                   deep = inner > 0 ? std::min(-inner / 2, start - inner / 8)
                                    : start / 2;
        impact = time_of_impact(other, moving, deep,
                                inner > 0 ? inner / 16 : std::abs(start) / 8,
                                fast.memory);
        fast.rounds += impact.rounds;
        return impact;
    };
    // a half-space: its rows hold what comes, and nothing is behind it
    const auto impact_on_wall = [&](const HalfSpace& wall,
                                    const MovingShape& moving, Real inner) {
        if (!fast.have_rows) return first_impact(wall, moving, inner);
        const Real deep = std::max(inner, margin) / 2;
        Impact impact = time_of_impact(wall, moving, -deep, deep / 8, fast.memory);
        fast.rounds += impact.rounds;
        if (!impact.close) return impact;
        impact = time_of_impact(wall, moving, impact.start - deep / 4, deep / 8,
                                fast.memory);
        fast.rounds += impact.rounds;
        return impact;
    };
    // how deep a body may be in an edge: its centroid must stay in front of it
    const auto inner_at_edge = [&](const MovingShape& moving, const Placed& edge,
                                   Real inner) {
        Real front = margin;
        for (const Vec<3>& x : {moving.from, moving.to})
            front = std::min(
                front,
                edge.normal(0).dot(middle_at(moving, x) - edge.vertex(0)) / 2);
        return std::max(inner, front > margin / 100 ? front : 0);
    };
    const auto impact_on_edge = [&](const MovingShape& other,
                                    const MovingShape& moving, const Placed& edge,
                                    Real inner) {
        const Impact near =
            time_of_impact(other, moving, margin / 4, margin / 4, fast.memory);
        fast.rounds += near.rounds;
        if (!near.hit && !near.close) return near;
        // what is close has its row
        if (near.close || is_held(other, moving))
            inner = inner_at_edge(moving, edge, inner);
        return first_impact(other, moving, inner, inner > 0);
    };
    // what slides over a seam does not catch on it, (12.13)
    const auto is_hidden = [&](const MovingShape& moving, Real inner, int b,
                               Real part) {
        if (!fast.seams || !stands(scene, b)) return false;
        fast.memory.b.move(*moving.shape, moving.at(part));
        const Placed shape = placed.of(b);
        const Manifold m = collide(shape, fast.memory.b.view(), {margin});
        const Box box = grown(box_of(shape), margin);
        const Real flush = flush_within(margin, inner);
        return all_hidden(m, false, [&](const Vec2& p, const Vec2& n) {
            for (const HalfSpace& wall : scene.walls)
                if (hides(wall, shape, p, n, flush)) return true;
            bool hidden = false;
            finder.near(box, [&](int c) {
                hidden = hidden || (c != b && !edges.has(c) && stands(scene, c) &&
                                    finder.may_touch(number_of(scene, moving), c) &&
                                    overlap(box, box_of(placed.of(c))) &&
                                    hides(placed.of(c), shape, p, n, flush));
            });
            return hidden;
        });
    };
    for (std::size_t i = 0; i < fast.bodies.size(); ++i) {
        const int a = fast.bodies[i];
        const MovingShape moving = motion(a);
        const Real inner_a = fast.inner[static_cast<std::size_t>(a)];
        finder.near(grown(fast.swept[i], others_move), [&](int b) {
            if (fast.is_fast[static_cast<std::size_t>(b)] ||
                !overlap(fast.swept[i], reached(b)) || !finder.may_touch(a, b))
                return;
            if (edges.has(b)) {  // only what comes from before it
                if (!is_behind(placed.of(b), middle_at(moving, moving.from)))
                    hold(a,
                         impact_on_edge(motion(b), moving, placed.of(b), inner_a));
                return;
            }
            const Real inner = std::max(inner_a, inner_of(b));
            Impact impact = first_impact(motion(b), moving, inner);
            if (impact.hit && is_hidden(moving, inner_a, b, impact.part)) {
                impact = time_of_impact(motion(b), moving, -inner / 2, inner / 16,
                                        fast.memory);
                fast.rounds += impact.rounds;
            }
            hold(a, impact);
        });
        for (const HalfSpace& wall : scene.walls)
            hold(a, impact_on_wall(wall, moving, inner_a));
    }
    fast.pairs.clear();
    fast.sweep.order.clear();  // each step has other fast bodies
    overlapping_pairs(fast.swept, fast.sweep, [&](int i, int j) {
        const int a = fast.bodies[static_cast<std::size_t>(i)],
                  b = fast.bodies[static_cast<std::size_t>(j)];
        if (finder.may_touch(a, b)) fast.pairs.emplace_back(a, b);
    });
    std::sort(fast.pairs.begin(), fast.pairs.end(),
              [](const auto& p, const auto& q) {
                  return std::tie(p.second, p.first) < std::tie(q.second, q.first);
              });
    stop_each_other(motion, first_impact, part_of, fast);
    put_back(scene, settings.h, now.rows, motion, fast);
}
//! [fast]

}  // namespace rigid
