// The functions of doll_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/25_world_in_space/doll_scenes.hpp"
#include "common/scenes.hpp"

namespace rigid {

void add_doll(SpaceScene& scene, const Vec3& at)
{
    const Index first = scene.bodies.count();
    const Vec3 up(0, 1, 0);
    const auto add = [&](const Hull& hull, const Vec3& where,
                         const Vec3& along = {1, 0, 0}) {
        return add_body(scene, {hull}, 900.0, at + where, frame_along(along));
    };
    const auto join = [&](Index a, Index b, const Vec3& where, const Vec3& axis,
                          Real bend, Real turn) {
        SpaceJoint joint = ball_joint(scene, a, b, at + where, axis);
        // the middle of the cone: a body bends forward farther than back
        joint.frame_a =
            ball_joint(scene, a, b, at + where, axis + Vec3(0.25, 0, 0)).frame_a;
        joint.hi[cone] = bend;
        joint.lo[twist] = -turn, joint.hi[twist] = turn;
        scene.joints.push_back(joint);
    };
    const auto join_hinge = [&](Index a, Index b, const Vec3& where,
                                const Vec3& axis) {
        SpaceJoint joint = hinge(scene, a, b, at + where, axis);
        joint.lo[twist] = 0, joint.hi[twist] = 2.3;
        scene.joints.push_back(joint);
    };
    const Index pelvis = add(solid_box({0.18, 0.16, 0.3}), {0, 1, 0}),
                chest = add(solid_box({0.2, 0.36, 0.34}), {0, 1.3, 0}),
                head = add(solid_ball(0.12), {0, 1.64, 0});
    join(pelvis, chest, {0, 1.1, 0}, up, 0.5, 0.4);
    join(chest, head, {0, 1.5, 0}, up, 0.6, 0.8);
    for (const Real side : {-1.0, 1.0}) {
        const Vec3 out(0, 0, side);
        const auto beside = [side](Real y, Real z) { return Vec3(0, y, side * z); };
        const Index arm = add(solid_capsule(0.2, 0.045), beside(1.42, 0.4), out),
                    fist = add(solid_capsule(0.16, 0.04), beside(1.42, 0.69), out),
                    thigh = add(solid_capsule(0.28, 0.07), beside(0.71, 0.1), -up),
                    shin = add(solid_capsule(0.3, 0.05), beside(0.26, 0.1), -up);
        join(chest, arm, beside(1.42, 0.23), out, 1.3, 0.7);
        join_hinge(arm, fist, beside(1.42, 0.55), side * up);
        join(pelvis, thigh, beside(0.93, 0.1), -up, 1.0, 0.5);
        join_hinge(thigh, shin, beside(0.48, 0.1), {0, 0, -1});
    }
    give_friction(scene, first, 0.5);
}

void add_stairs(SpaceScene& scene, int steps, Real width, Real mu)
{
    require_count("steps of stairs", steps);
    require_positive("the width of stairs", width);
    for (int i = 0; i < steps; ++i) {
        const Real from = i == 0 ? -2 : 0.3 * (i - 1), to = 0.3 * i;
        const Vec3 size(to - from, 0.18 * (steps - i), width);
        add_body(scene, {solid_box(size)}, SolidMass{},
                 {(from + to) / 2, size.y() / 2, 0});
    }
    add_floor(scene, mu);
}

SpaceScene dolls_on_stairs(int dolls, Real speed, int steps)
{
    require_count("dolls", dolls);
    SpaceScene scene;
    const int row = std::min(dolls, 5);
    add_stairs(scene, steps, 1.9 * row + 0.5, 0.5);
    const Index first = scene.bodies.count();
    for (int i = 0; i < dolls; ++i)
        add_doll(scene, {-0.3 - 0.3 * (i / 5), 0.18 * steps + 2 * (i / 5),
                         1.9 * (i % 5 - (row - 1) / 2.0)});
    for (Index k = first; k < scene.bodies.count(); ++k)
        scene.bodies.u[6 * k] = speed;
    scene.length = 1;
    return scene;
}

Real largest_limit_error(const SpaceScene& scene)
{
    Real largest = 0;
    for (const SpaceJoint& joint : scene.joints) {
        const JointFrames f = frames_of(scene.bodies.x, joint);
        for (int c = 0; c < coordinates; ++c) {
            if (joint.locked(c)) continue;
            const Real value =
                coordinate_of(f, joint, static_cast<Coordinate>(c)).C;
            const auto i = static_cast<std::size_t>(c);
            largest = std::max({largest, joint.lo[i] - value, value - joint.hi[i]});
        }
    }
    return largest;
}

}  // namespace rigid
