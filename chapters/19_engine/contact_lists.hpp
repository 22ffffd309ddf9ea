/// \file contact_lists.hpp
/// What touches what, point by point: of bodies that are awake as the last step had it, of sleepers as they rest.
#pragma once

#include "chapters/13_friction/friction_rows.hpp"
#include "chapters/19_engine/resting_forces.hpp"

namespace rigid {

/// The wall of a contact that has just been found; none where it is of two bodies.
inline WallId wall_id(const EngineState& state, const Contact& c)
{
    return c.a == world ? state.walls.id(wall_of(state.scene, c)) : WallId{};
}

/// Where a contact is, without its impulses.
inline ContactView view_of(const EngineState& state, const Contact& c, WallId wall)
{
    return {{state.id(c.shape_a()), state.id(c.shape_b()), wall},
            c.point,
            c.normal,
            c.gap};
}

//! [contacts]
/// The contacts of the last step.
/// \param wanted  bool(const Contact&)
template <class Wanted>
void list_contacts(const EngineState& state, const Wanted& wanted,
                   std::vector<ContactView>& list)
{
    const StepData<3>& now = state.now;
    if (state.work.skipped || !state.is_answered()) return;
    // rows of friction come before those of normals, both in the contacts' order
    std::size_t drag = 0;
    const auto friction_of = [&](int index) {
        const auto is_before = [index](const Source& it) {
            return it.of != Source::Of::contact || it.part != tangent_part ||
                   it.index < index;
        };
        while (drag < now.sources.size() && is_before(now.sources[drag])) ++drag;
        return drag < now.sources.size() && now.sources[drag].index == index
                   ? now.solution.lambda[static_cast<Index>(drag)]
                   : 0;
    };
    for (std::size_t i = 0; i < now.sources.size(); ++i) {
        const Source& source = now.sources[i];
        if (source.of != Source::Of::contact || source.part != normal_part)
            continue;
        const Contact& c = now.contacts[static_cast<std::size_t>(source.index)];
        if (!wanted(c) || !state.was_there(c.a) || !state.was_there(c.b)) continue;
        // shapes and walls may be others by now
        const WallId wall = state.met_walls[static_cast<std::size_t>(source.index)];
        if (c.a == world && !state.walls.has(wall)) continue;
        list.push_back(view_of(state, c, wall));
        list.back().impulse = now.solution.lambda[static_cast<Index>(i)];
        list.back().friction = friction_of(source.index);
    }
}
//! [contacts]

/// The impulses of a sleeper's island by their keys, in sub-steps of the length of the last one.
inline std::vector<std::pair<ImpulseKey, Real>>
resting_impulses(const EngineState& state, Index k)
{
    std::vector<std::pair<ImpulseKey, Real>> found;
    for_each_resting_force(state, k, [&](const ImpulseKey& key, Real force) {
        found.emplace_back(key, force * state.method.start.cache.h);
    });
    std::sort(found.begin(), found.end(),
              [](const auto& a, const auto& b) { return a.first < b.first; });
    return found;
}

/// What a sleeper rests on, and what rests on it, as the contacts were when it fell asleep.
inline void list_resting_contacts(const EngineState& state, Index k,
                                  std::vector<ContactView>& list)
{
    const auto impulses = resting_impulses(state, k);
    const auto impulse = [&](const Contact& c, int part) {
        const ImpulseKey key = contact_key(c, part);
        const auto at =
            std::lower_bound(impulses.begin(), impulses.end(), key,
                             [](const auto& entry, const ImpulseKey& it) {
                                 return entry.first < it;
                             });
        return at != impulses.end() && at->first == key ? at->second : 0;
    };
    StepData<3> found;
    const RigidScene& scene = state.scene;
    const Real margin = state.metres(state.settings.margin);
    scene.for_each_shape(k, [&](Index i) {
        if (!scene.pushes(i)) return;
        const PlacedShape shape(state.shape(i), scene.bodies.position(i));
        for (std::size_t w = 0; w < scene.walls.size(); ++w)
            if (state.walls.has(w))
                add_contacts(scene, world, i,
                             collide(scene.walls[w], shape.view(), margin),
                             static_cast<int>(w) * shape.view().size(), found);
    });
    const Manifolds& stage = state.awake().touching;
    for (const auto* const pairs : {&stage.touching, &stage.resting})
        for (const TouchingPair& pair : *pairs)
            if ((scene.carrier(pair.a) == k || scene.carrier(pair.b) == k) &&
                state.was_there(pair.a) && state.was_there(pair.b))
                add_contacts(scene, pair.a, pair.b, pair.manifold, 0, found);
    for (const Contact& c : found.contacts) {
        list.push_back(view_of(state, c, wall_id(state, c)));
        list.back().impulse = impulse(c, normal_part);
        list.back().friction = impulse(c, tangent_part);
    }
}

}  // namespace rigid
