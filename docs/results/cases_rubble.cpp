// One step of heaps with friction: the impulses of random rubble. A problem is rows and u*, an answer λ, and its error the
// residual of Coulomb's law (13.5), as λ and u need not be unique.
#include "docs/results/turning_runs.hpp"

#include "chapters/13_friction/friction_problems.hpp"
#include "chapters/13_friction/friction_solver.hpp"

namespace rigid::results {
namespace {

struct Rubble {
    std::string parameters;
    FrictionRows given;
    bool quick = false, small = false;
};
using SharedRubble = std::shared_ptr<const Rubble>;

/// Adds a solver. \param make  make() gives solve(rows, u*, Solution&), which returns its counted work
template <class Make>
void add_solver(Registry& registry, const SharedRubble& rubble, const std::string& chapter,
                const std::string& method, const std::string& parameters, const Make& make)
{
    registry.add({chapter, method, "rubble", rubble->parameters + ' ' + parameters + " reference=residual",
                  1.0 / 60, rubble->quick, [=] {
                      const auto solution = std::make_shared<Solution>();
                      const auto work = std::make_shared<std::int64_t>();
                      Task task;
                      task.run = [=, solve = make()]() mutable {
                          *solution = {};
                          *work = solve(rubble->given.rows, rubble->given.u_star, *solution);
                      };
                      task.judge = [=] {
                          Mlcp mlcp = assemble(rubble->given.rows, rubble->given.u_star);
                          std::vector<FrictionBox> boxes;
                          boxes_of(rubble->given.rows, boxes);
                          const Real residual = coulomb_residual(mlcp, boxes, solution->lambda);
                          return Result{*work,
                                        {},
                                        std::isfinite(residual) ? residual : infinity,
                                        std::string(to_string(solution->status))};
                      };
                      return task;
                  }});
}

/// Finds λ of A, q and the boxes. \param find  void(Mlcp&, boxes, Solution&), and returns its counted work
template <class Find>
auto from_matrix(Find find)
{
    return [find = std::move(find), scratch = AssemblyScratch(), mlcp = Mlcp(),
            boxes = std::vector<FrictionBox>()](const std::vector<Row<3>>& rows, const VecX& u_star,
                                                Solution& solution) mutable {
        assemble(rows, u_star, scratch, mlcp);
        boxes_of(rows, boxes);
        return find(mlcp, boxes, solution);
    };
}

/// Algorithm 13.2, cold each time.
struct ByGuesses {
    FrictionMemory memory;
    std::int64_t operator()(Mlcp& mlcp, std::span<const FrictionBox> boxes, Solution& solution)
    {
        memory.forget();
        friction_active_sets(mlcp, boxes, {}, memory, solution);
        return memory.work.guesses;
    }
};

std::int64_t by_walking(Mlcp& mlcp, std::span<const FrictionBox> boxes, Solution& solution)
{
    FindByStewartTrinkle{}(mlcp, boxes, 0, solution);
    return solution.iterations;
}

void add_rubble(Registry& registry, int contacts, bool quick)
{
    Rubble rubble;
    rubble.parameters = "contacts=" + std::to_string(contacts) + " mu=0.5";
    rubble.quick = quick;
    Random random(static_cast<std::uint64_t>(contacts));
    rubble.given = random_rubble(random, contacts, 0.5, 0.1);
    const auto shared = std::make_shared<const Rubble>(std::move(rubble));
    for (int sweeps = 4; sweeps <= 4096; sweeps *= 4)
        add_solver(registry, shared, "13", "friction_sweeps",
                   "sweeps=" + std::to_string(sweeps) + " unit=row_visit", [=] {
                       return [=, memory = ImpulseMemory<3>(),
                               u = VecX()](const std::vector<Row<3>>& rows, const VecX& u_star,
                                           Solution& solution) mutable -> std::int64_t {
                           u = u_star;
                           sequential_impulse<3>(rows, {}, {sweeps, 0, false}, memory, u, solution);
                           return solution.iterations * static_cast<std::int64_t>(rows.size());
                       };
                   });
    add_solver(registry, shared, "13", "exact_friction", "unit=case_set",
               [] { return from_matrix(ByGuesses()); });
    if (contacts <= 50)
        add_solver(registry, shared, "13", "friction_by_lemke", "unit=pivot",
                   [] { return from_matrix(by_walking); });
}

}  // namespace

void add_rubble(Registry& registry)
{
    constexpr bool quick = true;
    add_rubble(registry, 20, quick);
    add_rubble(registry, 200, quick);
    add_rubble(registry, 2000, !quick);
}

}  // namespace rigid::results
