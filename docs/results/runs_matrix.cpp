// Chapters 3 to 5 and 9 step a scene: chapter 3's step with their solvers, an error repaid as a whole, b = C/h.
#include "docs/results/exact_solvers.hpp"
#include "docs/results/runs.hpp"

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/04_pgs/pgs.hpp"

namespace rigid::results {
namespace {

/// \param make_solve  make_solve() gives solve(mlcp, solution) and returns the work of it
template <class MakeSolve>
void add_solver_run(Registry& registry, const SharedRun& run, const std::string& chapter,
                    const std::string& method, const std::string& parameters, bool quick,
                    const MakeSolve& make_solve)
{
    add_run(registry, run, chapter, method, parameters, quick, [=] {
        return [settings = StepSettings{.h = run->h()}, now = StepData<2>(), solve = make_solve()](
                   DiscScene& scene, std::int64_t& work, bool& solved) mutable {
            const auto count = [&](const Mlcp& mlcp, Solution& solution) { work += solve(mlcp, solution); };
            step(scene, settings, by_matrix(count), now);
            solved = solved && now.solution.status == Status::solved;
        };
    });
}

}  // namespace

void add_matrix_runs(Registry& registry, const SharedRun& run)
{
    for (const int sweeps : {10, 40, 160}) {
        add_solver_run(registry, run, "4", "gauss_seidel",
                       "sweeps=" + std::to_string(sweeps) + " unit=row_visit", sweeps == 10 && run->dense,
                       [=] {
                           return [=, memory = PgsMemory()](const Mlcp& mlcp, Solution& solution) mutable {
                               PgsSettings settings;
                               settings.tolerance = 0;
                               settings.max_sweeps = sweeps;
                               cold_start(mlcp, solution.lambda);
                               pgs(mlcp, settings, memory, solution);
                               // A fixed number of sweeps was asked for, and made.
                               solution.status = Status::solved;
                               return mlcp.size() * (solution.iterations + memory.checks);
                           };
                       });
    }
    if (run->dense)
        add_solver_run(registry, run, "5", "lemke", "unit=pivot", false, [] {
            return [](const Mlcp& mlcp, Solution& solution) {
                solution = solve_by_lemke(mlcp);
                return solution.iterations;
            };
        });
    if (run->exact)
        add_solver_run(registry, run, "9", "active_sets_warm", "unit=factorisation", run->dense,
                       new_active_sets);
}

}  // namespace rigid::results
