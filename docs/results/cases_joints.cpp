// Bodies on joints: a chain that swings with a heavy load, a bridge at rest under one, a doll on stairs. See turning_runs.hpp.
#include "docs/results/turning_runs.hpp"

#include "chapters/14_joints/joint_scenes.hpp"
#include "chapters/14_joints/ragdoll.hpp"
#include "chapters/15_trees/reduced.hpp"
#include "common/elementary.hpp"

namespace rigid::results {
namespace {

/// Where the load of a chain is at the end of each step: RK4 of its equations in the coordinates of its joints (15.26).
std::vector<Vec2> path_of_load(const JointedScene& start, int steps, Real h)
{
    // 0.13 ms beside the 1 ms of the fastest swing of a link: to 1e-6 m after a second, by halves and quarters
    constexpr int parts = 128;
    ReducedTree tree(start);
    VecX x = start.bodies.x, u = start.bodies.u, c, a = u, weight = VecX::Zero(u.size());
    for (Index k = 0; k < start.bodies.count(); ++k) weight.segment<2>(3 * k) = start.gravity;
    const auto n = static_cast<Index>(tree.size());
    VecX s = VecX::Zero(2 * n);
    s.head(n) = tree.coordinates(x);
    const auto rates = [&](const VecX& at) {
        tree.place(at.head(n), x);
        tree.move(at.tail(n), x, u);
        tree.velocity_products(x, at.tail(n), u, c);
        VecX rate(2 * n);
        rate << at.tail(n), tree.nearest(x, start.bodies.inverse_mass, weight, c, a);
        return rate;
    };
    const Real part = h / parts;
    std::vector<Vec2> path;
    for (int i = 0; i < steps; ++i) {
        for (int k = 0; k < parts; ++k) {
            const VecX k1 = rates(s), k2 = rates(s + part / 2 * k1), k3 = rates(s + part / 2 * k2),
                       k4 = rates(s + part * k3);
            s += part / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
        tree.place(s.head(n), x);
        path.push_back(x.segment<2>(x.size() - 3));
    }
    return path;
}

/// The largest error of a joint that has no bounds [m]; of limits what is overstepped [m, rad].
Real apart(const JointedScene& scene)
{
    Real largest = largest_joint_error(scene);
    for (const PointJoint& joint : scene.joints)
        if (joint.kind == ConstraintKind::unilateral)
            largest = std::max(largest, -joint_constraint(scene.bodies.x, joint).C);
    return largest;
}

/// A chain of rods at 20° that is let go: its joints, and where its load is.
TurningScene swinging(int links, int ratio)
{
    constexpr int steps = 60;
    TurningScene run{"jointed_chain_run",
                     "links=" + std::to_string(links) + " load=" + std::to_string(ratio) +
                         " angle=20 steps=" + std::to_string(steps),
                     "coordinates", chain_scene({links, 0.1, 0.1, static_cast<Real>(ratio), pi / 9}), steps};
    run.rests = run.touches = false;
    const auto path = std::make_shared<std::vector<Vec2>>();
    run.error = [=, start = run.scene, h = run.h()](const JointedScene& now, int n) {
        if (path->empty()) *path = path_of_load(start, steps, h);
        const Vec2 load = now.bodies.x.segment<2>(now.bodies.x.size() - 3);
        return std::max(apart(now), (load - (*path)[static_cast<std::size_t>(n - 1)]).norm());
    };
    return run;
}

/// A bridge as it hangs at rest, its plank in the middle heavier. At its half, at the plank's centre, the pull is level, so the
/// slope of the k-th plank from there is what hangs between both centres over the pull H, and H is that for which the planks
/// reach from bank to bank.
TurningScene hanging_bridge(int planks, int ratio)
{
    constexpr int steps = 120;
    JointedScene scene = bridge_scene(planks);
    const int middle = planks / 2;
    const Real m = 1 / scene.bodies.inverse_mass[0], L = 8.4 / planks, weight = 9.81 * m;
    const auto slope = [&](int k, Real H) {
        const int away = std::abs(k - middle);
        if (away == 0) return Real{0};
        return (k < middle ? -1 : 1) * atan2(weight * (ratio + 2 * (away - 1) + 1) / 2, H);
    };
    const auto span = [&](Real H) {
        Real sum = 0;
        for (int k = 0; k < planks; ++k) sum += L * cos(slope(k, H));
        return sum;
    };
    Real low = 0, high = 1e3 * weight * (ratio + planks);
    for (int i = 0; i < 200; ++i) {
        const Real H = (low + high) / 2;
        (span(H) < 8 ? low : high) = H;
    }
    scene.bodies.inverse_mass.segment<3>(3 * middle) /= ratio;
    Vec2 end(-4, 0);
    for (int k = 0; k < planks; ++k) {
        const Real angle = slope(k, high);
        const Vec2 along = L * Vec2(cos(angle), sin(angle));
        scene.bodies.position(k) << end + along / 2, angle;
        end += along;
    }
    TurningScene run{"bridge_run",
                     "planks=" + std::to_string(planks) + " load=" + std::to_string(ratio) +
                         " steps=" + std::to_string(steps),
                     "rest", std::move(scene), steps};
    run.touches = false;
    run.error = [x = run.scene.bodies.x](const JointedScene& now, int) {
        return (now.bodies.x - x).lpNorm<Eigen::Infinity>();
    };
    return run;
}

/// A doll that falls down stairs: how far its joints and limits are off.
TurningScene falling_doll()
{
    constexpr int steps = 60;
    TurningScene run{"doll_run", "steps=" + std::to_string(steps), "joints", {}, steps};
    add_stairs(run.scene, 8);
    const Index first = add_ragdoll(run.scene, {0.2, 3.6});
    for (Index k = first; k < first + 10; ++k) run.scene.bodies.velocity(k)[0] = 0.8;
    forbid_itself(first, [&](Index a, Index b) { run.apart.push_back({a, b}); });
    cover(run.scene, {0.6, 0, 0, 0});
    run.error = [](const JointedScene& now, int) { return apart(now); };
    return run;
}

}  // namespace

void add_joints(Registry& registry)
{
    const auto add = [&](TurningScene run, bool quick = false) {
        run.quick = quick;
        const auto shared = std::make_shared<const TurningScene>(std::move(run));
        add_joint_methods(registry, shared);
        add_turning_engines(registry, shared);
    };
    constexpr bool quick = true;
    add(swinging(10, 1000), quick);
    add(swinging(50, 1));
    add(swinging(50, 1000));
    add(hanging_bridge(9, 1000), quick);
    add(hanging_bridge(41, 1000));
    add(falling_doll(), quick);
}

}  // namespace rigid::results
