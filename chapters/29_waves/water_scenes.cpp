// The functions of water_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/29_waves/water_scenes.hpp"

namespace rigid {
namespace {

Real level_at(const WaterScene& pond, Real x)
{
    const Index i = pond.water.cell_at(x);
    return pond.water.bed[i] + pond.water.depth[i];
}

}  // namespace

WaterScene pond(Index cells, Real length, Real depth)
{
    WaterScene made{{}, ShallowWater(cells, length, depth)};
    made.water.origin = -length / 2;
    made.scene.walls = {{{0, 1}, 0}, {{1, 0}, -length / 2}, {{-1, 0}, -length / 2}};
    return made;
}

Index add_floating_box(WaterScene& pond, Real x, Real height, Real ratio, Real part,
                       Real tilt)
{
    const Real draught = box_draught(height, part);
    return add_body(pond.scene, box(ratio * height, height),
                    part * pond.water.density,
                    {x, level_at(pond, x) - draught + height / 2}, tilt);
}

Index add_boat(WaterScene& pond, Real x)
{
    JointedScene& all = pond.scene;
    const Real y = level_at(pond, x);
    const Polygon hull{{{-0.8, -0.35}, {0.8, -0.35}, {1.2, 0.3}, {-1.2, 0.3}}, 0};
    const Index boat =
        add_body(all, hull, Mass{600, {0, -0.15}, 220}, {x, y - 0.1});
    const Vec2 foot(x, y + 0.35);
    const Index mast =
        add_body(all, box(0.08, 1.4), Mass{15, {0, 0}, 2.5}, {x, y + 1.05});
    add_joint(all, joint_at(all, JointKind::weld, boat, mast, foot));
    return boat;
}

Index add_raft(WaterScene& pond, Real x, int planks)
{
    if (planks < 1)
        throw std::invalid_argument("the raft has " + std::to_string(planks) +
                                    " planks; it must have one or more");
    JointedScene& all = pond.scene;
    const Real y = level_at(pond, x), left = x - 0.375 * (planks - 1);
    const Index first = all.bodies.count();
    for (int i = 0; i < planks; ++i) {
        const Real at = left + 0.75 * i;
        add_body(all, box(0.7, 0.18), 0.5 * pond.water.density, {at, y});
        if (i > 0)
            add_joint(all, joint_at(all, JointKind::revolute, first + i - 1,
                                    first + i, {at - 0.375, y}));
    }
    return first;
}

Index add_duck(WaterScene& pond, Real x)
{
    JointedScene& all = pond.scene;
    const Real y = level_at(pond, x);
    const Index body =
        add_body(all, capsule(0.5, 0.28), Mass{150, {0, -0.08}, 9}, {x, y});
    const Vec2 at(x + 0.36, y + 0.42);
    const Index head = add_body(all, disc(0.19), 90.0, at);
    const Index beak = add_body(all, {{{0, -0.05}, {0.18, 0}, {0, 0.05}}, 0}, 90.0,
                                at + Vec2(0.18 + 0.06, 0));
    add_joint(all, joint_at(all, JointKind::weld, body, head, {x + 0.3, y + 0.27}));
    add_joint(all, joint_at(all, JointKind::weld, head, beak, at + Vec2(0.18, 0)));
    return body;
}

}  // namespace rigid
