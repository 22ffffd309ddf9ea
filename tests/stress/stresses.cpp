#include "tests/stress/tasks.hpp"

#include "chapters/08_warm_starting/looped_trusses.hpp"
#include "chapters/09_active_sets/linkages.hpp"
#include "common/text.hpp"

namespace rigid::stress {

void perturb(DiscScene& scene, std::uint64_t seed)
{
    Random random(seed);
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        if (scene.bodies.inverse_mass[2 * k] <= 0) continue;
        scene.bodies.inverse_mass.segment<2>(2 * k) *= random.uniform(0.95, 1.05);
        const Real vy = random.uniform(-1e-3, 1e-3), vx = random.uniform(-1e-3, 1e-3);
        scene.bodies.velocity(k) = Vec2(vx, vy);
    }
}

void vary_masses(DiscScene& scene, std::uint64_t seed)
{
    Random random(seed);
    for (Index k = 0; k < scene.bodies.count(); ++k)
        if (scene.bodies.inverse_mass[2 * k] > 0)
            scene.bodies.inverse_mass.segment<2>(2 * k) *= random.uniform(0.95, 1.05);
}

std::vector<Conserving> conserving_scenes(Real h)
{
    std::vector<Conserving> all = {
        {"double pendulum", "two rods of 1 m with discs of 1 kg, the upper one level", linked_discs(2), {}},
        {"four-bar", "a four-bar linkage of 30.9 J", four_bar(), {}},
        {"swinging chain", "ten links of 0.1 m with discs of 1 kg, from level", free_swinging_chain(), {}}};
    for (Conserving& one : all) {
        one.task.h = h;
        one.task.steps = std::lround(10 / h);
        one.task.size = one.scene.links.front().length;
        one.task.rests = false;
        one.task.conserves = true;
    }
    // From the start down to where all hang straight; of the four-bar all that it has.
    all[0].task.energy = 2 * 9.81;
    all[1].task.energy = 30.9;
    all[2].task.energy = 55 * 0.1 * 9.81;
    return all;
}

Task standing()
{
    Task task;
    task.upright = true;
    return task;
}

/// A chain of links of 0.1 m, let go at 30° from straight down; its discs never meet.
DiscScene slanted_chain(Index count, Real end_mass)
{
    DiscScene scene = hanging_chain(count, end_mass);
    const Vec2 along(std::sin(pi / 6), -std::cos(pi / 6));
    for (Index k = 1; k <= count; ++k) scene.bodies.position(k) = 0.1 * static_cast<Real>(k) * along;
    scene.linked = PairSet::all();
    return scene;
}

Task swinging()
{
    Task task;
    task.rests = false;
    task.size = 0.1;
    return task;
}

DiscScene loaded_column() { return column_between_walls(5, 1000, 0.001); }

namespace {

/// No two discs collide and there is no wall.
bool links_alone(const DiscScene& scene)
{
    return scene.walls.empty() && scene.segments.empty() && scene.linked.is_all();
}

/// A run of a scene that a method can hold, unless it has too many rows for it.
std::optional<Verdict> run(const Method& method, const Wish& wish, DiscScene scene, const Task& task,
                           std::uint64_t seed)
{
    if (static_cast<Index>(scene.links.size()) + 2 * scene.bodies.count() > method.most_rows)
        return std::nullopt;
    if (method.links_only && !links_alone(scene)) return std::nullopt;
    perturb(scene, seed);
    return judge(std::move(scene), task, method.start(std::make_shared<const Wish>(wish)));
}

/// A column between walls that leave it a hundredth of a radius of play.
DiscScene held_column(Index count, Real top_mass = 1) { return column_between_walls(count, top_mass, 0.001); }

Stress heavy_top()
{
    const Values R = {1, 30, 1e3, 3e4, 1e6};
    return {"heavy on light", "a disc of R kg on a column of four discs of 1 kg between walls, two seconds",
            with_units(R, "kg"), [R](const Method& method, int level, std::uint64_t seed) {
                return run(method, {}, held_column(5, R[static_cast<std::size_t>(level)]), standing(), seed);
            }};
}

Stress heavy_bottom()
{
    const Values R = {1, 30, 1e3, 3e4, 1e6};
    return {"light on heavy", "four discs of 1 kg on one of R kg between walls, two seconds",
            with_units(R, "kg"), [R](const Method& method, int level, std::uint64_t seed) {
                DiscScene scene = held_column(5);
                scene.bodies.inverse_mass.head<2>().setConstant(1 / R[static_cast<std::size_t>(level)]);
                return run(method, {}, scene, standing(), seed);
            }};
}

Stress tall_column()
{
    const Values N = {10, 20, 40, 80, 160};
    return {"tall column", "a column of N equal discs between walls, two seconds", with_units(N, "discs"),
            [N](const Method& method, int level, std::uint64_t seed) {
                return run(method, {}, held_column(static_cast<Index>(N[static_cast<std::size_t>(level)])),
                           standing(), seed);
            }};
}

Stress long_chain()
{
    const Values N = {10, 30, 100, 300, 1000};
    return {"long chain", "a chain of N equal links, let go at 30°, two seconds", with_units(N, "links"),
            [N](const Method& method, int level, std::uint64_t seed) {
                return run(method, {},
                           slanted_chain(static_cast<Index>(N[static_cast<std::size_t>(level)]), 1),
                           swinging(), seed);
            }};
}

Stress loaded_chain()
{
    const Values R = {1, 6, 30, 180, 1000};
    return {"loaded chain", "a chain of 40 links of 1 kg with R kg at its end, let go at 30°, two seconds",
            with_units(R, "kg"), [R](const Method& method, int level, std::uint64_t seed) {
                return run(method, {}, slanted_chain(40, R[static_cast<std::size_t>(level)]), swinging(),
                           seed);
            }};
}

/// A linkage whose exact energy never changes, at larger and larger steps.
Stress energy_of(std::size_t which)
{
    const Values per_second = {960, 480, 240, 120, 60};
    const Conserving one = conserving_scenes(1).at(which);
    Stress stress{
        one.name, one.what + ": ten seconds in steps of h, and no energy is gained or lost",
        steps_of(per_second),
        [=](const Method& method, int level, std::uint64_t seed) -> std::optional<Verdict> {
            Conserving now = conserving_scenes(1 / per_second[static_cast<std::size_t>(level)]).at(which);
            vary_masses(now.scene, seed);
            return judge(std::move(now.scene), now.task, method.start(std::make_shared<const Wish>()));
        }};
    stress.seeds = {4, 4, 4, 4, 4};
    return stress;
}

Stress time_step()
{
    const Values per_second = {960, 240, 60, 30, 10};
    return {"long step", "the ten discs fall in their box, two seconds with steps of h", steps_of(per_second),
            [per_second](const Method& method, int level, std::uint64_t seed) {
                Task task;
                task.h = 1 / per_second[static_cast<std::size_t>(level)];
                task.steps = std::lround(2 / task.h);
                task.rests = false;
                task.size = 0.1;
                return run(method, {}, ten_discs(), task, seed);
            }};
}

Stress beta()
{
    const Values share = {0.1, 0.5, 1, 1.5, 1.9};
    return {"eager repair", "a triangle of base 4 between walls; a step repays the share β of an error",
            with_units(share, ""),
            [share](const Method& method, int level, std::uint64_t seed) -> std::optional<Verdict> {
                if (!method.has_beta) return std::nullopt;
                Wish wish;
                wish.beta = share[static_cast<std::size_t>(level)];
                return run(method, wish, triangle(4), {}, seed);
            }};
}

Stress restitution()
{
    const Values N = {1, 2, 3, 5, 10};
    return {"bouncing", "N discs above each other, dropped half a metre apart, restitution 1: two seconds",
            with_units(N, "discs"),
            [N](const Method& method, int level, std::uint64_t seed) -> std::optional<Verdict> {
                if (!method.has_restitution) return std::nullopt;
                Wish wish;
                wish.restitution = 1;
                DiscScene scene = held_column(static_cast<Index>(N[static_cast<std::size_t>(level)]));
                for (Index k = 0; k < scene.bodies.count(); ++k)
                    scene.bodies.position(k).y() += 0.5 * static_cast<Real>(k + 1);
                Task task = standing();
                task.rests = false;
                // Symplectic Euler's energy is off by g h u / 2 in the fall: a half percent of this with h = 1/480 s.
                task.h = 1.0 / 480;
                task.steps = 960;
                task.energy = potential_energy(scene.bodies, scene.gravity);
                return run(method, wish, scene, task, seed);
            }};
}

Stress redundant()
{
    const Values copies = {1, 2, 4, 8, 16};
    return {"redundant rows", "a chain of 10 whose links are given n times each, let go at 30°, two seconds",
            with_units(copies, "times"), [copies](const Method& method, int level, std::uint64_t seed) {
                DiscScene scene = slanted_chain(10, 1);
                const std::vector<Link> once = scene.links;
                for (int n = 1; n < static_cast<int>(copies[static_cast<std::size_t>(level)]); ++n)
                    scene.links.insert(scene.links.end(), once.begin(), once.end());
                return run(method, {}, scene, swinging(), seed);
            }};
}

Stress looped_trusses()
{
    const Values seconds = {0.5, 1, 2, 4, 8};
    return {
        "looped truss",
        "random trusses whose rods form loops, discs of 1e-6 m/s, no gravity: no energy is gained in so long",
        with_units(seconds, "s"), [seconds](const Method& method, int level, std::uint64_t seed) {
            // The five discs of section 8.4 in turns with random ones.
            Random random(seed);
            DiscScene scene = seed % 2 == 1 ? five_discs_in_loops() : looped_truss(random);
            if (seed % 2 == 0) scene.bodies.u *= 1e-6;
            Task task;
            task.rests = false;
            task.size = 0.1;
            task.steps = std::lround(60 * seconds[static_cast<std::size_t>(level)]);
            task.energy = kinetic_energy(scene.bodies);
            if (static_cast<Index>(scene.links.size()) > method.most_rows) return std::optional<Verdict>{};
            return std::optional<Verdict>{
                judge(std::move(scene), task, method.start(std::make_shared<const Wish>()))};
        }};
}

Stress conflicting()
{
    const Values share = {1e-4, 1e-3, 1e-2, 1e-1, 1};
    return {"conflicting rows",
            "a chain of 10; a second rod at each link asks for a length that differs by this share",
            with_units(share, ""), [share](const Method& method, int level, std::uint64_t seed) {
                DiscScene scene = slanted_chain(10, 1);
                const std::vector<Link> once = scene.links;
                const Real mismatch = share[static_cast<std::size_t>(level)];
                for (Link link : once) {
                    link.length *= 1 + mismatch;
                    scene.links.push_back(link);
                }
                Task task = swinging();
                task.gap =
                    mismatch * 0.1;  // one of the two rods is off by at least half of it; let either win
                return run(method, {}, scene, task, seed);
            }};
}

Stress far_away()
{
    const Values metres = {1e2, 1e3, 1e4, 1e5, 1e6};
    return {"far away",
            "a column of 5 between walls and off the origin by this much in x and y; also compared with the "
            "origin",
            with_units(metres, "m"),
            [metres](const Method& method, int level, std::uint64_t seed) -> std::optional<Verdict> {
                DiscScene near = held_column(5, 10);
                for (Index k = 0; k < 5; ++k) near.bodies.position(k).y() += 0.5;  // it falls first
                perturb(near, seed);
                DiscScene far = near;
                const Vec2 moved = Vec2::Constant(metres[static_cast<std::size_t>(level)]);
                for (Index k = 0; k < 5; ++k) far.bodies.position(k) += moved;
                for (HalfSpace& wall : far.walls) wall.offset += wall.normal.dot(moved);
                Task task = standing();
                task.rests = false;
                task.energy = lifting(near);
                if (method.links_only) return std::nullopt;
                const auto own = std::make_shared<const Wish>();
                Verdict verdict = judge(far, task, method.start(own));
                // A position that froze would look perfect. While both fall, 0.3 s, their velocities are to agree
                // to a millimetre a second: a millionth of a metre lies between two numbers at 1e6 m / 1e-10.
                const Step here = method.start(own), there = method.start(own);
                for (int n = 0; n < 18; ++n) here(near, task.h), there(far, task.h);
                if (verdict.score > failed && !((near.bodies.u - far.bodies.u).cwiseAbs().maxCoeff() < 1e-3))
                    verdict = {failed, "velocity", verdict.gap};
                return verdict;
            }};
}

Stress small_mass()
{
    const Values mass = {1, 1e-3, 1e-6, 1e-9, 1e-12};
    return {"vanishing mass", "the third of five discs in a column between walls has this mass, two seconds",
            with_units(mass, "kg"), [mass](const Method& method, int level, std::uint64_t seed) {
                DiscScene scene = held_column(5);
                scene.bodies.inverse_mass.segment<2>(4).setConstant(1 /
                                                                    mass[static_cast<std::size_t>(level)]);
                return run(method, {}, scene, standing(), seed);
            }};
}

Stress coincident()
{
    const Values N = {2, 3, 4, 6, 8};
    return {"coincident",
            "N discs in one point of a box without gravity: they are to part within two seconds",
            with_units(N, "discs"),
            [N](const Method& method, int level, std::uint64_t seed) -> std::optional<Verdict> {
                const auto count = static_cast<Index>(N[static_cast<std::size_t>(level)]);
                DiscScene scene;
                scene.bodies = Bodies<2>(count);
                scene.radius = VecX::Constant(count, 0.1);
                scene.walls = {{{1, 0}, -1}, {{-1, 0}, -1}, {{0, 1}, -1}, {{0, -1}, -1}};
                scene.gravity = {0, 0};
                perturb(scene, seed);
                Task task;
                task.rests = false;
                // Parting a whole diameter within a step, each disc gets 2r/h; more than that would be an explosion.
                task.energy = 100 * static_cast<Real>(count) * 0.5 * std::pow(0.2 / task.h, 2);
                if (method.links_only) return std::nullopt;
                return judge(scene, task, method.start(std::make_shared<const Wish>()));
            }};
}

Stress long_run()
{
    const Values steps = {1e2, 1e3, 1e4, 1e5, 1e6};
    Stress stress{"long run", "a column of 5 between walls stands for so many steps at 60 Hz",
                  with_units(steps, "steps"), [steps](const Method& method, int level, std::uint64_t seed) {
                      Task task = standing();
                      task.steps = std::lround(steps[static_cast<std::size_t>(level)]);
                      return run(method, {}, held_column(5), task, seed);
                  }};
    stress.quick = false;
    stress.seeds = {16, 16, 16, 4, 1};  // an exact method needs minutes for a million steps
    return stress;
}

}  // namespace

std::vector<Stress> stresses()
{
    return {heavy_top(),   heavy_bottom(), tall_column(),    long_chain(),  loaded_chain(),
            energy_of(0),  energy_of(1),   energy_of(2),     time_step(),   beta(),
            restitution(), redundant(),    looped_trusses(), conflicting(), far_away(),
            small_mass(),  coincident(),   bad_input(),      long_run()};
}

}  // namespace rigid::stress
