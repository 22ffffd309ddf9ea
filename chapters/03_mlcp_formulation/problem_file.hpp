/// \file problem_file.hpp
/// An MLCP in a text file: read it, solve it by a method's name, write the answer in the same format.
///
///     # a comment
///     name two contacts        key value: name, n, solution (unique, w_unique, any, none)
///     n 2
///     A                        a section: its name, then its numbers; A has n lines of n numbers
///     2 1
///     1 2
///     q                        q, lo, hi, z, w have one line of n numbers
///     -1 -1
///
/// `n`, `A` and `q` are needed. Without `lo` and `hi` the bounds are 0 and inf.
#pragma once

#include "chapters/03_mlcp_formulation/problem_reader.hpp"

#include <fstream>
#include <functional>
#include <map>
#include <ostream>
#include <sstream>
#include <string>

namespace rigid {

/// Reads a problem. \throws std::invalid_argument  naming the line and what is wrong with it
inline Problem read_problem(std::istream& in) { return ProblemReader(in).read(); }

/// Reads a problem from a file. \throws std::invalid_argument  naming the file, the line and what is wrong
inline Problem read_problem(const std::string& path)
{
    std::ifstream file(path);
    if (!file) throw std::invalid_argument(path + " cannot be read");
    try {
        return read_problem(file);
    } catch (const std::invalid_argument& refused) {
        throw std::invalid_argument(path + ", " + refused.what());
    }
}

/// Writes status, residual [m/s] and iterations as key-value lines, z = λ [N s] and w = A z + q [m/s] as
/// sections, with all the digits that a number has.
inline void write_solution(std::ostream& out, const Problem& problem, const Solution& solution)
{
    std::ostringstream text;
    text.precision(17);
    text << "name " << problem.name << "\nn " << problem.mlcp.size() << "\nstatus "
         << to_string(solution.status) << "\nresidual " << solution.residual << "\niterations "
         << solution.iterations;
    const auto section = [&text](const char* name, const VecX& numbers) {
        text << '\n' << name << '\n';
        for (Index i = 0; i < numbers.size(); ++i) text << (i ? " " : "") << numbers[i];
    };
    if (solution.lambda.size() == problem.mlcp.size()) {
        section("z", solution.lambda);
        section("w", problem.mlcp.A * solution.lambda + problem.mlcp.q);
    }
    out << text.str() << '\n';
}

/// What a chapter can solve a problem by: its names, in the words of --method.
using ProblemSolvers = std::map<std::string, std::function<Solution(const Mlcp&)>>;

/// Solves the problem in a file and writes the answer.
/// \return  the exit code of a program: 0 if it was solved, 3 if not
/// \throws std::invalid_argument  for a file or a method that makes no sense
inline int solve_problem_file(const std::string& path, const std::string& method,
                              const ProblemSolvers& solvers, std::ostream& out)
{
    const auto solver = solvers.find(method);
    if (solver == solvers.end()) {
        std::string known;
        for (const auto& entry : solvers) known += " " + entry.first;
        throw std::invalid_argument("the method '" + method + "' is not known here; there are:" + known);
    }
    const Problem problem = read_problem(path);
    const Solution solution = solver->second(problem.mlcp);
    write_solution(out, problem, solution);
    return solution.status == Status::solved ? 0 : 3;
}

}  // namespace rigid
