// Bodies that turn: stacks and a pyramid with friction, a box on a slope, two rods of a pendulum. See turning_runs.hpp.
#include "docs/results/turning_runs.hpp"

#include "chapters/12_contact_manifolds/stacks.hpp"

namespace rigid::results {
namespace {

constexpr Real mu = 0.5;

JointedScene rough(RigidScene scene)
{
    JointedScene all;
    static_cast<RigidScene&>(all) = std::move(scene);
    cover(all, {mu, 0, 0, 0});
    return all;
}

/// Whatever rests is to stay where it is.
TurningScene resting(const std::string& name, const std::string& parameters, JointedScene scene, int steps)
{
    TurningScene run{name, parameters + " steps=" + std::to_string(steps), "rest", std::move(scene), steps};
    run.error = [x = run.scene.bodies.x](const JointedScene& now, int) {
        return (now.bodies.x - x).lpNorm<Eigen::Infinity>();
    };
    return run;
}

TurningScene loaded_stack(int boxes, int top)
{
    JointedScene scene = rough(box_stack(boxes));
    scene.bodies.inverse_mass.tail<3>() /= top;
    return resting("box_stack_run", "boxes=" + std::to_string(boxes) + " top_mass=" + std::to_string(top),
                   std::move(scene), 120);
}

TurningScene sliding_box()
{
    const Real degrees = 30, slippery = 0.3;
    TurningScene run{"sliding_box_run", "slope=30 mu=0.3 steps=60", "closed_form",
                     jointed(on_a_slope(box(1, 1), 0.5, degrees, slippery)), 60};
    run.rests = false;
    run.error = [=, h = run.h()](const JointedScene& now, int n) {
        const Real t = n * h;
        return std::abs(down_the_slope(now) - block_by_hand(degrees, slippery) * t * t / 2);
    };
    return run;
}

/// Two rods of 1 m and 1 kg from level; their angles from straight down after a second: `shared` reference R1.
TurningScene double_rod()
{
    JointedScene scene;
    for (int k = 0; k < 2; ++k) {
        add_body(scene, capsule(1, 0), thin_rod(1, 1), {k + 0.5, 0});
        add_pin(scene, k == 0 ? world : 0, k == 0 ? Vec2(0, 0) : Vec2(0.5, 0), k, {-0.5, 0});
    }
    TurningScene run{"double_rod_run", "steps=60", "angles", std::move(scene), 60};
    run.rests = run.touches = false;
    run.error = [](const JointedScene& now, int n) -> Real {
        if (n < 60) return 0;
        // RK4 in angles. A rod at θ from straight down, to the right first, has turned by θ − π/2 from level.
        const Real first = -1.207716238190638, second = -0.8143910230912964;
        const auto off = [&](Index k, Real theta) {
            return std::abs(std::remainder(now.bodies.x[3 * k + 2] + pi / 2 - theta, 2 * pi));
        };
        return std::max(off(0, first), off(1, second));
    };
    return run;
}

}  // namespace

void add_turning(Registry& registry)
{
    const auto add = [&](TurningScene run, bool quick = false) {
        run.quick = quick;
        const auto shared = std::make_shared<const TurningScene>(std::move(run));
        add_turning_methods(registry, shared);
        add_turning_engines(registry, shared);
    };
    for (const int boxes : {10, 20}) add(loaded_stack(boxes, 1));
    add(loaded_stack(5, 1000));
    constexpr bool quick = true;
    add(resting("box_pyramid_run", "base=6 boxes=21", rough(box_pyramid(6)), 60), quick);
    add(resting("box_pyramid_run", "base=20 boxes=210", rough(box_pyramid(20)), 60));
    add(sliding_box(), quick);
    add(double_rod(), quick);
}

}  // namespace rigid::results
