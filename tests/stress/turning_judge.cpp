#include "chapters/11_rotation/rigid_method.hpp"
#include "chapters/12_contact_manifolds/manifold.hpp"
#include "chapters/12_contact_manifolds/wall_manifold.hpp"
#include "chapters/14_joints/joint.hpp"
#include "tests/stress/jointed.hpp"

namespace rigid::stress {

Real total_energy(const RoughScene& scene) { return energy(scene); }

Real lifting(const RoughScene& scene)
{
    Real weight = 0, low = infinity, high = -infinity;
    PlacedShapes placed;
    placed.move(scene);
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        if (!scene.bodies.can_move(k)) continue;
        low = std::min(low, placed.boxes[static_cast<std::size_t>(k)].low.y());
        high = std::max(high, placed.boxes[static_cast<std::size_t>(k)].high.y());
        weight += scene.gravity.norm() / scene.bodies.inverse_mass[3 * k];
    }
    return weight * (high - low);
}

namespace {

/// How deep a manifold goes [m].
Real depth(const Manifold& m)
{
    Real deepest = 0;
    for (int i = 0; i < m.count; ++i) deepest = std::max(deepest, -m.points[static_cast<std::size_t>(i)].gap);
    return deepest;
}

bool joined(const RigidScene& scene, Index a, Index b)
{
    for (const PointJoint& joint : scene.joints)
        if ((joint.a == a && joint.b == b) || (joint.a == b && joint.b == a)) return true;
    return false;
}

}  // namespace

Real largest_gap(const RoughScene& scene)
{
    PlacedShapes placed;
    placed.move(scene);
    Real largest = largest_joint_error(scene);
    const Index K = scene.bodies.count();
    for (Index b = 0; b < K; ++b) {
        if (scene.bodies.can_move(b))
            for (const HalfSpace& wall : scene.walls)
                for (int i = 0; i < placed.of(b).size(); ++i)
                    largest = std::max(largest, wall.offset + placed.of(b).radius -
                                                    wall.normal.dot(placed.of(b).vertex(i)));
        for (Index a = 0; a < b; ++a) {
            if (!scene.bodies.can_move(a) && !scene.bodies.can_move(b)) continue;
            if (!overlap(placed.boxes[static_cast<std::size_t>(a)],
                         placed.boxes[static_cast<std::size_t>(b)]) ||
                joined(scene, a, b))
                continue;
            largest = std::max(largest, depth(collide(placed.of(a), placed.of(b))));
        }
    }
    return largest;
}

Real largest_gap(const JointedScene& scene)
{
    Real largest = largest_gap(static_cast<const RoughScene&>(scene));
    for (const PointJoint& row : scene.joints)
        if (row.kind == ConstraintKind::unilateral)
            largest = std::max(largest, -joint_constraint(scene.bodies.x, row).C);
    return largest;
}

bool stands_in_order(const RoughScene& scene)
{
    for (Index k = 0; k + 1 < scene.bodies.count(); ++k)
        if (!(scene.bodies.position(k).y() < scene.bodies.position(k + 1).y())) return false;
    return true;
}

Real largest_speed(const RoughScene& scene, Real size)
{
    Real largest = 0;
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Vec<3> u = scene.bodies.velocity(k);
        largest = std::max({largest, u.head<2>().norm(), std::abs(u[2]) * size});
    }
    return largest;
}

/// A centimetre a second is rest for bodies of a metre.
Real speed_of_rest(const RoughScene&, const Task& task) { return resting_speed * task.size; }

void watch(const RoughScene& scene, const VecX& start, const Task& task, Verdict& verdict)
{
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        if (!scene.bodies.can_move(k)) continue;
        const Vec2 at = scene.bodies.position(k).head<2>();
        if (task.stays) verdict.gap = std::max(verdict.gap, (at - start.segment<2>(3 * k)).norm());
        if (!((at.cwiseAbs() - task.inside).maxCoeff() <= 0)) verdict.through = true;
    }
}

}  // namespace rigid::stress
