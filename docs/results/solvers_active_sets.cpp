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

/// How chapter 9 is asked: as it comes, from the previous guess, or by one of its two nets from the beginning.
enum class Way { plain, warm, descent, proximal };

void add_guesses(Registry& registry, const SharedScene& scene, const std::string& method, Way way)
{
    add_solver(registry, scene, "9", method, "unit=factorisation", scene->rows() <= 60, [=] {
        ActiveSetSettings settings;
        if (way == Way::descent) settings.patience = 0;  // the first flip without progress, and down it goes
        return [=, assembled = Assembler(), memory = ActiveSetMemory(),
                solution = Solution()](const OneStep& step, std::size_t k, Solved& out) mutable {
            if (k == 0 || way != Way::warm) memory = {};
            if (way == Way::proximal) memory.dependent = true;
            active_sets(assembled(step), settings, memory, solution);
            take(solution, memory.work.factorisations + memory.work.updates, out);
        };
    });
}

}  // namespace

void add_active_sets(Registry& registry, const SharedScene& scene)
{
    add_guesses(registry, scene, "active_sets", Way::plain);
    if (scene->steps.size() > 1) add_guesses(registry, scene, "active_sets_warm", Way::warm);
    if (scene->all_ways) {
        add_guesses(registry, scene, "active_sets_descent", Way::descent);
        add_guesses(registry, scene, "active_sets_proximal", Way::proximal);
    }
    if (scene->rows() <= scene->most_exact_rows)
        add_exact(registry, scene, "9", "dantzig", "pivot", [](const Mlcp& mlcp) { return dantzig(mlcp); });
}

}  // namespace rigid::results
