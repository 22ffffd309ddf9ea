/// \file problem_reader.hpp
/// Reads a problem from text, line by line; the format is described in problem_file.hpp.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"
#include "common/text.hpp"

#include <istream>
#include <map>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

struct Problem {
    std::string name;
    Mlcp mlcp;
    /// what the file says of its answer
    Uniqueness kind = Uniqueness::not_examined;
    /// the known answer; empty if there is none
    VecX z, w;
};

/// characters; 10000 numbers of 25 take a quarter of it
inline constexpr std::size_t longest_line = 1'000'000;
/// rows; a file of so many is dense and has 200 MB or more
inline constexpr Index largest_problem = 10000;

/// Reads a problem line by line and remembers where it is, so that each refusal names the line.
class ProblemReader {
public:
    /// \param in    the text
    /// \param file  its name, for the refusals; may be empty
    explicit ProblemReader(std::istream& in, const std::string& file = "")
        : in_(in), file_(file.empty() ? "" : file + ", ")
    {
    }

    Problem read();

private:
    /// The words of the next line that has any; false at the end of the file.
    bool next_line();

    /// std::getline with a limit: a file that is no problem may have no end of a line at all.
    bool next_text(std::string& text);

    void read_key(const std::string& key);

    void read_section(const std::string& key);

    /// One line of n numbers.
    VecX numbers(const std::string& key, const std::string& what, Index n);

    void require_bounds();

    [[noreturn]] void refuse(const std::string& sentence) const
    {
        throw std::invalid_argument(file_ + "line " + std::to_string(line_) + ": " +
                                    sentence);
    }

    static std::string quoted(const std::string& word)
    {
        return '"' + (word.size() > 40 ? word.substr(0, 40) + "..." : word) + '"';
    }

    std::istream& in_;
    std::string file_;
    int line_ = 0;
    int bounds_line_ = 0;
    std::vector<std::string> words_;
    std::map<std::string, int> given_;  ///< and in which line
    Problem problem_;
};

}  // namespace rigid
