/// \file problem_file.hpp
/// Problems in files: read one, print its answer.
///
///     name two_walls        # a comment
///     n 2
///     A
///     2 1
///     1 2
///     q
///     -3 -3
///
/// First the keys `name`, `n` (needed) and `solution` (unique, w_unique, any or none), each with its value on
/// the same line. Then the sections, each after its name: `A` (needed) has n lines of n numbers; `q`
/// (needed), `lo`, `hi` and, where the answer is known, `z` and `w` have one line of n numbers. Bounds may be
/// inf and -inf; without them 0 ≤ z. Here z is what the chapters call λ.
#pragma once

#include "chapters/03_mlcp_formulation/problem_reader.hpp"

#include <algorithm>
#include <fstream>
#include <functional>
#include <iostream>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// Reads a problem. Throws std::invalid_argument, with the line and one sentence, for a malformed one.
inline Problem read_problem(std::istream& in) { return ProblemReader(in).read(); }
inline Problem read_problem(const std::string& file)
{
    std::ifstream in(file);
    if (!in)
        throw std::invalid_argument("the problem " + file +
                                    " can't be read; it must be a file");
    return ProblemReader(in, file).read();
}

/// Prints name, n, status, residual and iterations as keys; the uniqueness as `solution` if the method examined
/// it; and z and w as sections, if there is an answer or what came near to one.
inline void write_solution(std::ostream& out, const Problem& problem,
                           const Solution& solution)
{
    const auto section = [&out](const char* name, const VecX& numbers) {
        out << name << '\n';
        for (Index i = 0; i < numbers.size(); ++i)
            out << (i ? " " : "") << shortest(numbers[i]);
        out << '\n';
    };
    if (!problem.name.empty()) out << "name " << problem.name << '\n';
    out << "n " << problem.mlcp.size() << '\n';
    out << "status " << to_string(solution.status) << '\n';
    out << "residual " << shortest(solution.residual) << '\n';
    out << "iterations " << solution.iterations << '\n';
    if (solution.uniqueness != Uniqueness::not_examined)
        out << "solution " << to_string(solution.uniqueness) << '\n';
    if (solution.status == Status::infeasible ||
        solution.status == Status::singular)
        return;
    if (solution.lambda.size() != problem.mlcp.size() ||
        !solution.lambda.allFinite())
        return;
    section("z", solution.lambda);
    section("w", problem.mlcp.A * solution.lambda + problem.mlcp.q);
}

/// The ways that a program can solve a problem, by name; the first is the default.
using ProblemMethods =
    std::vector<std::pair<std::string, std::function<Solution(const Mlcp&)>>>;

inline std::vector<std::string> names_of(const ProblemMethods& methods)
{
    std::vector<std::string> names;
    for (const auto& method : methods) names.push_back(method.first);
    return names;
}

/// What `--problem FILE --method NAME` does. Prints the answer to standard output.
/// \return the exit code: 0 if the status is `solved`, else 3
/// \throws std::invalid_argument for a malformed file, an unknown method, or a problem that is not for it
inline int solve_problem_file(const std::string& file, const std::string& method,
                              const ProblemMethods& methods)
{
    const auto solve =
        std::find_if(methods.begin(), methods.end(),
                     [&](const auto& one) { return one.first == method; });
    if (solve == methods.end())
        throw std::invalid_argument("there is no method \"" + method +
                                    "\"; there are: " + joined(names_of(methods)));
    const Problem problem = read_problem(file);
    const Solution solution = solve->second(problem.mlcp);
    write_solution(std::cout, problem, solution);
    return solution.status == Status::solved ? 0 : 3;
}

}  // namespace rigid
