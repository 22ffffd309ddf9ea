#include "chapters/09_active_sets/dantzig.hpp"
#include "chapters/09_active_sets/exact_method.hpp"
#include "tests/stress/matrix_step.hpp"
#include "tests/stress/stepping.hpp"

namespace rigid::stress {

namespace {

/// Chapter 9 on chapter 3's step: all active rows at once, or one row at a time.
Method on_the_matrix(const std::string& name, bool one_at_a_time)
{
    struct Solve {
        bool one_at_a_time;
        ActiveSetMemory memory;
        void operator()(const Mlcp& mlcp, const Wish& wish, int first, Solution& solution)
        {
            ActiveSetSettings settings;
            spoil_solver(wish, first, {or_infinity("tolerance", &settings.tolerance)});
            if (one_at_a_time) dantzig(mlcp, settings, memory, solution);
            else active_sets(mlcp, settings, memory, solution);
        }
    };
    Method method = matrix_method(9, name, "exact", {or_infinity("tolerance", nullptr)}, [one_at_a_time] {
        return Solve{one_at_a_time, {}};
    });
    if (one_at_a_time) method.most_rows = 100;
    return method;
}

/// Every problem of the last sub-step, the second one on the same rows as well.
struct HonestExact {
    template <class Solving>
    void operator()(Solving& by, const StepData<2>& now) const
    {
        if (by.correction.method != Stabilizer::split_impulse)
            return require_honest(by.solver.mlcp, now.solution);
        require_honest(by.solver.mlcp, by.correction.second.solution);
    }
};

/// The second half of the last sub-step is a problem of its own: the first was held to the same rule by the solver.
struct HonestRattle {
    void operator()(RattleMethod& by, const StepData<2>& now) const
    {
        Solution second = now.solution;
        second.lambda -= by.correction.lambda_first;
        require_honest(by.solver.mlcp, second);
    }
};

Method by_rattle(const std::string& name, int substeps)
{
    return stepping(9, name,
                    "exact, " + std::to_string(substeps) + (substeps > 1 ? " substeps" : " step") +
                        " with positions met",
                    RattleMethod{}, substeps, HonestRattle{});
}

/// The one step with an exact solver. With `projection` the positions are corrected by five sweeps after each sub-step.
Method on_small_steps(const std::string& name, const Spending& spending)
{
    ExactMethod by;
    by.correction = correction_of(spending);
    return stepping(9, name,
                    "exact, " + std::to_string(spending.substeps) +
                        (spending.substeps > 1 ? " substeps" : " step"),
                    by, spending.substeps, HonestExact{});
}

}  // namespace

std::vector<Method> exact_methods(int sweeps)
{
    const int few = sweeps < 8 ? sweeps : 4;
    return {on_the_matrix("active sets", false),
            on_the_matrix("dantzig", true),
            on_small_steps("exact baumgarte", {Stabilizer::baumgarte, 1, 0, 1, infinity, 0.2}),
            on_small_steps("exact substeps",
                           {Stabilizer::baumgarte, 1, 0, sweeps < 8 ? sweeps : 16, infinity, 0.05}),
            on_small_steps("exact projection", {Stabilizer::projection, 1, 5, few, infinity, 0.5}),
            on_small_steps("exact split", {Stabilizer::split_impulse, 1, 0, 1, infinity, 1}),
            on_small_steps("exact split substeps",
                           {Stabilizer::split_impulse, 1, 0, sweeps < 8 ? sweeps : 16, infinity, 1}),
            by_rattle("rattle", 1),
            by_rattle("rattle substeps", sweeps < 8 ? sweeps : 16)};
}

}  // namespace rigid::stress
