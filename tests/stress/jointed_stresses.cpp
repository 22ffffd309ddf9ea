#include "chapters/11_rotation/rigid_method.hpp"
#include "chapters/14_joints/placed_joints.hpp"
#include "chapters/14_joints/ragdoll.hpp"
#include "common/elementary.hpp"
#include "tests/stress/jointed.hpp"
#include "tests/stress/tasks.hpp"
#include "tests/stress/turning_fields.hpp"

namespace rigid::stress {

namespace {

struct Case {
    JointedScene scene;
    Task task;
};

/// What drives the joints of a scene, which not every method knows.
enum class Drives { none, springs, motors };

JointedStress stress_of(const std::string& name, const std::string& what, const Values& values,
                        const std::string& unit, const std::function<Case(Real)>& make,
                        Drives drives = Drives::none)
{
    return stress_over<JointedScene>(
        name, what, values, unit, {3, 3, 3, 3, 3},
        [=](const JointedMethod& method, Real value, std::uint64_t seed) -> std::optional<Verdict> {
            if ((drives == Drives::springs && !method.springs) ||
                (drives == Drives::motors && !method.motors))
                return std::nullopt;
            Case now = make(value);
            if (static_cast<Index>(now.scene.joints.size()) > method.most_rows) return std::nullopt;
            perturb(now.scene, seed, now.task.size);
            return judge(std::move(now.scene), now.task, method.start(std::make_shared<const Wish>()));
        });
}

RigidJoint pin(Index a, const Vec2& at_a, Index b, const Vec2& at_b)
{
    RigidJoint joint;
    joint.a = a, joint.b = b, joint.at_a = at_a, joint.at_b = at_b;
    return joint;
}

/// A rod of 10 kg and 1 m on a pin of the world at its left end; its moment of inertia there is 10 (1 + 0.01)/12 + 2.5.
constexpr Real inertia_at_the_pin = 10 * 1.01 / 12 + 2.5;  // [kg m²]

Index add_rod(JointedScene& scene) { return add_body(scene, box(1, 0.1), 100, {0.5, 0}); }

/// Rods of 1 m on pins, let go at 30°.
JointedScene chain(int rods, Real end_mass = 10, int copies = 1, Real size = 1)
{
    JointedScene scene;
    const Vec2 along(sin(pi / 6), -cos(pi / 6));
    for (int k = 0; k < rods; ++k) {
        add_body(scene, box(0.1 * size, size),
                 k + 1 == rods ? end_mass / (0.1 * size * size) : 10 / (0.1 * size * size),
                 (k + 0.5) * size * along, pi / 6);
        for (int copy = 0; copy < copies; ++copy)
            add_joint(scene, pin(k - 1, k == 0 ? Vec2(0, 0) : Vec2(0, -0.5 * size), k, {0, 0.5 * size}));
    }
    return scene;
}

JointedStress loops()
{
    return stress_of(
        "loops", "a ladder of N squares of pinned rods, let go at 30°, two seconds", {1, 2, 5, 10, 30},
        "squares", [](Real N) {
            Case now{{}, moving()};
            const Vec2 along(sin(pi / 6), -cos(pi / 6)), across(cos(pi / 6), sin(pi / 6));
            Index left = world, right = world;  // the rails' last rods
            for (int k = 0; k < static_cast<int>(N); ++k) {
                const Vec2 top = k * along;
                const auto rail = [&](const Vec2& from, Index above, const Vec2& hook) {
                    const Index rod = add_body(now.scene, box(0.1, 0.8), 125, from + 0.5 * along, pi / 6);
                    add_joint(now.scene, pin(above, above == world ? hook : Vec2(0, -0.5), rod, {0, 0.5}));
                    return rod;
                };
                left = rail(top, left, {0, 0});
                right = rail(top + across, right, across);
                const Index rung =
                    add_body(now.scene, box(0.8, 0.1), 125, top + along + 0.5 * across, pi / 6);
                add_joint(now.scene, pin(left, {0, -0.5}, rung, {-0.5, 0}));
                add_joint(now.scene, pin(right, {0, -0.5}, rung, {0.5, 0}));
            }
            return now;
        });
}

JointedStress redundant()
{
    return stress_of("redundant joints", "a chain of ten rods whose pins are given n times each, two seconds",
                     {1, 2, 4, 8, 16}, "times", [](Real copies) {
                         return Case{chain(10, 10, static_cast<int>(copies)), moving()};
                     });
}

JointedStress contradictory()
{
    return stress_of(
        "links that do not fit",
        "a platform of 2 m on three parallel links of 1 m, the middle one longer by this much: two seconds",
        {0, 1e-4, 1e-3, 0.01, 0.1}, "m", [](Real longer) {
            Case now{{}, moving()};
            const Index platform = add_body(now.scene, box(2, 0.1), 100, {0.5, -std::sqrt(0.75)});
            for (const int place : {-1, 0, 1}) {
                RigidJoint link = pin(world, {place * 1.0, 0}, platform, {place * 1.0, 0});
                link.kind = JointKind::distance;
                link.length = place == 0 ? 1 + longer : 1;
                add_joint(now.scene, link);
            }
            now.task.gap = longer;        // one of them cannot be met
            now.task.energy = 20 * 9.81;  // of 20 kg lifted by the length of a link
            return now;
        });
}

JointedStress fighting_motors()
{
    return stress_of(
        "motors at odds",
        "a rod on a pin, two motors of this torque that want +10 and −10 rad/s: it stays, two seconds",
        {1, 1e2, 1e4, 1e6, 1e8}, "N m",
        [](Real torque) {
            Case now{{}, moving()};
            now.scene.gravity.setZero();
            const Index rod = add_rod(now.scene);
            for (const Real speed : {10.0, -10.0}) {
                RigidJoint joint = pin(world, {0, 0}, rod, {-0.5, 0});
                joint.motor.speed = speed;
                joint.motor.force = torque;
                add_joint(now.scene, joint);
            }
            now.task.stays = true;
            now.task.energy = inertia_at_the_pin * 50;  // of the rod at 10 rad/s
            return now;
        },
        Drives::motors);
}

JointedStress crossed_limits()
{
    return stress_of(
        "limits that cross",
        "a rod on a pin that may not turn below x by one joint and not above −x by another: two seconds",
        {1e-6, 1e-3, 0.01, 0.1, 1}, "rad", [](Real x) {
            Case now{{}, moving()};
            now.scene.gravity.setZero();
            const Index rod = add_rod(now.scene);
            for (const bool low : {true, false}) {
                RigidJoint joint = pin(world, {0, 0}, rod, {-0.5, 0});
                if (low) joint.lower = x;
                else joint.upper = -x;
                add_joint(now.scene, joint);
            }
            now.task.gap = 2 * x;  // one is met at best
            now.task.energy = inertia_at_the_pin * 50;
            return now;
        });
}

JointedStress zero_length()
{
    return stress_of(
        "links of no length",
        "a weight on a link of this length under a rod on a pin, let go level: two seconds",
        {1, 0.01, 1e-4, 1e-8, 0}, "m", [](Real length) {
            Case now{{}, moving()};
            const Index rod = add_rod(now.scene);
            add_joint(now.scene, pin(world, {0, 0}, rod, {-0.5, 0}));
            const Index weight = add_body(now.scene, disc(0.1), Mass{10, {0, 0}, 0.05}, {1, -length});
            RigidJoint link = pin(rod, {0.5, 0}, weight, {0, 0});
            link.kind = JointKind::distance;
            link.length = length;
            add_joint(now.scene, link);
            now.task.conserves = true;
            return now;
        });
}

JointedStress long_chain()
{
    JointedStress stress =
        stress_of("long chain", "a chain of N rods of 1 m on pins, let go at 30°, two seconds",
                  {10, 30, 100, 300, 1000}, "rods", [](Real N) {
                      return Case{chain(static_cast<int>(N)), moving()};
                  });
    stress.quick = false;
    return stress;
}

JointedStress loaded_chain()
{
    return stress_of("loaded chain",
                     "a chain of twenty rods of 10 kg whose last has R kg, let go at 30°, two seconds",
                     {1e2, 1e3, 1e4, 1e5, 1e7}, "kg", [](Real R) {
                         return Case{chain(20, R), moving()};
                     });
}

JointedStress beam()
{
    return stress_of(
        "welded beam", "a beam of N boxes of 1 m, welded to each other and to the world at one end: it stays",
        {2, 5, 10, 20, 40}, "boxes", [](Real N) {
            Case now{{}, moving()};
            for (int k = 0; k < static_cast<int>(N); ++k) {
                const Index b = add_body(now.scene, box(1, 0.3), 10, {k + 0.5, 0});
                RigidJoint weld = pin(k == 0 ? world : b - 1, {k == 0 ? 0 : 0.5, 0}, b, {-0.5, 0});
                weld.kind = JointKind::weld;
                add_joint(now.scene, weld);
            }
            now.task.stays = true;
            now.task.rests = true;
            return now;
        });
}

JointedStress thrown_doll()
{
    return stress_of(
        "doll that spins", "a doll of ten limbs, thrown so that it spins at ω, without weight: two seconds",
        {1, 10, 50, 200, 1e3}, "rad/s",
        [](Real spin) {
            Case now{{}, moving(0.3)};
            JointedScene& scene = now.scene;
            scene.gravity.setZero();
            add_ragdoll(scene, {0, 0});
            for (Polygon& shape : scene.shapes) shape = disc(0.01);  // limbs that do not touch
            Vec2 centre(0, 0);
            Real mass = 0;
            for (Index k = 0; k < scene.bodies.count(); ++k) {
                const Real m = 1 / scene.bodies.inverse_mass[3 * k];
                centre += m * scene.bodies.position(k).head<2>();
                mass += m;
            }
            centre /= mass;
            for (Index k = 0; k < scene.bodies.count(); ++k) {
                const Vec2 arm = scene.bodies.position(k).head<2>() - centre;
                scene.bodies.velocity(k) << -spin * arm.y(), spin * arm.x(), spin;
            }
            now.task.energy = energy(scene);
            return now;
        },
        Drives::motors);  // friction in its joints
}

/// What is to move for ever, in steps of these lengths.
JointedStress swings_on()
{
    const Values per_second = {480, 240, 120, 60, 30};
    JointedStress stress =
        stress_of("pendulum for a minute",
                  "a disc on a pin, let go at 0.5 rad: a minute in steps of h, no energy is gained or lost",
                  per_second, "", [](Real rate) {
                      Case now{{}, moving()};
                      add_body(now.scene, disc(0.05), Mass{1, {0, 0}, 1e-3}, {sin(0.5), -cos(0.5)}, 0.5);
                      add_joint(now.scene, pin(world, {0, 0}, 0, {0, 1}));
                      now.task.h = 1 / rate;
                      now.task.steps = std::lround(60 * rate);
                      now.task.conserves = true;
                      now.task.energy = 9.81 * (1 - cos(0.5));
                      return now;
                  });
    stress.values = steps_of(per_second);
    return stress;
}

JointedStress light_bead()
{
    return stress_of("load on a light bead",
                     "0.1 kg and this load below it on two links of 0.5 m, nearly upright: five seconds",
                     {1, 1e2, 1e3, 1e4, 1e5}, "kg", [](Real load) {
                         Case now{{}, moving(0.5)};
                         add_body(now.scene, disc(0.05), Mass{0.1, {0, 0}, 1e-4}, {0.01, -0.5});
                         add_body(now.scene, disc(0.05), Mass{load, {0, 0}, load * 1e-3}, {0.02, -1});
                         for (const Index k : {0, 1}) {
                             RigidJoint link = pin(k - 1, {0, 0}, k, {0, 0});
                             link.kind = JointKind::distance;
                             link.length = Vec2(0.01, 0.5).norm();
                             add_joint(now.scene, link);
                         }
                         now.task.steps = 300;
                         return now;
                     });
}

JointedStress any_size()
{
    return stress_of("any size",
                     "a chain of ten rods of this length, let go at 30° under the gravity of the earth",
                     {1e-3, 0.03, 1, 30, 1e3}, "m", [](Real size) {
                         return Case{chain(10, 10, 1, size), moving(size)};
                     });
}

JointedStress stiff_spring()
{
    return stress_of(
        "stiff spring",
        "a slider of 10 kg on a spring of this stiffness, damped to a tenth, let go at 0.1 m: two seconds",
        {1e2, 1e4, 1e6, 1e9, 1e12}, "N/m",
        [](Real stiffness) {
            Case now{{}, moving()};
            now.scene.gravity.setZero();
            const Index slider = add_body(now.scene, box(0.5, 0.5), 40, {0.1, 0});
            RigidJoint joint = pin(world, {0, 0}, slider, {0, 0});
            joint.kind = JointKind::prismatic;
            joint.spring.stiffness = stiffness;
            joint.spring.damping = 0.2 * std::sqrt(10 * stiffness);
            add_joint(now.scene, joint);
            now.task.lift = now.task.energy = 0.5 * stiffness * 0.01;  // what the spring holds
            return now;
        },
        Drives::springs);
}

/// A rod on a pin with limits and a motor, a weld, a rope, over a floor.
JointedScene some_joints(std::uint64_t seed, bool motor)
{
    JointedScene scene;
    scene.walls = {{{0, 1}, -3}};
    const Index rod = add_rod(scene), box_ = add_body(scene, box(0.4, 0.4), 10, {1.2, 0}),
                weight = add_body(scene, disc(0.2), 10, {1.2, -0.9});
    RigidJoint hinge = pin(world, {0, 0}, rod, {-0.5, 0});
    hinge.lower = -1, hinge.upper = 2;
    if (motor) hinge.motor.force = 5;
    add_joint(scene, hinge);
    RigidJoint weld = pin(rod, {0.5, 0}, box_, {-0.2, 0});
    weld.kind = JointKind::weld;
    add_joint(scene, weld);
    RigidJoint rope = pin(box_, {0, 0}, weight, {0, 0});
    rope.kind = JointKind::rope;
    rope.length = 1;
    add_joint(scene, rope);
    cover(scene, {0.5, 0, 0, 0});
    perturb(scene, seed);
    return scene;
}

JointedStress bad_joints()
{
    return bad_input_of<JointedScene>(
        [](const JointedMethod& method, int level, std::uint64_t seed) -> std::optional<Verdict> {
            const JointedScene scene = some_joints(seed, method.motors);
            FieldsOf<JointedScene> joints = fields_of_rows_and_walls(scene);
            const FieldsOf<JointedScene> surfaces = fields_of_surfaces(scene);
            joints.insert(joints.end(), surfaces.begin(), surfaces.end());
            return spoil_all(method, scene, level, fields_of_bodies(scene), joints);
        });
}

}  // namespace

std::vector<JointedStress> jointed_stresses()
{
    return {loops(),      redundant(),    contradictory(), fighting_motors(), crossed_limits(), zero_length(),
            long_chain(), loaded_chain(), beam(),          thrown_doll(),     swings_on(),      light_bead(),
            any_size(),   stiff_spring(), bad_joints()};
}

}  // namespace rigid::stress
