// The functions of island_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/18_islands/island_scenes.hpp"

namespace rigid {

JointedScene poured_scene(int bodies, Real rolling)
{
    JointedScene scene;
    scene.length = 1;
    const int wide = width_of_pour(bodies);
    scene.walls = trough_of_pour(wide);
    for (int i = 0; i < bodies; ++i) {
        const PouredBody body(i, wide);
        add_body(scene, body.shape, 1, body.at, body.angle);
    }
    cover(scene, {0.6, 0, 0, 0});
    for (int i = 2; i < bodies; i += 3)
        scene.surfaces[static_cast<std::size_t>(i)].rolling = rolling;
    return scene;
}

namespace {

/// Adds a net whose upper left corner is there.
void add_net(JointedScene& scene, int side, const Vec2& corner)
{
    const Index first = scene.bodies.count();
    for (int row = 0; row < side; ++row)
        for (int i = 0; i < side; ++i) {
            const Vec2 at = corner + Vec2(0.5 * i, -0.5 * row);
            const bool held = row == 0 && (i == 0 || i + 1 == side);
            const Index k = held ? add_body(scene, disc(0.2), Mass{}, at)
                                 : add_body(scene, disc(0.2), 1, at);
            const auto join = [&](Index other) {
                if (!scene.bodies.can_move(other) && held) return;
                const Vec2 middle =
                    (at + scene.bodies.position(other).head<2>()) / 2;
                add_joint(scene,
                          joint_at(scene, JointKind::revolute, other, k, middle));
            };
            if (i > 0) join(k - 1);
            if (row > 0) join(first + (row - 1) * side + i);
        }
}

/// Adds boxes of these masses, one on another.
void add_tower(JointedScene& scene, Real x, const std::vector<Real>& masses)
{
    for (std::size_t i = 0; i < masses.size(); ++i)
        add_body(scene, box(1, 1), masses[i], {x, 0.5 + static_cast<Real>(i)});
}

}  // namespace

JointedScene net_scene(int side)
{
    JointedScene scene;
    scene.length = 1;
    add_net(scene, side, {0, 0});
    cover(scene, {0.6, 0, 0, 0});
    return scene;
}

JointedScene struck_tower_scene(Real speed)
{
    JointedScene scene;
    scene.length = 1;
    scene.walls.push_back({{0, 1}, 0});
    add_body(scene, disc(0.5), 1, {-15, 0.5});
    add_tower(scene, -10, {1, 1, 100});
    add_tower(scene, 0, std::vector<Real>(20, 1));
    if (speed > 0) {
        const Index k = add_body(scene, disc(0.6), 3, {-1.3 * speed, 12});
        scene.bodies.velocity(k) << speed, 6.4, 0;  // 1.3 s up and down again
    }
    cover(scene, {0.6, 0, 0, 0});
    return scene;
}

JointedScene mixed_scene(int bodies, int side)
{
    JointedScene scene = poured_scene(bodies);
    const Real edge = -scene.walls.back().offset + 0.2;
    scene.walls.resize(1);  // the floor
    for (const Real x : {-edge, edge}) add_body(scene, box(0.4, 4), Mass{}, {x, 2});
    add_net(scene, side, {edge + 1, 0.5 * side + 0.5});
    for (int i = 0; i < 5; ++i)
        add_body(scene, box(0.6, 0.6), 1, {-edge - 1.5, 0.3 + 0.6 * i});
    cover(scene, {0.6, 0, 0, 0});
    return scene;
}

}  // namespace rigid
