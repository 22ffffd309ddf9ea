/// What the library buys: prints the table of the reader's guide, the small programs of chapters 8, 13 and 18 beside
/// the library on the same scenes.
///
///     build/release/bin/small_table
///
/// Visits and errors are the same on each run; times are of this run, the shortest of three.

#include "tests/small/alone.hpp"

#include "chapters/08_warm_starting/small_steps.hpp"
#include "chapters/10_skipping_work/skipping_world.hpp"
#include "chapters/12_contact_manifolds/stacks.hpp"
#include "chapters/13_friction/friction_solver.hpp"

#include <chrono>

#define main small_main
namespace small08 {
#include "chapters/08_warm_starting/small.cpp"
}
namespace small13 {
#include "chapters/13_friction/small.cpp"
}
namespace small18 {
#include "chapters/18_islands/small.cpp"
}
#undef main

using namespace rigid;

namespace {

constexpr Real h = 1.0 / 60;
constexpr int steps = 600;

/// So many columns of five discs, or one of twenty.
small08::Discs columns(int count, int high)
{
    const int K = count * high;
    const VecX one = VecX::Ones(2 * K);
    small08::Discs d{0 * one, 0 * one, one, VecX::Constant(K, 0.1), 0, VecX{{0, 1, 0}}};
    for (int k = 0; k < K; ++k) d.x.segment<2>(2 * k) << 0.5 * (k / high), 0.1 * (2 * (k % high) + 1);
    return d;
}

DiscScene library_scene(const small08::Discs& d)
{
    DiscScene scene;
    scene.bodies = Bodies<2>(d.radius.size());
    scene.bodies.x = d.x;
    scene.bodies.inverse_mass = d.inverse_mass;
    scene.radius = d.radius;
    scene.walls.push_back({{0, 1}, 0});
    return scene;
}

/// Runs the steps three times, and prints a line of the table.
/// \param start  a new scene
/// \param take   one step of it; its row visits
/// \param error  at the end
template <class Start, class Take, class Error>
void line(const char* scene, const char* method, const Start& start, const Take& take, const Error& error)
{
    double best = INFINITY;
    long visits = 0;
    Real off = 0;
    for (int round = 0; round < 3; ++round) {
        auto world = start();
        visits = 0;
        const auto begin = std::chrono::steady_clock::now();
        for (int n = 0; n < steps; ++n) visits += take(world);
        const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
        best = std::min(best, time.count());
        off = error(world);
    }
    std::printf("| %s | %s | %ld | %.2g | %.2g |\n", scene, method, visits / steps, 1e6 * best / steps, off);
}

template <class Method, class Scene>
struct World {
    Scene scene;
    Method method = {};
    StepData<Scene::dof> now = {};

    long take()
    {
        step(scene, {.h = h}, method, now);
        return static_cast<long>(now.visits);
    }
};

void discs(const char* name, int count, int high)
{
    const small08::Discs begin = columns(count, high);
    const auto lowest = [&](const VecX& x) { return 1000 * (begin.x - x).cwiseAbs().maxCoeff(); };
    for (const int most : {10, 100000})
        line(
            name,
            most == 10 ? "small program 8, ten sweeps" : "small program 8, until no row is off by 1 µm/s",
            [&] { return begin; },
            [&](small08::Discs& d) {
                const int sweeps = small08::step(d, h, 0.2, most);
                return static_cast<long>(sweeps) * static_cast<long>(d.contacts.size());
            },
            [&](const small08::Discs& d) { return lowest(d.x); });
    struct Small {
        DiscScene scene;
        SmallStep now = {};
    };
    line(
        name, "chapter 8, quick small steps", [&] { return Small{library_scene(begin)}; },
        [&](Small& world) {
            small_steps(world.scene, {.h = h}, world.now);
            return static_cast<long>(world.now.rows.size()) * quick_steps().substeps;  // one sweep each
        },
        [&](const Small& world) { return lowest(world.scene.bodies.x); });
    line(
        name, "chapter 10, exact islands and sleep",
        [&] {
            World<SkippingMethod, DiscScene> world{library_scene(begin)};
            world.method.contacts.reset(world.scene, filter_of(world.scene));
            return world;
        },
        [](auto& world) { return world.take(); },
        [&](const auto& world) { return lowest(world.scene.bodies.x); });
}

template <class Method>
void boxes(const char* method, const RoughScene& begin)
{
    line(
        "ten boxes", method, [&] { return World<Method, RoughScene>{begin}; },
        [](auto& world) { return world.take(); },
        [&](const auto& world) {
            return 1000 * (world.scene.bodies.x - begin.bodies.x).cwiseAbs().maxCoeff();
        });
}

}  // namespace

int main()
{
    std::printf("| scene | method | row visits a step | µs a step | off after 10 s [mm] "
                "|\n|---|---|---:|---:|---:|\n");
    discs("column of 20 discs", 1, 20);
    discs("100 columns of 5 discs", 100, 5);
    const small13::Bodies tower = small13::boxes(10, 0, 0.6);
    for (const int sweeps : {10, 100})
        line(
            "ten boxes", sweeps == 10 ? "small program 13, ten sweeps" : "small program 13, a hundred sweeps",
            [&] { return tower; },
            [&](small13::Bodies& d) {
                small13::step(d, h, sweeps);
                return static_cast<long>(sweeps) * static_cast<long>(d.contacts.size());
            },
            [&](const small13::Bodies& d) { return 1000 * (d.x - tower.x).cwiseAbs().maxCoeff(); });
    small18::Bodies stack;
    small18::add_box(stack, 100, 0.5, INFINITY, {0, -0.5, 0});
    for (int k = 0; k < 10; ++k) small18::add_box(stack, 0.5, 0.5, 1, {0, 0.5 + k, 0});
    line(
        "ten boxes", "small program 18, exact where it stands, and sleep", [&] { return stack; },
        [&](small18::Bodies& d) {
            small18::step(d, h);
            return 0L;  // visits none
        },
        [&](const small18::Bodies& d) { return 1000 * (d.x - stack.x).cwiseAbs().maxCoeff(); });
    RoughScene scene;
    static_cast<RigidScene&>(scene) = box_stack(10);
    cover(scene, {0.6, 0, 0, 0});
    boxes<FrictionSweeps<Manifolds>>("chapter 13, ten sweeps and relaxation", scene);
    boxes<ExactFriction<Manifolds>>("chapter 13, exact", scene);
    boxes<SkippingFriction>("chapter 13, islands and sleep", scene);
}
