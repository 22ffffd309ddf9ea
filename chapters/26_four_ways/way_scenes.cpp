// The functions of way_scenes.hpp.
#include "common/eigen_instances.hpp"

#include "chapters/26_four_ways/way_scenes.hpp"

#include "chapters/01_euler_integration/integrators.hpp"
#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/slopes.hpp"
#include "chapters/14_joints/bar_linkages.hpp"
#include "chapters/14_joints/ragdoll.hpp"

namespace rigid {

namespace {

JointedScene of(const RoughScene& rough)
{
    JointedScene scene;
    static_cast<RoughScene&>(scene) = rough;
    return scene;
}

/// An angle under its own equation, by chapter 1's method of order four.
template <class Rate>
Real angle_after(State<1> s, Real t, const Rate& rate)
{
    const int steps = 20000;
    for (int i = 0; i < steps; ++i)
        s = rk4(s, t / steps, [&](const Vec<1>& x, const Vec<1>& u) {
            return Vec<1>(rate(x[0], u[0]));
        });
    return s.x[0];
}

Vec<1> one(Real value) { return Vec<1>::Constant(value); }

}  // namespace

JointedScene bead_on_a_wire()
{
    JointedScene scene;
    scene.gravity = {0, -10};
    add_body(scene, disc(0.05), Mass{1, {0, 0}, 1}, {0.6, -0.8});
    scene.bodies.u.head<2>() << 0.8, 0.6;
    RigidJoint wire;
    wire.kind = JointKind::distance;
    wire.length = 1;
    add_joint(scene, wire);
    return scene;
}

WayScene pendulum()
{
    WayScene way;
    way.name = "pendulum";
    const Index rod = add_bar(way.scene, {0, 0}, {1, 0}, 1);
    pin(way.scene, world, rod, {0, 0});
    way.keeps_energy = true;
    const Real angle = angle_after({one(0), one(0)}, way.time, [](Real x, Real) {
        return -1.5 * 9.81 * cos(x);
    });
    const Vec2 end(cos(angle), sin(angle));
    way.error = [end](const JointedScene& s) {
        return (point_of(s.bodies.x, 0, {0.5, 0}) - end).norm();
    };
    return way;
}

WayScene double_pendulum()
{
    WayScene way;
    way.name = "double pendulum";
    Index before = world;
    for (int k = 0; k < 2; ++k) {
        const Vec2 from(k, 0);
        const Index rod = add_bar(way.scene, from, from + Vec2(1, 0), 1);
        pin(way.scene, before, rod, from);
        before = rod;
    }
    way.keeps_energy = true;
    way.unit = "rad";
    way.error = [](const JointedScene& s) {
        return std::max(std::abs(rod_angle(s, 0) + 1.207716238190638),  // R1
                        std::abs(rod_angle(s, 1) + 0.8143910230912964));
    };
    return way;
}

WayScene slider_crank_loop()
{
    WayScene way;
    way.name = "slider-crank";
    JointedScene& scene = way.scene;
    scene.gravity = {0, 0};
    const Real r = 0.2, l = 0.5, speed = 10;
    const Index crank = add_bar(scene, {0, 0}, {r, 0}, 1),
                rod = add_bar(scene, {r, 0}, {r + l, 0}, 1),
                slider = add_body(scene, box(0.1, 0.1), Mass{1, {0, 0}, 1.0 / 600},
                                  {r + l, 0});
    pin(scene, world, crank, {0, 0});
    pin(scene, crank, rod, {r, 0});
    add_joint(scene,
              joint_at(scene, JointKind::prismatic, world, slider, {r + l, 0}));
    pin(scene, rod, slider, {r + l, 0});
    scene.bodies.velocity(crank) << 0, r / 2 * speed, speed;
    scene.bodies.velocity(rod) << 0, r / 2 * speed, -r / l * speed;
    way.keeps_energy = true;
    // ½ I(θ) ω² is constant: I by the motions of the three for one radian a second
    const auto inertia = [r, l](Real theta) {
        const Real s = r / l * sin(theta), c = std::sqrt(1 - s * s),
                   turn = -r / l * cos(theta) / c;  // of the rod, φ = −asin s
        const Vec2 middle(-r * sin(theta) + l / 2 * s * turn,
                          r * cos(theta) + l / 2 * c * turn);
        const Real slides = -r * sin(theta) + l * s * turn;
        return r * r / 3 + middle.squaredNorm() + l * l / 12 * turn * turn +
               slides * slides;
    };
    const Real twice = inertia(0) * speed * speed;
    Real theta = 0;
    const int steps = 20000;
    const Real h = way.time / steps;
    const auto rate = [&](Real at) { return std::sqrt(twice / inertia(at)); };
    for (int i = 0; i < steps; ++i) {
        const Real k1 = rate(theta), k2 = rate(theta + h / 2 * k1),
                   k3 = rate(theta + h / 2 * k2), k4 = rate(theta + h * k3);
        theta += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
    }
    const Vec2 end(r * cos(theta), r * sin(theta));
    way.error = [end](const JointedScene& s) {
        return (point_of(s.bodies.x, 0, {0.1, 0}) - end).norm();
    };
    return way;
}

WayScene heavy_chain()
{
    WayScene way;
    way.name = "heavy chain";
    way.scene = chain_scene({20, 0.1, 0.1, 100, 20 * pi / 180});
    way.filter.set_meets(0, 0, false);
    way.time = 0.5;
    way.stiffness = 1e5;
    way.keeps_energy = true;
    way.error = [](const JointedScene& s) {
        return (s.bodies.position(20).head<2>() - heavy_chain_end).norm();
    };
    return way;
}

WayScene sliding_block()
{
    WayScene way;
    way.name = "block on a slope";
    way.scene = of(on_a_slope(box(1, 0.5), 0.25, 30, 0.3));
    way.error = [t = way.time](const JointedScene& s) {
        return std::abs(down_the_slope(s) - block_by_hand(30, 0.3) * t * t / 2);
    };
    return way;
}

WayScene bouncing_ball()
{
    WayScene way;
    way.name = "bouncing ball";
    way.scene.walls.push_back({{0, 1}, 0});
    add_body(way.scene, disc(0.1), Mass{1, {0, 0}, 0.005}, {0, 1.1});
    cover(way.scene, {0, 0.8, 0, 0});
    way.time = 2;
    way.error = [](const JointedScene& s) {
        return std::abs(s.bodies.x[1] - 0.1 - 0.260741728327057);  // D1
    };
    return way;
}

WayScene stack_of_five()
{
    WayScene way;
    way.name = "stack of five";
    RoughScene rough;
    static_cast<RigidScene&>(rough) = box_stack(5);
    cover(rough, {0.5, 0, 0, 0});
    way.scene = of(rough);
    way.error = [start = way.scene.bodies.x](const JointedScene& s) {
        Real most = 0;
        for (Index k = 0; k < 5; ++k)
            most = std::max(most, (s.bodies.x - start).segment<2>(3 * k).norm());
        return most;
    };
    return way;
}

WayScene jammed_rod()
{
    WayScene way;
    way.name = "Painleve's rod";
    way.scene = of(rod_on_end(atan2(2, 1), {-1, 0}, 0, 1.6));
    way.scene.gravity = {0, -9.81};
    way.time = 0.02;
    way.stiffness = 1e6;
    way.unit = "m/s";
    way.error = [](const JointedScene& s) {
        return std::abs(
            velocity_at(s.bodies, 0, point_of(s.bodies.x, 0, {-0.5, 0})).x());
    };
    return way;
}

WayScene newtons_cradle()
{
    WayScene way;
    way.name = "Newton's cradle";
    JointedScene& scene = way.scene;
    scene.gravity = {0, 0};
    for (int k = 0; k < 5; ++k)
        add_body(scene, disc(0.1), Mass{1, {0, 0}, 0.005},
                 {k == 0 ? -0.1 : 0.2 * k, 0});
    scene.bodies.u[0] = 1;
    cover(scene, {0, 1, 0, 0});
    way.time = 0.3;
    way.unit = "m/s";
    way.error = [](const JointedScene& s) {
        Real most = 0;
        for (Index k = 0; k < 5; ++k)
            most = std::max(most, std::abs(s.bodies.u[3 * k] - (k == 4 ? 1 : 0)));
        return most;
    };
    return way;
}

WayScene falling_doll()
{
    WayScene way;
    way.name = "doll";
    way.scene.walls.push_back({{0, 1}, 0});
    std::vector<std::pair<Index, Index>> pairs;
    const Index first = add_ragdoll(way.scene, {0, 1.15}, 0);
    for (Index k = first; k < way.scene.bodies.count(); ++k) {  // as one body
        const Vec2 r = way.scene.bodies.position(k).head<2>() - Vec2(0, 1.15);
        way.scene.bodies.velocity(k) << perpendicular(r) * 2, 2;
    }
    forbid_itself(first, [&pairs](Index a, Index b) { pairs.push_back({a, b}); });
    cover(way.scene, {0.6, 0, 0, 0});
    way.filter = forbid_pairs(way.scene.bodies.count(), pairs);
    way.error = [](const JointedScene& s) { return largest_joint_error(s); };
    return way;
}

std::vector<WayScene> way_scenes()
{
    return {pendulum(),       double_pendulum(), slider_crank_loop(), heavy_chain(),
            sliding_block(),  bouncing_ball(),   stack_of_five(),     jammed_rod(),
            newtons_cradle(), falling_doll()};
}

}  // namespace rigid
