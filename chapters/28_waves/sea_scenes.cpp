// The functions of sea_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/28_waves/sea_scenes.hpp"

#include "chapters/22_distance_of_solids/convex_hull.hpp"
#include "chapters/21_joints_in_space/joint_makers.hpp"

namespace rigid {
namespace {

Real still_level(const SeaScene& sea) { return sea.water.level(0); }

/// An eggshell of flat faces: rings of so many corners, and two poles, about a centre.
Hull egg(const Vec3& at, const Vec3& half)
{
    std::vector<Vec3> points{at + Vec3(-half.x(), 0, 0), at + Vec3(half.x(), 0, 0)};
    for (const Real s : {-0.75, -0.35, 0.1, 0.55, 0.85})
        for (int k = 0; k < 8; ++k) {
            const Real turn = 2 * pi * k / 8, r = std::sqrt(1 - s * s);
            points.push_back(at + Vec3(half.x() * s, half.y() * r * cos(turn),
                                       half.z() * r * sin(turn)));
        }
    return solid_hull(points);
}

}  // namespace

SeaScene sea(Index cells, Real side, Real depth)
{
    SeaScene made{
        {}, ShallowGrid(cells, cells, side / static_cast<Real>(cells), depth)};
    made.water.origin_x = made.water.origin_z = -side / 2;
    made.scene.walls = {{{0, 1, 0}, 0},
                        {{1, 0, 0}, -side / 2},
                        {{-1, 0, 0}, -side / 2},
                        {{0, 0, 1}, -side / 2},
                        {{0, 0, -1}, -side / 2}};
    return made;
}

Index add_floating_box(SeaScene& sea, const Vec3& at, const Vec3& size, Real part,
                       Real tilt)
{
    const Real draught = box_draught(size.y(), part);
    Vec3 place = at;
    place.y() = still_level(sea) - draught + size.y() / 2;
    return add_body(sea.scene, {solid_box(size)}, part * sea.water.density, place,
                    {0, 0, tilt});
}

Index add_boat(SeaScene& sea, Real x, Real z)
{
    std::vector<Vec3> corners;
    for (const Real side : {-1.0, 1.0}) {
        corners.emplace_back(-1.1, 0.35, side * 0.62);
        corners.emplace_back(0.5, 0.35, side * 0.62);
        corners.emplace_back(-0.9, -0.3, side * 0.45);
        corners.emplace_back(0.5, -0.3, side * 0.4);
    }
    corners.emplace_back(1.4, 0.4, 0);
    corners.emplace_back(1.0, -0.25, 0);
    const Hull hull = solid_hull(corners);
    const Hull house = solid_box({0.6, 0.35, 0.6}, {-0.4, 0.525, 0}),
               mast = solid_box({0.06, 0.9, 0.06}, {0.3, 0.8, 0});
    // the skin is thin; its ballast lies low
    SolidMass all = mass_of({hull, house, mast}, 300);
    all.centroid.y() -= 0.25;
    return add_body(sea.scene, {hull, house, mast}, all,
                    {x, still_level(sea) + 0.02, z});
}

Index add_raft(SeaScene& sea, Real x, Real z, int along, int across)
{
    const Real pitch = 0.75, y = still_level(sea);
    const Index first = sea.scene.bodies.count();
    for (int j = 0; j < across; ++j)
        for (int i = 0; i < along; ++i) {
            const Vec3 at(x + pitch * (i - (along - 1) / 2.0), y,
                          z + pitch * (j - (across - 1) / 2.0));
            const Index plank = add_body(sea.scene, {solid_box({0.7, 0.2, 0.7})},
                                         0.5 * sea.water.density, at);
            if (i > 0)
                sea.scene.joints.push_back(ball_joint(sea.scene, plank - 1, plank,
                                                      at - Vec3(pitch / 2, 0, 0)));
            if (j > 0)
                sea.scene.joints.push_back(ball_joint(
                    sea.scene, plank - along, plank, at - Vec3(0, 0, pitch / 2)));
        }
    return first;
}

Index add_duck(SeaScene& sea, Real x, Real z)
{
    const Hull body = egg({0, 0, 0}, {0.55, 0.32, 0.38}),
               head = egg({0.42, 0.42, 0}, {0.2, 0.2, 0.2}),
               beak = solid_hull({{0.58, 0.34, -0.1},
                                  {0.58, 0.34, 0.1},
                                  {0.58, 0.44, -0.08},
                                  {0.58, 0.44, 0.08},
                                  {0.82, 0.38, 0}});
    SolidMass all = mass_of({body, head, beak}, 280);
    all.centroid.y() -= 0.14;
    return add_body(sea.scene, {body, head, beak}, all,
                    {x, still_level(sea) + 0.05, z});
}

}  // namespace rigid
