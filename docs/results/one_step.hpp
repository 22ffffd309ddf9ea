/// \file one_step.hpp
/// The task "find the impulses of a step": rows and velocities before them are given, the velocities after them
/// are known exactly.
///
///     rows (J, b, bounds), u*   →   λ   →   u = u* + M⁻¹ Jᵀ λ,   error = max |u − u_exact| / (g h)
///
/// An error of 0.01 leaves the worst body a hundredth of the free fall of one step. What a method needs to make
/// of the rows first (chapters 3 to 5 and 9 assemble A) is part of its task.
#pragma once

#include "docs/results/measurement.hpp"

#include "chapters/03_mlcp_formulation/assembly.hpp"
#include "chapters/08_warm_starting/impulse_cache.hpp"

#include <algorithm>
#include <memory>

namespace rigid::results {

struct OneStep {
    std::vector<rigid::Row<2>> rows;
    std::vector<ImpulseKey> keys;  ///< which rows they are, for a method that remembers
    VecX u_star, exact_u;          ///< [m/s]
};

/// One step, or several that follow each other: a method may remember from one what helps it with the next.
struct StepScene {
    std::string scene, parameters, reference;
    std::vector<OneStep> steps;
    Real fall = 9.81 / 60;        ///< g h [m/s]: what the error is measured in
    bool bilateral = false;       ///< all rows without bounds
    Real omega = 1.5;             ///< relaxation for SOR: the best one where theory knows it
    long most_sweeps = 16384;     ///< after which nothing is left to gain
    Index most_exact_rows = 400;  ///< dense exact solvers are left out above this
    bool enumerable = false;      ///< chapter 3's enumeration ends within a second
    bool all_ways = false;        ///< chapter 6's orders and blocks too, and chapter 9's nets by themselves

    Index rows() const
    {
        Index most = 0;
        for (const OneStep& step : steps) most = std::max(most, static_cast<Index>(step.rows.size()));
        return most;
    }
};

using SharedScene = std::shared_ptr<const StepScene>;

/// What a solver says of one step.
struct Solved {
    VecX lambda;
    std::optional<std::int64_t> work, sweeps;
    std::string_view status = to_string(Status::solved);  ///< or how a peer's answer was judged
    Real seconds = 0;                                     ///< of a program that times itself
};

/// Chapters 3 to 5 and 9 want A.
class Assembler {
public:
    const Mlcp& operator()(const OneStep& step)
    {
        assemble(step.rows, step.u_star, scratch_, mlcp_);
        return mlcp_;
    }

private:
    AssemblyScratch scratch_;
    Mlcp mlcp_;
};

/// Adds a method.
/// \param make_solver  make_solver() gives solver(step, number of the step, Solved&): out is kept between calls
/// \param own_clock    the solver tells its seconds
template <class MakeSolver>
void add_solver(Registry& registry, const SharedScene& scene, const std::string& chapter,
                const std::string& method, const std::string& parameters, bool quick,
                const MakeSolver& make_solver, bool own_clock = false)
{
    const std::string all = scene->parameters + ' ' + parameters + " reference=" + scene->reference;
    registry.add(
        {chapter, method, scene->scene, all, scene->fall / 9.81, quick, [=] {
             const auto solved = std::make_shared<std::vector<Solved>>(scene->steps.size());
             Task task;
             task.run = [=, solver = make_solver()]() mutable {
                 for (std::size_t k = 0; k < scene->steps.size(); ++k)
                     solver(scene->steps[k], k, (*solved)[k]);
             };
             task.judge = [=] {
                 Result result{std::int64_t{0}, std::int64_t{0}, 0, std::string(to_string(Status::solved))};
                 for (std::size_t k = 0; k < scene->steps.size(); ++k) {
                     const OneStep& step = scene->steps[k];
                     const Solved& answer = (*solved)[k];
                     VecX u = step.u_star;
                     if (answer.lambda.size() == static_cast<Index>(step.rows.size()))
                         apply(step.rows, answer.lambda, u);
                     const Real error = (u - step.exact_u).cwiseAbs().maxCoeff() / scene->fall;
                     if (!(error <= result.error)) result.error = std::isfinite(error) ? error : infinity;
                     if (answer.work && result.work) *result.work += *answer.work;
                     else result.work.reset();
                     if (answer.sweeps && result.sweeps) *result.sweeps += *answer.sweeps;
                     else result.sweeps.reset();
                     if (answer.status != to_string(Status::solved)) result.status = answer.status;
                 }
                 return result;
             };
             if (own_clock)
                 task.seconds = [=] {
                     Real sum = 0;
                     for (const Solved& answer : *solved) sum += answer.seconds;
                     return sum;
                 };
             return task;
         }});
}

inline void take(const Solution& solution, std::int64_t work, Solved& out)
{
    out.lambda = solution.lambda;
    out.work = work;
    out.status = to_string(solution.status);
}

/// One that takes an Mlcp and counts in solution.iterations.
template <class Solve>
void add_exact(Registry& registry, const SharedScene& scene, const std::string& chapter,
               const std::string& method, const std::string& unit, Solve solve)
{
    add_solver(registry, scene, chapter, method, "unit=" + unit, scene->rows() <= 60, [=] {
        return [=, assembled = Assembler()](const OneStep& step, std::size_t, Solved& out) mutable {
            const Solution solution = solve(assembled(step));
            take(solution, solution.iterations, out);
        };
    });
}

void add_direct(Registry& registry, const SharedScene& scene);       ///< chapters 2 and 3
void add_sweeps(Registry& registry, const SharedScene& scene);       ///< chapters 4, 6 and 8
void add_lemke(Registry& registry, const SharedScene& scene);        ///< chapter 5
void add_active_sets(Registry& registry, const SharedScene& scene);  ///< chapter 9
void add_exact_peers(Registry& registry, const SharedScene& scene);  ///< other programs

/// Every method of the book and every peer that can take the scene.
inline void add_solvers(Registry& registry, const StepScene& given)
{
    const auto scene = std::make_shared<const StepScene>(given);
    add_direct(registry, scene);
    add_sweeps(registry, scene);
    const bool dense = scene->rows() <= scene->most_exact_rows;
    if (dense) add_lemke(registry, scene);
    add_active_sets(registry, scene);
    if (dense) add_exact_peers(registry, scene);
}

}  // namespace rigid::results
