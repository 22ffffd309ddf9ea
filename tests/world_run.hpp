/// \file world_run.hpp
/// A body for a world of chapter 19 under test, and steps of a sixtieth of a second.
#pragma once

#include "chapters/19_engine/world_scenes.hpp"

namespace worlds {  // not the library's: tests that run a world in another way call theirs `run`, too

constexpr rigid::Real frame = 1.0 / 60;

inline rigid::BodyDefinition body_at(const rigid::Vec2& at, rigid::Real density = 1,
                                     const rigid::Polygon& shape = rigid::box(1, 1))
{
    return rigid::body_of(shape, at, 0, density);
}

inline void run(rigid::World& engine, int steps)
{
    for (int n = 0; n < steps; ++n) engine.step(frame);
}

}  // namespace worlds
