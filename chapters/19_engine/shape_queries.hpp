/// \file shape_queries.hpp
/// Questions to a world: what does a ray meet, a shape on its way, a shape where it is?
///
/// Boxes in the tree of the contacts stage answer "nearly", chapter 12's functions for two shapes answer exactly. Shapes
/// are placed where the bodies are now with the first question after a step. From then on a question writes nothing that
/// another one reads: the way through the tree is kept in the question itself.
#pragma once

#include "chapters/12_contact_manifolds/casts.hpp"
#include "chapters/12_contact_manifolds/time_of_impact.hpp"
#include "chapters/19_engine/world_state.hpp"

#include <tuple>

namespace rigid {

//! [place]
/// The stage keeps shapes and boxes as they were when it looked; what has moved
/// since is placed again.
inline void place_moved(EngineState& state)
{
    if (state.unplaced.empty()) return;
    Manifolds& stage = state.awake().touching;
    std::vector<int>& list = state.unplaced;
    std::sort(list.begin(), list.end());
    stage.placed.move(state.scene, list);
    for (const int k : list)
        // as large as the stage has them, or it would miss a pair
        stage.finder.place(k, grown(stage.placed.boxes[static_cast<std::size_t>(k)],
                                    state.awake().margin / 2));
    for (const int k : list) state.is_unplaced[static_cast<std::size_t>(k)] = 0;
    list.clear();
}
//! [place]

//! [walk]
/// Calls visit(k) for each leaf whose box fulfils touches(box), in the order of the
/// tree's own search(), without its memory: from a node that is done the way goes
/// up to the first that has another child to look at.
template <class Touches, class Visit>
void walk(const BoxTree& tree, const Touches& touches, const Visit& visit)
{
    int here = tree.root();
    while (here != BoxTree::nobody) {
        const BoxTree::Node& node = tree.node(here);
        if (touches(node.box)) {
            if (!node.is_leaf()) {
                here = node.left;
                continue;
            }
            visit(node.item);
        }
        int up = node.parent;
        while (up != BoxTree::nobody && tree.node(up).right == here)
            here = up, up = tree.node(up).parent;
        here = up == BoxTree::nobody ? up : tree.node(up).right;
    }
}
//! [walk]

/// Whether a question with this filter is about body k.
inline bool is_asked(const EngineState& state, int k, const Filter& filter)
{
    const BodyNotes& note = state.note(k);
    return state.bodies.has(static_cast<std::size_t>(k)) && !note.sensor &&
           !note.disabled && lets_meet(filter, note.filter);
}

//! [overlap]
/// Calls visit(k) for each body that overlaps a shape, in any order.
template <class Visit>
void for_each_overlap(const EngineState& state, const Placed& shape,
                      const Filter& filter, const Visit& visit)
{
    const Manifolds& stage = state.awake().touching;
    const Box near = box_of(shape);
    walk(
        stage.finder.tree, [&](const Box& box) { return overlap(near, box); },
        [&](int k) {
            if (!is_asked(state, k, filter)) return;
            const Manifold m = collide(shape, stage.placed.of(k), {0, 0, nullptr});
            if (m.count > 0) visit(k);
        });
}
//! [overlap]

//! [ray]
/// What a question wants of all that it meets: the first, or each.
struct FirstMet {
    std::optional<Met> met;
    int order = -1;
    Real part = 1;  ///< of the way: no farther

    /// \param number  of the body; of a wall −1: among equals the lowest is first
    void take(const Met& it, int number)
    {
        if (met && (it.part > part || (it.part == part && number > order))) return;
        met = it, order = number, part = it.part;
    }
};
struct AllMet {
    std::vector<std::pair<int, Met>> met;
    static constexpr Real part = 1;

    void take(const Met& it, int number) { met.emplace_back(number, it); }
    /// In the order of the way.
    std::vector<Met> sorted()
    {
        std::stable_sort(met.begin(), met.end(), [](const auto& a, const auto& b) {
            return std::tuple(a.second.part, a.first) <
                   std::tuple(b.second.part, b.first);
        });
        std::vector<Met> all;
        for (const auto& it : met) all.push_back(it.second);
        return all;
    }
};

template <class Wanted>
void meet_on_ray(const EngineState& state, const Ray& ray, const Filter& filter,
                 Wanted& wanted)
{
    const Manifolds& stage = state.awake().touching;
    const auto take = [&](const RayHit& hit, BodyId body, WallId wall, int number) {
        if (hit.hit)
            wanted.take(
                {body, wall, hit.part, ray.from + hit.part * ray.way, hit.normal},
                number);
    };
    for (std::size_t w = 0; w < state.scene.walls.size(); ++w) {
        if (!state.walls.has(w)) continue;
        const HalfSpace& wall = state.scene.walls[w];
        const Real height = wall.normal.dot(ray.from) - wall.offset,
                   closing = -wall.normal.dot(ray.way);
        RayHit hit;
        if (height <= 0) hit.hit = true, hit.part = 0;
        else if (closing > 0 && height <= closing)
            hit.hit = true, hit.part = height / closing, hit.normal = wall.normal;
        take(hit, {}, state.walls.id(w), -1);
    }
    walk(
        stage.finder.tree,
        [&](const Box& box) { return meets(ray, wanted.part, box); },
        [&](int k) {
            if (is_asked(state, k, filter))
                take(cast(ray, stage.placed.of(k)), state.id(k), {}, k);
        });
}
//! [ray]

//! [cast]
/// The same for a shape, by chapter 12's conservative advancement: it stops at most a
/// millionth of ℓ before what it meets.
template <class Wanted>
void meet_on_way(const EngineState& state, const Polygon& shape, const Vec<3>& from,
                 const Vec2& way, const Filter& filter, Wanted& wanted)
{
    const Manifolds& stage = state.awake().touching;
    MovingShape moving{&shape, from, from};
    moving.to.head<2>() += way;
    const Real close = state.metres(1e-6);
    ImpactMemory memory;
    const auto take = [&](const Impact& impact, BodyId body, WallId wall,
                          int number, const auto& nearest) {
        if (!impact.hit && !impact.close) return;
        const Real part = impact.close ? 0 : impact.part;
        if (part > wanted.part) return;
        const PlacedShape there(shape, moving.at(part));
        const Manifold m = nearest(there.view());
        wanted.take({body, wall, part, m.points[0].point,
                     impact.close ? Vec2(0, 0) : m.normal},
                    number);
    };
    for (std::size_t w = 0; w < state.scene.walls.size(); ++w) {
        if (!state.walls.has(w)) continue;
        const HalfSpace& wall = state.scene.walls[w];
        take(time_of_impact(wall, moving, 0, close, memory), {}, state.walls.id(w),
             -1,
             [&](const Placed& there) { return collide(wall, there, infinity); });
    }
    const PlacedShape begin(shape, moving.from), end(shape, moving.to);
    const Box from_box = box_of(begin.view()), to_box = box_of(end.view());
    const Box swept = grown(
        {from_box.low.cwiseMin(to_box.low), from_box.high.cwiseMax(to_box.high)},
        close);
    walk(
        stage.finder.tree, [&](const Box& box) { return overlap(swept, box); },
        [&](int k) {
            if (!is_asked(state, k, filter)) return;
            const Vec<3> pose = state.scene.bodies.position(k);
            const MovingShape still{&state.shape(k), pose, pose};
            take(time_of_impact(still, moving, 0, close, memory), state.id(k), {},
                 k, [&](const Placed& there) {
                     return collide(stage.placed.of(k), there);
                 });
        });
}
//! [cast]

//! [sensors]
/// What is in the sensors now, against what was in them.
inline void update_sensors(EngineState& state)
{
    state.seen_then.swap(state.seen);
    std::vector<Seen>&now = state.seen, &then = state.seen_then;
    now.clear();
    const Manifolds& stage = state.awake().touching;
    for (std::size_t s = 0; s < state.notes.size(); ++s) {
        if (!state.bodies.has(s) || !state.notes[s].sensor ||
            state.notes[s].disabled)
            continue;
        const auto k = static_cast<Index>(s);
        for_each_overlap(state, stage.placed.of(k), state.note(k).filter,
                         [&](int b) {
                             if (state.scene.carrier(b) != state.scene.carrier(k))
                                 now.push_back({state.id(k), state.id(b)});
                         });
    }
    std::sort(now.begin(), now.end());
    std::set_difference(now.begin(), now.end(), then.begin(), then.end(),
                        std::back_inserter(state.events.entered));
    std::set_difference(then.begin(), then.end(), now.begin(), now.end(),
                        std::back_inserter(state.events.left));
}
//! [sensors]

}  // namespace rigid
