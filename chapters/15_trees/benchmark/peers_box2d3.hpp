/// \file peers_box2d3.hpp
/// Bodies on revolute joints as a world of Box2D 3, where find_package(box2d 3) finds one.
///
/// Its own sub-steps, its own softness of joints and contacts, one thread; sleep and continuous collision off. Its headers
/// have names that those of Box2D 2.4 have too, so they are seen by peers_box2d3.cpp alone.
#pragma once

#include "chapters/14_joints/joint.hpp"

#include <memory>
#include <vector>

namespace rigid {

class Box2d3Joints {
public:
    /// \param substeps  of a step
    /// \param group     as of Box2dJoints
    /// \param hertz     of its joints' softness, 0 = its default of 60 [Hz]; it takes
    ///                  at most a quarter of a turn a sub-step
    Box2d3Joints(const JointedScene& scene, int substeps,
                 const std::vector<int>& group = {}, Real hertz = 0);
    ~Box2d3Joints();
    Box2d3Joints(const Box2d3Joints&) = delete;
    Box2d3Joints& operator=(const Box2d3Joints&) = delete;

    void step(Real h);
    /// Writes positions and velocities into the scene.
    void read(JointedScene& scene) const;

private:
    struct World;
    std::unique_ptr<World> world_;
};

}  // namespace rigid
