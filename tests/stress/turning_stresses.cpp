#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/slopes.hpp"
#include "tests/stress/tasks.hpp"
#include "tests/stress/turning.hpp"

namespace rigid::stress {

void perturb(RoughScene& scene, std::uint64_t seed, Real size, Real masses)
{
    Random random(seed);
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        if (!scene.bodies.can_move(k)) continue;
        scene.bodies.inverse_mass.segment<3>(3 * k) *= random.uniform(1 - masses, 1 + masses);
        const Real vx = random.uniform(-1e-3, 1e-3), vy = random.uniform(-1e-3, 1e-3),
                   spin = random.uniform(-1e-3, 1e-3);
        scene.bodies.velocity(k) += Vec<3>(vx * size, vy * size, spin);
    }
}

RoughScene slanted_rods(int count, Real end_mass, int copies)
{
    RoughScene scene;
    const Vec2 along(std::sin(pi / 6), -std::cos(pi / 6));
    for (int k = 0; k < count; ++k) {
        const bool last = k + 1 == count;
        add_body(scene, box(0.1, 1), last ? 10 * end_mass : 10, (k + 0.5) * along, pi / 6);
        for (int copy = 0; copy < copies; ++copy)
            add_pin(scene, k == 0 ? world : k - 1, k == 0 ? Vec2(0, 0) : Vec2(0, -0.5), k, {0, 0.5});
    }
    return scene;
}

namespace {

/// What a scene needs a method to know.
struct Needs {
    bool touching = true;   ///< bodies that touch each other
    bool friction = false;  ///< else it does without where the method does
};

struct Case {
    RoughScene scene;
    Task task;
    Real masses = 0.05;  ///< perturbation of them
};

/// Rows of joints, and of two points with friction for each body and wall or neighbour.
Index rows_of(const RoughScene& scene)
{
    return static_cast<Index>(scene.joints.size()) + 4 * scene.bodies.count();
}

TurningStress stress_of(const std::string& name, const std::string& what, const Values& values,
                        const std::string& unit, const Needs& needs, const std::function<Case(Real)>& make,
                        const Seeds& seeds = {3, 3, 3, 3, 3})
{
    return stress_over<RoughScene>(
        name, what, values, unit, seeds,
        [=](const TurningMethod& method, Real value, std::uint64_t seed) -> std::optional<Verdict> {
            if ((needs.touching && method.walls_only) || (needs.friction && !method.friction))
                return std::nullopt;
            Case now = make(value);
            if (rows_of(now.scene) > method.most_rows) return std::nullopt;
            if (!now.scene.joints.empty() && !method.joints) return std::nullopt;
            perturb(now.scene, seed, now.task.size, now.masses);
            return judge(std::move(now.scene), now.task, method.start(std::make_shared<const Wish>()));
        });
}

constexpr Real mu = 0.5;

/// Boxes of the given side, one on another on a floor; 1 kg each in a box of 1 m.
RoughScene stack(int boxes, Real side = 1)
{
    RoughScene scene;
    scene.walls.push_back({{0, 1}, 0});
    for (int i = 0; i < boxes; ++i) add_body(scene, box(side, side), 1, {0, side * (i + 0.5)});
    cover(scene, {mu, 0, 0, 0});
    return scene;
}

TurningStress heavy_top()
{
    return stress_of("heavy on light", "a box of R kg on a stack of four boxes of 1 kg, two seconds",
                     {1, 30, 1e3, 3e4, 1e6}, "kg", {}, [](Real R) {
                         Case now{stack(5), standing_on()};
                         now.scene.bodies.inverse_mass.segment<3>(12) /= R;
                         return now;
                     });
}

TurningStress tall_stack()
{
    return stress_of("tall stack", "a stack of N equal boxes, two seconds", {5, 10, 20, 40, 80}, "boxes", {},
                     [](Real N) {
                         return Case{stack(static_cast<int>(N)), standing_on()};
                     });
}

TurningStress pushed_stack()
{
    return stress_of("pushed stack",
                     "ten boxes pushed sideways by this share of what tips the stack: none may move",
                     {0.2, 0.5, 0.8, 0.9, 0.95}, "", {true, true}, [](Real share) {
                         Case now{stack(10), standing_on()};
                         now.scene.gravity.x() = 9.81 * share / 10;
                         now.task.stays = true;
                         return now;
                     });
}

TurningStress steep_slope()
{
    return stress_of("steep slope",
                     "a box on a slope that is this share of the steepest that holds it: it may not move",
                     {0.5, 0.9, 0.99, 0.999, 0.9999}, "", {false, true}, [](Real share) {
                         Case now{on_a_slope(box(1, 1), 0.5, std::atan(share * mu) * 180 / pi, mu), {}};
                         now.task.size = 1;
                         now.task.stays = true;
                         return now;
                     });
}

TurningStress leaning_plates()
{
    return stress_of("leaning plates",
                     "two thin plates lean on each other, steep by this share of what friction holds",
                     {0.5, 0.9, 0.97, 0.99, 0.999}, "", {true, true}, [](Real share) {
                         // (L/2) sin φ / (r + L cos φ) = share μ: weight and push in balance about a foot
                         const Real r = 0.01, wanted = share * mu;
                         Real low = 0, high = 1.4;
                         for (int n = 0; n < 60; ++n) {
                             const Real phi = (low + high) / 2;
                             (0.5 * std::sin(phi) / (r + std::cos(phi)) < wanted ? low : high) = phi;
                         }
                         Case now;
                         now.scene.walls.push_back({{0, 1}, 0});
                         const Vec2 half(std::sin(low) / 2, std::cos(low) / 2);
                         add_body(now.scene, capsule(1, r), 40, {-half.x() - r, half.y() + r}, pi / 2 - low);
                         add_body(now.scene, capsule(1, r), 40, {half.x() + r, half.y() + r}, pi / 2 + low);
                         cover(now.scene, {mu, 0, 0, 0});
                         now.task.size = 1;
                         now.task.stays = true;
                         now.masses = 0;  // unequal plates need more
                         return now;
                     });
}

TurningStress spinning_box()
{
    return stress_of("spinning box", "a box that spins at ω falls on a floor between walls, two seconds",
                     {1, 10, 100, 1e3, 1e4}, "rad/s", {false, false}, [](Real spin) {
                         Case now{{}, moving()};
                         now.scene.walls = {{{0, 1}, 0}, {{1, 0}, -2}, {{-1, 0}, -2}};
                         add_body(now.scene, box(1, 1), 1, {0, 1});
                         cover(now.scene, {mu, 0, 0, 0});
                         now.scene.bodies.u[2] = spin;
                         now.task.energy = 9.81 + spin * spin / 12;
                         return now;
                     });
}

TurningStress spinning_rod()
{
    return stress_of("spinning rod", "a rod on a pin at its end spins at ω: no energy is gained or lost",
                     {1, 5, 30, 200, 1e3}, "rad/s", {false, false}, [](Real spin) {
                         Case now{{}, moving()};
                         now.scene.gravity.setZero();
                         add_body(now.scene, box(1, 0.1), 10, {0.5, 0});
                         add_pin(now.scene, world, {0, 0}, 0, {-0.5, 0});
                         now.scene.bodies.u << 0, 0.5 * spin, spin;
                         now.task.conserves = true;
                         now.task.energy = spin * spin * (0.25 + 1.01 / 12) / 2;
                         return now;
                     });
}

TurningStress bouncing_ball()
{
    const Values per_second = {480, 240, 120, 60, 30};
    TurningStress stress = stress_of(
        "ball that bounces", "a ball with e = 1 falls by 2 m: ten seconds in steps of h, no energy is lost",
        per_second, "", {false, true}, [](Real rate) {
            Case now{{}, moving()};
            now.scene.walls.push_back({{0, 1}, 0});
            add_body(now.scene, disc(0.1), Mass{1, {0, 0}, 5e-3}, {0, 2.1});
            now.scene.surfaces.assign(1, {0, 1});
            now.scene.wall_surfaces.assign(1, {0, 1});
            now.task.h = 1 / rate;
            now.task.steps = std::lround(10 * rate);
            now.task.conserves = true;
            now.task.energy = 2 * 9.81;
            return now;
        });
    stress.values = steps_of(per_second);
    return stress;
}

TurningStress double_rod()
{
    const Values per_second = {960, 480, 240, 120, 60};
    TurningStress stress = stress_of(
        "double rod pendulum", "two rods from level: ten seconds in steps of h, no energy is gained or lost",
        per_second, "", {false, false},
        [](Real rate) {
            Case now{{}, moving()};
            for (int k = 0; k < 2; ++k) {
                add_body(now.scene, box(1, 0.1), 10, {k + 0.5, 0});
                add_pin(now.scene, k == 0 ? world : 0, k == 0 ? Vec2(0, 0) : Vec2(0.5, 0), k, {-0.5, 0});
            }
            now.task.h = 1 / rate;
            now.task.steps = std::lround(10 * rate);
            now.task.conserves = true;
            now.task.energy = 2 * 9.81;
            return now;
        },
        {2, 2, 2, 2, 2});
    stress.values = steps_of(per_second);
    return stress;
}

TurningStress slender_rods()
{
    return stress_of(
        "slender rods",
        "ten rods of 1 m, so many times as long as thick, fall into a trough: six seconds, the last 1.5 are "
        "judged",
        {3, 10, 30, 100, 300}, "", {}, [](Real ratio) {
            Case now{{}, moving()};
            now.scene.walls = {{{0, 1}, 0}, {Vec2(1, 1).normalized(), -1}, {Vec2(-1, 1).normalized(), -1}};
            for (int k = 0; k < 10; ++k)
                add_body(now.scene, box(1, 1 / ratio), ratio, {0.1 * (k % 3 - 1), 1.2 + 1.1 * k}, 0.7 * k);
            cover(now.scene, {mu, 0, 0, 0});
            now.task.size = 1 / ratio;
            now.task.steps = 360;
            now.task.from = 0.75;
            return now;
        });
}

TurningStress any_size()
{
    return stress_of("any size",
                     "a stack of five boxes of this side under the gravity of the earth, two seconds",
                     {1e-3, 0.03, 1, 30, 1e3}, "m", {}, [](Real side) {
                         return Case{stack(5, side), standing_on(side)};
                     });
}

TurningStress deep_overlap()
{
    return stress_of(
        "deep overlap",
        "a stack of five boxes whose neighbours overlap by this share at the start: three seconds",
        {0.03, 0.1, 0.3, 0.6, 1}, "", {}, [](Real share) {
            Case now{stack(5), {}};
            for (Index k = 0; k < 5; ++k) {
                const Real lift = static_cast<Real>(k) * share;
                now.scene.bodies.position(k).y() -= lift;
                now.task.lift += 9.81 * lift;
            }
            now.task.energy = 5 * 9.81 * 5;
            now.task.size = 1;
            now.task.steps = 180;
            return now;
        });
}

TurningStress thin_walls()
{
    return stress_of(
        "thin walls", "six bodies of 0.2 m at this speed, spinning, in a room with walls of 1 cm: one second",
        {10, 100, 300, 1e3, 1e4}, "m/s", {}, [](Real speed) {
            Case now{{}, moving()};
            RoughScene& scene = now.scene;
            scene.gravity.setZero();
            for (const Real side : {-1.0, 1.0}) {
                add_body(scene, box(0.01, 4.1), Mass{}, {2 * side, 0});
                add_body(scene, box(4.1, 0.01), Mass{}, {0, 2 * side});
            }
            for (int k = 0; k < 6; ++k) {
                const Polygon shape = k % 3 == 0 ? box(0.2, 0.2) : k % 3 == 1 ? disc(0.1) : box(0.2, 0.02);
                const Index b = add_body(scene, shape, 1, {0.6 * (k % 3 - 1), 0.6 * (k / 3)}, k);
                scene.bodies.velocity(b) << speed * std::cos(2.4 * k + 0.3), speed * std::sin(2.4 * k + 0.3),
                    speed * (k % 2 == 0 ? 0.5 : -0.5);
                now.task.energy += 0.5 * speed * speed / scene.bodies.inverse_mass[3 * b];
            }
            cover(scene, {mu, 0, 0, 0});
            now.task.inside = {2, 2};
            now.task.gap = 0.05;  // half of an inner radius: what a corner that turns may do
            now.task.size = 0.2;
            now.task.steps = 60;
            return now;
        });
}

TurningStress poured()
{
    TurningStress stress = stress_of(
        "poured boxes", "N boxes of 0.5 m are poured into a trough: six seconds, the last 1.5 are judged",
        {10, 30, 60, 120, 240}, "boxes", {},
        [](Real N) {
            Case now{{}, moving()};
            now.scene.walls = {{{0, 1}, 0}, {{1, 0}, -4}, {{-1, 0}, -4}};
            for (int k = 0; k < static_cast<int>(N); ++k)
                add_body(now.scene, box(0.5, 0.5), 4, {0.72 * (k % 10 - 4.5), 0.5 + 0.72 * (k / 10)},
                         0.3 * k);
            cover(now.scene, {mu, 0, 0, 0});
            now.task.size = 0.5;
            now.task.steps = 360;
            now.task.from = 0.75;
            return now;
        },
        {2, 2, 1, 1, 1});
    stress.quick = false;
    return stress;
}

TurningStress long_chain()
{
    return stress_of("long chain", "a chain of N rods of 1 m on pins, let go at 30°, two seconds",
                     {5, 10, 20, 40, 80}, "rods", {false, false}, [](Real N) {
                         return Case{slanted_rods(static_cast<int>(N), 1), moving()};
                     });
}

TurningStress loaded_chain()
{
    return stress_of("loaded chain",
                     "a chain of 20 rods of 1 kg whose last has R kg, let go at 30°, two seconds",
                     {1, 10, 100, 1e3, 1e4}, "kg", {false, false}, [](Real R) {
                         return Case{slanted_rods(20, R), moving()};
                     });
}

TurningStress redundant()
{
    return stress_of("redundant rows", "a chain of 10 rods whose pins are given n times each, two seconds",
                     {1, 2, 4, 8, 16}, "times", {false, false}, [](Real copies) {
                         return Case{slanted_rods(10, 1, static_cast<int>(copies)), moving()};
                     });
}

TurningStress time_step()
{
    const Values per_second = {960, 240, 60, 30, 10};
    TurningStress stress = stress_of(
        "long step",
        "twelve bodies of all shapes fall into a trough: four seconds of steps of h, the last is judged",
        per_second, "", {}, [](Real rate) {
            Case now{{}, moving()};
            static_cast<RigidScene&>(now.scene) = pile(12);
            // as it is, the leftmost disc begins 12 cm deep in a wall: that is `deep overlap`
            for (Index k = 3; k < now.scene.bodies.count(); ++k) now.scene.bodies.x[3 * k] *= 0.9;
            cover(now.scene, {mu, 0, 0, 0});
            now.task.h = 1 / rate;
            now.task.steps = std::lround(4 * rate);
            now.task.from = 0.75;
            now.task.size = 0.5;
            return now;
        });
    stress.values = steps_of(per_second);
    return stress;
}

TurningStress far_away()
{
    return stress_of("far away", "a stack of five boxes, off the origin by this much in x and y, falls 0.1 m",
                     {1e2, 1e3, 1e4, 1e5, 1e6}, "m", {}, [](Real metres) {
                         Case now{stack(5), standing_on()};
                         now.task.energy = lifting(now.scene);
                         for (Index k = 0; k < 5; ++k)
                             now.scene.bodies.position(k) += Vec<3>(metres, metres + 0.1, 0);
                         now.scene.walls[0].offset += metres;
                         return now;
                     });
}

TurningStress long_run()
{
    TurningStress stress = stress_of("long run", "a stack of five boxes stands for so many steps at 60 Hz",
                                     {100, 1e3, 3e3, 1e4, 3e4}, "steps", {true, true},
                                     [](Real steps) {
                                         Case now{stack(5), standing_on()};
                                         now.task.steps = std::lround(steps);
                                         return now;
                                     },
                                     {3, 2, 1, 1, 1});
    stress.quick = false;
    return stress;
}

}  // namespace

std::vector<TurningStress> turning_stresses()
{
    return {heavy_top(),    tall_stack(),   pushed_stack(),  steep_slope(), leaning_plates(),
            spinning_box(), spinning_rod(), bouncing_ball(), double_rod(),  slender_rods(),
            any_size(),     deep_overlap(), thin_walls(),    poured(),      long_chain(),
            loaded_chain(), redundant(),    time_step(),     far_away(),    turning_bad_input(),
            long_run()};
}

}  // namespace rigid::stress
