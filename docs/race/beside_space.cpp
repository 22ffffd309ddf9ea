/// \file beside_space.cpp
/// Our side of the runs in node (beside.mjs) in space: the scenes of chapter 25's benchmark, its methods on them, and the
/// judge of both sides, which is that of the benchmark.
#include "chapters/25_world_in_space/benchmark/touching.hpp"
#include "chapters/25_world_in_space/built_scenes.hpp"
#include "chapters/25_world_in_space/cradle.hpp"
#include "chapters/25_world_in_space/space_sleep.hpp"
#include "docs/race/space_text.hpp"

#include <array>
#include <functional>
#include <optional>
#include <variant>

namespace rigid::race {
namespace {

struct SpaceRun : Measured {
    std::function<SpaceScene()> make;
};

/// Each body begins up to 0.1 mm beside its place.
SpaceScene unsettled(SpaceScene scene)
{
    Random random(1);
    for (Index k = 0; k < scene.bodies.count(); ++k) {
        const Real x = random.uniform(-1e-4, 1e-4), z = random.uniform(-1e-4, 1e-4);
        scene.bodies.x[6 * k] += x;
        scene.bodies.x[6 * k + 2] += z;
    }
    return scene;
}

/// Friction is for what may touch, of which there is nothing.
SpaceScene chain_of_fifty()
{
    SpaceScene scene = heavy_chain(50, 1000);
    scene.friction.assign(scene.shapes.size(), 0.5);
    return scene;
}

std::vector<SpaceRun> space_runs()
{
    return {
        {{"stack_10", "ten boxes", "m"}, [] { return unsettled(box_stack(10, 0.05, 0.5)); }},
        {{"stack_20", "twenty boxes", "m"}, [] { return unsettled(box_stack(20, 0.05, 0.5)); }},
        {{"heavy", "1000 times the mass on three", "m"}, [] { return unsettled(heavy_stack(4, 1000)); }},
        {{"wall", "wall of 105 bricks", "m"}, [] { return unsettled(brick_wall(10, 10, 0.6)); }},
        {{"chain", "chain of 50 with a heavy end", "g"}, [] { return chain_of_fifty(); }},
        {{"dolls", "ten dolls on stairs", "go"}, [] { return dolls_on_stairs(10, 2); }},
        {{"pour_60", "60 poured", "o"}, [] { return simple_heap(60); }},
        {{"pour_300", "300 poured", "o"}, [] { return simple_heap(300, 6); }},
    };
}

struct Page {
    std::vector<SpaceRun> runs = space_runs();
    const SpaceRun* run = nullptr;
    SpaceScene start, ours;
    std::variant<TouchingCones, SleepingCones> method;
    StepData<6> now;
    int substeps = 1;
    std::optional<SpaceJudge> judge;
    VecX theirs, x;
    std::array<Real, 3> found{};
};

Page& page()
{
    static Page one;
    return one;
}

}  // namespace
}  // namespace rigid::race

using namespace rigid;
using namespace rigid::race;

RIGID_PAGE(web_start) int web_start()
{
    return attempt([] { page(); });
}
RIGID_PAGE(web_description) const char* web_description()
{
    return said(description_of("beside_space", page().runs));
}
RIGID_PAGE(web_sentence) const char* web_sentence() { return last_said().sentence.c_str(); }

/// Begins a run. \param how  1: exact where an island has at most 1000 rows, else: sweeps; \param sweeps  0: as they come
RIGID_PAGE(race_open) int race_open(int scene, int how, int substeps, int sweeps, int sleep)
{
    return attempt([&] {
        Page& all = page();
        all.run = &all.runs.at(static_cast<std::size_t>(scene));
        all.start = all.run->make();
        all.ours = all.start;
        all.judge.emplace(all.start);
        all.now = {};
        all.substeps = substeps;
        if (sleep != 0) all.method.emplace<SleepingCones>();
        else all.method.emplace<TouchingCones>();
        std::visit(
            [&](auto& method) {
                if (how == 1) {
                    const TouchingCones exact = exact_cones();
                    method.solver.exact_rows = exact.solver.exact_rows;
                    method.solver.sweeps = exact.solver.sweeps;
                }
                if (sweeps > 0) method.solver.sweeps.max_sweeps = sweeps;
            },
            all.method);
        all.theirs.resize(7 * all.start.bodies.count());
    });
}
RIGID_PAGE(race_scene) const char* race_scene() { return said(space_text(page().ours)); }
RIGID_PAGE(race_step) int race_step(double h)
{
    return attempt([&] {
        Page& all = page();
        std::visit([&](auto& method) { step(all.ours, {.h = h, .substeps = all.substeps}, method, all.now); },
                   all.method);
    });
}
/// Room for where their bodies are, (x, y, z) and a quaternion with its w last of each.
RIGID_PAGE(race_theirs) double* race_theirs() { return page().theirs.data(); }
/// The errors of our positions, or of theirs: moved, gap, overlap [m]; what is no error of the scene is 0.
RIGID_PAGE(race_errors) const double* race_errors(int theirs)
{
    Page& all = page();
    all.found.fill(0);
    all.x = all.ours.bodies.x;
    if (theirs != 0)
        for (Index k = 0; k < all.start.bodies.count(); ++k) {
            const auto t = all.theirs.segment<7>(7 * k);
            // in floats it is a unit quaternion to 1e-7
            const Real length = t.tail<4>().norm();
            all.x.segment<6>(6 * k) << t.head<3>(),
                rotation_vector(Quaternion{t[6] / length, Vec3(t.segment<3>(3) / length)});
        }
    if (!all.x.allFinite()) {
        all.found.fill(infinity);
        return all.found.data();
    }
    if (all.run->by('m')) all.found[0] = SpaceJudge::moved(all.start.bodies.x, all.x);
    if (all.run->by('g')) {
        SpaceScene here = all.start;
        here.bodies.x = all.x;
        all.found[1] = largest_joint_error(here);
    }
    if (all.run->by('o')) all.found[2] = all.judge->overlap(all.x);
    return all.found.data();
}
