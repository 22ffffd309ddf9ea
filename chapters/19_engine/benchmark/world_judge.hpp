/// \file world_judge.hpp
/// Errors of poses, measured alike for every engine: by the shapes, masses and joints of the world that they began as.
#pragma once

#include "chapters/19_engine/world_scenes.hpp"
#include "tests/peers/poses.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rigid {

class WorldJudge {
public:
    explicit WorldJudge(const World& start) : world_(&start), ids_(start.bodies())
    {
        for (std::size_t k = 0; k < ids_.size(); ++k)
            place_.resize(std::max<std::size_t>(place_.size(), ids_[k].place + 1u)),
                place_[ids_[k].place] = k;
        for (const JointId joint : start.joints())
            joined_.push_back(
                pair_key(number(start.body_a(joint)), number(start.body_b(joint))));
        std::sort(joined_.begin(), joined_.end());
        for (const BodyId id : ids_)
            mass_.push_back(moves(id) ? start.mass(id) : 0);
    }

    /// The deepest overlap of two bodies, or of a body and a wall [m]
    Real overlap(const Poses& poses)
    {
        shapes_.resize(ids_.size());
        boxes_.resize(ids_.size());
        for (std::size_t k = 0; k < ids_.size(); ++k) {
            shapes_[k].move(world_->shape(ids_[k]), poses[k]);
            boxes_[k] = box_of(shapes_[k].view());
        }
        Real deepest = 0;
        overlapping_pairs(boxes_, sweep_, [&](int a, int b) {
            const auto i = static_cast<std::size_t>(a),
                       j = static_cast<std::size_t>(b);
            if (mass_[i] == 0 && mass_[j] == 0) return;
            if (!lets_meet(world_->filter(ids_[i]), world_->filter(ids_[j])))
                return;
            if (std::binary_search(joined_.begin(), joined_.end(), pair_key(a, b)))
                return;
            deepest = std::max(deepest,
                               depth(collide(shapes_[i].view(), shapes_[j].view(),
                                             {0, 0, nullptr})));
        });
        for (const WallId wall : world_->walls())
            for (std::size_t k = 0; k < ids_.size(); ++k)
                if (mass_[k] > 0)
                    deepest = std::max(
                        deepest,
                        depth(collide(world_->wall(wall), shapes_[k].view(), 0)));
        return deepest;
    }

    /// The largest distance of the two points of a joint, of those with a length what it is off by [m]
    Real gap(const Poses& poses) const
    {
        Real largest = 0;
        for (const JointId id : world_->joints()) {
            const RigidJoint& joint = world_->joint(id);
            const BodyId of = world_->body_a(id);
            const Vec2 a = of ? at(pose_of(poses, of), joint.at_a) : joint.at_a,
                       b = at(pose_of(poses, world_->body_b(id)), joint.at_b);
            const bool rope = joint.kind == JointKind::rope;
            const Real off = (b - a).norm() - joint.length;
            largest = std::max(largest, rope ? off : std::abs(off));
        }
        return largest;
    }

    /// How far the body that moved most is from where it was [m]
    static Real moved(const Poses& from, const Poses& to)
    {
        Real most = 0;
        for (std::size_t k = 0; k < to.size(); ++k)
            most = std::max(most, (to[k] - from[k]).head<2>().norm());
        return most;
    }

    /// Energy as the height that all bodies together would have with it at rest [m], velocities by the difference of two
    /// poses: a step of free fall never makes it larger.
    Real height(const Poses& before, const Poses& now, Real h) const
    {
        const Vec2 g = world_->settings().gravity;
        Real energy = 0, weight = 0;
        for (std::size_t k = 0; k < ids_.size(); ++k) {
            if (mass_[k] == 0) continue;
            Vec<3> u = (now[k] - before[k]) / h;
            // one of the engines gives angles within ±π
            u[2] = std::remainder(now[k][2] - before[k][2], 2 * pi) / h;
            energy += mass_[k] * (u.head<2>().squaredNorm() / 2 -
                                  g.dot(now[k].head<2>())) +
                      world_->inertia(ids_[k]) * u[2] * u[2] / 2;
            weight += mass_[k] * g.norm();
        }
        return energy / weight;
    }

private:
    bool moves(BodyId id) const { return world_->mass(id) < infinity; }
    int number(BodyId id) const
    {
        return id ? static_cast<int>(place_[id.place]) : -1;
    }
    const Vec<3>& pose_of(const Poses& poses, BodyId id) const
    {
        return poses[static_cast<std::size_t>(number(id))];
    }
    static Real depth(const Manifold& m)
    {
        Real deepest = 0;
        for (int p = 0; p < m.count; ++p)
            deepest = std::max(deepest, -m.points[static_cast<std::size_t>(p)].gap);
        return deepest;
    }
    static Vec2 at(const Vec<3>& pose, const Vec2& own)
    {
        const Real c = std::cos(pose[2]), s = std::sin(pose[2]);
        return {pose[0] + c * own.x() - s * own.y(),
                pose[1] + s * own.x() + c * own.y()};
    }

    const World* world_;
    std::vector<BodyId> ids_;
    std::vector<std::size_t> place_;
    std::vector<Real> mass_;  ///< 0: cannot be pushed
    std::vector<std::uint64_t> joined_;
    std::vector<PlacedShape> shapes_;
    std::vector<Box> boxes_;
    BoxSweep sweep_;
};

}  // namespace rigid
