#include "chapters/21_joints_in_space/joint_coordinates.hpp"
#include "chapters/23_faces_that_touch/solid_touch.hpp"
#include "tests/stress/space.hpp"

namespace rigid::stress {

Real total_energy(const SpaceScene& scene) { return energy(scene); }

namespace {

/// The hulls of a body where they are.
struct Placed {
    std::vector<SolidForm> forms;
    std::vector<PlacedSolid> solids;
};

std::vector<Placed> place_all(const SpaceScene& scene)
{
    std::vector<Placed> all(scene.shapes.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
        const auto body = static_cast<Index>(k);
        for (const Hull& hull : scene.shapes[k]) all[k].forms.push_back(form_of(hull));
        all[k].solids.resize(all[k].forms.size());
        for (std::size_t i = 0; i < all[k].forms.size(); ++i)
            all[k].solids[i].place(all[k].forms[i], centre_of(scene.bodies.x, body),
                                   rotation_of(scene.bodies.x, body));
    }
    return all;
}

bool joined(const SpaceScene& scene, Index a, Index b)
{
    for (const SpaceJoint& joint : scene.joints)
        if ((joint.a == a && joint.b == b) || (joint.a == b && joint.b == a)) return true;
    return false;
}

/// How deep two solids are in each other [m].
Real depth(const Placed& a, const Placed& b)
{
    Real deepest = 0;
    ClipRoom room;
    SolidTouch touch;
    for (const PlacedSolid& p : a.solids)
        for (const PlacedSolid& q : b.solids) {
            collide(p, q, {0, 0}, room, touch);
            for (int i = 0; i < touch.count; ++i)
                deepest = std::max(deepest, -touch.points[static_cast<std::size_t>(i)].gap);
        }
    return deepest;
}

/// The largest gap of a locked coordinate, and the farthest that one is beyond a limit [m, rad].
Real joint_gap(const SpaceScene& scene)
{
    Real largest = 0;
    for (const SpaceJoint& joint : scene.joints) {
        const JointFrames f = frames_of(scene.bodies.x, joint);
        for_each_slot(f, joint, [&](int slot) {
            if (slot == motor_slot) return;
            const Constraint<6> c = joint_constraint(f, joint, slot);
            largest = std::max(largest, c.kind == ConstraintKind::unilateral ? -c.C : std::abs(c.C));
        });
    }
    return largest;
}

}  // namespace

Real lifting(const SpaceScene& scene)
{
    Real weight = 0, low = infinity, high = -infinity;
    const std::vector<Placed> all = place_all(scene);
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        if (!scene.bodies.can_move(k)) continue;
        for (const PlacedSolid& solid : all[static_cast<std::size_t>(k)].solids)
            for (const Vec3& p : solid.vertices) {
                low = std::min(low, p.y() - solid.radius());
                high = std::max(high, p.y() + solid.radius());
            }
        weight += scene.gravity.norm() / scene.bodies.inverse_mass[6 * k];
    }
    return weight * (high - low);
}

Real largest_gap(const SpaceScene& scene)
{
    Real largest = joint_gap(scene);
    const std::vector<Placed> all = place_all(scene);
    const Index K = scene.bodies.count();
    for (Index b = 0; b < K; ++b) {
        if (scene.bodies.can_move(b))
            for (const SolidWall& wall : scene.walls)
                for (const PlacedSolid& solid : all[static_cast<std::size_t>(b)].solids)
                    for (const Vec3& p : solid.vertices)
                        largest = std::max(largest, wall.offset + solid.radius() - wall.normal.dot(p));
        const Real reach = reach_of(scene.shapes[static_cast<std::size_t>(b)]);
        for (Index a = 0; a < b; ++a) {
            if (!scene.bodies.can_move(a) && !scene.bodies.can_move(b)) continue;
            const Vec3 way = centre_of(scene.bodies.x, b) - centre_of(scene.bodies.x, a);
            if (way.norm() > reach + reach_of(scene.shapes[static_cast<std::size_t>(a)]) ||
                joined(scene, a, b))
                continue;
            largest =
                std::max(largest, depth(all[static_cast<std::size_t>(a)], all[static_cast<std::size_t>(b)]));
        }
    }
    return largest;
}

bool stands_in_order(const SpaceScene& scene)
{
    for (Index k = 0; k + 1 < scene.bodies.count(); ++k)
        if (!(centre_of(scene.bodies.x, k).y() < centre_of(scene.bodies.x, k + 1).y())) return false;
    return true;
}

Real largest_speed(const SpaceScene& scene, Real size)
{
    Real largest = 0;
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Vec<6> u = scene.bodies.velocity(k);
        largest = std::max({largest, u.head<3>().norm(), u.tail<3>().norm() * size});
    }
    return largest;
}

/// A centimetre a second is rest for bodies of a metre.
Real speed_of_rest(const SpaceScene&, const Task& task) { return resting_speed * task.size; }

void watch(const SpaceScene& scene, const VecX& start, const Task& task, Verdict& verdict)
{
    if (!task.stays) return;
    for (Index k = 0; k < scene.bodies.count(); ++k)
        verdict.gap = std::max(verdict.gap, (centre_of(scene.bodies.x, k) - centre_of(start, k)).norm());
}

}  // namespace rigid::stress
