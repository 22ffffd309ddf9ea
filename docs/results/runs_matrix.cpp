// Chapters 3 to 5 and 9 step a scene: chapter 3's step with their solvers, an error repaid as a whole, b = C/h; and
// chapter 9's own method, whose position errors are corrected exactly as well and leave no velocity, in small steps.
#include "docs/results/exact_solvers.hpp"
#include "docs/results/runs.hpp"

#include "chapters/03_mlcp_formulation/step.hpp"
#include "chapters/04_pgs/pgs.hpp"
#include "chapters/09_active_sets/exact_method.hpp"

namespace rigid::results {
namespace {

/// \param make_solve  make_solve() gives solve(mlcp, solution) and returns the work of it
template <class MakeSolve>
void add_solver_run(Registry& registry, const SharedRun& run, const std::string& chapter,
                    const std::string& method, const std::string& parameters, bool quick,
                    const MakeSolve& make_solve)
{
    add_run(registry, run, chapter, method, parameters, quick, [=] {
        return [settings = StepSettings{.h = run->h()}, now = StepData<2>(),
                solve = make_solve()](DiscScene& scene, std::int64_t& work, bool& solved) mutable {
            const auto count = [&](const Mlcp& mlcp, Solution& solution) { work += solve(mlcp, solution); };
            step(scene, settings, by_matrix(count), now);
            solved = solved && now.solution.status == Status::solved;
        };
    });
}

/// Chapter 9's solver, which counts what its problems cost: velocities and position errors, sub-step by sub-step.
struct CountedSolver : ExactSolver {
    std::int64_t work = 0;

    void solve(Bodies<2>& bodies, StepData<2>& now)
    {
        ExactSolver::solve(bodies, now);
        count(find);
    }
    void solve_apart(SecondProblem& second, VecX& v, StepData<2>& now)
    {
        ExactSolver::solve_apart(second, v, now);
        count(errors);
    }

private:
    void count(const FindActiveSets& by) { work += by.memory.work.factorisations + by.memory.work.updates; }
};

struct ExactSteps {
    AllPairs contacts;
    Correction correction = exact_correction();
    ColdStart start;
    CountedSolver solver;
};

void add_exact_steps(Registry& registry, const SharedRun& run, int substeps)
{
    add_run(registry, run, "9", "exact_steps", "substeps=" + std::to_string(substeps) + " unit=factorisation",
            substeps == 4 && run->dense, [=] {
                ExactSteps method;
                method.contacts.collides = run->engine.collides;
                return
                    [settings = StepSettings{.h = run->h(), .substeps = substeps}, method = std::move(method),
                     now = StepData<2>()](DiscScene& scene, std::int64_t& work, bool& solved) mutable {
                        method.solver.work = 0;
                        step(scene, settings, method, now);
                        work += method.solver.work;
                        solved = solved && method.solver.unsolved == 0;
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
    if (run->exact)
        for (const int substeps : {1, 4, 16}) add_exact_steps(registry, run, substeps);
}

}  // namespace rigid::results
