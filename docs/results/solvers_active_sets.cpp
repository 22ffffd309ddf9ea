// Chapter 9 on the task "find the impulses of a step".
#include "docs/results/exact_solvers.hpp"
#include "docs/results/one_step.hpp"

#include "chapters/09_active_sets/active_sets.hpp"
#include "chapters/09_active_sets/dantzig.hpp"

namespace rigid::results {

ActiveSets new_active_sets()
{
    return [memory = std::make_shared<ActiveSetMemory>()](const Mlcp& mlcp, Solution& solution) {
        active_sets(mlcp, {}, *memory, solution);
        return memory->work.factorisations + memory->work.updates;
    };
}

namespace {

void add_guesses(Registry& registry, const SharedScene& scene, bool warm)
{
    add_solver(registry, scene, "9", warm ? "active_sets_warm" : "active_sets", "unit=factorisation",
               scene->rows() <= 60, [=] {
                   return [=, assembled = Assembler(), memory = ActiveSetMemory(),
                           solution = Solution()](const OneStep& step, std::size_t k, Solved& out) mutable {
                       if (k == 0 || !warm) memory = {};
                       active_sets(assembled(step), {}, memory, solution);
                       take(solution, memory.work.factorisations + memory.work.updates, out);
                   };
               });
}

}  // namespace

void add_active_sets(Registry& registry, const SharedScene& scene)
{
    add_guesses(registry, scene, false);
    if (scene->steps.size() > 1) add_guesses(registry, scene, true);
    if (scene->rows() <= scene->most_exact_rows)
        add_exact(registry, scene, "9", "dantzig", "pivot", [](const Mlcp& mlcp) { return dantzig(mlcp); });
}

}  // namespace rigid::results
