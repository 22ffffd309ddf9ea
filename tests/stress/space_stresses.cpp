#include "chapters/21_joints_in_space/joint_makers.hpp"
#include "chapters/24_friction_is_a_disc/solid_scenes.hpp"
#include "tests/stress/bad_input.hpp"
#include "tests/stress/space.hpp"
#include "tests/stress/tasks.hpp"

namespace rigid::stress {

namespace {

/// Whether bodies touch, which methods of joints alone don't know.
enum class Touching : bool { none, some };

struct Case {
    SpaceScene scene;
    Task task;
};

/// Locked coordinates, and four points with friction for each body that touches.
Index rows_of(const SpaceScene& scene, Touching touching)
{
    Index rows = touching == Touching::some ? 12 * scene.bodies.count() : 0;
    for (const SpaceJoint& joint : scene.joints)
        for (int c = 0; c < coordinates; ++c) rows += joint.locked(c);
    return rows;
}

/// Masses by up to 5 %, velocities by up to 1 mm/s of a body of `size` 1 m.
void perturb(SpaceScene& scene, std::uint64_t seed, Real size)
{
    Random random(seed);
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        if (!scene.bodies.can_move(k)) continue;
        scene.bodies.inverse_mass.segment<6>(6 * k) *= random.uniform(0.95, 1.05);
        for (Index i = 0; i < 6; ++i)
            scene.bodies.u[6 * k + i] += random.uniform(-1e-3, 1e-3) * (i < 3 ? size : 1);
    }
}

SpaceStress stress_of(const std::string& name, const std::string& what, const Values& values,
                      const std::string& unit, Touching touching, const std::function<Case(Real)>& make,
                      const Seeds& seeds = {3, 3, 3, 3, 3})
{
    return stress_over<SpaceScene>(
        name, what, values, unit, seeds,
        [=](const SpaceMethod& method, Real value, std::uint64_t seed) -> std::optional<Verdict> {
            if (touching == Touching::some && method.links_only) return std::nullopt;
            Case now = make(value);
            if (rows_of(now.scene, touching) > method.most_rows) return std::nullopt;
            perturb(now.scene, seed, now.task.size);
            return judge(std::move(now.scene), now.task, method.start(std::make_shared<const Wish>()));
        });
}

constexpr Real mu = 0.5;

/// Cubes of this side and 1 kg, one on another, each turned a little against the one below.
SpaceScene stack(int boxes, Real side = 1)
{
    SpaceScene scene;
    for (int i = 0; i < boxes; ++i)
        add_body(scene, {solid_box({side, side, side})}, 1 / (side * side * side), {0, side * (i + 0.5), 0},
                 {0, 0.05 * i, 0});
    add_floor(scene, mu);
    return scene;
}

SpaceStress heavy_top()
{
    return stress_of("heavy on light", "a cube of R kg on a stack of four of 1 kg, two seconds",
                     {1, 30, 1e3, 3e4, 1e6}, "kg", Touching::some, [](Real R) {
                         Case now{stack(5), standing_on()};
                         now.scene.bodies.inverse_mass.tail<6>() /= R;
                         return now;
                     });
}

SpaceStress tall_stack()
{
    return stress_of("tall stack", "a stack of N equal cubes, two seconds", {3, 5, 10, 20, 40}, "cubes",
                     Touching::some, [](Real N) {
                         return Case{stack(static_cast<int>(N)), standing_on()};
                     });
}

SpaceStress pushed_stack()
{
    return stress_of(
        "pushed stack",
        "five cubes pushed across their faces by this share of what tips the stack: none may move",
        {0.2, 0.5, 0.8, 0.9, 0.95}, "", Touching::some, [](Real share) {
            Case now{box_stack(5, 0, mu), standing_on()};
            now.scene.gravity.x() = 9.81 * share / 5;  // half a side over half of the height
            now.scene.gravity.z() = now.scene.gravity.x() / 4;
            now.task.stays = true;
            return now;
        });
}

SpaceStress steep_slope()
{
    return stress_of(
        "steep slope",
        "a plate on a slope that leads askew to its sides and is this share of the steepest that "
        "holds it: it may not move",
        {0.5, 0.9, 0.99, 0.999, 0.9999}, "", Touching::some, [](Real share) {
            Case now{block_on_slope(atan2(share * mu, 1) * 180 / pi, 0.6, mu), {}};
            now.task.size = 1;
            now.task.stays = true;
            return now;
        });
}

SpaceStress spinning_plate()
{
    return stress_of("spinning plate",
                     "a free plate spins at ω about its middle axis, nearly: no energy is gained or lost",
                     {1, 10, 100, 1e3, 1e4}, "rad/s", Touching::none, [](Real spin) {
                         Case now{{}, moving()};
                         now.scene.gravity.setZero();
                         add_body(now.scene, {solid_box({1, 0.1, 0.5})}, 20.0, {0, 0, 0});
                         // of three moments the second by size
                         const Vec3 inverse = now.scene.bodies.inverse_mass.segment<3>(3);
                         Index middle = 0;
                         for (const Index i : {1, 2})
                             if (inverse[i] < inverse.maxCoeff() && inverse[i] > inverse.minCoeff())
                                 middle = i;
                         now.scene.bodies.u.segment<3>(3).setConstant(0.01 * spin);
                         now.scene.bodies.u[3 + middle] = spin;
                         now.task.conserves = true;
                         now.task.energy = energy(now.scene);
                         return now;
                     });
}

SpaceStress spinning_rod()
{
    return stress_of(
        "spinning rod", "a rod on a ball joint at its end goes round at ω: no energy is gained or lost",
        {1, 5, 30, 200, 1e3}, "rad/s", Touching::none, [](Real spin) {
            Case now{{}, moving()};
            now.scene.gravity.setZero();
            add_body(now.scene, {solid_box({1, 0.1, 0.1})}, 100.0, {0.5, 0, 0});
            now.scene.joints.push_back(ball_joint(now.scene, world, 0, {0, 0, 0}));
            const Vec3 omega(0, spin, 0);
            now.scene.bodies.u.head<3>() = cross(omega, Vec3(0.5, 0, 0));
            now.scene.bodies.u.tail<3>() = rotation_of(now.scene.bodies.x, 0).transpose() * omega;
            now.task.conserves = true;
            now.task.energy = energy(now.scene);
            return now;
        });
}

SpaceStress spinning_box()
{
    return stress_of("spinning box",
                     "a box that spins askew at ω falls on a floor between walls, two seconds",
                     {1, 10, 100, 1e3, 1e4}, "rad/s", Touching::some, [](Real spin) {
                         Case now{{}, moving()};
                         add_body(now.scene, {solid_box({1, 0.6, 0.8})}, 1 / 0.48, {0, 1, 0});
                         add_floor(now.scene, mu);
                         for (const Vec3& n : {Vec3(1, 0, 0), Vec3(-1, 0, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
                             now.scene.walls.push_back({n, -2});
                         now.scene.wall_friction.assign(5, mu);
                         now.scene.bodies.u.tail<3>() = spin * Vec3(1, 2, 3).normalized();
                         now.task.energy = 9.81 + kinetic_energy(now.scene.bodies);
                         return now;
                     });
}

SpaceStress slender_rods()
{
    return stress_of("slender rods",
                     "eight rods of 1 m, so many times as long as thick, fall into a pit: four seconds, the "
                     "last one is judged",
                     {3, 10, 30, 100, 300}, "", Touching::some, [](Real ratio) {
                         Case now{mixed_heap(8, mu, 1), moving(1 / ratio)};
                         for (Index k = 0; k < 8; ++k) {
                             SpaceScene rod;
                             add_body(rod, {solid_box({1, 1 / ratio, 1 / ratio})}, ratio * ratio, {0, 0, 0});
                             now.scene.shapes[static_cast<std::size_t>(k)] = rod.shapes[0];
                             now.scene.bodies.inverse_mass.segment<6>(6 * k) = rod.bodies.inverse_mass;
                             now.scene.bodies.position(k).head<3>() =
                                 Vec3(0, 1.5 + 1.1 * static_cast<Real>(k), 0);
                         }
                         now.task.steps = 240;
                         now.task.from = 0.75;
                         return now;
                     });
}

SpaceStress any_size()
{
    return stress_of("any size",
                     "a stack of five cubes of this side under the gravity of the earth, two seconds",
                     {1e-3, 0.03, 1, 30, 1e3}, "m", Touching::some, [](Real side) {
                         return Case{stack(5, side), standing_on(side)};
                     });
}

SpaceStress deep_overlap()
{
    return stress_of(
        "deep overlap",
        "a stack of five cubes whose neighbours overlap by this share at the start: three seconds",
        {0.03, 0.1, 0.3, 0.6, 1}, "", Touching::some, [](Real share) {
            Case now{stack(5), {}};
            for (Index k = 0; k < 5; ++k) {
                const Real lift = static_cast<Real>(k) * share;
                now.scene.bodies.position(k).y() -= lift;
                // the heaviest that perturb() makes one, in whatever order they end
                now.task.lift += 9.81 * lift / 0.95;
            }
            now.task.energy = 5 * 9.81 * 5;
            now.task.size = 1;
            now.task.steps = 180;
            return now;
        });
}

SpaceStress poured()
{
    SpaceStress stress = stress_of("poured solids",
                                   "N balls, capsules, boxes and hulls are poured into a pit: four seconds, "
                                   "the last one is judged",
                                   {5, 10, 20, 40, 80}, "solids", Touching::some,
                                   [](Real N) {
                                       Case now{mixed_heap(static_cast<int>(N), mu, 1), moving(0.5)};
                                       now.task.steps = 240;
                                       now.task.from = 0.75;
                                       return now;
                                   },
                                   {2, 2, 1, 1, 1});
    stress.quick = false;
    return stress;
}

SpaceStress time_step()
{
    const Values per_second = {960, 60, 30, 20, 10};
    SpaceStress stress = stress_of(
        "long step",
        "twelve solids of four shapes fall into a pit: four seconds of steps of h, the last is judged",
        per_second, "", Touching::some,
        [](Real rate) {
            Case now{mixed_heap(12, mu, 2), moving(0.5)};
            now.task.h = 1 / rate;
            now.task.steps = std::lround(4 * rate);
            now.task.from = 0.75;
            return now;
        },
        {2, 2, 2, 2, 2});
    stress.values = steps_of(per_second);
    stress.quick = false;
    return stress;
}

SpaceStress far_away()
{
    return stress_of("far away", "a stack of five cubes, off the origin by this much, falls 0.1 m",
                     {1e2, 1e3, 1e4, 1e5, 1e6}, "m", Touching::some, [](Real metres) {
                         Case now{stack(5), standing_on()};
                         now.task.energy = lifting(now.scene);
                         for (Index k = 0; k < 5; ++k)
                             now.scene.bodies.position(k).head<3>() += Vec3(metres, metres + 0.1, metres);
                         now.scene.walls[0].offset += metres;
                         return now;
                     });
}

/// Rods of 1 m on ball joints, let go at 30°, the last one of the given mass.
SpaceScene chain(int rods, Real end_mass = 10, int copies = 1)
{
    SpaceScene scene;
    const Vec3 along(sin(pi / 6), -cos(pi / 6), 0);
    for (int k = 0; k < rods; ++k) {
        add_body(scene, {solid_box({0.1, 1, 0.1})}, k + 1 == rods ? 100 * end_mass : 1000, (k + 0.5) * along,
                 {0, 0, pi / 6});
        for (int copy = 0; copy < copies; ++copy)
            scene.joints.push_back(ball_joint(scene, k - 1, k, k * along));
    }
    return scene;
}

SpaceStress long_chain()
{
    return stress_of("long chain", "a chain of N rods of 1 m on ball joints, let go at 30°, two seconds",
                     {5, 10, 20, 40, 80}, "rods", Touching::none, [](Real N) {
                         return Case{chain(static_cast<int>(N)), moving()};
                     });
}

SpaceStress loaded_chain()
{
    return stress_of("loaded chain",
                     "a chain of twenty rods of 10 kg whose last has R kg, let go at 30°, two seconds",
                     {10, 100, 1e3, 1e4, 1e6}, "kg", Touching::none, [](Real R) {
                         return Case{chain(20, R), moving()};
                     });
}

SpaceStress redundant()
{
    return stress_of("redundant joints",
                     "a chain of ten rods whose joints are given n times each, two seconds", {1, 2, 4, 8, 16},
                     "times", Touching::none, [](Real copies) {
                         return Case{chain(10, 10, static_cast<int>(copies)), moving()};
                     });
}

SpaceStress loops()
{
    return stress_of(
        "loops",
        "a ladder of N squares of rods on parallel hinges, let go at 30°, two seconds: each loop "
        "has three rows too many",
        {1, 2, 5, 10, 20}, "squares", Touching::none, [](Real N) {
            Case now{{}, moving()};
            SpaceScene& scene = now.scene;
            const Vec3 along(sin(pi / 6), -cos(pi / 6), 0), across(cos(pi / 6), sin(pi / 6), 0),
                axis(0, 0, 1);
            Index left = world, right = world;  // the rails' last rods
            for (int k = 0; k < static_cast<int>(N); ++k) {
                const Vec3 top = k * along;
                const auto rail = [&](const Vec3& from, Index above) {
                    const Index rod = add_body(scene, {solid_box({0.1, 0.8, 0.1})}, 1250, from + 0.5 * along,
                                               {0, 0, pi / 6});
                    scene.joints.push_back(hinge(scene, above, rod, from, axis));
                    return rod;
                };
                left = rail(top, left);
                right = rail(top + across, right);
                const Index rung = add_body(scene, {solid_box({0.8, 0.1, 0.1})}, 1250,
                                            top + along + 0.5 * across, {0, 0, pi / 6});
                scene.joints.push_back(hinge(scene, left, rung, top + along, axis));
                scene.joints.push_back(hinge(scene, right, rung, top + along + across, axis));
            }
            return now;
        });
}

SpaceStress welded_beam()
{
    return stress_of(
        "welded beam", "a beam of N boxes of 1 m, fixed to each other and to the world at one end: it stays",
        {2, 5, 10, 20, 40}, "boxes", Touching::none, [](Real N) {
            Case now{{}, moving()};
            for (int k = 0; k < static_cast<int>(N); ++k) {
                const Index b = add_body(now.scene, {solid_box({1, 0.3, 0.3})}, 33, {k + 0.5, 0, 0});
                now.scene.joints.push_back(fixed_joint(now.scene, k - 1, b, {k * 1.0, 0, 0}));
            }
            now.task.stays = true;
            now.task.rests = true;
            return now;
        });
}

/// A rod of 1 m and 10 kg on hinges of the world at its left end, about z.
SpaceScene rod_on_hinges(int hinges)
{
    SpaceScene scene;
    scene.gravity.setZero();
    add_body(scene, {solid_box({1, 0.1, 0.1})}, 1000.0, {0.5, 0, 0});
    for (int i = 0; i < hinges; ++i) scene.joints.push_back(hinge(scene, world, 0, {0, 0, 0}, {0, 0, 1}));
    return scene;
}
constexpr Real energy_of_the_rod = (10 * 1.01 / 12 + 2.5) * 50;  ///< at 10 rad/s [J]

SpaceStress contradictory()
{
    return stress_of(
        "joints that do not fit",
        "a box held at both ends by joints whose places in the world are this much too far apart: "
        "two seconds",
        {0, 1e-4, 1e-3, 0.01, 0.1}, "m", Touching::none, [](Real off) {
            Case now{{}, moving()};
            const Index b = add_body(now.scene, {solid_box({1, 0.2, 0.3})}, 100.0, {0, 0, 0});
            for (const Real side : {-0.5, 0.5}) {
                SpaceJoint joint = hinge(now.scene, world, b, {side, 0, 0}, {0, 0, 1});
                joint.at_a.x() += side * off;
                now.scene.joints.push_back(joint);
            }
            now.task.gap = off;  // both cannot be met
            now.task.energy = 6 * 9.81;
            return now;
        });
}

SpaceStress fighting_motors()
{
    return stress_of("motors at odds",
                     "a rod on hinges, two motors of this torque that want +10 and −10 rad/s: it stays",
                     {1, 1e2, 1e4, 1e6, 1e8}, "N m", Touching::none, [](Real torque) {
                         Case now{rod_on_hinges(2), moving()};
                         for (std::size_t i = 0; i < 2; ++i) {
                             now.scene.joints[i].motor = twist;
                             now.scene.joints[i].speed = i == 0 ? 10 : -10;
                             now.scene.joints[i].force = torque;
                         }
                         now.task.stays = true;
                         now.task.energy = energy_of_the_rod;
                         return now;
                     });
}

SpaceStress crossed_limits()
{
    return stress_of("limits that cross",
                     "a rod that may not turn below x by one hinge and not above −x by another: two seconds",
                     {1e-6, 1e-3, 0.01, 0.1, 1}, "rad", Touching::none, [](Real x) {
                         Case now{rod_on_hinges(2), moving()};
                         now.scene.joints[0].lo[twist] = x;
                         now.scene.joints[1].hi[twist] = -x;
                         now.task.gap = 2 * x;  // one is met at best
                         now.task.energy = energy_of_the_rod;
                         return now;
                     });
}

using Fields = FieldsOf<SpaceScene>;
using Field = FieldOf<SpaceScene>;

/// A number that must be zero or positive.
Field not_negative(const std::function<Real&(SpaceScene&, Real&, Wish&)>& at)
{
    return {.at = at, .may_be_negative = false, .may_be_zero = true};
}

/// A rod on a hinge with limits and a motor; where they touch, a box, a ball and a capsule over a floor and a wall.
SpaceScene some_solids(const SpaceMethod& method, std::uint64_t seed)
{
    SpaceScene scene = rod_on_hinges(1);
    scene.gravity = {0, -9.81, 0};
    scene.joints[0].lo[twist] = -1, scene.joints[0].hi[twist] = 2;
    scene.joints[0].motor = twist, scene.joints[0].force = 5;
    if (!method.links_only) {
        add_body(scene, {solid_box({0.5, 0.5, 0.5})}, 100, {1, -1.7, 0});
        add_body(scene, {solid_ball(0.2)}, 100, {0, -1.75, 0});
        add_body(scene, {solid_capsule(0.4, 0.1)}, 100, {-1, -1.85, 0});
        scene.walls = {{{0, 1, 0}, -2}, {{1, 0, 0}, -2}};
        scene.wall_friction.assign(2, mu);
        scene.friction.assign(4, mu);
        scene.rolling.assign(4, 0.01);
        scene.spinning.assign(4, 0.01);
    }
    perturb(scene, seed, 1);
    return scene;
}

Fields fields_of_bodies(const SpaceScene& scene, bool shapes)
{
    Fields fields;
    for (auto vector : {&Bodies<6>::x, &Bodies<6>::u, &Bodies<6>::inverse_mass})
        for (Index i = 0; i < scene.bodies.x.size(); ++i)
            fields.push_back({[=](SpaceScene& s, Real&, Wish&) -> Real& { return (s.bodies.*vector)[i]; }});
    for (std::size_t k = 0; k < scene.shapes.size() && shapes; ++k) {
        fields.push_back(
            not_negative([=](SpaceScene& s, Real&, Wish&) -> Real& { return s.shapes[k][0].radius; }));
        for (std::size_t i = 0; i < scene.shapes[k][0].vertices.size(); ++i)
            for (Index d = 0; d < 3; ++d)
                fields.push_back(
                    {[=](SpaceScene& s, Real&, Wish&) -> Real& { return s.shapes[k][0].vertices[i][d]; }});
    }
    return fields;
}

Fields fields_of_joints_and_walls(const SpaceScene& scene)
{
    Fields fields;
    for (std::size_t i = 0; i < scene.joints.size(); ++i) {
        for (auto vector : {&SpaceJoint::at_a, &SpaceJoint::at_b, &SpaceJoint::frame_a, &SpaceJoint::frame_b})
            for (Index d = 0; d < 3; ++d)
                fields.push_back(
                    {[=](SpaceScene& s, Real&, Wish&) -> Real& { return (s.joints[i].*vector)[d]; }});
        for (std::size_t c = 0; c < coordinates; ++c) {
            // no limit: −∞ below and +∞ above
            fields.push_back({.at = [=](SpaceScene& s, Real&, Wish&) -> Real& { return s.joints[i].lo[c]; },
                              .may_be_minus_infinite = true});
            fields.push_back({.at = [=](SpaceScene& s, Real&, Wish&) -> Real& { return s.joints[i].hi[c]; },
                              .may_be_infinite = true});
        }
        fields.push_back({[=](SpaceScene& s, Real&, Wish&) -> Real& { return s.joints[i].speed; }});
        fields.push_back({.at = [=](SpaceScene& s, Real&, Wish&) -> Real& { return s.joints[i].force; },
                          .may_be_infinite = true,
                          .may_be_negative = false,
                          .may_be_zero = true});
    }
    for (std::size_t w = 0; w < scene.walls.size(); ++w) {
        for (Index d = 0; d < 3; ++d)
            fields.push_back({[=](SpaceScene& s, Real&, Wish&) -> Real& { return s.walls[w].normal[d]; }});
        fields.push_back({[=](SpaceScene& s, Real&, Wish&) -> Real& { return s.walls[w].offset; }});
    }
    for (auto list :
         {&SpaceScene::friction, &SpaceScene::wall_friction, &SpaceScene::rolling, &SpaceScene::spinning})
        for (std::size_t i = 0; i < (scene.*list).size(); ++i)
            fields.push_back(
                not_negative([=](SpaceScene& s, Real&, Wish&) -> Real& { return (s.*list)[i]; }));
    fields.push_back(not_negative([](SpaceScene& s, Real&, Wish&) -> Real& { return s.length; }));
    return fields;
}

SpaceStress bad_solids()
{
    return bad_input_of<SpaceScene>(
        [](const SpaceMethod& method, int level, std::uint64_t seed) -> std::optional<Verdict> {
            const SpaceScene scene = some_solids(method, seed);
            return spoil_all(method, scene, level, fields_of_bodies(scene, !method.links_only),
                             fields_of_joints_and_walls(scene));
        });
}

}  // namespace

std::vector<SpaceStress> space_stresses()
{
    return {heavy_top(),      tall_stack(),   pushed_stack(), steep_slope(),   spinning_plate(),
            spinning_rod(),   spinning_box(), slender_rods(), any_size(),      deep_overlap(),
            poured(),         time_step(),    far_away(),     long_chain(),    loaded_chain(),
            redundant(),      loops(),        welded_beam(),  contradictory(), fighting_motors(),
            crossed_limits(), bad_solids()};
}

}  // namespace rigid::stress
