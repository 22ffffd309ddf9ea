// The functions of slopes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/13_friction/slopes.hpp"

namespace rigid {

RoughScene on_a_slope(const Polygon& shape, Real below, Real degrees, Real mu)
{
    const Real a = degrees * pi / 180;
    RoughScene scene;
    scene.walls.push_back({{sin(a), cos(a)}, 0});
    add_body(scene, shape, 1.0, Vec2(sin(a), cos(a)) * below, -a);
    cover(scene, {mu, 0, 0, 0});
    return scene;
}

RoughScene thrown_disc(Real v0, Real mu)
{
    RoughScene scene;
    scene.walls.push_back({{0, 1}, 0});
    add_body(scene, disc(0.5), 1.0, {0, 0.5});
    scene.bodies.u[0] = v0;
    cover(scene, {mu, 0, 0, 0});
    return scene;
}

RoughScene rod_on_end(Real angle, const Vec2& velocity, Real spin, Real mu)
{
    RoughScene scene;
    scene.gravity = {0, 0};
    scene.walls.push_back({{0, 1}, 0});
    add_body(scene, capsule(1, 0), thin_rod(1, 1), {0, sin(angle) / 2}, angle);
    scene.bodies.u << velocity, spin;
    cover(scene, {mu, 0, 0, 0});
    return scene;
}

}  // namespace rigid
