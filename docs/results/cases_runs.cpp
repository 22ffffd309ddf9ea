// A few seconds of chains, columns and heaps, as an engine is used. See runs.hpp.
#include "docs/results/cases.hpp"
#include "docs/results/runs.hpp"

namespace rigid::results {

void add_runs(Registry& registry)
{
    const auto add = [&](RunScene run) {
        const auto shared = std::make_shared<const RunScene>(std::move(run));
        add_matrix_runs(registry, shared);
        add_impulse_runs(registry, shared);
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
            add({engine_pile("column_run", column_between_walls(discs, mass)), parameters, 300, true, true});
        }
    add({engine_pile("triangle_run", triangle(10)), "base=10 discs=55 steps=300", 300, true});
    add({engine_pile("triangle_run", triangle(44)), "base=44 discs=990 steps=60", 60, false});
}

}  // namespace rigid::results
