/// \file box2d3_world.hpp
/// A World's bodies, walls and joints (revolute, distance, rope, weld) in Box2D 3, where find_package(box2d 3) finds one.
///
/// By its own defaults: softness of contacts and joints, warm starting, continuous collision and sleep on, one thread; its
/// unit of length is that of the world. Its default are four sub-steps a step. Its headers have names that those of Box2D
/// 2.4 have too, so they are seen by box2d3_world.cpp alone. Its numbers are floats.
#pragma once

#include "tests/peers/poses.hpp"

#include <memory>

namespace rigid {

class Box2d3World {
public:
    explicit Box2d3World(const World& here, bool sleeps = true, int substeps = 4);
    ~Box2d3World();
    Box2d3World(const Box2d3World&) = delete;
    Box2d3World& operator=(const Box2d3World&) = delete;

    void step(Real h);
    void read(Poses& poses) const;
    void read_velocities(Poses& velocities) const;
    /// \param k  the number of a body, in the order of World::bodies()
    void drive(std::size_t k, const Vec2& velocity, Real spin);

private:
    struct Inside;
    std::unique_ptr<Inside> inside_;
};

}  // namespace rigid
