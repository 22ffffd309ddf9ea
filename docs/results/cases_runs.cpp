// A few seconds of chains, columns and heaps, as an engine is used. See runs.hpp.
#include "docs/results/cases.hpp"
#include "docs/results/runs.hpp"
#include "docs/results/turning_runs.hpp"

namespace rigid::results {
namespace {

/// Between a row of discs and what holds it at its ends [m]. Between walls that a row fills to the last bit, a nanometre would
/// leave a contradiction of the size of rounding, and no exact answer.
constexpr Real play = 10 * nudge;

/// A pile whose side walls are set back by the play.
EngineScene pile(const std::string& name, DiscScene scene)
{
    for (HalfSpace& wall : scene.walls)
        if (wall.normal.y() == 0) wall.offset -= play;
    return engine_pile(name, std::move(scene));
}

/// A thousand discs on a floor, in a hundred bins: triangles of ten, each between two discs that cannot move.
DiscScene bins()
{
    constexpr Index count = 100, base = 4, fixed = 2;
    constexpr Real radius = 0.1, apart = 1.5;
    const DiscScene heap = triangle(base);
    const Index each = heap.bodies.count() + fixed;
    DiscScene scene;
    scene.bodies = Bodies<2>(count * each);
    scene.radius = VecX::Constant(count * each, radius);
    scene.bodies.inverse_mass.setOnes();
    for (Index bin = 0; bin < count; ++bin) {
        const Vec2 middle(apart * (static_cast<Real>(bin) - 0.5 * static_cast<Real>(count - 1)), 0);
        for (Index k = 0; k < each - fixed; ++k)
            scene.bodies.position(bin * each + k) = middle + heap.bodies.position(k);
        for (Index side = 0; side < fixed; ++side) {
            const Index k = bin * each + each - fixed + side;
            scene.bodies.position(k) =
                middle + Vec2((side == 0 ? -1 : 1) * ((base + 1) * radius + play), radius);
            scene.bodies.inverse_mass.segment<2>(2 * k).setZero();
        }
    }
    scene.walls = {{{0, 1}, 0}};
    return scene;
}

}  // namespace

void add_runs(Registry& registry)
{
    const auto add = [&](RunScene run) {
        const auto shared = std::make_shared<const RunScene>(std::move(run));
        add_matrix_runs(registry, shared);
        add_impulse_runs(registry, shared);
        add_skipping_runs(registry, shared);
        add_engine_runs(registry, shared);
    };
    const auto number = [](auto n) { return std::to_string(n); };
    for (const Index links : {10, 40, 200})
        for (const int mass : {1, 100, 1000}) {
            const std::string parameters =
                "links=" + number(links) + " end_mass=" + number(mass) + " steps=300";
            add({engine_chain("hanging_chain_run", hanging_chain(links, mass), true), parameters});
        }
    add({engine_chain("swinging_chain_run", swinging_chain(40, 1), false), "links=40 end_mass=1 steps=60",
         60});
    for (const Index discs : {10, 20})
        for (const int mass : {1, 100, 10000}) {
            const std::string parameters =
                "discs=" + number(discs) + " top_mass=" + number(mass) + " steps=300";
            add({.engine = pile("column_run", column_between_walls(discs, mass)),
                 .parameters = parameters,
                 .steps = 300,
                 .dense = true});
        }
    add({.engine = pile("triangle_run", triangle(10)), .parameters = "base=10 discs=55 steps=300"});
    add({.engine = pile("triangle_run", triangle(44)),
         .parameters = "base=44 discs=990 steps=60",
         .steps = 60,
         .resting = true});
    add({.engine = pile("bins_run", bins()), .parameters = "bins=100 discs=1000 steps=300", .resting = true});
    add_turning(registry);
    add_joints(registry);
    add_rubble(registry);
}

}  // namespace rigid::results
