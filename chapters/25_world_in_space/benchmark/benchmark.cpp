/// Chapter 25: work against error for solids that touch, beside other engines.
///
///     SCENE/WHO/N   four seconds at 60 steps a second in N sub-steps each, with 50 iterations in each; nothing sleeps.
///                   bullet_10, jolt_10 and ode_20 have the iterations that these engines have by default, and book_steps
///                   makes N steps, each of which looks for contacts, as Bullet, ODE and Jolt do:
///                   us_step  time of a step, the median over the steps [µs]
///                   overlap  the deepest after the first second [m]
///                   gap      the farthest that a locked coordinate of a joint was off [m, rad]
///                   over     the farthest that a limit of a joint was overstepped [rad]
///                   gained   the most by which the energy of all rose above its least so far [J]
///                   crept    how far the body that moved most in the last two seconds moved in them [m]
///                   moved    and in all four [m]
///                   visits   rows visited in a step, of the book
///                   guesses  of Algorithm 24.2 in a step, of the book; unsolved: steps whose last sub-step did not meet
///                            its tolerance, 1e-6 ℓ/s of sweeps and 1e-9 ℓ/s of guesses

#include "chapters/21_joints_in_space/hung_scenes.hpp"
#include "chapters/25_world_in_space/benchmark/touching.hpp"
#include "chapters/25_world_in_space/built_scenes.hpp"

#ifdef RIGID_HAS_BULLET
#include "chapters/25_world_in_space/benchmark/peer_bullet.hpp"
#endif
#ifdef RIGID_HAS_ODE
#include "chapters/25_world_in_space/benchmark/peer_ode.hpp"
#endif

#ifdef RIGID_HAS_BOX3D
#include "chapters/25_world_in_space/benchmark/peer_box3d.hpp"
#endif

#ifdef RIGID_HAS_JOLT
#include "chapters/25_world_in_space/benchmark/peer_jolt.hpp"
#endif

#include <benchmark/benchmark.h>

#include <functional>
#include <limits>
#include <string>

using namespace rigid;

namespace {

/// A table has the same counters in each row; what was not measured is no number.
void begin(benchmark::State& state)
{
    for (const char* const name :
         {"us_step", "overlap", "gap", "over", "gained", "crept", "moved", "visits",
          "guesses", "unsolved"})
        state.counters[name] = std::numeric_limits<Real>::quiet_NaN();
}

constexpr int iterations = 50;

/// \param steps  a frame is so many steps, each of which looks for contacts
void by_book(benchmark::State& state, SpaceScene scene, int substeps,
             TouchingCones method = {}, int steps = 1)
{
    begin(state);
    const SpaceScene start = scene;
    method.solver.sweeps.max_sweeps = iterations;
    StepData<6> now;
    std::int64_t visits = 0, guesses = 0;
    int unsolved = 0;
    follow(
        state, start,
        [&] {
            bool solved = true;
            for (int i = 0; i < steps; ++i) {
                step(scene, {.h = 1.0 / 60 / steps, .substeps = substeps}, method,
                     now);
                visits += now.visits;
                guesses += method.solver.guesses;
                solved = solved && now.solution.status == Status::solved;
            }
            unsolved += !solved;
        },
        [&](VecX& x, VecX& u) { x = scene.bodies.x, u = scene.bodies.u; });
    state.counters["visits"] = static_cast<Real>(visits) / 240;
    state.counters["guesses"] = static_cast<Real>(guesses) / 240;
    state.counters["unsolved"] = unsolved;
}

template <class Engine>
void by_engine(benchmark::State& state, const SpaceScene& start, int substeps,
               int rounds = iterations)
{
    begin(state);
    Engine engine(start, substeps, rounds);
    follow(
        state, start, [&] { engine.step(1.0 / 60); },
        [&](VecX& x, VecX& u) { engine.read(x, u); });
}

/// Friction is for what may touch, of which there is nothing.
SpaceScene chain_of_fifty()
{
    SpaceScene scene = heavy_chain(50, 1000);
    scene.friction.assign(scene.shapes.size(), 0.5);
    return scene;
}

void register_scene(const std::string& name,
                    const std::function<SpaceScene()>& make)
{
    for (const int substeps : {1, 4, 16}) {
        const auto add = [&](const std::string& who,
                             const std::function<void(benchmark::State&)>& run) {
            benchmark::RegisterBenchmark(
                (name + "/" + who + "/" + std::to_string(substeps)).c_str(), run)
                ->Iterations(1);
        };
        add("book", [=](benchmark::State& s) { by_book(s, make(), substeps); });
        add("book_steps",
            [=](benchmark::State& s) { by_book(s, make(), 1, {}, substeps); });
        add("book_exact", [=](benchmark::State& s) {
            by_book(s, make(), substeps, exact_cones());
        });
#ifdef RIGID_HAS_BULLET
        add("bullet", [=](benchmark::State& s) {
            by_engine<BulletWorld>(s, make(), substeps);
        });
        add("bullet_10", [=](benchmark::State& s) {
            by_engine<BulletWorld>(s, make(), substeps, 10);
        });
#endif
#ifdef RIGID_HAS_ODE
        add("ode_quick",
            [=](benchmark::State& s) { by_engine<OdeWorld>(s, make(), substeps); });
        add("ode_20", [=](benchmark::State& s) {
            by_engine<OdeWorld>(s, make(), substeps, 20);
        });
        add("ode_exact", [=](benchmark::State& s) {
            by_engine<OdeWorld>(s, make(), substeps, 0);
        });
#endif
#ifdef RIGID_HAS_BOX3D
        // it makes one sweep, and one more that relaxes, in each sub-step
        add("box3d", [=](benchmark::State& s) {
            by_engine<Box3dWorld>(s, make(), substeps);
        });
#endif
#ifdef RIGID_HAS_JOLT
        add("jolt",
            [=](benchmark::State& s) { by_engine<JoltPeer>(s, make(), substeps); });
        add("jolt_10", [=](benchmark::State& s) {
            by_engine<JoltPeer>(s, make(), substeps, 10);
        });
#endif
    }
}

const bool registered = [] {
    register_scene("stack_10", [] { return box_stack(10, 0.05, 0.5); });
    register_scene("stack_20", [] { return box_stack(20, 0.05, 0.5); });
    register_scene("heavy_1000_on_3", [] { return heavy_stack(4, 1000); });
    register_scene("heavy_1000_on_19", [] { return heavy_stack(20, 1000); });
    register_scene("pour_60", [] { return simple_heap(60); });
    register_scene("pour_300", [] { return simple_heap(300, 6); });
    register_scene("wall", [] { return brick_wall(10, 10, 0.6); });
    register_scene("chain_1000", [] { return chain_of_fifty(); });
    register_scene("dolls_10", [] { return dolls_on_stairs(10, 2); });
    return true;
}();

}  // namespace

BENCHMARK_MAIN();
