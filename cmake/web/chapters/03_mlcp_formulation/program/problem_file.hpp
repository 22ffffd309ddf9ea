/// \file problem_file.hpp
/// In place of the chapter's own header in the preset web: a page reads no files, and what reads them is a third of a program.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "common/text.hpp"

#include <functional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

using ProblemMethods = std::vector<std::pair<std::string, std::function<Solution(const Mlcp&)>>>;

inline std::vector<std::string> names_of(const ProblemMethods& methods)
{
    std::vector<std::string> names;
    for (const auto& method : methods) names.push_back(method.first);
    return names;
}

inline int solve_problem_file(const std::string& file, const std::string&, const ProblemMethods&)
{
    throw std::invalid_argument("the problem " + file + " can't be read; a page reads no files");
}

}  // namespace rigid
