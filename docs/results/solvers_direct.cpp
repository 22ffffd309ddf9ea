// Chapters 2 and 3 on the task "find the impulses of a step": no sweeps and no either/or, or all of them.
#include "docs/results/exact_solvers.hpp"
#include "docs/results/one_step.hpp"

#include "chapters/03_mlcp_formulation/exact.hpp"

namespace rigid::results {

Solution solve_direct(const Mlcp& mlcp) { return direct(mlcp); }

Solution solve_by_cases(const Mlcp& mlcp)
{
    EnumerationSettings settings;
    settings.stop_at_first = true;  // where there is one answer only, and no other is looked for
    return schur(mlcp, settings);
}

void add_direct(Registry& registry, const SharedScene& scene)
{
    if (scene->bilateral) {
        add_solver(registry, scene, "2", "one_shot", "unit=factorisation", scene->rows() <= 40, [] {
            return [solver = RowsSolver<2>()](const OneStep& step, std::size_t, Solved& out) mutable {
                out.lambda = solver.solve(step.rows, step.u_star).lambda;
                out.work = 1;
            };
        });
        add_exact(registry, scene, "3", "direct", "factorisation", solve_direct);
    }
    if (scene->enumerable) add_exact(registry, scene, "3", "enumeration", "case_set", solve_by_cases);
}

}  // namespace rigid::results
