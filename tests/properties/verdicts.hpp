/// \file verdicts.hpp
/// Every verdict on a problem held against what can be known of it; what is false is told in sentences.
#pragma once

#include "tests/properties/all_solvers.hpp"
#include "tests/properties/judge.hpp"
#include "tests/properties/whole_numbers.hpp"

#include <optional>
#include <string>

namespace rigid::properties {

/// A residual above this share of what the problem is given is no rounding and no tolerance of a solver.
inline constexpr Real wrong_from = 1e-8;

struct Tally {
    long verdicts = 0, solved = 0, infeasible = 0,
         counted = 0;  ///< counted: verdicts on how many answers there are
    long exact = 0;    ///< problems whose answers were all known exactly
};

inline std::string in_words(Wide x)
{
    char text[40];
    std::snprintf(text, sizeof text, "%.3g", static_cast<double>(x));
    return text;
}

/// The false verdicts as sentences; empty if all can stand.
inline std::vector<std::string> false_verdicts(const Mlcp& mlcp, bool whole,
                                               const std::vector<Answer>& answers, Tally& tally)
{
    std::vector<std::string> sentences;
    const Index n = mlcp.size();
    const WideProblem problem(mlcp);
    std::optional<AllAnswers> all;
    if (whole && n <= 4) all = all_answers(mlcp);
    tally.exact += all.has_value();
    bool boxed = true;
    for (Index i = 0; i < n; ++i) boxed = boxed && mlcp.lo[i] > -infinity && mlcp.hi[i] < infinity;

    // Answers that are certain: those of the solvers, solved again in wide numbers, and, where somebody says that there
    // is none, all that can be found.
    std::optional<std::vector<Wide>> certain_one;
    std::string whose = "all bounds are finite, so there is an answer";
    bool searched = false;
    const auto find_certain = [&] {
        if (searched) return;
        searched = true;
        for (const Answer& answer : answers)
            if (!certain_one && answer.solution.status == Status::solved) {
                certain_one = certain_answer(problem, answer.solution.lambda);
                whose = "the answer of " + answer.solver + " is one";
            }
        if (certain_one || n > 6) return;
        certain_one = search_answer(problem);
        whose = "solving all sets in wide numbers finds one";
    };

    for (const Answer& answer : answers) {
        const Solution& solution = answer.solution;
        ++tally.verdicts;
        const auto says = [&](const std::string& what) {
            sentences.push_back(answer.solver + " says " + what);
        };
        if (solution.lambda.size() != n) {
            says(std::to_string(solution.lambda.size()) + " impulses, for " + std::to_string(n) + " rows");
            continue;
        }
        if (solution.status == Status::solved) {
            ++tally.solved;
            for (Index i = 0; i < n;
                 ++i) {  // by more than the rounding of lo + z: then the residual is no measure
                const Real room = 1e-14 * std::abs(solution.lambda[i]);
                if (!(solution.lambda[i] >= mlcp.lo[i] - room && solution.lambda[i] <= mlcp.hi[i] + room))
                    says("solved with a lambda outside its bounds, number " + std::to_string(i));
            }
            const Wide error = problem.error(widened(solution.lambda), 11 * static_cast<Wide>(answer.enough));
            if (!(error <= wrong_from))
                says("solved, and the residual is " + in_words(error) + " of what is given");
            if (all && !all->any && problem.error(widened(solution.lambda)) == 0)
                says("solved exactly, and the judge finds no answer");
        }
        if (solution.status == Status::infeasible || solution.uniqueness == Uniqueness::none) {
            ++tally.infeasible;
            if (!all && !boxed) find_certain();
            if (all ? all->any : boxed)
                says(all ? "infeasible, and in whole numbers there is an answer"
                         : "infeasible, and " + whose);
            else if (!all && certain_one) says("infeasible, and " + whose);
        }
        if (solution.uniqueness == Uniqueness::not_examined) continue;
        ++tally.counted;
        if (all) {
            if (solution.uniqueness != all->uniqueness())
                says("the answer is " + std::string(to_string(solution.uniqueness)) +
                     ", and in whole numbers it is " + std::string(to_string(all->uniqueness())));
            continue;
        }
        if (solution.uniqueness != Uniqueness::unique) continue;
        const auto own = certain_answer(problem, solution.lambda);
        for (const Answer& other : answers) {  // a second answer has to be certain, and elsewhere
            if (!own || other.solution.status != Status::solved) continue;
            const auto another = certain_answer(problem, other.solution.lambda);
            Wide apart = 0, size = 0;
            for (std::size_t k = 0; another && k < own->size(); ++k) {
                apart = std::max(apart, magnitude((*another)[k] - (*own)[k]) * problem.unit[k]);
                size = std::max(size, magnitude((*another)[k]) * problem.unit[k]);
            }
            if (!(apart > 1e-4 * (size + problem.given))) continue;
            says("the answer is unique, and " + other.solver + " has another one");
            break;
        }
    }
    return sentences;
}

}  // namespace rigid::properties
