/// \file problem_reader.hpp
/// Reads an MLCP from text, line by line; the format is told in problem_file.hpp.
#pragma once

#include "chapters/03_mlcp_formulation/mlcp.hpp"

#include <charconv>
#include <istream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

namespace rigid {

/// A file of a larger problem than this is taken for a mistake: A is written in full.
inline constexpr Index largest_problem = 5000;

struct Problem {
    std::string name = "unnamed";
    Mlcp mlcp;
    std::string solution = "any";  ///< what the file says of its answer: unique, w_unique, any or none
    VecX z, w;                     ///< the answer that the file gives; empty if none
};

/// Reads a problem line by line; every complaint names the line.
class ProblemReader {
public:
    explicit ProblemReader(std::istream& in) : in_(in) {}

    /// \throws std::invalid_argument  with the number of the line and what is wrong with it
    Problem read()
    {
        std::string word, rest;
        while (next_line()) {
            split(word, rest);
            if (word == "name") problem_.name = rest;
            else if (word == "n") read_size(rest);
            else if (word == "solution") read_kind(rest);
            else if (word == "A" || word == "q" || word == "lo" || word == "hi" || word == "z" || word == "w")
                read_section(word, rest);
            else
                refuse("'" + word +
                       "' is neither a key (name, n, solution) nor a section (A, q, lo, hi, z, w)");
        }
        for (const char* needed : {"n", "A", "q"})
            if (!seen_.count(needed)) refuse_end(std::string("the problem has no ") + needed);
        const Mlcp& mlcp = problem_.mlcp;
        for (Index i = 0; i < mlcp.size(); ++i)
            if (!(mlcp.lo[i] <= mlcp.hi[i]) || mlcp.lo[i] == infinity || mlcp.hi[i] == -infinity)
                throw std::invalid_argument("line " + std::to_string(bounds_line_) + ": row " +
                                            std::to_string(i) + " has lo = " + number(mlcp.lo[i]) +
                                            " and hi = " + number(mlcp.hi[i]) +
                                            "; lo must not be above hi, and one number must fit between");
        return std::move(problem_);
    }

private:
    [[noreturn]] void refuse(const std::string& what) const
    {
        throw std::invalid_argument("line " + std::to_string(line_number_) + ": " + what);
    }
    [[noreturn]] void refuse_end(const std::string& what) const
    {
        throw std::invalid_argument("line " + std::to_string(line_number_) + " is the last: " + what);
    }

    static std::string number(Real value)
    {
        std::ostringstream text;
        text << value;
        return text.str();
    }

    /// The next line that says something, without its comment.
    bool next_line()
    {
        while (std::getline(in_, line_)) {
            ++line_number_;
            line_ = line_.substr(0, line_.find('#'));
            line_.erase(line_.find_last_not_of(" \t\r") + 1);
            line_.erase(0, line_.find_first_not_of(" \t"));
            if (!line_.empty()) return true;
        }
        return false;
    }

    void split(std::string& word, std::string& rest) const
    {
        const auto end = line_.find_first_of(" \t");
        word = line_.substr(0, end);
        const auto begin = end == std::string::npos ? end : line_.find_first_not_of(" \t", end);
        rest = begin == std::string::npos ? "" : line_.substr(begin);
    }

    void read_size(const std::string& text)
    {
        if (!seen_.insert("n").second) refuse("n is given twice");
        Index n = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), n);
        if (error != std::errc() || end != text.data() + text.size() || n < 1 || n > largest_problem)
            refuse("n is '" + text + "'; it must be a whole number from 1 to " +
                   std::to_string(largest_problem));
        problem_.mlcp.q.resize(n);
        problem_.mlcp.lo = VecX::Zero(n);
        problem_.mlcp.hi = VecX::Constant(n, infinity);
    }

    void read_kind(const std::string& text)
    {
        if (text != "unique" && text != "w_unique" && text != "any" && text != "none")
            refuse("solution is '" + text + "'; it must be unique, w_unique, any or none");
        problem_.solution = text;
    }

    void read_section(const std::string& name, const std::string& rest)
    {
        if (!seen_.count("n")) refuse("section " + name + " stands before n");
        if (!seen_.insert(name).second) refuse("section " + name + " is given twice");
        if (!rest.empty())
            refuse("'" + rest + "' stands behind the name of section " + name +
                   "; its numbers begin on the next line");
        const Index n = problem_.mlcp.size();
        if (name == "A") {
            std::vector<Eigen::Triplet<Real>> entries;
            for (Index i = 0; i < n; ++i) {
                const VecX row = read_numbers("row " + std::to_string(i) + " of A", n, false);
                for (Index j = 0; j < n; ++j)
                    if (row[j] != 0 || i == j)
                        entries.emplace_back(static_cast<int>(i), static_cast<int>(j), row[j]);
            }
            problem_.mlcp.A.resize(n, n);
            problem_.mlcp.A.setFromTriplets(entries.begin(), entries.end());
            return;
        }
        const bool bounds = name == "lo" || name == "hi";
        const VecX numbers = read_numbers(name, n, bounds);
        if (bounds) bounds_line_ = line_number_;
        (name == "q"    ? problem_.mlcp.q
         : name == "lo" ? problem_.mlcp.lo
         : name == "hi" ? problem_.mlcp.hi
         : name == "z"  ? problem_.z
                        : problem_.w) = numbers;
    }

    VecX read_numbers(const std::string& what, Index count, bool may_be_infinite)
    {
        if (!next_line()) refuse_end(what + " is missing");
        VecX numbers(count);
        Index found = 0;
        std::istringstream words(line_);
        for (std::string word; words >> word; ++found) {
            const char* const begin = word.data() + (word.front() == '+' ? 1 : 0);
            Real value = 0;
            const auto [end, error] = std::from_chars(begin, word.data() + word.size(), value);
            if (error != std::errc() || end != word.data() + word.size())
                refuse("'" + word + "' in " + what + " is not a number");
            if (std::isnan(value) || (std::isinf(value) && !may_be_infinite))
                refuse("'" + word + "' in " + what + "; it must be " +
                       (may_be_infinite ? "a number" : "finite"));
            if (found < count) numbers[found] = value;
        }
        if (found != count)
            refuse(what + " has " + std::to_string(found) + " numbers; n is " + std::to_string(count));
        return numbers;
    }

    std::istream& in_;
    std::string line_;
    int line_number_ = 0;
    int bounds_line_ = 0;
    std::set<std::string> seen_;
    Problem problem_;
};

}  // namespace rigid
