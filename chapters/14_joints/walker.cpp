// The functions of walker.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/14_joints/walker.hpp"

namespace rigid {

//! [walker]
Walker add_walker(JointedScene& scene, Real x, Real ground, const Drive& motor)
{
    constexpr Real third = 2 * pi / 3;
    Real lowest = 0;
    for (int i = 0; i < 3; ++i)
        for (const Real phase : {third * i, pi - third * i})
            lowest = std::min(lowest, JansenLeg(phase).p[5].y());
    const Vec2 axle(x, ground - lowest);
    Walker walker;
    const Real arm = 15 * JansenLeg::scale, below = 7.8 * JansenLeg::scale;
    walker.chassis = add_body(scene, box(0.76, 0.06), Mass{10, {0, 0}, 0.5},
                              axle - Vec2(0, below));
    walker.crank = add_body(scene, disc(arm), Mass{2, {0, 0}, arm * arm}, axle);
    RigidJoint turns =
        joint_at(scene, JointKind::revolute, walker.chassis, walker.crank, axle);
    turns.motor = motor;
    walker.motor = add_joint(scene, turns);
    std::size_t foot = 0;
    for (int i = 0; i < 3; ++i) {
        const Real phase = third * i;  // of this pin of the crank
        walker.feet[foot++] =
            hang_jansen_leg(scene, walker.chassis, walker.crank, JansenLeg(phase),
                            [&](const Vec2& p) -> Vec2 { return axle + p; });
        walker.feet[foot++] = hang_jansen_leg(
            scene, walker.chassis, walker.crank, JansenLeg(pi - phase),
            [&](const Vec2& p) -> Vec2 { return axle + Vec2(-p.x(), p.y()); });
    }
    return walker;
}
//! [walker]

}  // namespace rigid
