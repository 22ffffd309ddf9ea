/// Chapter 8, small steps: what they are held to, and how they and other engines are measured.

#include "tests/no_allocation.hpp"

#include "chapters/08_warm_starting/benchmark/pose_errors.hpp"
#include "chapters/08_warm_starting/small_steps.hpp"
#include "chapters/08_warm_starting/warm_method.hpp"
#include "common/random.hpp"

#include "tests/catch.hpp"

#include <bit>
#include <limits>

namespace rigid::small_steps_tests {

EngineScene engine_scene(const std::string& name)
{
    for (EngineScene& scene : engine_scenes())
        if (scene.name == name) return scene;
    throw std::invalid_argument("there is no scene " + name);
}

/// Discs that fall over each other between walls; some pairs are linked.
DiscScene heap(Random& random)
{
    const Index count = 4 + random.index(8);
    DiscScene scene;
    scene.bodies = Bodies<2>(count);
    scene.radius.resize(count);
    for (Index k = 0; k < count; ++k) {
        scene.bodies.position(k) << random.uniform(-0.3, 0.3), 0.15 + 0.17 * static_cast<Real>(k);
        scene.bodies.velocity(k) << random.uniform(-1, 1), random.uniform(-1, 1);
        scene.bodies.inverse_mass.segment<2>(2 * k).setConstant(1 / random.uniform(0.2, 5));
        scene.radius[k] = random.uniform(0.05, 0.12);
    }
    for (Index k = 0; k + 1 < count; k += 3)
        scene.links.push_back({k, k + 1, (scene.bodies.position(k + 1) - scene.bodies.position(k)).norm()});
    scene.walls = {{{0, 1}, 0}, {{1, 0}, -0.45}, {{-1, 0}, -0.45}};
    link_neighbours(scene);
    return scene;
}

/// The settings of a step for what small steps do.
StepSettings same_settings(const SmallStepSettings& small)
{
    StepSettings settings;
    settings.h = small.h;
    settings.margin = small.margin;
    settings.substeps = small.substeps;
    return settings;
}

/// And the method.
WarmMethod same_method(const SmallStepSettings& small)
{
    WarmMethod method;
    static_cast<StabilizerSettings&>(method.correction) = small.correction;
    method.correction.at_the_end = true;
    method.start.from = Start::best_multiple;
    method.start.rule = small.start;
    method.solver.sweeps.max_sweeps = small.sweeps;
    method.solver.ordering = small.coloured ? Order::coloured : Order::given;
    return method;
}

VecX run_small(DiscScene scene, const SmallStepSettings& settings, int steps)
{
    SmallStep now;
    for (int k = 0; k < steps; ++k) small_steps(scene, settings, now);
    return scene.bodies.x;
}

PoseErrors watched(const EngineScene& from, SmallStepSettings settings, int steps)
{
    settings.collides = from.collides;
    PoseWatch watch(from, steps, settings.h);
    SmallStep now;
    DiscScene scene = from.scene;
    for (int k = 0; k < steps; ++k) {
        small_steps(scene, settings, now);
        watch.look(scene);
    }
    return watch.errors;
}

TEST_CASE("a small step of another length starts from the scaled impulses also where its rows are the same",
          "[idea]")
{
    DiscScene scene = engine_scene("column_20_1").scene;
    SmallStepSettings settings = quick_steps();
    SmallStep now;
    for (int k = 0; k < 20; ++k) small_steps(scene, settings, now);
    REQUIRE(now.same_rows);
    settings.h *= 0.75;
    DiscScene anew = scene;
    SmallStep made_anew = now;
    made_anew.forget_rows = true;  // then nothing is reused but the impulses, scaled
    small_steps(scene, settings, now);
    small_steps(anew, settings, made_anew);
    CHECK(scene.bodies.u == anew.bodies.u);
    CHECK(scene.bodies.x == anew.bodies.x);
}

TEST_CASE("small steps are the warm step with nothing computed twice", "[idea]")
{
    Random random(81);
    int rows_changed = 0;
    for (int sample = 0; sample < 60; ++sample) {
        DiscScene small = heap(random), warm = small;
        SmallStepSettings settings = sample % 2 ? careful_steps() : quick_steps();
        settings.first_sweeps = 0;  // the warm step has no such thing
        settings.sweeps = 1 + sample % 3;
        settings.coloured = sample % 4 < 2;
        settings.correction.slop = 0;  // what a row inside its slop takes from its neighbours, and
        settings.correction.max_correction_speed =
            infinity;  // how a limit is shared among visits, is each step's own
        const StepSettings same = same_settings(settings);
        WarmMethod method = same_method(settings);
        SmallStep now;
        StepData<2> other;
        for (int k = 0; k < 12; ++k) {
            small_steps(small, settings, now);
            step(warm, same, method, other);
            rows_changed += now.same_rows ? 0 : 1;
        }
        CAPTURE(sample);
        // Rounding errors of 1e-16 grow with each impact of a heap.
        CHECK((small.bodies.x - warm.bodies.x).lpNorm<Eigen::Infinity>() < 1e-10);
        CHECK((small.bodies.u - warm.bodies.u).lpNorm<Eigen::Infinity>() < 1e-8);
    }
    CHECK(rows_changed > 200);  // contacts came and went
}

TEST_CASE("rows that are kept because nothing came or went give the same bits as rows made again", "[house]")
{
    for (const char* name : {"hanging_10_10", "column_10_100", "triangle_10"}) {
        const EngineScene from = engine_scene(name);
        SmallStepSettings settings = quick_steps();
        settings.first_sweeps = 3;
        DiscScene kept = from.scene, anew = from.scene;
        SmallStep now, other;
        int kept_steps = 0;
        for (int k = 0; k < 60; ++k) {
            small_steps(kept, settings, now);
            kept_steps += now.same_rows ? 1 : 0;
            other.forget_rows = true;
            small_steps(anew, settings, other);
            REQUIRE(!other.same_rows);
        }
        CAPTURE(name);
        CHECK(kept_steps > 50);
        CHECK(kept.bodies.x == anew.bodies.x);
        CHECK(kept.bodies.u == anew.bodies.u);
    }
}

TEST_CASE("a small step allocates no memory once it has run the scene", "[house]")
{
    for (const char* name : {"swinging_10_10", "column_20_1", "triangle_10"})
        for (const bool forget : {false, true}) {
            const EngineScene from = engine_scene(name);
            SmallStepSettings settings = quick_steps();
            settings.collides = from.collides;
            DiscScene scene = from.scene;
            SmallStep now;
            for (int k = 0; k < 5; ++k) {
                now.forget_rows = forget;
                small_steps(scene, settings, now);
            }
            {
                const NoAllocation guard;
                for (int k = 0; k < 5; ++k) {
                    now.forget_rows = forget;
                    small_steps(scene, settings, now);
                }
            }
            CAPTURE(name, forget);
            CHECK(NoAllocation::violations() == 0);
        }
}

TEST_CASE("a first step from known impulses leaves a column where it stands", "[idea]")
{
    // 1e-6 m/s of what the sweeps leave in the first step is all that there is to sink by; without them the column
    // of 20 sinks by millimetres before its impulses have grown.
    const EngineScene column = engine_scene("column_20_1");
    const PoseErrors known = watched(column, careful_steps(), 300);
    CHECK(known.overlap < 1e-5);
    CHECK(known.drift < 1e-5);
    CHECK(known.speed < 1e-5);
    SmallStepSettings cold = careful_steps();
    cold.first_sweeps = 0;
    CHECK(watched(column, cold, 300).overlap > 2e-4);
}

TEST_CASE("what small steps correct at the end is an overlap beyond the slop and the whole error of a link",
          "[idea]")
{
    // No gravity and nothing moves, so that only the projection changes x. Two discs of 0.1 m and a link of 1 m, apart.
    DiscScene scene;
    scene.gravity = {0, 0};
    scene.bodies = Bodies<2>(4);
    scene.radius = VecX::Constant(4, 0.1);
    const Real length = typical_length(scene), slop = quick_steps().correction.slop * length;
    const auto lay = [&](Real overlap, Real stretch) {
        scene.bodies.x << 0, 0, 0.2 - overlap, 0, 0, 2, 1 + stretch, 2;
        scene.links = {{2, 3, 1}};
        link_neighbours(scene);
        SmallStep now;
        small_steps(scene, quick_steps(), now);
    };
    // Rounding of places of 2 m: a few 1e-16 m.
    lay(0.5 * slop, 0.01);
    CHECK(scene.bodies.x[2] - scene.bodies.x[0] == Approx(0.2 - 0.5 * slop).margin(1e-14));
    CHECK(scene.bodies.x[6] - scene.bodies.x[4] == Approx(1).margin(1e-14));
    lay(3 * slop, -0.01);
    CHECK(scene.bodies.x[2] - scene.bodies.x[0] == Approx(0.2 - slop).margin(1e-14));
    CHECK(scene.bodies.x[6] - scene.bodies.x[4] == Approx(1).margin(1e-14));
    CHECK(scene.bodies.u.isZero(0));
}

TEST_CASE("a triangle on a base of 20 stands with careful steps", "[house]")
{
    const PoseErrors errors = watched(engine_scene("triangle_20"), careful_steps(), 300);
    CHECK(errors.in_order);
    CHECK(errors.position() < 1e-4);  // a five-hundredth of a gap that would let a disc through
    CHECK(errors.speed < 1e-3);
}

TEST_CASE("links of a swinging chain are a fifteenth of a link off at most with quick steps", "[house]")
{
    // 16 s of a whip; the largest error is where its end cracks.
    for (const char* name : {"swinging_10_1", "swinging_10_10"}) {
        const PoseErrors errors = watched(engine_scene(name), quick_steps(), 1000);
        CHECK(errors.link < 0.1 / 12);
        CHECK(errors.drift < 0.06);
    }
}

TEST_CASE("no small step adds energy to a heap or to a chain that swings", "[idea]")
{
    // Mass ratios up to 1000, and overlaps to begin with: the projection lifts what lies on them.
    Random random(82);
    for (int sample = 0; sample < 20; ++sample) {
        const bool chain = sample % 2 == 1;
        DiscScene scene = chain ? swinging_chain(20, std::pow(10, random.uniform(0, 3))) : heap(random);
        for (Index k = 0; !chain && k < scene.bodies.count(); ++k)
            scene.bodies.inverse_mass.segment<2>(2 * k) *= std::pow(10, random.uniform(-1.5, 1.5));
        const auto energy = [&] {
            return kinetic_energy(scene.bodies) + potential_energy(scene.bodies, scene.gravity);
        };
        const SmallStepSettings settings = sample % 4 < 2 ? quick_steps() : careful_steps();
        SmallStep now;
        small_steps(scene, settings, now);
        const Real begin = energy(),
                   scale = chain ? -potential_energy(hanging_chain(20).bodies, scene.gravity) : begin;
        Real most = begin;
        for (int k = 0; k < 400; ++k) {
            small_steps(scene, settings, now);
            most = std::max(most, energy());
        }
        CAPTURE(sample);
        CHECK(scene.bodies.x.allFinite());
        CHECK(most - begin < 0.02 * scale);
    }
}

TEST_CASE("small steps on a disc that is driven are the warm step too", "[idea]")
{
    // Three discs in a column on one that nothing moves: it rises, sinks, or falls away from under them.
    for (const Real speed : {0.1, -0.1, 1.0, -1.0}) {
        DiscScene scene;
        scene.length = 1;
        scene.bodies = Bodies<2>(4);
        scene.radius = VecX::Constant(4, 0.1);
        for (Index k = 0; k < 4; ++k) scene.bodies.position(k) = Vec2(0, 0.2 * static_cast<Real>(k));
        scene.bodies.inverse_mass << 0, 0, 1, 1, 1, 1, 1, 1;
        scene.bodies.velocity(0) = Vec2(0, speed);
        SmallStepSettings settings;
        settings.start = {};
        settings.first_sweeps = 1;
        settings.correction.slop = 0;
        DiscScene other = scene;
        SmallStep now;
        WarmMethod method = same_method(settings);
        StepData<2> then;
        for (int k = 0; k < 30; ++k) {
            small_steps(scene, settings, now);
            step(other, same_settings(settings), method, then);
            // Discs that fall freely have no load at all, and a multiple of rounding: 1e-12 of impulses of 1 N s.
            CHECK((scene.bodies.x - other.bodies.x).cwiseAbs().maxCoeff() < 1e-10);
        }
    }
}

TEST_CASE("small steps with settings that make no sense are refused", "[house]")
{
    const auto sentence = [](auto change) -> std::string {
        DiscScene scene = engine_scene("column_10_1").scene;
        SmallStepSettings settings;
        change(settings);
        SmallStep now;
        try {
            small_steps(scene, settings, now);
        } catch (const std::invalid_argument& refused) {
            return refused.what();
        }
        return "accepted";
    };
    CHECK(sentence([](auto&) {}) == "accepted");
    CHECK(sentence([](auto& s) { s.substeps = 0; }).find("0 substeps") != std::string::npos);
    CHECK(sentence([](auto& s) { s.sweeps = 0; }).find("0 sweeps") != std::string::npos);
    CHECK(sentence([](auto& s) { s.h = -1; }).find("time step") != std::string::npos);
    CHECK(sentence([](auto& s) { s.correction.slop = -1; }).find("slop") != std::string::npos);
    CHECK(sentence([](auto& s) { s.correction.beta = 0.5; }).find("beta") != std::string::npos);
    CHECK(
        sentence([](auto& s) { s.correction.tolerance = 1e-9; }) ==
        "the tolerance of the corrections is 1e-09; small steps make all their correction sweeps, so it must "
        "be 0");
    CHECK(sentence([](auto& s) { s.first_tolerance = std::numeric_limits<Real>::infinity(); }) ==
          "the tolerance of the first sweeps is inf; it must be zero or positive, and finite");
    for (const Stabilizer other :
         {Stabilizer::none, Stabilizer::baumgarte, Stabilizer::relaxation, Stabilizer::split_impulse})
        CHECK(sentence([other](auto& s) { s.correction.method = other; }) ==
              "the correction is " + std::string(to_string(other)) +
                  "; small steps correct errors of position by projection alone");
}

TEST_CASE("small steps fall with the gravity of the scene and refuse what they do not support", "[house]")
{
    DiscScene scene = column(1);
    scene.walls.clear();
    scene.gravity = {1, -2};
    SmallStep now;
    small_steps(scene, {.h = 0.25, .substeps = 1}, now);
    CHECK(scene.bodies.velocity(0) == Vec2(0.25, -0.5));  // powers of two: exact

    const auto sentence = [](const DiscScene& from) -> std::string {
        DiscScene refused = from;
        SmallStep memory;
        try {
            small_steps(refused, quick_steps(), memory);
        } catch (const std::invalid_argument& error) {
            CHECK(refused.bodies.x == from.bodies.x);
            CHECK(refused.bodies.u == from.bodies.u);
            return error.what();
        }
        return "accepted";
    };
    CHECK(sentence(ten_discs()).find("5 bends") != std::string::npos);
    DiscScene jointed = column(3);
    jointed.joints.resize(2);
    CHECK(sentence(jointed).find("2 joints") != std::string::npos);
    scene.gravity = {0, infinity};
    CHECK(sentence(scene).find("gravity") != std::string::npos);
}

TEST_CASE("discs in one point and immovable pairs do not make a number that is none", "[house]")
{
    DiscScene scene = column(4);
    scene.bodies.position(1) = scene.bodies.position(0);
    scene.bodies.inverse_mass.segment<2>(4).setZero();
    scene.bodies.inverse_mass.segment<2>(6).setZero();
    scene.bodies.position(3) = scene.bodies.position(2);
    scene.links = {{2, 3, 0.1}};
    const VecX fixed = scene.bodies.x.tail(4);
    SmallStep now;
    for (int k = 0; k < 100; ++k) small_steps(scene, quick_steps(), now);
    CHECK(scene.bodies.x.allFinite());
    CHECK(scene.bodies.u.allFinite());
    CHECK(scene.bodies.x.tail(4) == fixed);
}

TEST_CASE("every scene of the engines is valid and begins at rest within two nanometres", "[house]")
{
    const std::vector<EngineScene> scenes = engine_scenes();
    CHECK(scenes.size() == 27);
    for (const EngineScene& scene : scenes) {
        CAPTURE(scene.name);
        require_valid(scene.scene);
        CHECK(scene.scene.bodies.u.isZero(0));
        // Two neighbours, each a nanometre off, and coordinates of up to 20 m to rounding; what swings is exact.
        const Real off = scene.rests ? 2.0001 * nudge : 1e-14;
        CHECK(largest_link_error(scene.scene) < off);
        CHECK(deepest_penetration(scene.scene) < off);
        CHECK((scene.collides || deepest_penetration(scene.scene) == 0));
    }
}

TEST_CASE("no scene that engines are compared on rests to the last bit", "[house]")
{
    for (const EngineScene& scene : engine_scenes()) {
        if (!scene.rests) continue;
        CAPTURE(scene.name);
        const Bodies<2>& bodies = scene.scene.bodies;
        // A chain and a column stand on the line x = 0; each of their discs is beside it by less than a nanometre. The
        // discs of a triangle are half a disc apart, and its lowest row lies at the height of a radius.
        const bool on_a_line = scene.name.rfind("triangle", 0) != 0;
        Index count = 0;
        for (Index k = 0; k < bodies.count(); ++k) {
            if (!(bodies.inverse_mass[2 * k] > 0)) continue;
            const Real off = on_a_line ? bodies.x[2 * k] : std::remainder(bodies.x[2 * k], 0.1);
            CHECK(off != 0);
            CHECK(std::abs(off) <= 1.0001 * nudge);
            ++count;
        }
        CHECK(count >= 10);
    }
}

TEST_CASE("the chain that engines are compared with converges with order 4 and keeps energy and lengths",
          "[house]")
{
    const EngineScene from = engine_scene("swinging_10_10");
    const auto at_one_second = [&](int steps) {
        ChainReference chain(from.scene);
        for (int k = 0; k < steps; ++k) chain.step(Real{1} / steps);
        return chain;
    };
    const ChainReference fine = at_one_second(32000);
    DiscScene then = from.scene;
    then.bodies.x = fine.x;
    then.bodies.u = fine.u;
    const Real energy = kinetic_energy(then.bodies) + potential_energy(then.bodies, then.gravity);
    CHECK(std::abs(energy) < 1e-7 * kinetic_energy(then.bodies));  // it began with none
    CHECK(largest_link_error(then) < 1e-9);
    Real before = 0, order = 0;
    for (int steps = 500; steps <= 4000; steps *= 2) {
        const Real error = (at_one_second(steps).x - fine.x).norm();
        if (before > 0) order = std::log2(before / error);
        before = error;
    }
    CHECK(order == Approx(4).margin(0.15));
    // What PoseWatch uses: 200 parts of a sixtieth of a second.
    CHECK((at_one_second(12000).x - fine.x).lpNorm<Eigen::Infinity>() < 1e-8);
    then.links[3] = {4, 3, 0.1};
    CHECK_THROWS_AS(ChainReference(then), std::invalid_argument);
}

TEST_CASE("the measure of errors finds each of them", "[house]")
{
    const EngineScene from = engine_scene("column_10_1");
    const auto errors_after = [&](auto change) {
        PoseWatch watch(from, 2, 0.5);
        DiscScene scene = from.scene;
        watch.look(scene);
        change(scene);
        watch.look(scene);
        return watch.errors;
    };
    const PoseErrors none = errors_after([](DiscScene&) {});
    CHECK(none.position() < 2.0001 * nudge);  // as it began
    CHECK(none.drift == 0);
    CHECK(none.speed == 0);
    CHECK(none.in_order);
    const PoseErrors up = errors_after(
        [](DiscScene& scene) { scene.bodies.x[19] += 0.1; });  // the uppermost, by 0.1 m in half a second
    CHECK(up.drift == Approx(0.01));
    CHECK(up.speed == Approx(0.2));
    CHECK(up.overlap < 2.0001 * nudge);
    const PoseErrors down = errors_after([](DiscScene& scene) { scene.bodies.x[19] -= 0.03; });
    CHECK(down.overlap == Approx(0.03));
    CHECK(down.late == Approx(0.03));
    CHECK(down.in_order);
    CHECK(!errors_after([](DiscScene& scene) { std::swap(scene.bodies.x[1], scene.bodies.x[3]); }).in_order);
    const PoseErrors lost =
        errors_after([](DiscScene& scene) { scene.bodies.x[0] = std::numeric_limits<Real>::quiet_NaN(); });
    CHECK(!lost.in_order);
    CHECK(lost.position() == infinity);
}

}  // namespace rigid::small_steps_tests
