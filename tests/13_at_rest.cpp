/// Chapters 12 and 13: shapes with friction at rest: what keeps a tower still, what sleeps, and what wakes it.

#include "tests/no_allocation.hpp"

#include "chapters/12_contact_manifolds/names_kept.hpp"
#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/friction_solver.hpp"

#include "tests/catch.hpp"
#include "tests/sentence.hpp"

#include <functional>

using namespace rigid;

namespace {

constexpr Real time_step = 1.0 / 60;

/// Sweeps that go on until an island's residual is a micrometre a second.
SkippingFriction careful()
{
    SkippingFriction method;
    method.solver.sweeps.max_sweeps = 200;
    method.solver.sweeps.tolerance = 1e-6;
    return method;
}

RoughScene rough(const RigidScene& smooth, Real mu = 0.6)
{
    RoughScene scene;
    static_cast<RigidScene&>(scene) = smooth;
    cover(scene, {.friction = mu});
    return scene;
}

/// Two towers of five boxes, 6 m apart, on one floor.
RoughScene two_towers()
{
    RigidScene scene;
    scene.walls.push_back({{0, 1}, 0});
    for (const Real x : {-3.0, 3.0})
        for (int i = 0; i < 5; ++i) add_body(scene, box(1, 1), 1, {x + 0.01 * (i % 2), 0.5 + i});
    return rough(scene);
}

/// A solver that visits friction where its contact comes, behind the normal.
struct InPairs : ImpulseSolver<3> {
    void solve(Bodies<3>& bodies, StepData<3>& now)
    {
        const std::size_t normals = now.rows.size() - now.contacts.size();
        order.clear();
        for (std::size_t c = 0; c < now.contacts.size(); ++c) {
            order.push_back(static_cast<int>(normals + c));
            for (std::size_t i = 0; i < normals; ++i)
                if (now.sources[i].index == static_cast<int>(c)) order.push_back(static_cast<int>(i));
        }
        for (const int k : now.active) bodies.velocity(k) = now.u_star.segment<3>(3 * k);
        sequential_impulse(now.rows, std::span<const int>(order), sweeps, memory, bodies.u, now.solution);
    }
};

struct PairedFriction {
    WithFriction<Manifolds> contacts;
    Correction correction = steady_contacts();
    WarmStart start;
    InPairs solver;
};

/// The largest speed of a tower of ten boxes between ten and fifteen seconds after it was put down [m/s].
template <class Method>
Real late_speed(Method method, Stabilizer correction, Real slop)
{
    RigidScene smooth;
    smooth.walls.push_back({{0, 1}, 0});
    for (int i = 0; i < 10; ++i) add_body(smooth, box(1, 1), 1, {0.01 * (i % 2), 0.5 + i});
    RoughScene scene = rough(smooth);
    method.correction.method = correction;
    method.correction.slop = slop;
    StepData<3> now;
    Real fastest = 0;
    for (int i = 0; i < 900; ++i) {
        step(scene, {.h = time_step}, method, now);
        for (Index k = 0; i > 600 && k < 10; ++k)
            fastest = std::max(fastest, scene.bodies.velocity(k).head<2>().norm());
    }
    return fastest;
}

struct World {
    explicit World(RoughScene what) : scene(std::move(what)) {}

    RoughScene scene;
    SkippingFriction method = careful();
    StepData<3> now;

    void run(int steps)
    {
        for (int i = 0; i < steps; ++i) step(scene, {.h = time_step}, method, now);
    }
    bool asleep(Index k) const { return method.contacts.set.is_asleep(k); }
    bool all_asleep() const { return method.contacts.set.awake.empty(); }
};

World asleep_towers()
{
    World room(two_towers());
    room.run(240);
    REQUIRE(room.all_asleep());
    return room;
}

}  // namespace

TEST_CASE("ten sweeps keep a tower of ten at rest if the normals come last and contacts stay closed",
          "[idea]")
{
    // The table of section 13.5, as measured, within what another compiler's sums would change: where nothing
    // comes to rest the motion is chaotic, and only its size is asked.
    struct Cell {
        Stabilizer how;
        Real slop, least_in_pairs, most_last;
    };
    for (const Cell& cell :
         {Cell{Stabilizer::baumgarte, 0, 1, infinity}, Cell{Stabilizer::baumgarte, 0.005, 0.01, 2e-3},
          Cell{Stabilizer::split_impulse, 0, 0.1, 0.05}, Cell{Stabilizer::split_impulse, 0.005, 0.01, 2e-3},
          Cell{Stabilizer::relaxation, 0, 0.5, infinity}, Cell{Stabilizer::relaxation, 0.005, 3e-3, 1e-3}}) {
        CAPTURE(static_cast<int>(cell.how), cell.slop);
        CHECK(late_speed(PairedFriction{}, cell.how, cell.slop) >= cell.least_in_pairs);
        const Real last = late_speed(FrictionSweeps<Manifolds>{}, cell.how, cell.slop);
        CHECK(last <= cell.most_last);
        if (cell.most_last == infinity) CHECK(last >= 0.5);
    }
    // what the method takes by itself is the last line
    const FrictionSweeps<Manifolds> usual;
    CHECK(usual.correction.method == Stabilizer::relaxation);
    CHECK(usual.correction.slop == 0.005);
}

TEST_CASE("without sleep the stage for shapes finds what the plain one finds to the bit", "[house]")
{
    RoughScene scene = rough(pile(60)), twin = scene;
    FrictionSweeps<Manifolds> plain;
    FrictionSweeps<AwakeManifolds> skipping;
    skipping.contacts.sleep = false;
    StepData<3> now, found;
    for (int i = 0; i < 400; ++i) {
        step(scene, {.h = time_step, .substeps = 2}, plain, now);
        step(twin, {.h = time_step, .substeps = 2}, skipping, found);
        REQUIRE(now.contacts.size() == found.contacts.size());
        REQUIRE((scene.bodies.x == twin.bodies.x));
        REQUIRE((scene.bodies.u == twin.bodies.u));
    }
}

TEST_CASE("a heap of shapes with friction falls asleep and then a step does nothing", "[idea]")
{
    World room(rough(pile(60)));
    room.method.solver.sweeps.max_sweeps = 1000;
    int steps = 0;
    do room.run(1);
    while (!room.all_asleep() && ++steps < 3000);
    INFO("asleep after " << steps << " steps");
    REQUIRE(room.all_asleep());
    const VecX x = room.scene.bodies.x;
    room.run(60);
    CHECK((room.scene.bodies.x == x));
    CHECK(room.scene.bodies.u.isZero(0));
    CHECK(room.now.visits == 0);
    CHECK(room.now.active.empty());
}

TEST_CASE("a tower that is hit wakes and the other one sleeps on", "[idea]")
{
    World room = asleep_towers();
    const Index ball = add_body(room.scene, disc(0.3), 1, {-6, 2.5});
    room.scene.bodies.velocity(ball) << 8, 1, 0;
    room.scene.surfaces.push_back({.friction = 0.6});
    // a surface more is another set of surfaces: all wake once, and the right tower sleeps again while the ball comes
    room.scene.bodies.position(ball)[0] = -40;
    const VecX right = room.scene.bodies.x.segment(15, 15);
    room.run(60);
    CHECK(room.asleep(5));
    CHECK(!room.asleep(ball));
    room.scene.bodies.position(ball) << -6, 2.5, 0;
    room.scene.bodies.velocity(ball) << 8, 1, 0;
    bool woke = false;
    for (int i = 0; i < 60; ++i) {
        room.run(1);
        woke = woke || !room.asleep(0);
        CHECK(room.asleep(5));
        CHECK(room.asleep(9));
    }
    CHECK(woke);
    // (10.8) allows a creep of v_rest for t_rest: 0.5 mm
    CHECK((room.scene.bodies.x.segment(15, 15) - right).cwiseAbs().maxCoeff() <= 5e-4);
}

TEST_CASE("what is changed in a scene wakes those that it concerns without anybody being told", "[idea]")
{
    using Change = std::function<void(RoughScene&)>;
    const auto moved_by = [](const Change& change, int left, int right) {
        World room = asleep_towers();
        change(room.scene);
        room.run(1);
        CHECK(!room.asleep(left));
        if (right >= 0) CHECK(room.asleep(right));
        else CHECK(!room.asleep(5));
    };
    // one body: its tower wakes and the other one does not
    moved_by([](RoughScene& s) { s.bodies.velocity(4)[0] = 1; }, 0, 5);
    moved_by([](RoughScene& s) { s.bodies.position(4)[0] += 0.2; }, 0, 5);
    moved_by([](RoughScene& s) { s.bodies.position(2)[0] -= 100; }, 4, 5);
    moved_by([](RoughScene& s) { s.bodies.inverse_mass.segment<3>(12) *= 0.5; }, 0, 5);
    moved_by([](RoughScene& s) { s.bodies.inverse_mass.segment<3>(12).setZero(); }, 0, 5);
    moved_by([](RoughScene& s) { s.shapes[2] = box(1, 0.5); }, 4, 5);
    moved_by([](RoughScene& s) { add_pin(s, 0, {0, 0}, 4, {0, -4}); }, 0, 5);
    // what is there for all
    moved_by([](RoughScene& s) { s.gravity = {1, -9.81}; }, 0, -1);
    moved_by([](RoughScene& s) { s.walls[0].offset = -0.5; }, 0, -1);
    moved_by([](RoughScene& s) { s.wall_surfaces[0].belt = 1; }, 0, -1);
    moved_by([](RoughScene& s) { s.surfaces[3].friction = 0; }, 0, -1);
}

TEST_CASE("a fixed shelf that is taken from under a sleeper wakes it and so does one that is put into it",
          "[idea]")
{
    RigidScene smooth;
    add_body(smooth, box(4, 1), Mass{}, {0, -0.5});
    add_body(smooth, box(1, 1), 1, {0, 0.5});
    World room(rough(smooth));
    room.run(120);
    REQUIRE(room.asleep(1));
    room.scene.bodies.position(0)[1] = -20;
    room.run(60);
    CHECK(room.scene.bodies.x[4] < -3);  // it has fallen freely for a second: 4.9 m
    // put under it again, above: it is met on the way and carries the box
    room.scene.bodies.position(0)[1] = -8;
    room.run(240);
    CHECK(room.asleep(1));
    CHECK(std::abs(room.scene.bodies.x[4] - -7.0) < 0.01);
    room.scene.bodies.position(0)[1] = -7.9;  // 0.1 m into the sleeper
    room.run(1);
    CHECK(!room.asleep(1));
}

TEST_CASE("sleepers wake with the impulses that they fell asleep with", "[idea]")
{
    World room = asleep_towers();
    const VecX x = room.scene.bodies.x;
    // far too little to move anything, but another number
    room.scene.bodies.velocity(4)[0] = 1e-9;
    const auto fastest = [](World& w, int steps) {
        Real most = 0;
        for (int i = 0; i < steps; ++i) {
            w.run(1);
            most = std::max(most, w.scene.bodies.u.cwiseAbs().maxCoeff());
        }
        return most;
    };
    World cold = room;
    cold.method.contacts.forces = {};
    cold.method.contacts.forces.head.assign(10, -1);
    cold.method.start.cache.entries.clear();
    cold.method.solver.sweeps = room.method.solver.sweeps = {.max_sweeps = 4};
    const Real warm_speed = fastest(room, 5), cold_speed = fastest(cold, 5);
    CHECK(!room.asleep(0));
    // as slow as it has to be to sleep, v_rest of 1 mm/s; from zero, four sweeps on a tower of five let it drop
    CHECK(warm_speed <= 1e-3);
    CHECK(cold_speed > 10 * warm_speed);
    CHECK((room.scene.bodies.x - x).cwiseAbs().maxCoeff() <= 1e-4);
}

TEST_CASE("what changes for all wakes sleepers with their impulses as well", "[idea]")
{
    World room = asleep_towers();
    for (Surface& surface : room.scene.surfaces) surface.friction = 0.5;
    room.method.solver.sweeps = {.max_sweeps = 4};
    for (int i = 0; i < 5; ++i) {
        room.run(1);
        // v_rest; from zero, four sweeps let a tower of five drop ten times as fast
        CHECK(room.scene.bodies.u.cwiseAbs().maxCoeff() <= 1e-3);
    }
    CHECK(!room.asleep(0));
    CHECK(!room.asleep(9));
}

TEST_CASE("contacts have their names again after sleep", "[idea]")
{
    World room = asleep_towers();
    NamedImpulses last;
    last.remember(room.now);
    room.scene.bodies.velocity(4)[0] = 1e-9;
    room.run(1);
    REQUIRE(!room.asleep(0));
    // of the left tower; the right one still sleeps
    NamedImpulses left;
    for (const auto& entry : last.of)
        if (entry.key.second < 5) left.of.push_back(entry);
    CHECK(left.share_kept(room.now) == 1);
}

TEST_CASE("a name that memory alone keeps is there again after sleep", "[idea]")
{
    RigidScene smooth;
    smooth.walls.push_back({{0, 1}, 0});
    add_body(smooth, box(1, 1), 1, {0, 0.5});
    add_body(smooth, box(1, 1), 1, {1e-6, 1.5});
    // A disc that rolls past keeps the step busy while the boxes sleep.
    add_body(smooth, disc(0.5), 1, {40, 0.5});
    World room(rough(smooth));
    room.scene.bodies.velocity(2) = Vec<3>(1, 0, -2);
    room.run(1);
    // Corners over corners, now on the other side: the pair keeps its names only because it had them before.
    room.scene.bodies.position(1)[0] = -1e-6;
    NamedImpulses last;
    for (int i = 0; i < 240 && !room.asleep(0); ++i) {
        room.run(1);
        last.remember(room.now);
    }
    room.run(5);
    REQUIRE(room.asleep(0));
    REQUIRE(!room.asleep(2));
    room.scene.bodies.velocity(1)[0] = 1e-9;
    room.run(1);
    REQUIRE(!room.asleep(0));
    CHECK(last.share_kept(room.now) == 1);
}

TEST_CASE("a heap that sleeps stays where it is when all are woken and may not sleep", "[house]")
{
    // Heaps of random shapes; between one rest and the next something in them is changed.
    int rests = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        Random random(seed);
        RigidScene smooth;
        smooth.walls.push_back({{0, 1}, 0});
        for (int i = 0; i < 15; ++i) {
            const Real size = random.uniform(0.3, 1), other = random.uniform(0.3, 1);
            const Real x = random.uniform(-4, 4), y = random.uniform(0.7, 6);
            const Polygon shape = i % 3 == 0   ? disc(size / 2)
                                  : i % 3 == 1 ? capsule(size / 2, 0.2)
                                               : box(size, other);
            add_body(smooth, shape, 1, {x, y}, random.uniform(-1, 1));
        }
        World room(rough(smooth, random.uniform(0.2, 1)));
        for (Surface& surface : room.scene.surfaces) surface.rolling = 0.02;
        for (Surface& surface : room.scene.wall_surfaces) surface.rolling = 0.02;
        for (int change = 0; change < 3; ++change) {
            room.run(300);
            const Index k = random.index(15);
            const Real by = random.uniform(0.2, 2);
            if (room.all_asleep()) {
                ++rests;
                World woken = room;
                woken.method.contacts.sleep = false;
                woken.run(30);
                CAPTURE(seed, change);
                // half a second: what rest allows is v_rest in all of it
                CHECK((woken.scene.bodies.x - room.scene.bodies.x).cwiseAbs().maxCoeff() <= 1e-3 * 0.5);
            }
            if (change == 0) room.scene.bodies.position(k)[1] += by;
            if (change == 1) room.scene.bodies.inverse_mass.segment<3>(3 * k) *= by;
        }
    }
    CHECK(rests > 20);
}

TEST_CASE("a disc that spins in its place never falls asleep", "[idea]")
{
    RigidScene smooth;
    smooth.gravity = {0, 0};
    add_body(smooth, disc(1), 1, {0, 0});
    World room(rough(smooth));
    room.scene.bodies.velocity(0)[2] = 0.01;  // its rim runs at ten times v_rest
    room.run(300);
    CHECK(!room.asleep(0));
    CHECK(room.scene.bodies.velocity(0)[2] == 0.01);
}

TEST_CASE("a box that a slow platform carries never falls asleep", "[idea]")
{
    RigidScene smooth;
    add_body(smooth, box(4, 1), Mass{}, {0, -0.5});
    add_body(smooth, box(1, 1), 1, {0, 0.5});
    World room(rough(smooth));
    room.scene.bodies.velocity(0)[0] = 2e-4;  // slower than rest
    room.run(300);
    CHECK(!room.asleep(1));
    CHECK(room.scene.bodies.x[3] - room.scene.bodies.x[0] < 1e-4);
}

TEST_CASE("the rows and free velocities of the last step stay together when all have fallen asleep",
          "[house]")
{
    World room(two_towers());
    int steps = 0;
    do room.run(1);
    while (!room.all_asleep() && ++steps < 1000);
    REQUIRE(room.all_asleep());
    const VecX u_star = room.now.u_star, lambda = room.now.solution.lambda;
    REQUIRE(room.now.rows.size() > 0);
    CHECK(u_star[1] < -time_step * 9.81 / 2);  // not the 0 of a sleeper
    room.run(3);
    CHECK((room.now.u_star == u_star));
    CHECK((room.now.solution.lambda == lambda));
}

TEST_CASE("a platform that was stopped carries nothing on", "[idea]")
{
    RigidScene smooth;
    add_body(smooth, box(40, 1), Mass{}, {0, -2});
    add_body(smooth, box(1, 1), 1, {0, 1.5});
    World room(rough(smooth));
    auto platform = room.scene.bodies.velocity(0);
    platform << 2, 3, 0;
    room.run(10);  // half a metre up, and not yet below the box
    REQUIRE(room.scene.bodies.x[4] - room.scene.bodies.x[1] > 1.05);
    platform.setZero();
    room.run(90);
    CHECK(std::abs(room.scene.bodies.x[3]) < 1e-3);
    CHECK(std::abs(room.scene.bodies.x[4] - room.scene.bodies.x[1] - 1) < 0.01);
    CHECK(room.scene.bodies.velocity(1).norm() < 1e-3);
}

TEST_CASE("steps of boxes that wake and sleep again allocate nothing", "[house]")
{
    World room = asleep_towers();
    const auto knock = [&] {
        room.scene.bodies.velocity(4)[0] += 0.01;
        room.run(120);
    };
    knock();
    knock();
    {
        const NoAllocation watch;
        knock();
    }
    CHECK(NoAllocation::violations() == 0);
    CHECK(room.all_asleep());
}

TEST_CASE("settings of rest that make no sense are refused before shapes move", "[house]")
{
    World room(two_towers());
    room.method.contacts.rest.speed = -1;
    CHECK(sentence_of([&] { room.run(1); }) == "the speed of rest is -1; it must be positive and finite");
}

TEST_CASE("a body that is changed has to rest for all of its time however fast it was then", "[idea]")
{
    for (const bool changed : {false, true}) {
        RigidScene smooth;
        smooth.walls.push_back({{0, 1}, 0});
        add_body(smooth, box(1, 1), 1, {0, 0.5});
        RoughScene scene = rough(smooth);
        scene.bodies.u[0] = 1;
        SkippingFriction method = careful();
        StepData<3> now;
        step(scene, {.h = time_step}, method, now);
        CHECK(method.contacts.rests[0].time == 0);  // too fast
        if (changed) scene.bodies.u[0] = 0.5;
        step(scene, {.h = time_step}, method, now);
        CHECK(method.contacts.rests[0].undisturbed == (changed ? time_step : infinity));
        int steps = 0;
        while (steps < 200 && (steps == 0 || method.contacts.set.is_awake(0))) {
            step(scene, {.h = time_step}, method, now);
            ++steps;
        }
        // it slides for v/(μ g) = 0.17 s or 0.085 s and lies still at once; changed, it rests for half a second more
        if (changed) CHECK(steps >= 30);
        else CHECK(steps < 30);
    }
}
