// Chapter 5 on the task "find the impulses of a step".
#include "docs/results/exact_solvers.hpp"
#include "docs/results/one_step.hpp"

#include "chapters/05_lemke/lemke.hpp"

namespace rigid::results {

Solution solve_by_lemke(const Mlcp& mlcp) { return lemke(mlcp); }

void add_lemke(Registry& registry, const SharedScene& scene)
{
    // All rows bilateral: there is nothing to walk, the first elimination is chapter 3's direct solve.
    if (!scene->bilateral) add_exact(registry, scene, "5", "lemke", "pivot", solve_by_lemke);
}

}  // namespace rigid::results
